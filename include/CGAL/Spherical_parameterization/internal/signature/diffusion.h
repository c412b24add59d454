// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SIGNATURE_DIFFUSION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SIGNATURE_DIFFUSION_H

#include <CGAL/Spherical_parameterization/internal/algebra/dense_matrices.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The median distance of signatures is 2.6 on the Princeton benchmark, that of each part of a form 1, and a signature
/// weighs 1.5 times a part. How this and the number of neighbours were chosen: doc/shape_search.md.
constexpr double weight_of_forms = 2.6 / 1.5;

/// How similar each of n things is to the first one, by chains of neighbours: see `relevance_of_shapes()`.
/// \param distance  distance(i, j), symmetric
template <class Distance>
std::vector<double> diffused_similarity(std::size_t n, Distance distance)
{
  typedef typename Dense<Distance>::Matrix Matrix;
  typedef typename Dense<Distance>::Vector Vector;
  if(n == 0)
    return {};
  constexpr std::size_t neighbours = 5;
  constexpr double persistence = 0.95; // what a step of the diffusion leaves of the start is the rest
  const auto size = static_cast<Eigen::Index>(n);
  Matrix between(size, size);
  for(Eigen::Index i = 0; i < size; ++i)
    for(Eigen::Index j = 0; j <= i; ++j)
      between(i, j) = between(j, i) = i == j ? 0 : distance(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
  constexpr double rounding = 1e-6; // of the largest distance: copies in other places and sizes are that near
  const double negligible = rounding * between.maxCoeff();
  const auto is_copy = [&](Eigen::Index i, Eigen::Index j) { return between(i, j) <= negligible; };
  // neighbours, and how far the last one is; copies come in addition, or many of them would cut themselves off
  std::vector<std::vector<Eigen::Index>> near(n);
  Vector reach(size);
  for(Eigen::Index i = 0; i < size; ++i) {
    std::vector<Eigen::Index> others;
    for(Eigen::Index j = 0; j < size; ++j)
      if(j != i)
        others.push_back(j);
    std::stable_sort(others.begin(), others.end(),
                     [&](Eigen::Index a, Eigen::Index b) { return between(i, a) < between(i, b); });
    const auto copies = static_cast<std::size_t>(
      std::count_if(others.begin(), others.end(), [&](Eigen::Index j) { return is_copy(i, j); }));
    others.resize((std::min)(others.size(), copies + neighbours));
    reach[i] = others.empty() ? 0 : between(i, others.back());
    near[static_cast<std::size_t>(i)] = std::move(others);
  }
  Matrix weight = Matrix::Zero(size, size);
  for(Eigen::Index i = 0; i < size; ++i)
    for(const Eigen::Index j : near[static_cast<std::size_t>(i)]) {
      weight(i, j) = weight(j, i) =
        is_copy(i, j) ? 1 : std::exp(-between(i, j) * between(i, j) / (reach[i] * reach[j]));
    }
  const Vector root = weight.rowwise().sum().unaryExpr([](double sum) { return sum > 0 ? 1 / std::sqrt(sum) : 0; });
  const Matrix inverse = (Matrix::Identity(size, size) - persistence * (root.asDiagonal() * weight * root.asDiagonal()))
                           .llt() // positive definite: the eigenvalues of what is subtracted are at most `persistence`
                           .solve(Matrix::Identity(size, size));
  std::vector<double> similarity(n);
  for(Eigen::Index i = 0; i < size; ++i)
    similarity[static_cast<std::size_t>(i)] = i == 0 ? 1 : inverse(0, i) / std::sqrt(inverse(0, 0) * inverse(i, i));
  return similarity;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SIGNATURE_DIFFUSION_H
