// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "solvers.h"

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

template class Coarse_to_fine_map<Sequential_loop>;

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL
