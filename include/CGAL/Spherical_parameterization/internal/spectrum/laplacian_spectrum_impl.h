// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPECTRUM_LAPLACIAN_SPECTRUM_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPECTRUM_LAPLACIAN_SPECTRUM_IMPL_H

#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/internal/algebra/dense_matrices.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/spectrum/Block_lanczos.h>
#include <CGAL/Spherical_parameterization/internal/spectrum/Shift_inverse.h>
#include <CGAL/Spherical_parameterization/internal/spectrum/laplacian_spectrum.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Fills in pair 0, which is known: constants; and makes room for the others.
CGAL_SP_INLINE Laplacian_eigenpairs first_pair(const Host_loop& loop, const Host_array<double>& mass, int number)
{
  Laplacian_eigenpairs spectrum;
  const int n = static_cast<int>(mass.size());
  spectrum.number_of_vertices = mass.size();
  spectrum.mass.assign(mass.begin(), mass.end());
  spectrum.value.assign(static_cast<std::size_t>(number), 0);
  spectrum.functions.resize(mass.size() * static_cast<std::size_t>(number));
  const double constant = 1 / std::sqrt(sum_by_parts(loop, n, [&](int i) { return mass[i]; }));
  std::fill(spectrum.functions.begin(), spectrum.functions.begin() + n, constant);
  return spectrum;
}

/// All eigenvalues of a small matrix, as there is no room in it for a basis. Constants are moved out of the way.
template <class Loop>
void dense_spectrum(const Weighted_graph& laplacian, Laplacian_eigenpairs& spectrum)
{
  typedef typename Dense<Loop>::Matrix Matrix;
  const int n = static_cast<int>(spectrum.number_of_vertices);
  const auto& mass = spectrum.mass;
  Matrix a = Matrix::Zero(n, n);
  for(int i = 0; i < n; ++i)
    for(int k = laplacian.offset[i]; k < laplacian.offset[i + 1]; ++k) {
      const int j = laplacian.target[k];
      a(i, i) += laplacian.weight[k] / mass[i];
      a(i, j) -= laplacian.weight[k] / std::sqrt(mass[i] * mass[j]);
    }
  const double trace = a.trace(), constant = spectrum.functions[0];
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
      a(i, j) += trace * constant * constant * std::sqrt(mass[i] * mass[j]);
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(a);
  if(solver.info() != Eigen::Success)
    throw Input_error(Error_code::NOT_CONVERGED, "the eigenfunctions were not found");
  for(int k = 1; k < static_cast<int>(spectrum.number()); ++k) {
    spectrum.value[k] = solver.eigenvalues()[k - 1];
    for(int i = 0; i < n; ++i)
      spectrum.functions[static_cast<std::size_t>(k) * n + i] = solver.eigenvectors()(i, k - 1) / std::sqrt(mass[i]);
  }
}

/// Sets a shift below which there is a certain part of the eigenvalues that are sought. Above them there is nothing but
/// those to be kept from the basis: the nearer the shift is to the last ones, the smaller the basis can be, as long as
/// the first ones are nearer than what comes behind the last ones.
template <class Loop>
double choose_shift(const Watched_loop<Loop>& loop, const Laplacian_eigenpairs& spectrum, Shift_inverse<Loop>& inverse)
{
  constexpr double part = 0.6; // shifts and block widths were tried on spheres and on bodies with limbs
  constexpr int trials = 6;
  const double goal = part * static_cast<double>(spectrum.number());
  const double area =
    sum_by_parts(loop.bare(), static_cast<int>(spectrum.number_of_vertices), [&](int i) { return spectrum.mass[i]; });
  double shift = 4 * pi * goal / area;
  double usable = 0;
  for(int trial = 0; trial < trials; ++trial) {
    loop.advance(0);
    if(!inverse.set_shift(shift)) {
      shift *= 0.97;
      continue;
    }
    usable = shift;
    const int below = inverse.number_below();
    if(std::abs(below - goal) <= 0.1 * static_cast<double>(spectrum.number()) + 3)
      return shift;
    shift *= (std::min)((std::max)(goal / below, 0.1), 3.); // constants are always below
  }
  if(!(usable > 0) || (usable != shift && !inverse.set_shift(usable)))
    throw Input_error(Error_code::DEGENERATE_FACE, "the surface has no usable metric");
  return usable;
}

