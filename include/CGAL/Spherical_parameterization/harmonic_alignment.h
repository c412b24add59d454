// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HARMONIC_ALIGNMENT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_HARMONIC_ALIGNMENT_H

#include <CGAL/Spherical_parameterization/values/Harmonic_analysis.h>
#include <CGAL/Spherical_parameterization/internal/api/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/context/make_monitor.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/rotation.h>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationHarmonics
/// @{

/// The rotated functions f(R^-1 x), by Wigner's matrices.
/// \param coefficients  of the functions f
/// \param rotation      R
/// \param np  see \ref pd_calls
/// \return the coefficients of the rotated functions
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

/// The first-order ellipsoid. The signs of the first two axes are chosen such that the shape reaches farther in their
/// directions (the integral of the cubes of the coordinates is positive). So the ellipsoid of a shape without symmetry
/// is unique, whatever its pose.
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

/// Moves a shape to the position of its first-order ellipsoid: the centre is at the origin, the half axes are along x,
/// y and z, the largest along x, and the sphere is rotated so that its axes are mapped to them. Then shapes in any
/// position, with any rotation of their maps, can be compared coefficient by coefficient.
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

/// The rotation R with the largest correlation of f and the rotated g (`rotated()`): it maximizes the integral of f(x)
/// g(R^-1 x) over the sphere, summed over the functions, over all rotations. Constants (degree 0) have no influence.
///
/// The correlation is a trigonometric polynomial in the Euler angles, which Fourier transforms evaluate on a grid (B.
/// Kovacs, W. Wriggers, "Fast rotational matching", 2002; P. Kostelec, D. Rockmore, "FFTs on the rotation group",
/// 2008); Newton's method starts from the eight largest local maxima on a grid that is fine enough for the degree.
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

/// Registration of two shapes with any orientation in space, and with maps in any position: the rotations of space and
/// of the sphere with the largest correlation. Position and size have no influence.
///
/// It starts from each of the 24 ways to match the axes of the first-order ellipsoids, and alternates between the best
/// rotation of the sphere (`best_rotation()`) and the best rotation of space (B. Horn, 1987): first up to degree 4,
/// then the best results up to degree 8, and the best of these with all degrees, near the rotation found. Shapes
/// without symmetry whose low degrees differ are aligned from any position. There is no proof that no other motion is
/// better.
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
