// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

// Eigenfunctions of the Laplacian.
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/spectrum/laplacian_spectrum.h>

namespace CGAL::Spherical_parameterization::internal {

template Laplacian_eigenpairs laplacian_spectrum(const Host_loop&, const Weighted_graph&, const Host_array<double>&,
                                                 int, Monitor&);

} // namespace CGAL::Spherical_parameterization::internal
