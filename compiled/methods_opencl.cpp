// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "solvers.h"

namespace CGAL::Spherical_parameterization::internal {

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
CGAL_SP_FOR_EACH_METHOD(template, OpenCL_device)
#endif

} // namespace CGAL::Spherical_parameterization::internal
