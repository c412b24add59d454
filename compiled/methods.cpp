// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "solvers.h"

namespace CGAL::Spherical_parameterization::internal {

CGAL_SP_FOR_EACH_METHOD(template, CGAL::Sequential_tag)
#ifdef CGAL_LINKED_WITH_TBB
CGAL_SP_FOR_EACH_METHOD(template, CGAL::Parallel_tag)
#endif

} // namespace CGAL::Spherical_parameterization::internal
