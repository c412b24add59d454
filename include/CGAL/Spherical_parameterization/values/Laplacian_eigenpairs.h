// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_VALUES_LAPLACIAN_EIGENPAIRS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_VALUES_LAPLACIAN_EIGENPAIRS_H

#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationSpectrum
/// The smallest eigenvalues of L u = lambda M u and their functions u, for the Laplacian L of a surface and the
/// diagonal matrix M of the areas of its vertices. See `laplacian_eigenpairs()`.
///
/// The functions are orthonormal: the sum of `mass[i] * function(k, i) * function(l, i)` is 1 for k = l, else 0. The
/// sign of a function is chosen such that its largest value in magnitude is positive. The functions of a multiple
/// eigenvalue are an arbitrary basis.
struct Laplacian_eigenpairs {
  std::size_t number_of_vertices = 0; ///< number of vertices
  std::vector<double> value;          ///< the eigenvalues, ascending, in units of 1 / length^2; the first one is 0
  std::vector<double> functions;      ///< one after the other, in units of 1 / length: see `function()`
  std::vector<double> mass;           ///< of every vertex: a third of the areas of its faces

  std::size_t number() const { return value.size(); } ///< \return the number of pairs

  /// \param k,i  indices of a function and of a vertex \return the value of function k at vertex i
  double function(std::size_t k, std::size_t i) const { return functions[k * number_of_vertices + i]; }
};

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_VALUES_LAPLACIAN_EIGENPAIRS_H
