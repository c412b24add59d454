// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "solvers.h"

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

CGAL_SP_SOLVER(template, Saddle_point, CGAL::Sequential_tag)
CGAL_SP_SOLVER(template, Isometric, CGAL::Sequential_tag)
CGAL_SP_FOR_EACH_METHOD(template, CGAL::Sequential_tag)

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL
