// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

// What is done with a map, as far as it does not depend on the type of the mesh: segments, signatures, textures.
#include <CGAL/Spherical_parameterization/internal/segmentation/segments.h>
#include <CGAL/Spherical_parameterization/internal/signature/signature_values.h>
#include <CGAL/Spherical_parameterization/internal/texture/texture_layout.h>
#include <CGAL/Spherical_parameterization/values/segmentation_methods.h>

namespace CGAL::Spherical_parameterization::internal {

typedef Watched_loop<Host_loop> Loop;

template std::vector<int> segments_of(const Loop&, Mapped_surface, std::vector<double>, const Majority_vote&);
template std::vector<int> segments_of(const Loop&, Mapped_surface, std::vector<double>, const Girth_profiles&);
template std::vector<int> segments_of(const Loop&, Mapped_surface, std::vector<double>, const Region_growing&);
template Signature_values signature_values(const Loop&, const Mapped_surface&);
template Texture_layout texture_layout(const Loop&, const Valid_map&, const Texture_options&);

} // namespace CGAL::Spherical_parameterization::internal
