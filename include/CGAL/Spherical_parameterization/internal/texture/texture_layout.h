// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_TEXTURE_TEXTURE_LAYOUT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_TEXTURE_TEXTURE_LAYOUT_H

#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/surface/Mapped_surface.h>
#include <CGAL/Spherical_parameterization/values/texture_options.h>

#include <array>
#include <cmath>

namespace CGAL::Spherical_parameterization::internal {

/// A point or vector of the plane.
struct vec2 {
  double x, y;
};
inline vec2 add(vec2 a, vec2 b) { return {a.x + b.x, a.y + b.y}; }
inline vec2 sub(vec2 a, vec2 b) { return {a.x - b.x, a.y - b.y}; }
inline vec2 scale(double s, vec2 a) { return {s * a.x, s * a.y}; }
inline double inner(vec2 a, vec2 b) { return a.x * b.x + a.y * b.y; }
inline double distance(vec2 a, vec2 b) { return std::hypot(a.x - b.x, a.y - b.y); }

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
