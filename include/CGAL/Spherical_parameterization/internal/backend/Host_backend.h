// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_HOST_BACKEND_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_HOST_BACKEND_H

#include <CGAL/Spherical_parameterization/internal/backend/Moments.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/base/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/backend/vertex_formulas.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The verbs of a backend whose memory is the host's. A verb `v` is a loop over the formula `v_at` of
/// vertex_formulas.h. `Loop::for_each(count, f)` runs f(0) ... f(count-1) in any order. One core and all cores differ
/// in nothing else.
///
/// Sums are taken in one fixed order, which a device can follow (see `sum`). So results are equal bit by bit on any
/// number of threads and on every backend. Arguments that are written come last. They must not alias those that are
/// read, except where a verb says "in place".
template <class Loop>
class Host_backend {
public:
  using Host_loop = Loop;
  template <class T>
  using Array = Host_array<T>;
  using Vectors = Array<vec3>;
  using Scalars = Array<double>;
  using Matrix = Shared_graph;
  using Transfer = Sparse_matrix;
  using Colouring = std::vector<Host_array<int>>;

  explicit Host_backend(Loop loop = Loop()) : loop_(std::move(loop)) {}

  /// How set-up on the host is run.
  const Loop& host_loop() const { return loop_; }

  /// A bound of the relative rounding error of sums
  double rounding() const { return 1e-13; }

  /// The smallest residual that rounding allows for n vertices; 0 if it does not limit the accuracy.
  double best_accuracy(int) const { return 0; }

  /// \name Memory
  /// @{
  Vectors vectors(int n) const { return filled<vec3>(n, {0, 0, 0}); }
  Scalars scalars(int n) const { return filled<double>(n, 0); }
  template <class T>
  Array<T> upload(Host_array<T> host) const
  {
    return host;
  }
  Matrix upload(Shared_graph host) const { return host; }
  Transfer upload(Sparse_matrix host) const { return host; }
  const Vectors& download(const Vectors& x) const { return x; }
  Vectors download(Vectors&& x) const { return std::move(x); }
  Colouring colouring(Colouring colours) const { return colours; }
  /// @}

  /// \name Linear algebra
  /// @{
  /// y = x
  void copy(const Vectors& x, Vectors& y) const
  {
    for_each(x.size(), [&](int i) { copy_at(i, x.data(), y.data()); });
  }

  /// returns x . y
  double dot(const Vectors& x, const Vectors& y) const
  {
    return sum<1>(x.size(), [&](int i, double* s) { dot_at(i, x.data(), y.data(), s); })[0];
  }

  /// y = A x; returns x . y
  double multiply(const Matrix& a, const Vectors& x, Vectors& y) const
  {
    const graph_view g = a->view();
    return sum<1>(x.size(), [&](int i, double* s) { multiply_at(i, g, x.data(), y.data(), s); })[0];
  }

  /// x += alpha p and r -= alpha q, in place
  void descend(double alpha, const Vectors& p, const Vectors& q, Vectors& x, Vectors& r) const
  {
    for_each(x.size(), [&](int i) { descend_at(i, alpha, p.data(), q.data(), x.data(), r.data()); });
  }

  /// p = s + beta p, in place
  void conjugate(double beta, const Vectors& s, Vectors& p) const
  {
    for_each(p.size(), [&](int i) { conjugate_at(i, beta, s.data(), p.data()); });
  }

  /// r = b - A x
  void residual(const Matrix& a, const Vectors& b, const Vectors& x, Vectors& r) const
  {
    const graph_view g = a->view();
    for_each(x.size(), [&](int i) { residual_at(i, g, b.data(), x.data(), r.data()); });
  }

  /// x = gain D^-1 b, the damped Jacobi step from 0
  void start_smoothing(const Matrix& a, double gain, const Vectors& b, Vectors& x) const
  {
    for_each(x.size(), [&](int i) { start_smoothing_at(i, a->inverse_diagonal.data(), gain, b.data(), x.data()); });
  }

  /// y = x + gain D^-1 (b - A x), a damped Jacobi step
  void smooth(const Matrix& a, double gain, const Vectors& b, const Vectors& x, Vectors& y) const
  {
    const graph_view g = a->view();
    for_each(x.size(), [&](int i) { smooth_at(i, g, gain, b.data(), x.data(), y.data()); });
  }

  /// y = T x
  void transfer(const Transfer& t, const Vectors& x, Vectors& y) const
  {
    const sparse_view s = t.view();
    for_each(y.size(), [&](int i) { transfer_at(i, s, x.data(), y.data()); });
  }

