// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SIGNATURE_SIGNATURE_VALUES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SIGNATURE_SIGNATURE_VALUES_H

#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/surface/Mapped_surface.h>

#include <array>
#include <cstddef>

namespace CGAL::Spherical_parameterization::internal {

/// Of what the coordinates of a signature are, in their order.
struct Signature_sizes {
  static constexpr std::size_t coarse_bins = 16;
  static constexpr std::size_t fine_bins = 64;
  static constexpr std::size_t limbs = 8; ///< a length and a mass each
  static constexpr std::size_t all = coarse_bins + fine_bins + 2 * limbs;
};
typedef std::array<double, Signature_sizes::all> Signature_values;

/// The signature of a shape by a map that need not be valid. Throws Error for a surface or a map without area.
template <class Loop>
Signature_values signature_values(const Loop& loop, const Mapped_surface& map);

} // namespace CGAL::Spherical_parameterization::internal

#ifdef CGAL_SP_INCLUDE_CORE
#include <CGAL/Spherical_parameterization/internal/signature/signature_values_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SIGNATURE_SIGNATURE_VALUES_H
