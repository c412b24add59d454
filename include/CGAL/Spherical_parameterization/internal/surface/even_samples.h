// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_EVEN_SAMPLES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_EVEN_SAMPLES_H

#include <cmath>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The faces at `count` places, which are spread evenly over the area, in the order of the faces.
/// \param total  the sum of the areas, positive
template <class Areas>
std::vector<int> faces_at_even_areas(const Areas& area, double total, int count)
{
  const int last = static_cast<int>(area.size()) - 1;
  std::vector<int> faces;
  faces.reserve(count);
  double before = 0; // the area of the faces before this one
  int face = 0;
  for(int i = 0; i < count; ++i) {
    const double at = (i + 0.5) / count * total;
    for(; before + area[face] < at && face < last; ++face)
      before += area[face];
    faces.push_back(face);
  }
  return faces;
}

/// Member i of a sequence that fills the unit interval evenly, and with other steps the unit square or cube: M.
/// Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018. \param step  a power of the inverse of the
/// root of x^(d + 1) = x + 1, for d dimensions
inline double quasirandom(int i, double step)
{
  const double x = (i + 1) * step;
  return x - std::floor(x);
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_EVEN_SAMPLES_H
