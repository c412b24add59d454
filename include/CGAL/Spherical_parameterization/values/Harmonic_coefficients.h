// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_VALUES_HARMONIC_COEFFICIENTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_VALUES_HARMONIC_COEFFICIENTS_H

#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationHarmonics
/// @{

/// The largest degree of spherical harmonics.
constexpr int largest_harmonic_degree = 16383;

/// The coefficients of functions on the sphere (one, or more of the same degree: the coordinates of a shape are three)
/// in real orthonormal spherical harmonics:
///
///     f(x) = sum of c(l, m) Y(l, m)(x)  over  0 <= l <= degree,  -l <= m <= l
///
///     Y(l, m) = N(l, |m|) P(l, |m|)(cos theta) T(m)(phi)
///     T(m)(phi) = sqrt 2 sin(|m| phi) for m < 0,  1 for m = 0,  sqrt 2 cos(m phi) for m > 0
///     N(l, m)^2 = (2 l + 1) / (4 pi) (l - m)! / (l + m)!
///
/// with x = (sin theta cos phi, sin theta sin phi, cos theta) and the associated Legendre functions P *without* the
/// Condon-Shortley phase (-1)^m. The integral of Y(l, m) Y(k, n) over the unit sphere is 1 or 0, and
/// Y(1, -1), Y(1, 0), Y(1, 1) are sqrt(3 / (4 pi)) times y, z, x.
///
/// In other programs:
/// - pyshtools with `normalization="ortho", csphase=1`: `coeffs[0, l, m]` is c(l, m), `coeffs[1, l, m]` is c(l, -m).
///   With its default, `"4pi"`, divide by sqrt(4 pi).
/// - SPHARM-PDM: `write_coefficients()` with `Coefficient_format::SPHARM_PDM`. Its functions have the phase, and no
///   sqrt 2.
/// - `scipy.special.sph_harm`, complex, with the phase: Y(l, m) is sqrt 2 (-1)^m times its real part for m > 0,
///   sqrt 2 (-1)^m times the imaginary part of that of |m| for m < 0.
class Harmonic_coefficients {
public:
  /// No functions.
  Harmonic_coefficients() = default;

  /// All zero.
  /// \param degree            0 to `largest_harmonic_degree`
  /// \param number_of_fields  the number of functions
  explicit Harmonic_coefficients(int degree, int number_of_fields = 1)
    : degree_(checked(degree)), fields_(number_of_fields)
  {
    CGAL_SP_PRECONDITION(number_of_fields >= 0, "the number of functions must not be negative");
    values_.resize(static_cast<std::size_t>(fields_) * static_cast<std::size_t>(size()));
  }

  int degree() const { return degree_; }                     ///< \return the largest l, or -1
  int number_of_fields() const { return fields_; }           ///< \return the number of functions
  int size() const { return (degree_ + 1) * (degree_ + 1); } ///< \return the number of coefficients of a function

  /// \param l  0 or more
  /// \param m  -l to l
  /// \return where c(l, m) is in a function's range
  static int index(int l, int m) { return l * l + l + m; }

  /// \param l      0 to `degree()`
  /// \param m      -l to l
  /// \param field  the number of the function
  /// \return c(l, m)
  double operator()(int l, int m, int field = 0) const { return field_begin(field)[index(l, m)]; }
  /// \copydoc operator()(int,int,int)const
  double& operator()(int l, int m, int field = 0) { return field_begin(field)[index(l, m)]; }

  /// \param field  the number of the function
  /// \return its first coefficient; all `size()` of them follow each other, in the order of `index()`
  const double* field_begin(int field) const { return values_.data() + static_cast<std::ptrdiff_t>(field) * size(); }
  /// \copydoc field_begin(int)const
  double* field_begin(int field) { return values_.data() + static_cast<std::ptrdiff_t>(field) * size(); }

