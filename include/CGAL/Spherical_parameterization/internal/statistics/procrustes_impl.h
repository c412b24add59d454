// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STATISTICS_PROCRUSTES_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STATISTICS_PROCRUSTES_IMPL_H

#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/algebra/rotations.h>
#include <CGAL/Spherical_parameterization/internal/statistics/procrustes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The mean square of the entries of a shape.
CGAL_SP_INLINE double square_size(const Shape_set<double>& shapes, int shape)
{
  double sum = 0;
  for(int j = 0; j < shapes.entries(); ++j) {
    const vec3 p = shapes.get(shape, j);
    sum += shapes.weight(j) * inner(p, p);
  }
  return sum;
}

/// The rotation of a shape to where it is closest to `mean`.
CGAL_SP_INLINE Matrix_3 rotation_to(const Host_array<vec3>& mean, const Shape_set<double>& shapes, int shape)
{
  Host_array<vec3> weighted;
  for(int j = 0; j < shapes.entries(); ++j)
    weighted.push_back(scale(shapes.weight(j), shapes.get(shape, j)));
  return best_rotation(weighted, mean);
}

/// The mean of the shapes, each turned and scaled as its motion says.
template <class Loop>
void take_mean(const Loop& loop, const Shape_set<double>& shapes, const std::vector<Similarity>& motions,
               Host_array<vec3>& mean)
{
  for_each_index(loop, shapes.entries(), [&](int j) {
    vec3 sum = {0, 0, 0};
    for(int i = 0; i < shapes.size(); ++i)
      sum = add_scaled(sum, motions[i].scale / shapes.size(), rotated(motions[i].rotation, shapes.get(i, j)));
    mean[j] = sum;
  });
}

template <class Loop>
Procrustes_alignment superimpose(const Loop& loop, const Shape_set<double>& shapes, const Procrustes& method)
{
  const int n = shapes.size();
  Procrustes_alignment result;
  std::vector<Similarity>& motions = result.motions;
  motions.resize(static_cast<std::size_t>(n));
  if(method.scale) {
    std::vector<double> square(motions.size());
    loop.for_each(n, [&](int i) { square[i] = square_size(shapes, i); });
    const double mean = std::accumulate(square.begin(), square.end(), 0.) / n;
    for(int i = 0; i < n; ++i)
      motions[i].scale = square[i] > 0 ? std::sqrt(mean / square[i]) : 1;
  }
  Host_array<vec3> mean(static_cast<std::size_t>(shapes.entries()));
  if(method.rotate) {
    for_each_index(loop, shapes.entries(), [&](int j) { mean[j] = shapes.get(0, j); });
    result.has_converged = false;
    while(result.iterations < method.iterations && !result.has_converged) {
      loop.advance(static_cast<double>(result.iterations) / method.iterations);
      std::vector<double> change(motions.size(), 0);
      loop.for_each(n, [&](int i) {
        const Matrix_3 before = std::exchange(motions[i].rotation, rotation_to(mean, shapes, i));
        for(int a = 0; a < 3; ++a)
          for(int b = 0; b < 3; ++b)
            change[i] = (std::max)(change[i], std::abs(motions[i].rotation[a][b] - before[a][b]));
      });
      take_mean(loop, shapes, motions, mean);
      result.has_converged = *std::max_element(change.begin(), change.end()) <= method.accuracy;
      ++result.iterations;
    }
    const Matrix_3 back = transposed(motions[0].rotation);
    for(Similarity& motion : motions)
      motion.rotation = product(back, motion.rotation);
    motions[0].rotation = Similarity().rotation; // without rounding
  }
  take_mean(loop, shapes, motions, mean);
  std::vector<double> square(motions.size());
  loop.for_each(n, [&](int i) {
    for(int j = 0; j < shapes.entries(); ++j) {
      const vec3 p = scale(motions[i].scale, rotated(motions[i].rotation, shapes.get(i, j))), d = sub(p, mean[j]);
      shapes.put(i, j, p);
      square[i] += shapes.weight(j) * inner(d, d);
    }
  });
  result.deviation = std::sqrt(std::accumulate(square.begin(), square.end(), 0.) / n);
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STATISTICS_PROCRUSTES_IMPL_H
