// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_LEGENDRE_TRANSFORM_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_LEGENDRE_TRANSFORM_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/values/Harmonic_coefficients.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// A circle of latitude.
struct Latitude {
  double cos, sin; ///< of the angle from the north pole
};

/// What functions on the sphere are on circles of latitude, as Fourier series in the longitude: for every order m
/// (first index), function (times two: the series of cos(m phi), then of sin(m phi)) and row (last index) a number.
struct Latitude_series {
  int columns = 0, rows = 0; ///< columns: twice the number of functions
  Host_array<double> value;

  Latitude_series(int orders, int fields, int rows_)
    : columns(2 * fields), rows(rows_),
      value(static_cast<std::size_t>(orders) * static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows_))
  {}
  double* column(int m, int k) { return value.data() + (static_cast<std::size_t>(m) * columns + k) * rows; }
  const double* column(int m, int k) const { return value.data() + (static_cast<std::size_t>(m) * columns + k) * rows; }
};

/// Associated Legendre functions on rows that are symmetric to the equator: from coefficients to series on the rows,
/// and the transposed map.
///
/// The normalized functions follow from the recurrence in the degree, which is stable. It starts with sin(theta)^m,
/// which is smaller than any double near the poles; so a power of two goes with it until its values count
/// (M. Reinecke, D. S. Seljebotn, "Libsharp", A&A 554, 2013).
///
/// O(L^2) per row. Rows go four at a time, so that compilers use vector instructions.
class Legendre_transform {
public:
  /// \param degree  of the coefficients
  /// \param north   the rows from the north pole to the equator
  /// \param rows    of all: twice those of `north`, one less if the equator is among them. Row i and row
  ///                rows - 1 - i are symmetric.
  Legendre_transform(int degree, const std::vector<Latitude>& north, int rows) : degree_(degree), rows_(rows)
  {
    blocks_ = static_cast<int>((north.size() + lanes - 1) / lanes);
    pairs_ = static_cast<int>(north.size());
    cos_.resize(blocks_ * lanes, 0);
    seed_.resize(static_cast<std::size_t>(degree + 1) * blocks_ * lanes);
    for(int i = 0; i < pairs_; ++i) {
      cos_[i] = north[i].cos;
      Seed seed = {std::sqrt(1 / (4 * pi)), 0};
      for(int m = 0; m <= degree; ++m) {
        if(m > 0)
          seed.value *= std::sqrt((2. * m + 1) / (2. * m)) * north[i].sin * (m == 1 ? std::sqrt(2.) : 1);
        if(std::abs(seed.value) < lower() && seed.value != 0) {
          seed.value *= step_up();
          ++seed.scale;
        }
        seed_[static_cast<std::size_t>(m) * blocks_ * lanes + i] = seed;
      }
    }
  }

  int degree() const { return degree_; }

  /// Sums on the rows.
  template <class Loop>
  void synthesize(const Loop& loop, const Harmonic_coefficients& c, Latitude_series& series) const
  {
    loop.for_each(degree_ + 1, [&](int m) {
      const int columns = series.columns;
      const std::vector<double> coefficient = coefficients_of_order(c, m);
      const Recurrence recurrence(m, degree_);
      for(int block = 0; block < blocks_; ++block) {
        std::vector<Lanes> sum(static_cast<std::size_t>(2 * columns), Lanes{}); // even columns, odd columns
        run(recurrence, m, block, [&](int l, const Lanes& p) {
          Lanes* const s = sum.data() + ((l - m) % 2) * columns;
          const double* const a = coefficient.data() + static_cast<std::ptrdiff_t>(l - m) * columns;
          for(int k = 0; k < columns; ++k)
            for(int i = 0; i < lanes; ++i)
              s[k][i] += a[k] * p[i];
        });
        for(int k = 0; k < columns; ++k)
          for(int i = 0, row = block * lanes; i < lanes && row < pairs_; ++i, ++row) {
            const double even = sum[k][i], odd = sum[columns + k][i];
            series.column(m, k)[row] = even + odd;
            if(row != rows_ - 1 - row)
              series.column(m, k)[rows_ - 1 - row] = even - odd;
          }
      }
    });
  }

