// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "analysis.h"

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

CGAL_SP_ANALYSIS(Sequential_loop)

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL
