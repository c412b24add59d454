// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "solvers.h"

namespace CGAL::Spherical_parameterization::internal {

template class Coarse_to_fine_map<Host_loop>;

} // namespace CGAL::Spherical_parameterization::internal
