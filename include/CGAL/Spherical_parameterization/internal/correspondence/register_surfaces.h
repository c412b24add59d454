// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_REGISTER_SURFACES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_REGISTER_SURFACES_H

#include <CGAL/Spherical_parameterization/values/Registration.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/context/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/refine.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/surface/Mapped_surface.h>

#include <functional>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Writes images of the vertices of A, and returns what is stored then.
typedef std::function<Host_array<vec3>(const Host_array<vec3>&)> Store;

/// Throws the precondition for weights and limits that are none.
CGAL_SP_CORE void check_registration(const Registration& settings);

/// For the registration: in units in which its area is 4 pi, with its centre at the origin. Throws Error for a surface
/// without area, and for images that rounding to unit vectors flips.
CGAL_SP_CORE Registered_surface registered_surface(const Host_loop& loop, const Valid_map& map);

/// Registers the surface a with b: see `register_maps()`. All but the whole time is in the result. Throws Error if one
/// of them cannot be registered. \param landmarks  vertices of a and of b
CGAL_SP_CORE Registration_result register_surfaces(const Host_loop& loop, const Valid_map& a, const Valid_map& b,
                                                   const std::vector<std::pair<int, int>>& landmarks,
                                                   const Registration& settings, Monitor& monitor, const Store& store);

} // namespace CGAL::Spherical_parameterization::internal

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_COMPILED
#include <CGAL/Spherical_parameterization/internal/correspondence/register_surfaces_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_REGISTER_SURFACES_H
