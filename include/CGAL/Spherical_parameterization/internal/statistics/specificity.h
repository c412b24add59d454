// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STATISTICS_SPECIFICITY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STATISTICS_SPECIFICITY_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/statistics/principal_components.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Numbers of mean 0 and variance 1, normally distributed (G. Box, M. Muller, 1958): std::normal_distribution is
/// another one in every standard library.
inline std::vector<double> normal_numbers(std::size_t number, std::uint32_t seed)
{
  std::mt19937 random(seed);
  const auto uniform = [&random] { return (static_cast<double>(random()) + 0.5) / 4294967296.; };
  std::vector<double> result(number);
  for(double& x : result) {
    const double radius = std::sqrt(-2 * std::log(uniform()));
    x = radius * std::cos(2 * pi * uniform());
  }
  return result;
}

/// By the number of components, from 0 on: the mean distance of random shapes from the nearest one of the set, and its
/// standard error. Shapes are compared by their scores, which are coordinates of the space that the set spans.
///
/// O(samples n^2) for n shapes.
template <class Loop>
std::pair<std::vector<double>, std::vector<double>>
specificity(const Loop& loop, const Principal_components& components, int samples, std::uint32_t seed)
{
  const std::size_t n = components.combination.size(), modes = components.deviation.size();
  std::vector<double> score(n * modes), square(n, 0); // by mode, then by shape; of the distance from the mean
  for(std::size_t k = 0; k < modes; ++k)
    for(std::size_t i = 0; i < n; ++i) {
      double& s = score[k * n + i];
      s = components.combination[i][k] * components.deviation[k] * components.deviation[k];
      square[i] += s * s;
    }
  const std::vector<double> normal = normal_numbers(samples * modes, seed);
  std::vector<double> distance(samples * (modes + 1));
  loop.for_each(samples, [&](int sample) {
    std::vector<double> squares = square;
    double* const out = &distance[sample * (modes + 1)];
    const auto nearest = [&] { return std::sqrt((std::max)(0., *std::min_element(squares.begin(), squares.end()))); };
    out[0] = nearest();
    for(std::size_t k = 0; k < modes; ++k) {
      const double b = components.deviation[k] / std::sqrt(static_cast<double>(n) - 1) * normal[sample * modes + k];
      for(std::size_t i = 0; i < n; ++i)
        squares[i] += b * (b - 2 * score[k * n + i]);
      out[k + 1] = nearest();
    }
  });
  std::pair<std::vector<double>, std::vector<double>> result;
  for(std::size_t k = 0; k <= modes; ++k) {
    double mean = 0, variance = 0;
    for(int sample = 0; sample < samples; ++sample)
      mean += distance[sample * (modes + 1) + k] / samples;
    for(int sample = 0; sample < samples; ++sample)
      variance += std::pow(distance[sample * (modes + 1) + k] - mean, 2) / (samples - 1.);
    result.first.push_back(mean);
    result.second.push_back(std::sqrt(variance / samples));
  }
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STATISTICS_SPECIFICITY_H
