// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HARMONIC_ALIGNMENT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_HARMONIC_ALIGNMENT_H

#include <CGAL/Spherical_parameterization/values/Harmonic_coefficients.h>
#include <CGAL/Spherical_parameterization/values/Harmonic_results.h>
#include <CGAL/Spherical_parameterization/values/Rotation.h>
#include <CGAL/Spherical_parameterization/internal/api/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/context/make_monitor.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/ellipsoid.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/rotation.h>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationHarmonics
/// @{

/// The functions turned: f(R^-1 x), by Wigner's matrices.
/// \param coefficients  of the functions f
/// \param rotation      R
/// \param np  see \ref pd_calls
/// \return the coefficients of the turned functions
/// \throws Error  `NON_FINITE_COORDINATE` for coefficients that are not finite, and `INTERRUPTED`
///
/// Complexity: O(L^3); to 1e-12 for any degree.
template <class CGAL_NP_TEMPLATE_PARAMETERS>
Harmonic_coefficients rotated(const Harmonic_coefficients& coefficients, const Rotation& rotation,
                              const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::check_finite(coefficients);
  internal::Monitor monitor = internal::make_monitor(np);
  return internal::rotated_harmonics(internal::Watched_loop(internal::Host_loop(), monitor), coefficients, rotation);
}

/// The first-order ellipsoid. The signs of the axes are chosen so that the shape reaches farther (the integral of the
/// cubes of the coordinates is positive) along the first and the second one: so shapes without symmetry have one
/// ellipsoid, whatever their pose.
/// \param shape  three functions of degree 1 or more
/// \return the ellipsoid
/// \throws Error  `NON_FINITE_COORDINATE` for coefficients that are not finite
CGAL_SP_INLINE First_order_ellipsoid first_order_ellipsoid(const Harmonic_coefficients& shape)
{
  CGAL_SP_PRECONDITION(shape.number_of_fields() == 3 && shape.degree() >= 1,
                       "an ellipsoid needs three functions of degree 1 or more");
  internal::check_finite(shape);
  return internal::ellipsoid_of(internal::Host_loop(), shape);
}

/// A shape in the position of its first-order ellipsoid: centre at the origin, half axes along x, y and z, the largest
/// along x, and the sphere turned so that these are the images of its axes. Shapes in any pose, with any rotation of
/// their maps, become comparable coefficient by coefficient.
/// \param shape  three functions of degree 1 or more
/// \param np  see \ref pd_calls
/// \return the coefficients of the moved shape
/// \throws Error  `NON_FINITE_COORDINATE` for coefficients that are not finite, and `INTERRUPTED`
template <class CGAL_NP_TEMPLATE_PARAMETERS>
Harmonic_coefficients aligned_to_ellipsoid(const Harmonic_coefficients& shape,
                                           const CGAL_NP_CLASS& np = parameters::default_values())
{
  const First_order_ellipsoid ellipsoid = first_order_ellipsoid(shape);
  return rotated(internal::turned_in_space(shape, ellipsoid.axes, shape.degree()), ellipsoid.sphere_axes, np);
}

/// The rotation R for which f and g turned by R (`rotated()`) are correlated best, of all rotations: that of the
/// largest integral of f(x) g(R^-1 x) over the sphere, summed over the functions. Constants (degree 0) do not matter.
///
/// The correlation is a trigonometric polynomial in Euler's angles, and so is known everywhere by Fourier transforms
/// (B. Kovacs, W. Wriggers, "Fast rotational matching", 2002; P. Kostelec, D. Rockmore, "FFTs on the rotation group",
/// 2008); Newton's method starts from the eight largest of its local maxima on a grid as fine as the degree asks for.
/// \param f,g     as many functions in each; of the larger degree, what the other one has not got does not count
/// \param policy,np  see \ref pd_calls
/// \return R, to 1e-10 radians where the maximum is sharp
/// \throws Error  `NON_FINITE_COORDINATE` for coefficients that are not finite, and `INTERRUPTED`
/// \pre as many functions in f as in g
///
/// Complexity: O(L^4); 25 ms for three functions of degree 31 on one core.
template <class ExecutionPolicy, class CGAL_NP_TEMPLATE_PARAMETERS, internal::If_policy<ExecutionPolicy> = 0>
Rotation best_rotation(const ExecutionPolicy& policy, const Harmonic_coefficients& f, const Harmonic_coefficients& g,
                       const CGAL_NP_CLASS& np = parameters::default_values())
{
  CGAL_SP_PRECONDITION(f.number_of_fields() == g.number_of_fields() && f.degree() >= 0 && g.degree() >= 0,
                       "functions to be correlated are as many on each side");
  internal::check_finite(f);
  internal::check_finite(g);
  internal::Monitor monitor = internal::make_monitor(np);
  return internal::best_correlations(internal::Watched_loop(internal::host_loop(policy), monitor), f, g)
    .front()
    .rotation;
}
CGAL_SP_ON_ONE_CORE(best_rotation)

/// Registration of two shapes in any pose, with maps in any position: the rotations of space and of the sphere for
/// which they are correlated best. Where the shapes are, and their sizes, does not matter.
///
/// From the 24 ways to put the axes of the first-order ellipsoids onto each other the best rotation of the sphere, of
/// all (`best_rotation()`), and the best one of space (B. Horn, 1987) by turns: up to degree 4, the best of them up to
/// degree 8, and the best of these with all degrees, near what has been found. Shapes without symmetry, whose first
/// degrees are not too much alike, are brought together wherever they came from; a proof that no other motion is better
/// there is not.
/// \param f,g     three functions each; of the larger degree, what the other one has not got does not count
/// \param policy,np  see \ref pd_calls
/// \return the rotations and the correlation
/// \throws Error  `NON_FINITE_COORDINATE` for coefficients that are not finite, and `INTERRUPTED`
/// \pre three functions of degree 1 or more in both
///
/// Complexity: O(L^3) per step; 50 to 70 ms for degree 31 on one core.
template <class ExecutionPolicy, class CGAL_NP_TEMPLATE_PARAMETERS, internal::If_policy<ExecutionPolicy> = 0>
Shape_alignment best_alignment(const ExecutionPolicy& policy, const Harmonic_coefficients& f,
                               const Harmonic_coefficients& g, const CGAL_NP_CLASS& np = parameters::default_values())
{
  CGAL_SP_PRECONDITION(f.number_of_fields() == 3 && g.number_of_fields() == 3 && f.degree() >= 1 && g.degree() >= 1,
                       "shapes to be aligned are three functions each, of degree 1 or more");
  internal::check_finite(f);
  internal::check_finite(g);
  internal::Monitor monitor = internal::make_monitor(np);
  return internal::best_motion(internal::Watched_loop(internal::host_loop(policy), monitor), f, g);
}
CGAL_SP_ON_ONE_CORE(best_alignment)

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HARMONIC_ALIGNMENT_H
