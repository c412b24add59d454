// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_OPENCL_BACKEND_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_OPENCL_BACKEND_H

#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/backend/Moments.h>
#include <CGAL/Spherical_parameterization/internal/backend/opencl/OpenCL_queue.h>
#include <CGAL/Spherical_parameterization/internal/backend/opencl/OpenCL_runtime.h>
#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/backend/vertex_formulas.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The verbs of Host_backend on an OpenCL device: each is a kernel of kernels/, named like the verb. Verbs that return
/// numbers wait for the device. All others return at once. Set-up on the host is run with `Loop`. An object is for one
/// thread; `parameterize()` makes its own.
template <class Loop>
class OpenCL_backend {
public:
  using Host_loop = Loop;
  template <class T>
  using Array = OpenCL_array<T>;
  using Vectors = Array<vec3>;
  using Scalars = Array<double>;
  using Matrix = OpenCL_matrix;
  using Transfer = OpenCL_transfer;
  using Colouring = std::vector<Array<int>>;

  explicit OpenCL_backend(const OpenCL_queue& queue) : runtime_(queue) {}

  std::string device_name() const
  {
    const OpenCL_device_info& info = runtime_.queue().info();
    return info.name + " (" + info.platform + "), " + (is_double() ? "double" : "single") + " precision";
  }

  double rounding() const { return is_double() ? 1e-13 : 1e-6; }

  /// In single precision the residual of eq. (2) came down to between 0.7e-7 and 1.5e-7 times sqrt(n) on meshes of 162
  /// to 10242 vertices, and that of the balanced map to 1.5e-8 times sqrt(n) up to 163842 vertices.
  double best_accuracy(int n) const { return is_double() ? 0 : 3e-7 * std::sqrt(static_cast<double>(n)); }

  const Host_loop& host_loop() const { return loop_; }

  /// How often the host has waited for the device
  std::size_t number_of_read_backs() const { return runtime_.number_of_read_backs(); }

  /// \name Memory
  /// @{
  Vectors vectors(int n) const { return runtime_.zeros<vec3>(n); }
  Scalars scalars(int n) const { return runtime_.zeros<double>(n); }
  template <class T>
  Array<T> upload(const Host_array<T>& host) const
  {
    return runtime_.upload(host);
  }
  Matrix upload(const Shared_graph& host) const
  {
    const auto share = [&](const auto& array) { return runtime_.share(array, host); };
    return {share(host->offset), share(host->target), share(host->weight), share(host->excess),
            share(host->inverse_diagonal)};
  }
  Transfer upload(Sparse_matrix matrix) const
  {
    const auto host = std::make_shared<const Sparse_matrix>(std::move(matrix));
    const auto share = [&](const auto& array) { return runtime_.share(array, host); };
    return {share(host->offset), share(host->column), share(host->value)};
  }
  Host_array<vec3> download(const Vectors& x) const { return runtime_.download(x); }
  Colouring colouring(const std::vector<Host_array<int>>& colours) const
  {
    Colouring result;
    for(const Host_array<int>& colour : colours)
      result.push_back(upload(colour));
    return result;
  }
  /// @}

  /// \name Linear algebra
  /// @{
  /// By a kernel: drivers for CPUs copy buffers on one core.
  void copy(const Vectors& x, Vectors& y) const { run("sp_copy", x.size(), x, y); }

  double dot(const Vectors& x, const Vectors& y) const { return sum<1>("sp_dot", x.size(), x, y)[0]; }

  double multiply(const Matrix& a, const Vectors& x, Vectors& y) const
  {
    return sum<1>("sp_multiply", x.size(), a, x, y)[0];
  }

  void descend(double alpha, const Vectors& p, const Vectors& q, Vectors& x, Vectors& r) const
  {
    run("sp_descend", x.size(), alpha, p, q, x, r);
  }

  void conjugate(double beta, const Vectors& s, Vectors& p) const { run("sp_conjugate", p.size(), beta, s, p); }

  void residual(const Matrix& a, const Vectors& b, const Vectors& x, Vectors& r) const
  {
    run("sp_residual", x.size(), a, b, x, r);
  }

  void start_smoothing(const Matrix& a, double gain, const Vectors& b, Vectors& x) const
  {
    run("sp_start_smoothing", x.size(), a.inverse_diagonal, gain, b, x);
  }

  void smooth(const Matrix& a, double gain, const Vectors& b, const Vectors& x, Vectors& y) const
  {
    run("sp_smooth", x.size(), a, gain, b, x, y);
  }

