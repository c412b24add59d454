// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

// What is done with a map, as far as it does not depend on the type of the mesh: segments, signatures, textures.
#include <CGAL/Spherical_parameterization/internal/base/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/segmentation/segments.h>
#include <CGAL/Spherical_parameterization/internal/signature/signature_values.h>
#include <CGAL/Spherical_parameterization/internal/texture/texture_layout.h>
#include <CGAL/Spherical_parameterization/segmentation_methods.h>

#define CGAL_SP_SEGMENTS(LOOP, METHOD)                                                                                 \
  template std::vector<int> segments_of(const LOOP&, Mapped_surface, std::vector<double>, const METHOD&);
#define CGAL_SP_ANALYSIS(LOOP)                                                                                         \
  CGAL_SP_SEGMENTS(LOOP, Majority_vote)                                                                                \
  CGAL_SP_SEGMENTS(LOOP, Girth_profiles)                                                                               \
  CGAL_SP_SEGMENTS(LOOP, Region_growing)                                                                               \
  template Signature_values signature_values(const LOOP&, const Mapped_surface&);                                      \
  template Texture_layout texture_layout(const LOOP&, const Mapped_faces&, const Vertex_stars&, const Texture_options&);

namespace CGAL::Spherical_parameterization::internal {

CGAL_SP_ANALYSIS(Sequential_loop)
#ifdef CGAL_LINKED_WITH_TBB
CGAL_SP_ANALYSIS(Parallel_loop)
#endif

} // namespace CGAL::Spherical_parameterization::internal
