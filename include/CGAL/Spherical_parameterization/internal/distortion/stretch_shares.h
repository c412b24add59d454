// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DISTORTION_STRETCH_SHARES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DISTORTION_STRETCH_SHARES_H

#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/algebra/histogram.h>
#include <CGAL/Spherical_parameterization/internal/distortion/Face_measures.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/surface/Mapped_surface.h>
#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/values/Stretch_histogram.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// How many area-uniform points lie in the barycentric cell of each vertex. `accumulated` has the areas of the faces,
/// added up in their order.
CGAL_SP_INLINE std::vector<double> sample_cells(const Stretch_histogram& options,
                                                const std::vector<double>& accumulated,
                                                const Host_array<std::array<int, 3>>& corners, std::size_t cells)
{
  std::vector<double> count(cells, 0);
  // At `position` in [0, 1) of all area; (s, t) in the unit square chooses a point of the face there.
  const auto add_point = [&](double position, double s, double t) {
    const auto it = std::upper_bound(accumulated.begin(), accumulated.end(), position * accumulated.back());
    const auto f = (std::min)(static_cast<std::size_t>(it - accumulated.begin()), corners.size() - 1);
    if(s + t > 1) { // folds the square on the triangle
      s = 1 - s;
      t = 1 - t;
    }
    const std::array<double, 3> barycentric = {s, t, 1 - s - t};
    ++count[corners[f][std::max_element(barycentric.begin(), barycentric.end()) - barycentric.begin()]];
  };
  const std::size_t n = options.number_of_samples;
  if(options.sampling == Stretch_histogram::Sampling::RANDOM) {
    std::mt19937 generator(options.random_seed);
    const auto uniform = [&] {
      return static_cast<double>(generator()) * 0x1p-32;
    }; // the same numbers with every standard library
    for(std::size_t k = 0; k < n; ++k) {
      const double position = uniform(), s = uniform(), t = uniform();
      add_point(position, s, t);
    }
  } else {
    // M. Roberts' sequence: multiples of the inverse powers of the plastic number fill the unit square evenly.
    constexpr double plastic = 1.32471795724474602596;
    for(std::size_t k = 0; k < n; ++k) {
      const double x = static_cast<double>(k);
      const double s = std::fmod(0.5 + x / plastic, 1.), t = std::fmod(0.5 + x / (plastic * plastic), 1.);
      add_point((x + 0.5) / static_cast<double>(n), s, t);
    }
  }
  return count;
}

/// How much of the surface every bin has.
CGAL_SP_INLINE std::vector<double> stretch_shares(const Host_loop& loop, const Mapped_surface& map,
                                                  const Stretch_histogram& options)
{
  const Host_array<double>& area = map.face_area(loop);
  std::vector<double> accumulated(area.size());
  std::partial_sum(area.begin(), area.end(), accumulated.begin());
  if(!(accumulated.back() > 0))
    throw Input_error(Error_code::DEGENERATE_FACE, "the mesh has no area");
  const Host_array<double> stretch = vertex_stretch(loop, map);
  const Host_array<double>& cell_area = map.vertex_area(loop);
  const std::vector<double> weight = options.sampling == Stretch_histogram::Sampling::EXACT_AREAS
                                       ? std::vector<double>(cell_area.begin(), cell_area.end())
                                     : options.sampling == Stretch_histogram::Sampling::VERTICES
                                       ? std::vector<double>(stretch.size(), 1)
                                       : sample_cells(options, accumulated, map.face, stretch.size());
  Histogram histogram(options.bins, options.low, options.high);
  for(std::size_t i = 0; i < stretch.size(); ++i)
    histogram.add(options.scale == Stretch_histogram::Scale::LINEAR ? std::exp(stretch[i]) : stretch[i], weight[i]);
  return histogram.shares();
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DISTORTION_STRETCH_SHARES_H
