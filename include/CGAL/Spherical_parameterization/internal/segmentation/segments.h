// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_SEGMENTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_SEGMENTS_H

#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/surface/Mapped_surface.h>

#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// A segment for every face, by the stretch of the faces. Throws Error for what `Segmentation_mesh` refuses, for a
/// stretch that is not finite, and when it has to end.
template <class Method>
std::vector<int> segments_of(const Watched_loop<Host_loop>& loop, Mapped_surface surface, std::vector<double> stretch,
                             const Method& method);

} // namespace CGAL::Spherical_parameterization::internal

#ifdef CGAL_SP_INCLUDE_CORE
#include <CGAL/Spherical_parameterization/internal/segmentation/segments_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_SEGMENTS_H
