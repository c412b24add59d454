// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STATISTICS_PRINCIPAL_COMPONENTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STATISTICS_PRINCIPAL_COMPONENTS_H

#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/statistics/Shape_set.h>

#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The principal components of a set of shapes, as combinations of the shapes: component k is the sum over shapes of
/// their distances from the mean times combination[i][k]. The columns of `combination` times `deviation[k]` are
/// orthonormal. The sign of a component is that for which its longest score is positive.
struct Principal_components {
  std::vector<double> deviation;                ///< singular values, largest first; those that are rounding left out
  std::vector<std::vector<double>> combination; ///< by shape, then by component
  double square_sum = 0;                        ///< of the distances of the shapes from their mean
};

/// Singular values that are a smaller part of the largest one are rounding.
constexpr double smallest_deviation = 1e-10;

/// By the singular values of the triangle R of a QR decomposition of the tall matrix of the shapes, one column each
/// (G. Golub, C. Van Loan, "Matrix Computations", 8.6.3: R-SVD). Gram's matrix would square its condition. R comes from
/// blocks of rows, one after the other (J. Demmel, L. Grigori, M. Hoemmen, J. Langou, "Communication-optimal parallel
/// and sequential QR and LU factorizations", 2012), so that nothing of the size of the data is copied.
///
/// O(V n^2 + n^3) for n shapes of V entries.
template <class Loop>
Principal_components principal_components(const Loop& loop, const Shape_set<const double>& shapes);

/// Writes the mean of the shapes, and as many of the components as there are other shapes in `mean_and_modes`.
///
/// O(V n) per component.
template <class Loop>
void write_components(const Loop& loop, const Shape_set<const double>& shapes, const Principal_components& components,
                      const Shape_set<double>& mean_and_modes);

/// What components of other shapes leave of a shape: the shapes are dealt out to so many groups, i to group i mod
/// groups, and the shapes of every group reconstructed from the mean and the components of all others.
/// \return by the number of components, from 0 on, the root mean square distance over shapes
///
/// O(V n^2 + groups n^3).
template <class Loop>
std::vector<double> errors_of_left_out(const Loop& loop, const Shape_set<const double>& shapes, int groups);

} // namespace CGAL::Spherical_parameterization::internal

#ifdef CGAL_SP_INCLUDE_CORE
#include <CGAL/Spherical_parameterization/internal/statistics/principal_components_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STATISTICS_PRINCIPAL_COMPONENTS_H
