// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

// What is done with a map, as far as it does not depend on the type of the mesh: segments, signatures, textures.
#ifndef CGAL_SPHERICAL_PARAMETERIZATION_COMPILED_ANALYSIS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_COMPILED_ANALYSIS_H

#include <CGAL/Spherical_parameterization/internal/segmentation/segments.h>
#include <CGAL/Spherical_parameterization/internal/signature/signature_values.h>
#include <CGAL/Spherical_parameterization/internal/texture/texture_layout.h>

#define CGAL_SP_ANALYSIS(LOOP)                                                                                         \
  CGAL_SP_SEGMENTATION(template, LOOP)                                                                                 \
  template Signature_values signature_values(const LOOP&, const Mapped_surface&);                                      \
  template Texture_layout texture_layout(const LOOP&, const Mapped_faces&, const Vertex_stars&, const Texture_options&);

#endif // CGAL_SPHERICAL_PARAMETERIZATION_COMPILED_ANALYSIS_H
