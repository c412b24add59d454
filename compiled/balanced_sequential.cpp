// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "solvers.h"

namespace CGAL::Spherical_parameterization::internal {

CGAL_SP_SOLVER(template, Balanced, CGAL::Sequential_tag)

} // namespace CGAL::Spherical_parameterization::internal
