// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "solvers.h"

namespace CGAL::Spherical_parameterization::internal {

CGAL_SP_SOLVER(template, Saddle_point, CGAL::Sequential_tag)
CGAL_SP_FOR_EACH_METHOD(template, CGAL::Sequential_tag)

} // namespace CGAL::Spherical_parameterization::internal
