// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ELLIPSOID_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ELLIPSOID_H

#include <CGAL/Spherical_parameterization/values/Harmonic_coefficients.h>
#include <CGAL/Spherical_parameterization/values/Harmonic_results.h>
#include <CGAL/Spherical_parameterization/internal/api/compiled.h>

namespace CGAL::Spherical_parameterization::internal {

/// What the degrees 0 and 1 of three functions are.
template <class Loop>
First_order_ellipsoid ellipsoid_of(const Loop& loop, const Harmonic_coefficients& shape);

} // namespace CGAL::Spherical_parameterization::internal

#ifdef CGAL_SP_INCLUDE_CORE
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/ellipsoid_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ELLIPSOID_H
