// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_TEXTURE_LEAST_HARMFUL_POLES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_TEXTURE_LEAST_HARMFUL_POLES_H

#include <CGAL/Spherical_parameterization/internal/distortion/face_distortion.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

/// A face as seen by the choice of the poles: where it is, and the affine map from the source to the sphere.
struct Face_sample {
  vec3 centre;
  vec3 column[2]; ///< images of an orthonormal basis of the source face
  double area;
};

/// Directions that may become a pole: the tips of the limbs first, since a limb with a pole in its tip has all of u
/// round it, and elsewhere is a speck. Vertices by falling stretch, none closer to another than 0.1.
inline std::vector<vec3> pole_candidates(const std::vector<vec3>& directions, const std::vector<double>& stretch)
{
  constexpr std::size_t most = 48;
  std::vector<std::size_t> order(directions.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return stretch[i] > stretch[j] || (stretch[i] == stretch[j] && i < j);
  });
  std::vector<vec3> candidates;
  for(std::size_t i : order) {
    const bool is_far = std::all_of(candidates.begin(), candidates.end(), [&](vec3 c) {
      const vec3 d = sub(c, directions[i]);
      return inner(d, d) > 0.01;
    });
    if(is_far)
      candidates.push_back(directions[i]);
    if(candidates.size() == most)
      break;
  }
  return candidates;
}

/// How far the texture of latitude and longitude is from an isometry up to scale: the variance, over the area, of the
/// logarithms of the singular values.
inline double texture_distortion(const std::vector<Face_sample>& samples, vec3 pole)
{
  double weight = 0, sum = 0, squares = 0;
  for(const Face_sample& s : samples) {
    const vec3 away = tangent(pole, s.centre), axis = outer(pole, s.centre);
    const double sine = std::sqrt(inner(axis, axis)); // of the distance from the pole
    if(!(sine > 0))
      continue;
    const double x[2] = {inner(s.column[0], axis) / (sine * sine), inner(s.column[1], axis) / (sine * sine)};
    const double y[2] = {inner(s.column[0], away) / sine, inner(s.column[1], away) / sine};
    const double squared_sum = x[0] * x[0] + x[1] * x[1] + y[0] * y[0] + y[1] * y[1];
    const double product = std::abs(x[0] * y[1] - x[1] * y[0]);
    const double ratio = ratio_of_singular_values(squared_sum, product);
    if(!std::isfinite(ratio))
      continue;
    const double mean = std::log(product) / 2, half = std::log(ratio) / 2; // log sigma = mean +- half
    weight += s.area;
    sum += s.area * mean;
    squares += s.area * (mean * mean + half * half);
  }
  return weight > 0 ? squares / weight - (sum / weight) * (sum / weight) : 0;
}

/// The vertex that as the south pole makes the texture of latitude and longitude least distorted.
template <class TriangleMesh, class VertexPointMap, class VertexSphereMap>
vec3 least_harmful_south_pole(const TriangleMesh& mesh, VertexPointMap points, VertexSphereMap sphere)
{
  constexpr std::size_t enough = 4000; // samples; every k-th face
  std::size_t number_of_faces = 0;
  double total = 0;
  for(auto f : faces(mesh)) {
    ++number_of_faces;
    total += flat_area(corners(mesh, points, f));
  }
  const std::size_t stride = (std::max)(std::size_t(1), number_of_faces / enough);

  std::vector<Face_sample> samples;
  std::size_t k = 0;
  for(auto f : faces(mesh)) {
    if(k++ % stride != 0)
      continue;
    const auto p = corners(mesh, points, f), v = corners(mesh, sphere, f);
    const vec3 e = sub(p[1], p[0]), g = sub(p[2], p[0]);
    const double length = std::sqrt(inner(e, e)), area = flat_area(p);
    if(!(area > 0))
      continue;
    const double along = inner(e, g) / length, height = 2 * area / length;
    Face_sample s;
    s.centre = unit(add(v[0], add(v[1], v[2])));
    s.column[0] = scale(1 / length, sub(v[1], v[0]));
    s.column[1] = scale(1 / height, add_scaled(sub(v[2], v[0]), -along, s.column[0]));
    s.area = area / total;
    samples.push_back(s);
  }

  std::vector<vec3> directions;
  std::vector<double> stretch;
  for(auto v : vertices(mesh)) {
    directions.push_back(coordinates(get(sphere, v)));
    double in_source = 0, on_sphere = 0;
    for(auto h : halfedges_around_target(halfedge(v, mesh), mesh)) {
      in_source += flat_area(corners(mesh, points, face(h, mesh)));
      on_sphere += flat_area(corners(mesh, sphere, face(h, mesh)));
    }
    stretch.push_back(std::log((std::max)(in_source / total, 1e-300)) - std::log((std::max)(on_sphere, 1e-300)));
  }

  vec3 best = directions.front();
  double least = std::numeric_limits<double>::infinity();
  for(vec3 pole : pole_candidates(directions, stretch)) {
    const double distortion = texture_distortion(samples, pole);
    if(distortion < least) {
      least = distortion;
      best = pole;
    }
  }
  return best;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_TEXTURE_LEAST_HARMFUL_POLES_H
