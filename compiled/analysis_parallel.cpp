// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "analysis.h"

namespace CGAL::Spherical_parameterization::internal {

#ifdef CGAL_LINKED_WITH_TBB
CGAL_SP_ANALYSIS(Parallel_loop)
#endif

} // namespace CGAL::Spherical_parameterization::internal
