// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "solvers.h"

namespace CGAL::Spherical_parameterization::internal {

#ifdef CGAL_LINKED_WITH_TBB
template class Coarse_to_fine_map<Parallel_loop>;
#endif

} // namespace CGAL::Spherical_parameterization::internal
