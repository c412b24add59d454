// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPECTRUM_LAPLACIAN_SPECTRUM_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPECTRUM_LAPLACIAN_SPECTRUM_H

#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/context/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/values/Laplacian_eigenpairs.h>

namespace CGAL::Spherical_parameterization::internal {

/// The smallest eigenpairs of a connected graph with the masses of its vertices.
///
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
Laplacian_eigenpairs laplacian_spectrum(const Loop& loop, const Weighted_graph& laplacian,
                                        const Host_array<double>& mass, int number, Monitor& monitor);

} // namespace CGAL::Spherical_parameterization::internal

#ifdef CGAL_SP_INCLUDE_CORE
#include <CGAL/Spherical_parameterization/internal/spectrum/laplacian_spectrum_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPECTRUM_LAPLACIAN_SPECTRUM_H
