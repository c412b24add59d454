// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_TEXTURE_LEAST_HARMFUL_POLES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_TEXTURE_LEAST_HARMFUL_POLES_H

#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/surface/Mapped_surface.h>
#include <CGAL/Spherical_parameterization/internal/distortion/Face_measures.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// A face as seen by the choice of the poles: where it is, and the affine map from the source to the sphere.
struct Face_sample {
  vec3 centre;
  vec3 column[2]; ///< images of an orthonormal basis of the source face
  double area;
};

/// Directions that may become a pole: the tips of the limbs first, since a limb with a pole in its tip has all of u
/// round it, and elsewhere is a speck. Vertices by falling stretch, none closer to another than 0.1.
CGAL_SP_INLINE std::vector<vec3> pole_candidates(const Host_array<vec3>& directions, const std::vector<double>& stretch)
{
  constexpr std::size_t most = 48;
  std::vector<std::size_t> order(directions.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return stretch[i] > stretch[j]; });
  std::vector<vec3> candidates;
  for(std::size_t i : order) {
    if(candidates.size() == most)
      break;
    const auto is_far = [&](vec3 c) { return squared_distance(c, directions[i]) > 0.01; };
    if(std::all_of(candidates.begin(), candidates.end(), is_far))
      candidates.push_back(directions[i]);
  }
  return candidates;
}

/// How far the texture of latitude and longitude is from an isometry up to scale: the variance, over the area, of the
/// logarithms of the singular values.
CGAL_SP_INLINE double texture_distortion(const std::vector<Face_sample>& samples, vec3 pole)
{
  double weight = 0, sum = 0, squares = 0;
  for(const Face_sample& s : samples) {
    const vec3 away = tangent(pole, s.centre), axis = outer(pole, s.centre);
    const double sine = norm(axis); // of the distance from the pole
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
CGAL_SP_INLINE vec3 least_harmful_south_pole(const Watched_loop<Host_loop>& loop, const Mapped_surface& map)
{
  constexpr int enough = 4000; // samples; every k-th face
  const int n = map.number_of_faces(), stride = (std::max)(1, n / enough);
  const Host_array<double>& source_area = map.face_area(loop.bare());
  const double total = std::accumulate(source_area.begin(), source_area.end(), 0.);

  std::vector<Face_sample> samples;
  for(int f = 0; f < n; f += stride) {
    const auto p = map.in_source(f), v = map.of_image(f);
    const vec3 e = sub(p[1], p[0]), g = sub(p[2], p[0]);
    const double length = norm(e), area = source_area[f];
    if(!(area > 0))
      continue;
    const double along = inner(e, g) / length, height = 2 * area / length;
    const vec3 first = scale(1 / length, sub(v[1], v[0]));
    const vec3 second = scale(1 / height, add_scaled(sub(v[2], v[0]), -along, first));
    samples.push_back({unit(add(v[0], add(v[1], v[2]))), {first, second}, area / total});
  }

  std::vector<double> stretch(map.number_of_vertices);
  for_each_fan(loop.bare(), map.face, map.number_of_vertices, [&](const Fan& fan) {
    double in_source = 0, on_sphere = 0;
    for(int c : fan) {
      in_source += source_area[c / 3];
      on_sphere += flat_area(map.of_image(c / 3));
    }
    stretch[fan.vertex] = std::log((std::max)(in_source / total, 1e-300)) - std::log((std::max)(on_sphere, 1e-300));
  });

  loop.advance(0.2);
  const std::vector<vec3> poles = pole_candidates(map.image, stretch);
  loop.advance(0.6);
  std::vector<double> distortion(poles.size());
  loop.for_each(static_cast<int>(poles.size()), [&](int i) { distortion[i] = texture_distortion(samples, poles[i]); });
  return poles[std::min_element(distortion.begin(), distortion.end()) - distortion.begin()];
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_TEXTURE_LEAST_HARMFUL_POLES_H
