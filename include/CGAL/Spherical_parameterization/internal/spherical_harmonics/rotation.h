// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ROTATION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ROTATION_H

#include <CGAL/Spherical_parameterization/values/Harmonic_coefficients.h>
#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/algebra/rotations.h>

#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The coefficients of f(R^-1 x). O(L^3) per function.
Harmonic_coefficients rotated_harmonics(const Harmonic_coefficients& f, const Matrix_3& rotation);

/// A rotation, and what it is worth.
struct Correlation {
  Matrix_3 rotation;
  double value; ///< the integral over the sphere of f(x) g(R^-1 x), summed over the functions
};

/// The rotations R for which f and g turned by R are correlated best, the best one first: of all rotations, by their
/// correlation as a trigonometric polynomial of Euler's angles, and Newton's method from its eight largest values on a
/// grid that are some way apart. At least one.
/// \pre as many functions in g as in f; of the larger degree, what the other one has not got is not used
template <class Loop>
std::vector<Correlation> best_correlations(const Loop& loop, const Harmonic_coefficients& f,
                                           const Harmonic_coefficients& g);

/// Rotations of space and of the sphere, and what they are worth.
struct Motion {
  Matrix_3 space, sphere;
  double
    value; ///< the integral over the sphere of the inner product of f(x) and space g(sphere^-1 x), without degree 0
};

/// The best motion of a shape g to a shape f.
/// \pre three functions each, of the same degree, 1 or more
template <class Loop>
Motion best_motion(const Loop& loop, const Harmonic_coefficients& f, const Harmonic_coefficients& g);

} // namespace CGAL::Spherical_parameterization::internal

#ifdef CGAL_SP_INCLUDE_CORE
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/rotation_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ROTATION_H
