// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

// Statistics of shapes.
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/statistics/principal_components.h>
#include <CGAL/Spherical_parameterization/internal/statistics/procrustes.h>

namespace CGAL::Spherical_parameterization::internal {

typedef Watched_loop<Host_loop> Loop;

template Procrustes_alignment superimpose(const Loop&, const Shape_set<double>&, const Procrustes&);
template Principal_components principal_components(const Loop&, const Shape_set<const double>&);
template void write_components(const Loop&, const Shape_set<const double>&, const Principal_components&,
                               const Shape_set<double>&);
template std::vector<double> errors_of_left_out(const Loop&, const Shape_set<const double>&, int);

} // namespace CGAL::Spherical_parameterization::internal
