// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

// What takes the compiler long is compiled in a file of its own, and only there.
#pragma once

#include <CGAL/Spherical_parameterization/internal/backend/Host_backend.h>
#include <CGAL/Spherical_parameterization/internal/driver/solve.h>
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
#include <CGAL/Spherical_parameterization/OpenCL_device.h>
#endif

/// The balanced method, and the start map that other methods take of it.
#define CGAL_SP_BALANCED(PREFIX, BACKEND)                                                                              \
  PREFIX Solution Method_solver<Balanced>::solve(const BACKEND&, const Problem&, const Effort&, Monitor&) const;       \
  PREFIX Host_array<vec3> start_positions(const BACKEND&, const Problem&, Monitor&, std::size_t&);

namespace CGAL::Spherical_parameterization::internal {

CGAL_SP_BALANCED(extern template, Host_backend<Host_loop>)
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
CGAL_SP_BALANCED(extern template, OpenCL_backend<Host_loop>)
#endif

} // namespace CGAL::Spherical_parameterization::internal
