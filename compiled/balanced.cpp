// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "solvers.h"

namespace CGAL::Spherical_parameterization::internal {

CGAL_SP_BALANCED(template, Host_backend<Host_loop>)

} // namespace CGAL::Spherical_parameterization::internal
