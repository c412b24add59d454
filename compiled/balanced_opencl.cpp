// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "solvers.h"

namespace CGAL::Spherical_parameterization::internal {

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
CGAL_SP_BALANCED(template, OpenCL_backend<Host_loop>)
#endif

} // namespace CGAL::Spherical_parameterization::internal
