// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPECTRUM_KERNEL_SIGNATURES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPECTRUM_KERNEL_SIGNATURES_H

#include <CGAL/Spherical_parameterization/values/Laplacian_eigenpairs.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Of every energy of the wave kernel signature, the weights of the squares of all functions; 1 in all, and none of the
/// constant one. M. Aubry, U. Schlickewei, D. Cremers, ICCV Workshops 2011.
/// \param value  the eigenvalues, two or more
inline std::vector<std::vector<double>> wave_kernel_filters(const std::vector<double>& value, std::size_t number)
{
  constexpr double widest = 0.2; // of the whole, lest few energies are all in the middle
  constexpr double largest_exponent = 700;
  constexpr double rounding = 1e-9; // of eigenvalues that are equal: then all functions count alike
  const double least = 1e-9 * value.back();
  std::vector<double> energy;
  for(std::size_t k = 1; k < value.size(); ++k)
    energy.push_back(std::log((std::max)(value[k], least)));
  const double range = energy.back() - energy.front(), width = range > rounding ? range : 0;
  const double sigma = (std::min)(widest * width, 7 * width / static_cast<double>(number));
  const double low = energy.front() + 2 * sigma, high = energy.back() - 2 * sigma;
  std::vector<std::vector<double>> filters(number);
  for(std::size_t e = 0; e < number; ++e) {
    const double at = low + (high - low) * static_cast<double>(e) / static_cast<double>(number - 1);
    const auto exponent = [&](double of_function) {
      const double d = sigma > 0 ? (at - of_function) / sigma : 0;
      return d * d / 2;
    };
    double least_exponent = std::numeric_limits<double>::infinity(), sum = 0;
    for(double of_function : energy)
      least_exponent = (std::min)(least_exponent, exponent(of_function));
    const double shift = least_exponent < largest_exponent ? 0 : least_exponent; // far from all: the nearest counts
    filters[e].push_back(0);
    for(double of_function : energy) {
      filters[e].push_back(std::exp(shift - exponent(of_function)));
      sum += filters[e].back();
    }
    for(double& weight : filters[e])
      weight /= sum;
  }
  return filters;
}

/// One filter after the other, at every vertex the squares of all functions, weighted by it.
inline std::vector<double> filtered_squares(const Laplacian_eigenpairs& pairs,
                                            const std::vector<std::vector<double>>& filters)
{
  const std::size_t n = pairs.number_of_vertices;
  std::vector<double> result(filters.size() * n, 0);
  for(std::size_t f = 0; f < filters.size(); ++f)
    for(std::size_t k = 0; k < pairs.number(); ++k)
      for(std::size_t i = 0; i < n; ++i)
        result[f * n + i] += filters[f][k] * pairs.function(k, i) * pairs.function(k, i);
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPECTRUM_KERNEL_SIGNATURES_H