  /// The transposed map: inner products with the rows, as if every row had the weight 1. Coefficients are written, not
  /// added to.
  template <class Loop>
  void analyze(const Loop& loop, const Latitude_series& series, Harmonic_coefficients& c) const
  {
    loop.for_each(degree_ + 1, [&](int m) {
      const int columns = series.columns;
      const Recurrence recurrence(m, degree_);
      std::vector<Lanes> sum(static_cast<std::size_t>(degree_ - m + 1) * columns, Lanes{});
      std::vector<Lanes> half(static_cast<std::size_t>(2 * columns), Lanes{});
      for(int block = 0; block < blocks_; ++block) {
        for(int k = 0; k < columns; ++k)
          for(int i = 0; i < lanes; ++i) {
            const int row = block * lanes + i, other = rows_ - 1 - row;
            const double north = row < pairs_ ? series.column(m, k)[row] : 0;
            const double south = row < pairs_ && row != other ? series.column(m, k)[other] : 0;
            half[k][i] = north + south;
            half[columns + k][i] = north - south;
          }
        run(recurrence, m, block, [&](int l, const Lanes& p) {
          const Lanes* const h = half.data() + ((l - m) % 2) * columns;
          Lanes* const s = sum.data() + static_cast<std::ptrdiff_t>(l - m) * columns;
          for(int k = 0; k < columns; ++k)
            for(int i = 0; i < lanes; ++i)
              s[k][i] += h[k][i] * p[i];
        });
      }
      for(int l = m; l <= degree_; ++l)
        for(int k = 0; k < columns; ++k) {
          const Lanes& s = sum[static_cast<std::size_t>(l - m) * columns + k];
          if(m > 0 || k % 2 == 0)
            c(l, k % 2 == 0 ? m : -m, k / 2) = (s[0] + s[1]) + (s[2] + s[3]);
        }
    });
  }

private:
  static constexpr int lanes = 4;
  typedef std::array<double, lanes> Lanes;

  /// value * 2^(-800 scale)
  struct Seed {
    double value = 0;
    int scale = 0;
  };
  static constexpr double lower() { return 0x1p-400; }
  static constexpr double step_up() { return 0x1p800; }

  /// P(l) = a(l) (x P(l - 1) - b(l) P(l - 2)) for the functions of order m
  struct Recurrence {
    std::vector<double> a, b;

    Recurrence(int m, int degree) : a(degree - m + 1), b(degree - m + 1)
    {
      double before = 0;
      for(int l = m + 1; l <= degree; ++l) {
        const double inverse = std::sqrt((4. * l * l - 1) / ((static_cast<double>(l) - m) * (l + m)));
        a[l - m] = inverse;
        b[l - m] = before;
        before = 1 / inverse;
      }
    }
  };

  /// Calls f(l, values on the rows of the block) for l = m ... degree, in this order, but where all of them are 0.
  template <class F>
  void run(const Recurrence& recurrence, int m, int block, F f) const
  {
    Lanes x, p, before = {};
    std::array<int, lanes> scale;
    bool are_small = false;
    for(int i = 0; i < lanes; ++i) {
      const Seed& seed = seed_[static_cast<std::size_t>(m) * blocks_ * lanes + block * lanes + i];
      x[i] = cos_[block * lanes + i];
      p[i] = seed.value;
      scale[i] = seed.scale;
      are_small = are_small || seed.scale > 0;
    }
    for(int l = m;;) {
      if(!are_small)
        f(l, p);
      else {
        are_small = false;
        Lanes q;
        bool any = false;
        for(int i = 0; i < lanes; ++i) {
          q[i] = scale[i] == 0 ? p[i] : 0;
          any = any || scale[i] == 0;
          if(scale[i] > 0 && std::abs(p[i]) > 1 / lower()) {
            p[i] /= step_up();
            before[i] /= step_up();
            --scale[i];
          }
          are_small = are_small || scale[i] > 0;
        }
        if(any)
          f(l, q);
      }
      if(++l > degree_)
        return;
      const double a = recurrence.a[l - m], b = recurrence.b[l - m];
      for(int i = 0; i < lanes; ++i) {
        const double next = a * (x[i] * p[i] - b * before[i]);
        before[i] = p[i];
        p[i] = next;
      }
    }
  }

  /// Degree after degree, a number for every column.
  std::vector<double> coefficients_of_order(const Harmonic_coefficients& c, int m) const
  {
    std::vector<double> result;
    result.reserve(static_cast<std::size_t>(2 * c.number_of_fields()) * (degree_ - m + 1));
    for(int l = m; l <= degree_; ++l)
      for(int field = 0; field < c.number_of_fields(); ++field) {
        result.push_back(c(l, m, field));
        result.push_back(m == 0 ? 0 : c(l, -m, field));
      }
    return result;
  }

  int degree_, rows_, pairs_, blocks_;
  std::vector<double> cos_;
  std::vector<Seed> seed_; ///< of every order, all rows
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_LEGENDRE_TRANSFORM_H
