// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ANALYSIS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ANALYSIS_H

#include <CGAL/Spherical_parameterization/values/Harmonic_analysis.h>
#include <CGAL/Spherical_parameterization/internal/algebra/point_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/predicates/orientation.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/grids.h>
#include <CGAL/Spherical_parameterization/internal/surface/Mapped_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace CGAL::Spherical_parameterization::internal {

/// Functions on the sphere at some points: field after field.
struct Sampled_fields {
  int number_of_fields = 0;
  Host_array<double> value;
};

/// The coordinates of points as three functions.
inline Sampled_fields coordinate_fields(const Host_array<vec3>& points)
{
  const std::size_t n = points.size();
  Sampled_fields fields = {3, Host_array<double>(3 * n)};
  for(std::size_t i = 0; i < n; ++i) {
    fields.value[i] = points[i].x;
    fields.value[n + i] = points[i].y;
    fields.value[2 * n + i] = points[i].z;
  }
  return fields;
}

/// Scales numbers by a power of two, which changes no digit, to where their squares neither overflow nor vanish.
/// Returns its exponent.
CGAL_SP_INLINE int scale_to_one(double* begin, double* end)
{
  double largest = 0;
  for(const double* x = begin; x != end; ++x)
    largest = (std::max)(largest, std::abs(*x));
  const int exponent = largest > 0 ? std::ilogb(largest) : 0;
  for(double* x = begin; x != end; ++x)
    *x = std::ldexp(*x, -exponent);
  return exponent;
}

/// Throws Error for what is not finite, and directions of length 0.
CGAL_SP_INLINE void check_directions(Host_array<vec3>& directions)
{
  constexpr double harmless = 1e100; // lengths beyond have squares that overflow or vanish
  for(std::size_t i = 0; i < directions.size(); ++i) {
    vec3& d = directions[i];
    const double largest = (std::max)({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    if(!is_finite(d) || largest == 0)
      throw Input_error(Error_code::NON_FINITE_COORDINATE, "no direction at vertex " + std::to_string(i));
    if(largest > harmless || largest < 1 / harmless)
      d = scaled_to_unit_box(d);
  }
}

/// Whether the points of the source have to be there.
inline bool needs_points(const Least_squares& method) { return method.weights == Vertex_weights::SURFACE_AREA; }
inline bool needs_points(const Integration&) { return false; }

/// Of data of the vertices: least squares. Throws Error for a map that is not valid, and for what is not finite.
template <class Loop>
Harmonic_analysis analyze_vertices(const Loop& loop, Mapped_surface map, Sampled_fields fields, int degree,
                                   const Least_squares& method);

/// Integrals over the faces of the sphere of fields that are linear on them. Throws Error as above.
template <class Loop>
Harmonic_analysis analyze_vertices(const Loop& loop, Mapped_surface map, Sampled_fields fields, int degree,
                                   const Integration& method);

/// The values of the functions: direction after direction. \param directions  of any length but 0
template <class Loop>
Host_array<double> evaluate_harmonics(const Loop& loop, const Harmonic_coefficients& coefficients,
                                      const Host_array<vec3>& directions);

/// The functions on a grid: field after field, row after row.
template <class Loop>
Host_array<double> synthesize_on_rows(const Loop& loop, const Harmonic_coefficients& coefficients,
                                      const Latitude_rows& grid);

/// The quadrature of the grid.
template <class Loop>
Harmonic_coefficients analyze_rows(const Loop& loop, const Latitude_rows& grid, const Sampled_fields& fields,
                                   int degree);

} // namespace CGAL::Spherical_parameterization::internal

#ifdef CGAL_SP_INCLUDE_CORE
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/analysis_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ANALYSIS_H
