// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPECTRUM_LAPLACIAN_SPECTRUM_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPECTRUM_LAPLACIAN_SPECTRUM_H

#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/context/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>

namespace CGAL::Spherical_parameterization::internal {

/// The smallest eigenvalues of L u = lambda M u and their functions u, for the Laplacian L of a connected graph and the
/// diagonal matrix M of the masses of its vertices. The functions are orthonormal: the sum of mass u_k u_l is 1 for k =
/// l, else 0. The sign of a function is that for which its longest value is positive.
struct Laplacian_spectrum {
  int number_of_vertices = 0;
  int number = 0;              ///< of pairs
  Host_array<double> value;    ///< ascending; the first one is 0
  Host_array<double> function; ///< one after the other: function k at vertex i is function[k * number_of_vertices + i]
  Host_array<double> mass;     ///< by vertex
};

/// By block Lanczos iteration with the factorization of L - shift M (`Block_lanczos`, `Shift_inverse`).
///
/// The graph is that of a surface: by H. Weyl's law eigenvalue k is about 4 pi k over its area, which is where the
/// shift comes from. Much else is slow, and not wrong. Throws Error: `DEGENERATE_FACE` where a mass is not positive, or
/// the matrix cannot be factorized; `NOT_CONVERGED`; `INTERRUPTED`.
/// \param mass  by vertex
/// \pre 1 <= number <= number of vertices
///
/// Memory: 3 numbers per vertex and pair. Time: the factorization, O(n^1.5), and O(n number^2).
template <class Loop>
Laplacian_spectrum laplacian_spectrum(const Loop& loop, const Weighted_graph& laplacian, const Host_array<double>& mass,
                                      int number, Monitor& monitor);

} // namespace CGAL::Spherical_parameterization::internal

#ifdef CGAL_SP_INCLUDE_CORE
#include <CGAL/Spherical_parameterization/internal/spectrum/laplacian_spectrum_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPECTRUM_LAPLACIAN_SPECTRUM_H
