// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_TEXTURE_TEXTURE_LAYOUT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_TEXTURE_TEXTURE_LAYOUT_H

#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/surface/Mapped_surface.h>
#include <CGAL/Spherical_parameterization/internal/texture/texture_charts.h>
#include <CGAL/Spherical_parameterization/values/texture_options.h>

#include <array>

namespace CGAL::Spherical_parameterization::internal {

/// What is to be put into the texture.
struct Texture_layout {
  Host_array<std::array<vec2, 3>> uv; ///< of the corners of the faces
  Texture_report report;
};

/// \param map  with points, where the poles are to be chosen
template <class Loop>
Texture_layout texture_layout(const Loop& loop, const Valid_map& map, const Texture_options& options);

} // namespace CGAL::Spherical_parameterization::internal

#ifdef CGAL_SP_INCLUDE_CORE
#include <CGAL/Spherical_parameterization/internal/texture/texture_layout_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_TEXTURE_TEXTURE_LAYOUT_H
