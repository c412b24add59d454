// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"
#include "meshes/mesh.h"
#include "tables/table.h"

#include <CGAL/Spherical_parameterization/align_maps.h>
#include <CGAL/Spherical_parameterization/parameterize.h>
#include <CGAL/Spherical_parameterization/resample.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <random>
#include <stdexcept>

namespace SP = CGAL::Spherical_parameterization;

namespace {

/// In degrees, of the rotation that leads from one to the other. Small angles have the cosine 1 but for rounding; so it
/// is the sine that is measured.
double degrees_between(const SP::Rotation& r, const SP::Rotation& s)
{
  double square = 0; // |r - s|^2 = 8 sin^2(angle / 2)
  for(std::size_t i = 0; i < 3; ++i)
    for(std::size_t j = 0; j < 3; ++j)
      square += (r[i][j] - s[i][j]) * (r[i][j] - s[i][j]);
  return 2 * std::asin(std::min(1., std::sqrt(square / 8))) * 180 / std::acos(-1.);
}

} // namespace

void benchmark::tabulate_rotations(const Options& options)
{
  constexpr int level = 5; // 10,242 vertices
  constexpr double noise = 0.01, wrong = 0.5;
  Table table(
    options.output, "rotations", "Rotation between two maps",
    {"isometric map; the shape resampled at an icosphere that is rotated at random, with normal noise of 1 % of "
     "the root mean square distance from the centre in every coordinate",
     "error of aligning_rotation() in degrees; CPU milliseconds of one core, without maps and locators"},
    {"model", "vertices", "rotations", "above 0.5 degree", "mean error", "largest error", "ms"});
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for_each_mesh(options.meshes, [&](const std::string& model, Mesh& mesh, Sphere_map sphere) {
    if(!SP::parameterize(mesh, SP::Isometric(), sphere))
      throw std::runtime_error("there is no isometric map");
    Vector_3 centre = CGAL::NULL_VECTOR;
    for(const Point_3& p : mesh.points())
      centre += (p - CGAL::ORIGIN) / static_cast<double>(mesh.number_of_vertices());
    double square = 0;
    for(const Point_3& p : mesh.points())
      square += CGAL::squared_distance(p, CGAL::ORIGIN + centre) / static_cast<double>(mesh.number_of_vertices());
    const double deviation = noise * std::sqrt(square);

    const SP::Spherical_locator<Mesh> locator(mesh, sphere);
    double mean = 0, largest = 0, milliseconds = 0;
    int failures = 0;
    for(int k = 0; k < options.rotations; ++k) {
      const Eigen::Matrix3d matrix = Eigen::Quaterniond(Eigen::Vector4d::NullaryExpr([&] { return normal(random); }))
                                       .normalized()
                                       .toRotationMatrix();
      SP::Rotation turn; // uniform
      for(int i = 0; i < 3; ++i)
        for(int j = 0; j < 3; ++j)
          turn[i][j] = matrix(i, j);
      Mesh other;
      const Sphere_map images = sphere_map(other);
      SP::make_icosphere(level, other, images);
      for(const auto v : other.vertices()) { // its image is turned from where its point comes from
        const auto [face, weight] = locator.locate(images[v]);
        Vector_3 p = CGAL::NULL_VECTOR;
        auto h = mesh.halfedge(face);
        for(std::size_t c = 0; c < 3; ++c, h = mesh.next(h))
          p += weight[c] * (mesh.point(mesh.source(h)) - CGAL::ORIGIN);
        other.point(v) = CGAL::ORIGIN + p + deviation * Vector_3(normal(random), normal(random), normal(random));
        const Eigen::Vector3d q = matrix * Eigen::Vector3d(images[v].x(), images[v].y(), images[v].z());
        images[v] = Point_3(q.x(), q.y(), q.z());
      }
      const SP::Spherical_locator<Mesh> other_locator(other, images);
      const std::clock_t begin = std::clock();
      const SP::Rotation found = SP::aligning_rotation(locator, mesh.points(), other_locator, other.points());
      milliseconds += 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / options.rotations;
      const double error = degrees_between(found, turn);
      mean += error / options.rotations;
      largest = std::max(largest, error);
      failures += error > wrong;
    }
    table.add_row({model, mesh.number_of_vertices(), options.rotations, failures, mean, largest, milliseconds});
  });
}