  /// y += T x
  void transfer_add(const Transfer& t, const Vectors& x, Vectors& y) const
  {
    const sparse_view s = t.view();
    for_each(y.size(), [&](int i) { transfer_add_at(i, s, x.data(), y.data()); });
  }

  /// y = B x, B a dense square matrix by rows
  void multiply_dense(const Scalars& b, const Vectors& x, Vectors& y) const
  {
    const int n = static_cast<int>(x.size());
    for_each(n, [&](int i) { multiply_dense_at(i, n, b.data(), x.data(), y.data()); });
  }
  /// @}

  /// \name Spring energy
  /// @{
  /// Spring energy of exponent 2: sum over edges of w |v_i - v_j|^2 / 2
  double energy(const Matrix& a, const Vectors& v) const
  {
    const graph_view g = a->view();
    return sum<1>(v.size(), [&](int i, double* s) { energy_at(i, g, v.data(), s); })[0];
  }

  /// g = tangent gradient, density as in spring_gradient(); returns p E and the three sums of g
  std::array<double, 4> gradient(const Matrix& a, double p, const Vectors& v, Vectors& g, Scalars& density) const
  {
    const graph_view w = a->view();
    return sum<4>(v.size(), [&](int i, double* s) { gradient_at(i, w, p, v.data(), g.data(), density.data(), s); });
  }

  /// m = spring density of exponent 2, or 0 where negative weights (of coarse levels) make it negative
  void spring_masses(const Matrix& a, const Vectors& v, Scalars& m) const
  {
    const graph_view w = a->view();
    for_each(v.size(), [&](int i) { spring_masses_at(i, w, v.data(), m.data()); });
  }

  /// Second derivative of the Lagrangian E - mu . sum m_i v_i along the geodesics with velocity d; sum m_i |d_i|^2;
  /// and sum m_i |d_i|^2 v_i
  std::array<double, 5> curvature(const Matrix& a, double p, const Scalars& mass, vec3 mu, const Vectors& v,
                                  const Vectors& d, const Scalars& density) const
  {
    const graph_view w = a->view();
    return sum<5>(v.size(), [&](int i, double* s) {
      curvature_at(i, w, p, mass.data(), mu, v.data(), d.data(), density.data(), s);
    });
  }

  /// g -= m_i P_i mu, in place; returns sum |g_i / D_i|^2
  double balance_gradient(const Matrix& a, const Scalars& mass, vec3 mu, const Vectors& v, Vectors& g) const
  {
    return sum<1>(v.size(), [&](int i, double* s) {
      balance_gradient_at(i, a->inverse_diagonal.data(), mass.data(), mu, v.data(), g.data(), s);
    })[0];
  }

  /// What decides about the next direction beta d - step, projected: old_g . P step; for P step its product with g,
  /// sum m_i (P step)_i and sum m_i v_i x (P step)_i; and the same seven for P d
  std::array<double, 15> direction_products(const Scalars& mass, const Vectors& v, const Vectors& g,
                                            const Vectors& old_g, const Vectors& step, const Vectors& d) const
  {
    return sum<15>(v.size(), [&](int i, double* s) {
      direction_products_at(i, mass.data(), v.data(), g.data(), old_g.data(), step.data(), d.data(), s);
    });
  }

  /// d = P (beta d - step - y) - omega x v, in place: y and omega are an infinitesimal boost and rotation
  void next_direction(double beta, vec3 y, vec3 omega, const Vectors& v, const Vectors& step, Vectors& d) const
  {
    for_each(v.size(), [&](int i) { next_direction_at(i, beta, y, omega, v.data(), step.data(), d.data()); });
  }

  /// w = v moved by alpha d and a small boost with centre c; returns the moments of w
  Moments retract(const Scalars& mass, double alpha, vec3 c, const Vectors& v, const Vectors& d, Vectors& w) const
  {
    return to_moments(sum<9>(
      v.size(), [&](int i, double* s) { retract_at(i, mass.data(), alpha, c, v.data(), d.data(), w.data(), s); }));
  }

  /// returns the moments of v
  Moments moments(const Scalars& mass, const Vectors& v) const
  {
    return to_moments(sum<9>(v.size(), [&](int i, double* s) { moments_at(i, mass.data(), v.data(), s); }));
  }

  /// w = boost of v with centre c; returns the moments of w
  Moments transform(const Scalars& mass, vec3 c, const Vectors& v, Vectors& w) const
  {
    return to_moments(
      sum<9>(v.size(), [&](int i, double* s) { transform_at(i, mass.data(), c, v.data(), w.data(), s); }));
  }
  /// @}

