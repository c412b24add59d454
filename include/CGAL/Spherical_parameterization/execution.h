// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EXECUTION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EXECUTION_H

#include <CGAL/tags.h>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

/// Where the solvers run. An execution policy is a value that answers "where": each supported policy `P` has a
/// specialisation `Backend<P>`, the only place that knows how loops are run there. `Backend<P>::matrix`, `.array` and
/// the verbs (one loop each over a formula of vertex_formulas.h) are all that a solver sees.
///
/// There is a backend for
/// - `CGAL::Sequential_tag`: one core (internal/Host_backend.h).
template <class ExecutionPolicy>
class Backend;

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EXECUTION_H
