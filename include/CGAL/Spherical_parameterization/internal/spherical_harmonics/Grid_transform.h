// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_GRID_TRANSFORM_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_GRID_TRANSFORM_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/values/Harmonic_coefficients.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/Legendre_transform.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/fourier.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/grids.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Runs f(begin, end) on ranges of 0 ... n-1 that are worth a Fourier transform's tables.
template <class Loop, class F>
void for_each_range(const Loop& loop, int n, F f)
{
  constexpr int size = 16;
  loop.for_each((n + size - 1) / size, [&](int i) { f(i * size, (std::min)(n, (i + 1) * size)); });
}

/// The bump between grid points and points anywhere: exp(b (sqrt(1 - t^2) - 1)) for |t| < 1, `width` grid points wide
/// (A. Barnett, J. Magland, L. af Klinteberg, "A parallel nonuniform fast Fourier transform library based on an
/// 'exponential of semicircle' kernel", SIAM J. Sci. Comput. 41, 2019). On a grid of twice the necessary points, 14
/// points leave a relative error of 1e-13.
struct Kernel {
  static constexpr int width = 14;
  static constexpr int half_width = width / 2;
  static constexpr double steepness = 2.3 * width;

  /// \param distance  in grid points
  static double value(double distance)
  {
    const double t = distance / half_width;
    return t * t < 1 ? std::exp(steepness * (std::sqrt(1 - t * t) - 1)) : 0;
  }

  /// The factors of the frequencies 0 ... largest that make up for the bump on a grid of n points.
  static std::vector<double> corrections(int largest, int n)
  {
    constexpr int nodes = 100; // the midpoint rule: the bump is smooth, and 1e-14 at its ends
    std::array<double, nodes> bump;
    for(int i = 0; i < nodes; ++i)
      bump[i] = value((i + 0.5) / nodes * half_width);
    std::vector<double> result;
    for(int k = 0; k <= largest; ++k) {
      double sum = 0;
      for(int i = 0; i < nodes; ++i)
        sum += bump[i] * std::cos(2 * pi * k * (i + 0.5) / nodes * half_width / n);
      result.push_back(nodes / (2 * sum * half_width));
    }
    return result;
  }
};

/// Numbers on an equidistant grid in the angles, with more rows and columns round it, as wide as half a kernel: row
/// 0 is the north pole, row n/2 the south pole, column i the longitude 2 pi i / n.
struct Angular_grid {
  int n, fields;
  Host_array<double> value;

  Angular_grid(int n_, int fields_)
    : n(n_), fields(fields_),
      value(static_cast<std::size_t>(fields) * static_cast<std::size_t>(rows()) * static_cast<std::size_t>(columns()))
  {}
  int rows() const { return n / 2 + 1 + Kernel::width; }
  int columns() const { return n + Kernel::width; }
  /// From the row's first column, which is -half_width. \param row  from -half_width on
  double* row(int field, int row)
  {
    return value.data() + (static_cast<std::size_t>(field) * rows() + (row + Kernel::half_width)) * columns();
  }
  const double* row(int field, int row) const { return const_cast<Angular_grid*>(this)->row(field, row); }
};

/// From coefficients to numbers on an `Angular_grid` for which the sums of the numbers round a point, with kernels as
/// weights, are the function there; and the transposed map. With `Scattered_points` it is a fast transform at any
/// points (S. Kunis, D. Potts, "Fast spherical Fourier algorithms", J. Comput. Appl. Math. 161, 2003, by Legendre
/// functions on equidistant rows instead of a fast polynomial transform).
template <class...>
class Grid_transform {
public:
  explicit Grid_transform(int degree) : Grid_transform(degree, degree) {}

  /// \param degree_of_grid  of which a transform has the same grid; not less than the degree
  Grid_transform(int degree, int degree_of_grid)
    : coarse_(fourier_size(2 * degree + 2)),
      n_(fourier_size((std::max)(2 * fourier_size(2 * degree_of_grid + 2), 2 * Kernel::width))),
      legendre_(degree, latitudes(coarse_), coarse_ / 2 + 1), correction_(Kernel::corrections(degree, n_))
  {}

  Angular_grid grid(int fields) const { return Angular_grid(n_, fields); }
  int degree() const { return legendre_.degree(); }

  /// \param c  of at most this degree
  template <class Loop>
  void synthesize(const Loop& loop, const Harmonic_coefficients& c, Angular_grid& grid) const
  {
    const int fields = c.number_of_fields(), degree = this->degree();
    Latitude_series coarse(degree + 1, fields, coarse_ / 2 + 1), fine(degree + 1, fields, n_ / 2 + 1);
    legendre_.synthesize(loop, c, coarse);
    for_each_range(loop, degree + 1, [&](int begin, int end) {
      Fourier<> fourier;
      std::vector<std::complex<double>> z(coarse_), spectrum, fine_spectrum(n_), fine_z;
      for(int m = begin; m < end; ++m)
        for(int field = 0; field < fields; ++field) {
          const double* const cosine = coarse.column(m, 2 * field);
          const double* const sine = coarse.column(m, 2 * field + 1);
          for(int j = 0; j <= coarse_ / 2; ++j)
            z[j] = {cosine[j], sine[j]};
          for(int j = 1; j < coarse_ / 2; ++j)
            z[coarse_ - j] = (m % 2 == 0 ? 1. : -1.) * z[j];
          fourier.forward(spectrum, z);
          std::fill(fine_spectrum.begin(), fine_spectrum.end(), 0);
          for(int k = -degree; k <= degree; ++k)
            fine_spectrum[k < 0 ? n_ + k : k] = factor(m, k) * spectrum[k < 0 ? coarse_ + k : k];
          fourier.backward(fine_z, fine_spectrum);
          for(int j = 0; j <= n_ / 2; ++j) {
            fine.column(m, 2 * field)[j] = fine_z[j].real();
            fine.column(m, 2 * field + 1)[j] = fine_z[j].imag();
          }
        }
    });
    for(int field = 0; field < fields; ++field)
      for_each_range(loop, n_ / 2 + 1, [&](int begin, int end) {
        Fourier<> fourier;
        std::vector<std::complex<double>> spectrum(n_ / 2 + 1);
        for(int j = begin; j < end; ++j) {
          for(int m = 0; m <= degree; ++m)
            spectrum[m] = {(m == 0 ? 1 : 0.5) * fine.column(m, 2 * field)[j], -0.5 * fine.column(m, 2 * field + 1)[j]};
          spectrum[0].imag(0);
          fourier.backward(grid.row(field, j) + Kernel::half_width, spectrum, n_);
        }
      });
    for(int field = 0; field < fields; ++field)
      extend(grid, field);
  }

