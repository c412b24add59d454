// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_SEGMENTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_SEGMENTS_H

#include <CGAL/Spherical_parameterization/internal/base/compiled.h>
#include <CGAL/Spherical_parameterization/internal/base/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/mesh/Mapped_surface.h>
#include <CGAL/Spherical_parameterization/segmentation_methods.h>

#include <vector>

namespace CGAL::Spherical_parameterization {
namespace internal {

/// A segment for every face, by the stretch of the faces. Throws Error for what `make_segmentation_mesh()` refuses, and
/// for a stretch that is not finite.
template <class Loop, class Method>
std::vector<int> segments_of(const Loop& loop, Mapped_surface surface, std::vector<double> stretch,
                             const Method& method);

/// What the compiled library has, after the word `template` or `extern template`.
#define CGAL_SP_SEGMENTATION(PREFIX, LOOP)                                                                             \
  PREFIX std::vector<int> segments_of(const LOOP&, Mapped_surface, std::vector<double>, const Majority_vote&);         \
  PREFIX std::vector<int> segments_of(const LOOP&, Mapped_surface, std::vector<double>, const Girth_profiles&);        \
  PREFIX std::vector<int> segments_of(const LOOP&, Mapped_surface, std::vector<double>, const Region_growing&);

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_COMPILED
CGAL_SP_SEGMENTATION(extern template, Host_loop)
#endif

} // namespace internal

} // namespace CGAL::Spherical_parameterization

#ifdef CGAL_SP_INCLUDE_CORE
#include <CGAL/Spherical_parameterization/internal/segmentation/segments_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_SEGMENTS_H
