// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "analysis.h"

namespace CGAL::Spherical_parameterization::internal {

CGAL_SP_ANALYSIS(Sequential_loop)

} // namespace CGAL::Spherical_parameterization::internal