  /// The transposed map. Coefficients are written, not added to; the grid is scratch afterwards.
  template <class Loop>
  void analyze(const Loop& loop, Angular_grid& grid, Harmonic_coefficients& c) const
  {
    const int fields = c.number_of_fields(), degree = this->degree();
    for(int field = 0; field < fields; ++field)
      fold(grid, field);
    Latitude_series coarse(degree + 1, fields, coarse_ / 2 + 1), fine(degree + 1, fields, n_ / 2 + 1);
    for(int field = 0; field < fields; ++field)
      for_each_range(loop, n_ / 2 + 1, [&](int begin, int end) {
        Fourier<> fourier;
        std::vector<std::complex<double>> spectrum;
        for(int j = begin; j < end; ++j) {
          fourier.forward(spectrum, grid.row(field, j) + Kernel::half_width, n_);
          for(int m = 0; m <= degree; ++m) {
            fine.column(m, 2 * field)[j] = spectrum[m].real();
            fine.column(m, 2 * field + 1)[j] = -spectrum[m].imag();
          }
        }
      });
    for_each_range(loop, degree + 1, [&](int begin, int end) {
      Fourier<> fourier;
      std::vector<std::complex<double>> z, spectrum(coarse_), fine_spectrum, fine_z(n_);
      for(int m = begin; m < end; ++m)
        for(int field = 0; field < fields; ++field) {
          for(int j = 0; j <= n_ / 2; ++j)
            fine_z[j] = {fine.column(m, 2 * field)[j], fine.column(m, 2 * field + 1)[j]};
          std::fill(fine_z.begin() + n_ / 2 + 1, fine_z.end(), 0);
          fourier.backward(fine_spectrum, fine_z);
          std::fill(spectrum.begin(), spectrum.end(), 0);
          for(int k = -degree; k <= degree; ++k)
            spectrum[k < 0 ? coarse_ + k : k] = factor(m, k) * fine_spectrum[k < 0 ? n_ + k : k];
          fourier.forward(z, spectrum);
          for(int j = 0; j <= coarse_ / 2; ++j) {
            if(j > 0 && j < coarse_ / 2)
              z[j] += (m % 2 == 0 ? 1. : -1.) * z[coarse_ - j];
            coarse.column(m, 2 * field)[j] = z[j].real();
            coarse.column(m, 2 * field + 1)[j] = z[j].imag();
          }
        }
    });
    legendre_.analyze(loop, coarse, c);
  }

private:
  /// From the north pole to the equator.
  static std::vector<Latitude> latitudes(int n)
  {
    std::vector<Latitude> north;
    for(int j = 0; j <= n / 4; ++j)
      north.push_back({4 * j == n ? 0 : std::cos(2 * pi * j / n), std::sin(2 * pi * j / n)});
    return north;
  }

  /// Of the frequency m in the longitude and k in the other angle.
  double factor(int m, int k) const { return correction_[m] * correction_[k < 0 ? -k : k] / coarse_; }

  /// Beyond a pole there is the other side of the sphere.
  void extend(Angular_grid& grid, int field) const
  {
    constexpr int h = Kernel::half_width;
    for(int j = 1; j <= h; ++j)
      for(const auto& [beyond, row] : {std::pair(-j, j), std::pair(n_ / 2 + j, n_ / 2 - j)}) {
        const double* const from = grid.row(field, row) + h;
        double* const to = grid.row(field, beyond) + h;
        std::copy(from, from + n_ / 2, to + n_ / 2);
        std::copy(from + n_ / 2, from + n_, to);
      }
    for(int j = -h; j <= n_ / 2 + h; ++j) {
      double* const row = grid.row(field, j);
      std::copy(row + n_, row + n_ + h, row);
      std::copy(row + h, row + 2 * h, row + n_ + h);
    }
  }

  /// The transposed map of `extend()`.
  void fold(Angular_grid& grid, int field) const
  {
    constexpr int h = Kernel::half_width;
    for(int j = -h; j <= n_ / 2 + h; ++j) {
      double* const row = grid.row(field, j);
      for(int i = 0; i < h; ++i) {
        row[n_ + i] += row[i];
        row[h + i] += row[n_ + h + i];
      }
    }
    for(int j = 1; j <= h; ++j)
      for(const auto& [beyond, row] : {std::pair(-j, j), std::pair(n_ / 2 + j, n_ / 2 - j)}) {
        double* const to = grid.row(field, row) + h;
        const double* const from = grid.row(field, beyond) + h;
        for(int i = 0; i < n_; ++i)
          to[i] += from[(i + n_ / 2) % n_];
      }
  }

  int coarse_, n_; ///< points of the circle: those that the degree needs, and those of the grid
  Legendre_transform legendre_;
  std::vector<double> correction_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_GRID_TRANSFORM_H