  /// \return all coefficients, function after function
  const std::vector<double>& values() const { return values_; }
  /// \copydoc values()const
  std::vector<double>& values() { return values_; }

private:
  static int checked(int degree)
  {
    CGAL_SP_PRECONDITION(degree >= 0 && degree <= largest_harmonic_degree,
                         "the degree of spherical harmonics is 0 to 16383");
    return degree;
  }

  int degree_ = -1;
  int fields_ = 0;
  std::vector<double> values_;
};

/// \name What Coefficients Say
/// @{

/// The power of every degree: the sum of the squares of its coefficients over all functions. It is invariant to
/// rotations of the sphere and of the shape in space. The total power is the integral of the squares (Parseval).
/// \param coefficients  of the functions
/// \return for l = 0 ... degree
inline std::vector<double> power_spectrum(const Harmonic_coefficients& coefficients)
{
  std::vector<double> power(coefficients.degree() + 1, 0);
  for(int field = 0; field < coefficients.number_of_fields(); ++field)
    for(int l = 0; l <= coefficients.degree(); ++l)
      for(int m = -l; m <= l; ++m)
        power[l] += coefficients(l, m, field) * coefficients(l, m, field);
  return power;
}

/// The coefficients multiplied by a factor for every degree. Decreasing factors smooth the functions: exp(-t l (l + 1))
/// is the heat flow of time t. Factors above 1 sharpen them.
/// \param coefficients  of the functions
/// \param factor        called with the degree l
/// \return the coefficients of the filtered functions
template <class Factor>
Harmonic_coefficients filtered(Harmonic_coefficients coefficients, Factor factor)
{
  for(int l = 0; l <= coefficients.degree(); ++l) {
    const double f = factor(l);
    for(int field = 0; field < coefficients.number_of_fields(); ++field)
      for(int m = -l; m <= l; ++m)
        coefficients(l, m, field) *= f;
  }
  return coefficients;
}

/// The same functions with a smaller degree (a low-pass filter), or with a larger one and zeros.
/// \param coefficients  of the functions
/// \param degree        0 to `largest_harmonic_degree`
/// \return the coefficients
inline Harmonic_coefficients with_degree(const Harmonic_coefficients& coefficients, int degree)
{
  Harmonic_coefficients result(degree, coefficients.number_of_fields());
  for(int field = 0; field < result.number_of_fields(); ++field)
    std::copy_n(coefficients.field_begin(field), (std::min)(result.size(), coefficients.size()),
                result.field_begin(field));
  return result;
}

/// The mirror image in the plane z = 0. The map is mirrored, too, so that no face is flipped. To compare left with
/// right shapes, call `best_alignment()` also with the mirror image.
/// \param shape  three functions
/// \return the coefficients of the mirror image
inline Harmonic_coefficients mirrored(Harmonic_coefficients shape)
{
  CGAL_SP_PRECONDITION(shape.number_of_fields() == 3, "a shape is three functions");
  for(int field = 0; field < 3; ++field)
    for(int l = 0; l <= shape.degree(); ++l)
      for(int m = -l; m <= l; ++m)
        if(((l + m) % 2 != 0) != (field == 2))
          shape(l, m, field) *= -1;
  return shape;
}

/// @}

/// \cond SKIP_IN_MANUAL
namespace internal {

/// Throws Error for a coefficient that is not finite. \param whose  ends the sentence
inline void check_finite(const Harmonic_coefficients& c, const std::string& whose = "")
{
  for(int field = 0; field < c.number_of_fields(); ++field)
    for(int l = 0; l <= c.degree(); ++l)
      for(int m = -l; m <= l; ++m)
        if(!std::isfinite(c(l, m, field)))
          throw Input_error(Error_code::NON_FINITE_COORDINATE, "the coefficient of l = " + std::to_string(l) +
                                                                 ", m = " + std::to_string(m) + " of function " +
                                                                 std::to_string(field) + whose);
}

} // namespace internal
/// \endcond

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_VALUES_HARMONIC_COEFFICIENTS_H
