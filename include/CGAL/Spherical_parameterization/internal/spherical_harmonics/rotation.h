// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ROTATION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ROTATION_H

#include <CGAL/Spherical_parameterization/values/Harmonic_analysis.h>
#include <CGAL/Spherical_parameterization/internal/api/compiled.h>

#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// What the degrees 0 and 1 of three functions are.
template <class Loop>
First_order_ellipsoid ellipsoid_of(const Loop& loop, const Harmonic_coefficients& shape);

/// The coefficients of f(R^-1 x). O(L^3) per function.
template <class Loop>
Harmonic_coefficients rotated_harmonics(const Loop& loop, const Harmonic_coefficients& f, const Rotation& rotation);

/// The first degrees of three functions without their constants, turned in space.
CGAL_SP_INLINE Harmonic_coefficients turned_in_space(const Harmonic_coefficients& f, const Rotation& rotation,
                                                     int degree)
{
  Harmonic_coefficients result(degree, 3);
  for(int k = 0; k < 3; ++k)
    for(int j = 0; j < 3; ++j)
      for(int i = 1; i < result.size(); ++i)
        result.field_begin(k)[i] += rotation[k][j] * f.field_begin(j)[i];
  return result;
}

/// A rotation, and what it is worth.
struct Correlation {
  Rotation rotation;
  double value; ///< the integral over the sphere of f(x) g(R^-1 x), summed over the functions, which have the mean 0
};

/// The rotations R for which f and g turned by R are correlated best, the best one first: of all rotations, by their
/// correlation as a trigonometric polynomial of Euler's angles, and Newton's method from its eight largest values on a
/// grid that are some way apart. At least one.
/// \pre as many functions in g as in f; of the larger degree, what the other one has not got is not used
template <class Loop>
std::vector<Correlation> best_correlations(const Loop& loop, const Harmonic_coefficients& f,
                                           const Harmonic_coefficients& g);

/// The best motion of a shape g to a shape f.
/// \pre three functions each, of degree 1 or more; of the larger degree, what the other one has not got is not used
template <class Loop>
Shape_alignment best_motion(const Loop& loop, const Harmonic_coefficients& f, const Harmonic_coefficients& g);

} // namespace CGAL::Spherical_parameterization::internal

#ifdef CGAL_SP_INCLUDE_CORE
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/rotation_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ROTATION_H
