// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_FOURIER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_FOURIER_H

#include <unsupported/Eigen/FFT>

#include <complex>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Discrete Fourier transforms without factors, one after the other. A thread needs one of its own.
template <class...>
class Fourier {
public:
  Fourier()
  {
    fft_.SetFlag(Fft::Unscaled);
    fft_.SetFlag(Fft::HalfSpectrum);
  }

  /// to_k = sum of from_j exp(-2 pi i j k / n)
  void forward(std::vector<std::complex<double>>& to, const std::vector<std::complex<double>>& from)
  {
    to.resize(from.size());
    fft_.fwd(to.data(), from.data(), static_cast<Eigen::Index>(from.size()));
  }

  /// with exp(+2 pi i j k / n)
  void backward(std::vector<std::complex<double>>& to, const std::vector<std::complex<double>>& from)
  {
    to.resize(from.size());
    fft_.inv(to.data(), from.data(), static_cast<Eigen::Index>(from.size()));
  }

  /// The values of a function at n equidistant angles, n even: sum of Re(s_m exp(i m phi)) over m = 0 ... n/2, but
  /// twice that for 0 < m < n/2.
  void backward(double* values, const std::vector<std::complex<double>>& half_spectrum, int n)
  {
    fft_.inv(values, half_spectrum.data(), n);
  }

  /// Half of the spectrum of real values, m = 0 ... n/2.
  void forward(std::vector<std::complex<double>>& half_spectrum, const double* values, int n)
  {
    half_spectrum.resize(static_cast<std::size_t>(n));
    fft_.fwd(half_spectrum.data(), values, n);
  }

private:
  typedef Eigen::FFT<double> Fft;
  Fft fft_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_FOURIER_H
