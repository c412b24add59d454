// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_COMPLEX_HARMONICS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_COMPLEX_HARMONICS_H

#include <CGAL/Spherical_parameterization/internal/api/compiled.h>

#include <CGAL/Spherical_parameterization/values/Harmonic_coefficients.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Coefficients in the complex harmonics of quantum mechanics (with the Condon-Shortley phase), in which rotations are
/// simple. Those of -m are (-1)^m times the conjugates of those of m, since functions are real; all are there.
class Complex_harmonics {
public:
  typedef std::complex<double> Complex;

  explicit Complex_harmonics(const Harmonic_coefficients& c)
    : degree_(c.degree()), fields_(c.number_of_fields()), value_(c.values().size())
  {
    for(int field = 0; field < fields_; ++field)
      for(int l = 0; l <= degree_; ++l) {
        (*this)(l, 0, field) = c(l, 0, field);
        for(int m = 1; m <= l; ++m) {
          const Complex z = Complex(c(l, m, field), -c(l, -m, field)) * std::sqrt(0.5);
          (*this)(l, m, field) = m % 2 == 0 ? z : -z;
          (*this)(l, -m, field) = std::conj(z);
        }
      }
  }

  int degree() const { return degree_; }
  int number_of_fields() const { return fields_; }
  Complex& operator()(int l, int m, int field) { return value_[at(l, m, field)]; }
  const Complex& operator()(int l, int m, int field) const { return value_[at(l, m, field)]; }

  Harmonic_coefficients real() const
  {
    Harmonic_coefficients c(degree_, fields_);
    for(int field = 0; field < fields_; ++field)
      for(int l = 0; l <= degree_; ++l) {
        c(l, 0, field) = (*this)(l, 0, field).real();
        for(int m = 1; m <= l; ++m) {
          const Complex z = (m % 2 == 0 ? 1 : -1) * std::sqrt(2.) * (*this)(l, m, field);
          c(l, m, field) = z.real();
          c(l, -m, field) = -z.imag();
        }
      }
    return c;
  }

private:
  std::size_t at(int l, int m, int field) const
  {
    return static_cast<std::size_t>(field) * (degree_ + 1) * (degree_ + 1) + Harmonic_coefficients::index(l, m);
  }

  int degree_, fields_;
  std::vector<Complex> value_;
};

/// The sum over all coefficients of conj(f) g: the integral over the sphere of the product.
CGAL_SP_INLINE double inner(const Complex_harmonics& f, const Complex_harmonics& g)
{
  double sum = 0;
  for(int field = 0; field < f.number_of_fields(); ++field)
    for(int l = 0; l <= f.degree(); ++l) {
      sum += f(l, 0, field).real() * g(l, 0, field).real();
      for(int m = 1; m <= l; ++m)
        sum += 2 * (std::conj(f(l, m, field)) * g(l, m, field)).real();
    }
  return sum;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_COMPLEX_HARMONICS_H
