// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_COMPLEX_HARMONICS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_COMPLEX_HARMONICS_H

#include <CGAL/Spherical_parameterization/internal/algebra/rotations.h>
#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/values/Harmonic_coefficients.h>

#include <algorithm>
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

/// Wigner's matrix of a degree for the turn by 90 degrees about y, from which those of all rotations follow: real, and
/// d(l, m, k) for -l <= m, k <= l.
///
/// From one degree to the next by two steps of half a degree, which is stable for any degree (T. Risbo, "Fourier
/// transform summation of Legendre series and D-functions", J. Geodesy 70, 1996). O(l^2).
class Quarter_turn {
public:
  /// Of degree 0.
  Quarter_turn() : value_(1, 1) {}

  int degree() const { return twice_ / 2; }
  double operator()(int m, int k) const
  {
    const int l = degree();
    return value_[static_cast<std::size_t>(m + l) * (2 * l + 1) + (k + l)];
  }

  /// The matrix of the next degree.
  void advance()
  {
    half_step();
    half_step();
  }

private:
  void half_step()
  {
    const int n = ++twice_; // the new matrix has n + 1 rows
    std::vector<double> next(static_cast<std::size_t>(n + 1) * (n + 1), 0);
    std::vector<double> root(n + 1);
    for(int i = 0; i <= n; ++i)
      root[i] = std::sqrt(static_cast<double>(i));
    const double factor = std::sqrt(0.5) / n;
    for(int i = 0; i < n; ++i) {
      const double* const old = value_.data() + static_cast<std::size_t>(i) * n;
      double* const above = next.data() + static_cast<std::size_t>(i) * (n + 1);
      double* const below = above + n + 1;
      for(int k = 0; k < n; ++k) {
        const double left = factor * root[n - k] * old[k], right = factor * root[k + 1] * old[k];
        above[k] += root[n - i] * left;
        above[k + 1] += root[n - i] * right;
        below[k] -= root[i + 1] * left;
        below[k + 1] += root[i + 1] * right;
      }
    }
    value_.swap(next);
  }

  int twice_ = 0;
  std::vector<double> value_;
};

/// A rotation as turns about z, y and z: first gamma, last alpha.
struct Euler_angles {
  double alpha, beta, gamma;

  Euler_angles(double a, double b, double c) : alpha(a), beta(b), gamma(c) {}

  explicit Euler_angles(const Matrix_3& r)
    : alpha(std::atan2(r[1][2], r[0][2])), beta(std::atan2(std::sqrt(r[0][2] * r[0][2] + r[1][2] * r[1][2]), r[2][2]))
  {
    const double s = std::sin(alpha), c = std::cos(alpha); // what is left when the other two are undone
    gamma = std::atan2(c * r[1][0] - s * r[0][0], c * r[1][1] - s * r[0][1]);
  }

  Matrix_3 matrix() const
  {
    const auto turn = [](int i, int j, double angle) {
      Matrix_3 r = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
      r[i][i] = r[j][j] = std::cos(angle);
      r[j][i] = std::sin(angle);
      r[i][j] = -r[j][i];
      return r;
    };
    return product(turn(0, 1, alpha), product(turn(2, 0, beta), turn(0, 1, gamma)));
  }
};

/// Turns the functions' part of one degree. A turn about y is one about z in a frame where y points up:
/// exp(-i beta Jy) = Z(90) D exp(-i beta Jz) D^T Z(-90) with the quarter turn D about y.
CGAL_SP_INLINE void turn_degree(const Quarter_turn& quarter, const Euler_angles& angles, const Complex_harmonics& from,
                                Complex_harmonics& to)
{
  typedef std::complex<double> Complex;
  const int l = quarter.degree();
  std::vector<Complex> a(2 * l + 1), b(2 * l + 1);
  for(int field = 0; field < from.number_of_fields(); ++field) {
    std::fill(b.begin(), b.end(), 0);
    for(int m = -l; m <= l; ++m) {
      const Complex z = std::polar(1., -m * (angles.gamma - pi / 2)) * from(l, m, field);
      for(int k = -l; k <= l; ++k)
        b[k + l] += quarter(m, k) * z;
    }
    for(int k = -l; k <= l; ++k)
      b[k + l] *= std::polar(1., -k * angles.beta);
    for(int m = 0; m <= l; ++m) {
      Complex sum = 0;
      for(int k = -l; k <= l; ++k)
        sum += quarter(m, k) * b[k + l];
      sum *= std::polar(1., -m * (angles.alpha + pi / 2));
      to(l, m, field) = sum;
      to(l, -m, field) = (m % 2 == 0 ? 1. : -1.) * std::conj(sum);
    }
  }
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_COMPLEX_HARMONICS_H