  void transfer(const Transfer& t, const Vectors& x, Vectors& y) const { run("sp_transfer", y.size(), t, x, y); }

  void transfer_add(const Transfer& t, const Vectors& x, Vectors& y) const
  {
    run("sp_transfer_add", y.size(), t, x, y);
  }

  void multiply_dense(const Scalars& b, const Vectors& x, Vectors& y) const
  {
    run("sp_multiply_dense", x.size(), b, x, y);
  }
  /// @}

  /// \name Spring energy
  /// @{
  double energy(const Matrix& a, const Vectors& v) const { return sum<1>("sp_energy", v.size(), a, v)[0]; }

  std::array<double, 4> gradient(const Matrix& a, double p, const Vectors& v, Vectors& g, Scalars& density) const
  {
    return p == 2 ? sum<4>("sp_gradient", v.size(), a, v, g, density)
                  : sum<4>("sp_stiffening_gradient", v.size(), a, p, v, g, density);
  }

  void spring_masses(const Matrix& a, const Vectors& v, Scalars& m) const
  {
    run("sp_spring_masses", v.size(), a, v, m);
  }

  double balance_gradient(const Matrix& a, const Scalars& mass, vec3 mu, const Vectors& v, Vectors& g) const
  {
    return sum<1>("sp_balance_gradient", v.size(), a.inverse_diagonal, mass, mu, v, g)[0];
  }

  std::array<double, 15> direction_products(const Scalars& mass, const Vectors& v, const Vectors& g,
                                            const Vectors& old_g, const Vectors& step, const Vectors& d) const
  {
    return sum<15>("sp_direction_products", v.size(), mass, v, g, old_g, step, d);
  }

  void next_direction(double beta, vec3 y, vec3 omega, const Vectors& v, const Vectors& step, Vectors& d) const
  {
    run("sp_next_direction", v.size(), beta, y, omega, v, step, d);
  }

  std::array<double, 5> curvature(const Matrix& a, double p, const Scalars& mass, vec3 mu, const Vectors& v,
                                  const Vectors& d, const Scalars& density) const
  {
    return p == 2 ? sum<5>("sp_curvature", v.size(), a, mass, mu, v, d, density)
                  : sum<5>("sp_stiffening_curvature", v.size(), a, p, mass, mu, v, d, density);
  }

  Moments retract(const Scalars& mass, double alpha, vec3 c, const Vectors& v, const Vectors& d, Vectors& w) const
  {
    return to_moments(sum<9>("sp_retract", v.size(), mass, alpha, c, v, d, w));
  }

  Moments moments(const Scalars& mass, const Vectors& v) const
  {
    return to_moments(sum<9>("sp_moments", v.size(), mass, v));
  }

  Moments transform(const Scalars& mass, vec3 c, const Vectors& v, Vectors& w) const
  {
    return to_moments(sum<9>("sp_transform", v.size(), mass, c, v, w));
  }
  /// @}

  /// \name The published method
  /// @{
  void jacobi_sweep(const Matrix& a, double omega, const Vectors& v, const Vectors& u, Vectors& w) const
  {
    run("sp_jacobi_sweep", v.size(), a, omega, v, u, w);
  }

  void gauss_seidel_sweep(const Matrix& a, const Colouring& colours, double omega, const Vectors& v, Vectors& u) const
  {
    for(const Array<int>& colour : colours)
      run("sp_gauss_seidel_sweep", colour.size(), a, colour, omega, v, u);
  }

  double saddle_point_residual2(const Matrix& a, const Vectors& v, const Vectors& u) const
  {
    return sum<1>("sp_saddle_point_residual2", v.size(), a, v, u)[0];
  }

  void normalize(const Matrix& a, const Vectors& u, Vectors& v) const
  {
    run("sp_normalize", v.size(), a.inverse_diagonal, u, v);
  }

  double barycentric_residual2(const Matrix& a, const Vectors& v) const
  {
    return sum<1>("sp_barycentric_residual2", v.size(), a, v)[0];
  }
  /// @}

private:
  bool is_double() const { return runtime_.queue().is_double_precision(); }

  template <class... Arguments>
  void run(const char* kernel, std::size_t n, const Arguments&... arguments) const
  {
    runtime_.run(kernel, n, arguments...);
  }

  template <int K, class... Arguments>
  std::array<double, K> sum(const char* kernel, std::size_t n, const Arguments&... arguments) const
  {
    return runtime_.sum<K>(kernel, n, arguments...);
  }

  OpenCL_runtime runtime_;
  Host_loop loop_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_OPENCL_BACKEND_H
