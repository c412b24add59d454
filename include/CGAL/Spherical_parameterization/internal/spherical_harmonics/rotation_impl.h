// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ROTATION_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ROTATION_IMPL_H

#include <CGAL/Spherical_parameterization/internal/algebra/dense_matrices.h>
#include <CGAL/Spherical_parameterization/internal/algebra/rotations.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/Complex_harmonics.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/analysis.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/fourier.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/rotation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numeric>

namespace CGAL::Spherical_parameterization::internal {

/// The integrals over the sphere of the cubes of the coordinates along the axes: to which side a shape reaches farther.
template <class Loop>
std::array<double, 3> skewness(const Loop& loop, const Harmonic_coefficients& shape,
                               const typename Dense<Loop>::Matrix_3& axes)
{
  typedef typename Dense<Loop>::Vector_3 Vector;
  constexpr int largest = 16; // details do not decide
  const Harmonic_coefficients smooth = with_degree(shape, (std::min)(largest, shape.degree()));
  const Latitude_rows grid = gauss_legendre_rows(3 * smooth.degree() / 2 + 1, 3 * smooth.degree() + 1);
  const Host_array<double> value = synthesize_on_rows(loop, smooth, grid);
  const std::size_t n = grid.cos.size() * static_cast<std::size_t>(grid.columns);
  const double scale = 1 / std::sqrt(4 * pi);
  const Vector centre(scale * shape(0, 0, 0), scale * shape(0, 0, 1), scale * shape(0, 0, 2));
  std::array<double, 3> result = {};
  for(std::size_t i = 0; i < n; ++i) {
    const Vector p = axes.transpose() * (Vector(value[i], value[n + i], value[2 * n + i]) - centre);
    for(int k = 0; k < 3; ++k)
      result[k] += grid.weight[i / static_cast<std::size_t>(grid.columns)] * p[k] * p[k] * p[k];
  }
  return result;
}

template <class Loop>
First_order_ellipsoid ellipsoid_of(const Loop& loop, const Harmonic_coefficients& of_any_size)
{
  typedef typename Dense<Loop>::Matrix_3 Matrix;
  Harmonic_coefficients shape = of_any_size;
  const int exponent = scale_to_one(shape.values().data(), shape.values().data() + shape.values().size());
  First_order_ellipsoid result;
  Matrix a;
  const double constant = 1 / std::sqrt(4 * pi), linear = std::sqrt(3.) * constant;
  for(int k = 0; k < 3; ++k) {
    result.centre[k] = std::ldexp(constant * shape(0, 0, k), exponent);
    a.row(k) << linear * shape(1, 1, k), linear * shape(1, -1, k), linear * shape(1, 0, k);
  }
  const Eigen::JacobiSVD<Matrix> svd(a, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Matrix u = svd.matrixU(), v = svd.matrixV();
  // Each pair of columns has a free sign: the first two towards where the shape reaches farther, the third one so that
  // axes are right-handed.
  const std::array<double, 3> skew = skewness(loop, shape, u);
  for(int k = 0; k < 2; ++k)
    if(skew[k] < 0) {
      u.col(k) *= -1;
      v.col(k) *= -1;
    }
  const double mirrored = u.determinant() * v.determinant() < 0 ? -1 : 1;
  if(u.determinant() < 0)
    u.col(2) *= -1;
  if(v.determinant() < 0)
    v.col(2) *= -1;
  for(int k = 0; k < 3; ++k) {
    result.radii[k] = std::ldexp(svd.singularValues()[k] * (k == 2 ? mirrored : 1), exponent);
    for(int i = 0; i < 3; ++i) {
      result.axes[k][i] = u(i, k);
      result.sphere_axes[k][i] = v(i, k);
    }
  }
  return result;
}

template <class Loop>
Harmonic_coefficients rotated_harmonics(const Loop& loop, const Harmonic_coefficients& f, const Rotation& rotation)
{
  const Complex_harmonics from(f);
  Complex_harmonics to = from;
  const Euler_angles angles(rotation);
  Quarter_turn quarter;
  for(int l = 1; l <= f.degree(); ++l)
    loop.for_each(1, [&](int) {
      quarter.advance();
      turn_degree(quarter, angles, from, to);
    });
  return to.real();
}

/// The correlation of f and of g turned by R, for all R.
template <class Any = void>
class Rotation_search {
  typedef typename Dense<Any>::Matrix_3 Eigen_matrix;
  typedef typename Dense<Any>::Vector_3 Eigen_vector;

public:
  template <class Loop>
  Rotation_search(const Loop& loop, const Harmonic_coefficients& f, const Harmonic_coefficients& g)
    : f_(f), g_(g), degree_(f.degree())
  {
    quarter_.resize(degree_ + 1);
    for(int l = 1; l <= degree_; ++l)
      loop.for_each(1, [&](int) {
        quarter_[l] = quarter_[l - 1];
        quarter_[l].advance();
      });
    for(int axis = 0; axis < 3; ++axis)
      f_derivative_.push_back(derivative(f_, axis));
  }

  /// Newton's method, uphill from everywhere: a step of all of them, and the next one.
  template <class Loop>
  void refine(const Loop& loop, std::vector<Correlation>& starts) const
  {
    constexpr int most_steps = 30;
    const int n = static_cast<int>(starts.size());
    std::vector<Complex_harmonics> g(starts.size(), g_);
    std::vector<char> is_done(starts.size(), 0);
    loop.for_each(n, [&](int i) {
      g[i] = turned(starts[i].rotation);
      starts[i].value = inner(f_, g[i]);
    });
    for(int step = 0; step < most_steps; ++step)
      loop.for_each(n, [&](int i) {
        if(!is_done[i])
          is_done[i] = !climb(g[i], starts[i]);
      });
  }

  /// The largest of the local maxima on a grid of Euler's angles, the largest one first.
  template <class Loop>
  std::vector<Correlation> maxima_on_grid(const Loop& loop) const
  {
    const int n = fourier_size(2 * degree_ + 2), half = n / 2;
    const std::vector<double> value = values_on_grid(loop, n);
    const auto at = [&](int j, int a, int c) -> double {
      if(j < 0 || j > half) { // alpha and gamma go round by 180 degrees beyond 0 and 180 degrees of beta
        j = j < 0 ? -j : n - j;
        a += half;
        c += half;
      }
      return value[(static_cast<std::size_t>(j) * n + (a + n) % n) * n + (c + n) % n];
    };
    std::vector<std::vector<Correlation>> found(half + 1);
    loop.for_each(half + 1, [&](int j) {
      for(int c = 0; c < n; ++c)
        for(int a = 0; a < n; ++a) {
          const double here = at(j, c, a);
          bool is_largest = true;
          for(int k = 0; k < 27 && is_largest; ++k)
            is_largest = here >= at(j + k / 9 - 1, c + k / 3 % 3 - 1, a + k % 3 - 1);
          if(is_largest)
            found[j].push_back({Euler_angles(2 * pi * a / n, 2 * pi * j / n, 2 * pi * c / n).matrix(), here});
        }
    });
    std::vector<Correlation> all;
    for(const auto& some : found)
      all.insert(all.end(), some.begin(), some.end());
    std::stable_sort(all.begin(), all.end(), [](const auto& x, const auto& y) { return x.value > y.value; });
    return all;
  }

private:
  typedef std::complex<double> Complex;

  /// A step. `g`: turned by that rotation. Returns whether there is more to be gained.
  bool climb(Complex_harmonics& g, Correlation& now) const
  {
    constexpr double last_step = 1e-6; // radians: what is left then is the square of it
    vec3 w = newton_step(g);
    const bool is_last = norm(w) < last_step;
    for(;; w = scale(0.5, w)) {
      const Matrix_3 trial = product(rotation_about(w), now.rotation);
      g = turned(trial);
      const double trial_value = inner(f_, g);
      if(is_last || trial_value > now.value || norm(w) < last_step) {
        now = {trial, trial_value};
        return !is_last;
      }
    }
  }

  Complex_harmonics turned(const Matrix_3& rotation) const
  {
    Complex_harmonics result = g_;
    const Euler_angles angles(rotation);
    for(int l = 1; l <= degree_; ++l)
      turn_degree(quarter_[l], angles, g_, result);
    return result;
  }

  /// How the functions change when they are turned about an axis, per radian: -i J.
  static Complex_harmonics derivative(const Complex_harmonics& f, int axis)
  {
    Complex_harmonics result = f;
    for(int field = 0; field < f.number_of_fields(); ++field)
      for(int l = 0; l <= f.degree(); ++l)
        for(int m = -l; m <= l; ++m) {
          if(axis == 2) {
            result(l, m, field) = Complex(0, -m) * f(l, m, field);
            continue;
          }
          const Complex up = m > -l ? std::sqrt((l + m) * (l - m + 1.)) * f(l, m - 1, field) : 0;
          const Complex down = m < l ? std::sqrt((l - m) * (l + m + 1.)) * f(l, m + 1, field) : 0;
          result(l, m, field) = axis == 0 ? Complex(0, -0.5) * (up + down) : -0.5 * (up - down);
        }
    return result;
  }

  vec3 newton_step(const Complex_harmonics& g) const
  {
    constexpr double longest = 0.2, finite = 1e100; // radians
    Eigen_vector gradient;
    Eigen_matrix hessian;
    std::vector<Complex_harmonics> g_derivative;
    for(int axis = 0; axis < 3; ++axis)
      g_derivative.push_back(derivative(g, axis));
    for(int i = 0; i < 3; ++i) {
      gradient[i] = inner(f_, g_derivative[i]);
      for(int j = 0; j < 3; ++j)
        hessian(i, j) = -(inner(f_derivative_[i], g_derivative[j]) + inner(f_derivative_[j], g_derivative[i])) / 2;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen_matrix> eigen(hessian);
    Eigen_vector step = Eigen_vector::Zero();
    for(int i = 0; i < 3; ++i) {
      const Eigen_vector axis = eigen.eigenvectors().col(i);
      if(const double curvature = std::abs(eigen.eigenvalues()[i]); curvature > 0)
        step += std::clamp(axis.dot(gradient) / curvature, -finite, finite) * axis;
    }
    if(const double length = step.norm(); length > longest)
      step *= longest / length;
    return {step[0], step[1], step[2]};
  }

  /// At beta = 2 pi j / n, j = 0 ... n/2, gamma = 2 pi c / n, alpha = 2 pi a / n: number (j n + c) n + a (B. Kovacs, W.
  /// Wriggers, "Fast rotational matching", Acta Cryst. D58, 2002).
  template <class Loop>
  std::vector<double> values_on_grid(const Loop& loop, int n) const
  {
    const int half = n / 2, orders = 2 * degree_ + 1;
    // the series in alpha and gamma, for every beta: m >= 0, and all m'
    std::vector<Complex> series(static_cast<std::size_t>(half + 1) * (degree_ + 1) * orders);
    const auto at = [&](int j, int m, int m2) -> Complex& {
      return series[(static_cast<std::size_t>(j) * (degree_ + 1) + m) * orders + (m2 + degree_)];
    };
    loop.for_each(degree_ + 1, [&](int m) {
      Fourier<> fourier;
      std::vector<Complex> sum(n), values;
      for(int m2 = -degree_; m2 <= degree_; ++m2) {
        std::fill(sum.begin(), sum.end(), 0);
        for(int l = (std::max)(m, std::abs(m2)); l <= degree_; ++l) {
          Complex product = 0;
          for(int field = 0; field < f_.number_of_fields(); ++field)
            product += std::conj(f_(l, m, field)) * g_(l, m2, field);
          for(int k = 0; k <= l; ++k)
            sum[k] += quarter_[l](m, k) * quarter_[l](m2, k) * product;
        }
        const Complex phase = std::polar(1., pi / 2 * (m2 - m)); // from here on with exp(-i (m alpha + ...))
        for(int k = degree_; k >= 0; --k) {
          sum[k] *= phase;
          if(k > 0)
            sum[n - k] = (m + m2) % 2 == 0 ? sum[k] : -sum[k];
        }
        fourier.forward(values, sum);
        for(int j = 0; j <= half; ++j)
          at(j, m, m2) = values[j];
      }
    });
    std::vector<double> result(static_cast<std::size_t>(half + 1) * n * n);
    loop.for_each(half + 1, [&](int j) {
      Fourier<> fourier;
      std::vector<Complex> spectrum(n), values;
      std::vector<Complex> half_spectrum(static_cast<std::size_t>(n) * (half + 1), 0); // of every gamma
      for(int m = 0; m <= degree_; ++m) {
        std::fill(spectrum.begin(), spectrum.end(), 0);
        for(int m2 = -degree_; m2 <= degree_; ++m2)
          spectrum[(m2 + n) % n] = at(j, m, m2);
        fourier.forward(values, spectrum);
        for(int c = 0; c < n; ++c) // conjugate: the sum over m goes with exp(-i m alpha)
          half_spectrum[static_cast<std::size_t>(c) * (half + 1) + m] = std::conj(values[c]);
      }
      for(int c = 0; c < n; ++c) {
        const auto begin = half_spectrum.begin() + static_cast<std::ptrdiff_t>(c) * (half + 1);
        spectrum.assign(begin, begin + half + 1);
        spectrum[0].imag(0);
        fourier.backward(result.data() + (static_cast<std::size_t>(j) * n + c) * n, spectrum, n);
        spectrum.resize(n);
      }
    });
    return result;
  }

  Complex_harmonics f_, g_;
  int degree_;
  std::vector<Quarter_turn> quarter_;
  std::vector<Complex_harmonics> f_derivative_; ///< about x, y, z
};

/// A degree that both have, and functions of size 1 and mean 0: no rotation changes a mean, and beside that of a shape
/// far from the origin rounding would hide what rotations change.
struct Comparable {
  Harmonic_coefficients f, g;
  int exponent; ///< of the power of two that their products have to be scaled by

  Comparable(const Harmonic_coefficients& f_, const Harmonic_coefficients& g_)
    : f(with_degree(f_, (std::min)(f_.degree(), g_.degree()))), g(with_degree(g_, f.degree())), exponent(0)
  {
    for(Harmonic_coefficients* c : {&f, &g}) {
      for(int k = 0; k < c->number_of_fields(); ++k)
        *c->field_begin(k) = 0;
      exponent += scale_to_one(c->values().data(), c->values().data() + c->values().size());
    }
  }
};

template <class Loop>
std::vector<Correlation> best_correlations(const Loop& loop, const Harmonic_coefficients& of_f,
                                           const Harmonic_coefficients& of_g)
{
  constexpr std::size_t refined = 8; // a peak between grid points may seem lower than another one
  constexpr double apart = 0.98;     // cosine of half of the angle between two rotations that count as the same start
  const auto [f, g, exponent] = Comparable(of_f, of_g);
  const Rotation_search<> search(loop, f, g);
  const std::vector<Correlation> maxima = search.maxima_on_grid(loop);
  std::vector<Correlation> starts;
  for(const Correlation& start : maxima) {
    const auto is_near = [&](const Correlation& other) {
      double trace = 0;
      for(int i = 0; i < 3; ++i)
        for(int j = 0; j < 3; ++j)
          trace += start.rotation[i][j] * other.rotation[i][j];
      return std::sqrt((std::max)(0., 1 + trace)) / 2 > apart;
    };
    if(starts.size() < refined && std::none_of(starts.begin(), starts.end(), is_near))
      starts.push_back(start);
  }
  search.refine(loop, starts);
  std::stable_sort(starts.begin(), starts.end(), [](const auto& x, const auto& y) { return x.value > y.value; });
  for(Correlation& c : starts)
    c.value = std::ldexp(c.value, exponent);
  return starts;
}

/// The rotation of space that brings g to f where it is, constants left out.
CGAL_SP_INLINE Matrix_3 best_turn_in_space(const Harmonic_coefficients& f, const Harmonic_coefficients& g)
{
  std::vector<vec3> from, to;
  for(int i = 1; i < g.size(); ++i) {
    from.push_back({g.field_begin(0)[i], g.field_begin(1)[i], g.field_begin(2)[i]});
    to.push_back({f.field_begin(0)[i], f.field_begin(1)[i], f.field_begin(2)[i]});
  }
  return best_rotation(from, to);
}

/// Where rotations of the sphere are looked for.
enum class Among { ALL, NEAR };

/// Rotations of space and of the sphere, and what they are worth: the integral over the sphere of the inner product of
/// f(x) and space g(sphere^-1 x), without degree 0.
struct Motion {
  Matrix_3 space, sphere;
  double value;
};

/// By turns the best rotation of the sphere and the best rotation of space. No step makes it worse.
template <class Loop>
Motion alternated(const Loop& loop, const Harmonic_coefficients& f, const Harmonic_coefficients& g, Motion motion,
                  int degree, int most_steps, Among among)
{
  constexpr double enough = 1e-12; // relative gain; the error is of the order of its root
  const Matrix_3 unit = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const Harmonic_coefficients target = turned_in_space(f, unit, degree), source = turned_in_space(g, unit, degree);
  for(int step = 0; step < most_steps; ++step) {
    const double before = motion.value;
    const Harmonic_coefficients turned_source = turned_in_space(source, motion.space, degree);
    std::vector<Correlation> best = {{motion.sphere, 0}};
    if(among == Among::ALL)
      best = best_correlations(loop, target, turned_source);
    else
      Rotation_search<>(loop, target, turned_source).refine(loop, best);
    motion.sphere = best.front().rotation;
    const Harmonic_coefficients turned = rotated_harmonics(loop, source, motion.sphere);
    motion.space = best_turn_in_space(target, turned);
    const Harmonic_coefficients there = turned_in_space(turned, motion.space, degree);
    motion.value = std::inner_product(target.values().begin(), target.values().end(), there.values().begin(), 0.);
    if(step > 0 && !(motion.value > before + enough * std::abs(before)))
      break;
  }
  return motion;
}

template <class Loop>
Shape_alignment best_motion(const Loop& loop, const Harmonic_coefficients& of_f, const Harmonic_coefficients& of_g)
{
  constexpr int first_degree = 4, first_steps = 3, last_steps = 20;
  constexpr std::size_t refined = 3; // of the coarse ones
  const Comparable shapes(of_f, of_g);
  const Harmonic_coefficients &f = shapes.f, &g = shapes.g;
  const First_order_ellipsoid ellipsoid_f = ellipsoid_of(loop, f), ellipsoid_g = ellipsoid_of(loop, g);
  const Matrix_3 to_f = transposed(ellipsoid_f.axes); // from the axes to space
  // The 24 rotations of a cube between the axes: four of them are right for ellipsoids with three different axes, and
  // some one is near for all others.
  std::vector<Motion> motions;
  std::array<int, 3> p = {0, 1, 2};
  do
    for(int signs = 0; signs < 8; ++signs) {
      Matrix_3 cube = {};
      for(int i = 0; i < 3; ++i)
        cube[i][p[i]] = (signs >> i) % 2 == 0 ? 1 : -1;
      const bool is_odd = (p[0] > p[1]) != ((p[0] > p[2]) != (p[1] > p[2]));
      const bool mirrors = is_odd != (cube[0][p[0]] * cube[1][p[1]] * cube[2][p[2]] < 0);
      if(!mirrors)
        motions.push_back({product(to_f, product(cube, ellipsoid_g.axes)), {}, 0});
    }
  while(std::next_permutation(p.begin(), p.end()));
  const int coarse = (std::min)(first_degree, f.degree());
  const auto is_better = [](const Motion& a, const Motion& b) { return a.value > b.value; };
  loop.for_each(static_cast<int>(motions.size()), [&](int i) {
    motions[i] = alternated(loop.bare(), f, g, motions[i], coarse, first_steps, Among::ALL);
  });
  std::stable_sort(motions.begin(), motions.end(), is_better);
  std::vector<Motion> chosen; // the same optimum once
  for(const Motion& motion : motions)
    if(chosen.size() < refined && (chosen.empty() || motion.value < chosen.back().value * (1 - 1e-3)))
      chosen.push_back(motion);
  for(Motion& motion : chosen)
    motion = alternated(loop, f, g, motion, (std::min)(2 * first_degree, f.degree()), last_steps, Among::ALL);
  std::stable_sort(chosen.begin(), chosen.end(), is_better);
  const Motion best = alternated(loop, f, g, chosen.front(), f.degree(), last_steps, Among::NEAR);
  const auto power = [](const Harmonic_coefficients& c) {
    const std::vector<double> of_degree = power_spectrum(c);
    return std::accumulate(of_degree.begin() + 1, of_degree.end(), 0.);
  };
  const double size = std::sqrt(power(f) * power(g));
  return {best.space, best.sphere, size > 0 ? best.value / size : 0};
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ROTATION_IMPL_H