template <class Loop>
void sparse_spectrum(const Watched_loop<Loop>& loop, const Weighted_graph& laplacian, Laplacian_eigenpairs& spectrum)
{
  typedef typename Dense<Loop>::Matrix Matrix;
  typedef Block_lanczos<Watched_loop<Loop>, Shift_inverse<Loop>> Lanczos;
  constexpr double accuracy = 1e-11; // of residuals, relative to the eigenvalue of the inverse
  constexpr double rounding = 1e-10; // of eigenvalues, relative to the shift
  const int n = static_cast<int>(spectrum.number_of_vertices), others = static_cast<int>(spectrum.number()) - 1;
  const auto& mass = spectrum.mass;

  Shift_inverse<Loop> inverse(laplacian, mass);
  const double shift = choose_shift(loop, spectrum, inverse);
  Host_array<double> constant(mass.size());
  for_each_index(loop.bare(), n, [&](int i) { constant[i] = spectrum.functions[0] * std::sqrt(mass[i]); });

  // A basis of 15/8 of the pairs is mostly enough. The last block leads out of it, so there has to be room for one
  // more.
  const int first_check = 15 * others / 8 + 24, step = others / 5 + 8;
  const int largest = (std::min)(n - 1 - Lanczos::width, 6 * others + 100);
  Lanczos lanczos(loop, inverse, constant, largest);
  for(int goal = first_check;; goal += step) {
    goal = (std::min)(goal, largest / Lanczos::width * Lanczos::width);
    while(lanczos.size() < goal) {
      loop.advance(lanczos.size() / double(first_check + step));
      lanczos.grow();
    }
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(lanczos.t());
    const auto& inverse_value = solver.eigenvalues(); // of the inverse
    // The smallest ones from 0 on. What has not converged may lie anywhere, also below.
    std::vector<std::pair<double, int>> found;
    for(int k = 0; k < lanczos.size(); ++k) {
      const double value = shift + 1 / inverse_value[k];
      if(value > -rounding * shift)
        found.emplace_back((std::max)(value, 0.), k);
    }
    std::sort(found.begin(), found.end());
    const auto has_converged = [&](const std::pair<double, int>& pair) {
      const Matrix last = solver.eigenvectors().col(pair.second).tail(Lanczos::width);
      return (lanczos.rest() * last).norm() <= accuracy * std::abs(inverse_value[pair.second]);
    };
    const auto is_below = [&](const std::pair<double, int>& pair) { return pair.first < shift; };
    const bool is_done = static_cast<int>(found.size()) >= others &&
                         std::all_of(found.begin(), found.begin() + others, has_converged) &&
                         1 + std::count_if(found.begin(), found.end(), is_below) == inverse.number_below();
    if(is_done) {
      Matrix coefficients(lanczos.size(), others);
      for(int k = 0; k < others; ++k) {
        spectrum.value[k + 1] = found[k].first;
        coefficients.col(k) = solver.eigenvectors().col(found[k].second);
      }
      lanczos.combine(coefficients, [&](int i, int k, double x) {
        spectrum.functions[(k + 1) * static_cast<std::size_t>(n) + i] = x / std::sqrt(mass[i]);
      });
      return;
    }
    if(lanczos.size() + Lanczos::width > largest)
      throw Input_error(Error_code::NOT_CONVERGED, "the eigenfunctions were not found");
  }
}

template <class Loop>
Laplacian_eigenpairs laplacian_spectrum(const Loop& loop, const Weighted_graph& laplacian,
                                        const Host_array<double>& mass, int number, Monitor& monitor)
{
  const int n = static_cast<int>(mass.size());
  const int bad = first_index(loop, n, [&](int i) { return !(mass[i] > 0) || !std::isfinite(1 / mass[i]); });
  if(bad < n)
    throw Input_error(Error_code::DEGENERATE_FACE, "the faces round vertex " + std::to_string(bad) + " have no area");
  const Watched_loop<Loop> watched(loop, monitor);
  watched.advance(0);
  Laplacian_eigenpairs spectrum = first_pair(loop, mass, number);
  if(n < 3 * number + 100)
    dense_spectrum<Loop>(laplacian, spectrum);
  else if(number > 1)
    sparse_spectrum(watched, laplacian, spectrum);
  for_each_index<1>(loop, number, [&](int k) { // signs
    double* const function = spectrum.functions.data() + static_cast<std::size_t>(k) * n;
    double longest = 0;
    for(int i = 0; i < n; ++i)
      if(std::abs(function[i]) > std::abs(longest) * (1 + 1e-9)) // of equal ones the first, whatever the rounding
        longest = function[i];
    for(int i = 0; i < n && longest < 0; ++i)
      function[i] = -function[i];
  });
  monitor.advance(1); // whatever is answered: all is there
  return spectrum;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPECTRUM_LAPLACIAN_SPECTRUM_IMPL_H