  /// \name The published method
  /// @{
  /// One Jacobi sweep of Algorithm 1 from u to w.
  void jacobi_sweep(const Matrix& a, double omega, const Vectors& v, const Vectors& u, Vectors& w) const
  {
    const graph_view g = a->view();
    for_each(v.size(), [&](int i) { jacobi_sweep_at(i, g, omega, v.data(), u.data(), w.data()); });
  }

  /// One Gauss-Seidel sweep, in place, colour after colour: no two vertices of a colour are neighbours.
  void gauss_seidel_sweep(const Matrix& a, const Colouring& colours, double omega, const Vectors& v, Vectors& u) const
  {
    const graph_view g = a->view();
    for(const Host_array<int>& colour : colours)
      for_each(colour.size(), [&](int k) { gauss_seidel_sweep_at(k, g, colour.data(), omega, v.data(), u.data()); });
  }

  /// Squared L2 norm of P_v (u_i - neighbour mean of u): the residual of the saddle-point problem at u.
  double saddle_point_residual2(const Matrix& a, const Vectors& v, const Vectors& u) const
  {
    const graph_view g = a->view();
    return sum<1>(v.size(), [&](int i, double* s) { saddle_point_residual2_at(i, g, v.data(), u.data(), s); })[0];
  }

  /// v = u / |u|, except at fixed vertices
  void normalize(const Matrix& a, const Vectors& u, Vectors& v) const
  {
    for_each(v.size(), [&](int i) { normalize_at(i, a->inverse_diagonal.data(), u.data(), v.data()); });
  }

  /// Squared L2 norm of the residual of eq. (2).
  double barycentric_residual2(const Matrix& a, const Vectors& v) const
  {
    const graph_view g = a->view();
    return sum<1>(v.size(), [&](int i, double* s) { barycentric_residual2_at(i, g, v.data(), s); })[0];
  }
  /// @}

private:
  static constexpr int block_size = 1024;
  static constexpr int lanes = 64;

  template <class T>
  Array<T> filled(int n, T value) const
  {
    Array<T> x(n);
    for_each(n, [&](int i) { x[i] = value; });
    return x;
  }

  template <class F>
  void for_each(std::size_t n, F f) const
  {
    const int size = static_cast<int>(n);
    for_each_block(size, [&](int block) {
      const int end = (std::min)(size, (block + 1) * block_size);
      for(int i = block * block_size; i < end; ++i)
        f(i);
    });
  }

  /// A few blocks are run on the calling thread: that is faster than waking other threads.
  template <class F>
  void for_each_block(int n, F f) const
  {
    constexpr int few = 3;
    const int blocks = (n + block_size - 1) / block_size;
    if(blocks <= few)
      Sequential_loop().for_each(blocks, f);
    else
      loop_.for_each(blocks, f);
  }

  /// Lane l of a block adds up the elements i with i % lanes == l. The lanes are added pairwise, then the blocks in
  /// order. The order is that of a work-group (kernels/backend/loops.cl), and the same for any number of threads.
  template <int K, class F>
  std::array<double, K> sum(std::size_t n, F f) const
  {
    const int size = static_cast<int>(n);
    std::vector<std::array<double, K>> partial((size + block_size - 1) / block_size);
    for_each_block(size, [&](int block) {
      std::array<std::array<double, K>, lanes> lane{};
      const int end = (std::min)(size, (block + 1) * block_size);
      for(int i = block * block_size; i < end;)
        for(int l = 0; l < lanes && i < end; ++l, ++i)
          f(i, lane[l].data());
      for(int half = lanes / 2; half > 0; half /= 2)
        for(int l = 0; l < half; ++l)
          for(int k = 0; k < K; ++k)
            lane[l][k] += lane[l + half][k];
      partial[block] = lane[0];
    });
    std::array<double, K> total{};
    for(const auto& s : partial)
      for(int k = 0; k < K; ++k)
        total[k] += s[k];
    return total;
  }

  Loop loop_;
};

/// One core
class Sequential_backend : public Host_backend<Sequential_loop> {
public:
  explicit Sequential_backend(const CGAL::Sequential_tag&) {}
  std::string device_name() const { return "one core"; }
};

template <class Loop>
struct Backend_for<CGAL::Sequential_tag, Loop> {
  using type = Sequential_backend;
};

#ifdef CGAL_LINKED_WITH_TBB
/// The threads of the caller's TBB arena
class Parallel_backend : public Host_backend<Parallel_loop> {
public:
  explicit Parallel_backend(const CGAL::Parallel_tag&) {}
  std::string device_name() const { return std::to_string(tbb::this_task_arena::max_concurrency()) + " threads"; }
};

template <class Loop>
struct Backend_for<CGAL::Parallel_tag, Loop> {
  using type = Parallel_backend;
};
#endif

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_HOST_BACKEND_H
