// SPDX-License-Identifier: GPL-3.0-or-later

#include "helpers/certificate.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

namespace test {
namespace {

constexpr double pi = 3.14159265358979323846;

Eigen::Vector3d eigen(const Point& p) { return {p.x(), p.y(), p.z()}; }

/// Numbered by the corner opposite to it, so that angle k lies across from edge (k+1, k+2).
double angle_at(const Soup& soup, const std::vector<std::size_t>& face, std::size_t k)
{
  const Eigen::Vector3d o = eigen(soup.points[face[k]]);
  const Eigen::Vector3d a = eigen(soup.points[face[(k + 1) % 3]]) - o, b = eigen(soup.points[face[(k + 2) % 3]]) - o;
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

double area(const Soup& soup)
{
  double sum = 0;
  for(const auto& f : soup.faces) {
    const Eigen::Vector3d o = eigen(soup.points[f[0]]);
    sum += (eigen(soup.points[f[1]]) - o).cross(eigen(soup.points[f[2]]) - o).norm() / 2;
  }
  return sum;
}

double effective_weight(const Spring& s, const Sphere& sphere, double exponent)
{
  if(exponent == 2)
    return s.weight;
  const double stretch = (eigen(sphere[s.i]) - eigen(sphere[s.j])).norm() / s.length;
  return s.weight * std::pow(stretch, exponent - 2);
}

} // namespace

std::vector<Spring> make_springs(const Soup& soup, Weights weights)
{
  if(weights == Weights::CONFORMAL)
    throw std::logic_error("conformal springs are no edges of the mesh");
  std::map<std::pair<std::size_t, std::size_t>, double> edges;
  auto add = [&](std::size_t i, std::size_t j, double w) { edges[std::minmax(i, j)] += w; };
  for(const auto& f : soup.faces) {
    if(f.size() != 3)
      throw std::logic_error("springs need triangles");
    for(std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = f[(k + 1) % 3], j = f[(k + 2) % 3];
      if(weights == Weights::BARYCENTRIC)
        add(i, j, 0.5); // twice
      else if(weights == Weights::CLAMPED) {
        const double angle = std::min(std::max(angle_at(soup, f, k), 5 * pi / 180), 85 * pi / 180);
        add(i, j, 0.5 / std::tan(angle));
      } else {
        const double length = (eigen(soup.points[i]) - eigen(soup.points[j])).norm();
        const double at_i = angle_at(soup, f, (k + 1) % 3), at_j = angle_at(soup, f, (k + 2) % 3);
        add(i, j, 0.5 * (std::tan(at_i / 2) + std::tan(at_j / 2)) / length);
      }
    }
  }
  const double scale = std::sqrt(4 * pi / area(soup));
  std::vector<Spring> springs;
  for(const auto& [ends, w] : edges) {
    const double length = (eigen(soup.points[ends.first]) - eigen(soup.points[ends.second])).norm();
    springs.push_back({ends.first, ends.second, w, scale * length});
  }
  return springs;
}

std::size_t count_flipped_faces(const Soup& soup, const Sphere& sphere)
{
  std::size_t flips = 0;
  for(const auto& f : soup.faces)
    if(exact_orientation(Point(0, 0, 0), sphere[f[0]], sphere[f[1]], sphere[f[2]]) != CGAL::POSITIVE)
      ++flips;
  return flips;
}

int degree(const Soup& soup, const Sphere& sphere)
{
  const Point o(0, 0, 0), direction(0.3141592653, -0.2718281828, 0.5772156649);
  int covered = 0;
  for(const auto& f : soup.faces) {
    const auto side = exact_orientation(o, sphere[f[0]], sphere[f[1]], sphere[f[2]]);
    if(side == CGAL::ZERO)
      continue;
    bool inside = true;
    for(std::size_t k = 0; k < 3; ++k)
      inside = inside && exact_orientation(o, sphere[f[k]], sphere[f[(k + 1) % 3]], direction) == side;
    if(inside)
      covered += side;
  }
  return covered;
}

double smallest_area(const Soup& soup, const Sphere& sphere)
{
  double smallest = std::numeric_limits<double>::infinity();
  for(const auto& f : soup.faces) {
    const Eigen::Vector3d a = eigen(sphere[f[0]]), b = eigen(sphere[f[1]]), c = eigen(sphere[f[2]]);
    const double determinant = std::abs(a.dot((b - a).cross(c - a)));
    smallest = std::min(smallest, 2 * std::atan2(determinant, 1 + a.dot(b) + b.dot(c) + c.dot(a)));
  }
  return smallest;
}

double energy(const std::vector<Spring>& springs, const Sphere& sphere, double exponent)
{
  double sum = 0;
  for(const Spring& s : springs)
    sum += effective_weight(s, sphere, exponent) * (eigen(sphere[s.i]) - eigen(sphere[s.j])).squaredNorm();
  return sum / exponent;
}

double residual(const std::vector<Spring>& springs, const Sphere& sphere, const std::vector<std::size_t>& fixed,
                double exponent)
{
  std::vector<Eigen::Vector3d> sums(sphere.size(), Eigen::Vector3d::Zero());
  for(const Spring& s : springs) {
    const double w = effective_weight(s, sphere, exponent);
    sums[s.i] += w * eigen(sphere[s.j]);
    sums[s.j] += w * eigen(sphere[s.i]);
  }
  const std::set<std::size_t> is_fixed(fixed.begin(), fixed.end());
  double square = 0;
  for(std::size_t i = 0; i < sphere.size(); ++i)
    if(is_fixed.count(i) == 0)
      square += (eigen(sphere[i]) - sums[i].normalized()).squaredNorm();
  return std::sqrt(square);
}

double balanced_residual(const std::vector<Spring>& springs, const Sphere& sphere)
{
  Eigen::MatrixX3d forces = Eigen::MatrixX3d::Zero(Eigen::Index(sphere.size()), 3);
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(Eigen::Index(sphere.size()));
  for(const Spring& s : springs) {
    const Eigen::Index i = Eigen::Index(s.i), j = Eigen::Index(s.j);
    const Eigen::RowVector3d pull = s.weight * (eigen(sphere[s.i]) - eigen(sphere[s.j])).transpose();
    forces.row(i) += pull;
    forces.row(j) -= pull;
    weights[i] += s.weight;
    weights[j] += s.weight;
  }
  Eigen::MatrixX3d torques(forces.rows(), 3);
  for(Eigen::Index i = 0; i < forces.rows(); ++i)
    torques.row(i) = eigen(sphere[std::size_t(i)]).cross(forces.row(i).transpose()).transpose() / weights[i];
  return Eigen::JacobiSVD<Eigen::MatrixXd>(torques).singularValues()[2];
}

std::size_t count_vertices_off_sphere(const Sphere& sphere)
{
  std::size_t off = 0;
  for(const Point& p : sphere)
    if(!(std::abs(eigen(p).norm() - 1) <= 4e-15)) // NaN counts
      ++off;
  return off;
}

double distance_up_to_rotation(const Sphere& a, const Sphere& b)
{
  // Kabsch: the rotation nearest to the covariance of the two maps
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for(std::size_t i = 0; i < a.size(); ++i)
    covariance += eigen(a[i]) * eigen(b[i]).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d sign = Eigen::Matrix3d::Identity();
  if((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0)
    sign(2, 2) = -1;
  const Eigen::Matrix3d rotation = svd.matrixU() * sign * svd.matrixV().transpose();
  Sphere rotated;
  for(const Point& p : b) {
    const Eigen::Vector3d q = rotation * eigen(p);
    rotated.emplace_back(q.x(), q.y(), q.z());
  }
  return distance(a, rotated);
}

double distance(const Sphere& a, const Sphere& b)
{
  if(a.size() != b.size())
    throw std::logic_error("two maps of different meshes");
  double largest = 0;
  for(std::size_t i = 0; i < a.size(); ++i) {
    const double d = (eigen(a[i]) - eigen(b[i])).norm();
    if(!(d <= largest)) // NaN wins
      largest = d;
  }
  return largest;
}

} // namespace test
