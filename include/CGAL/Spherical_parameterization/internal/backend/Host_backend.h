// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_HOST_BACKEND_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_HOST_BACKEND_H

#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/base/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/backend/vertex_formulas.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

/// The sums that decide about balance: s = sum m_i v_i and S = sum m_i v_i v_i^T (xx, xy, xz, yy, yz, zz).
struct Moments {
  std::array<double, 3> first{};
  std::array<double, 6> second{};
};

/// The verbs of a backend whose memory is the host's. `Loop::for_each(count, f)` runs f(0) ... f(count-1) in any order;
/// it is all that differs between one core and all cores.
///
/// Sums are taken in one fixed order, which a device can follow, too (see `sum`): results are equal bit by bit on any
/// number of threads and on every backend. Arguments that are written come last; they must not alias the ones that are
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

  /// What set-up on the host is run with.
  const Loop& host_loop() const { return loop_; }

  /// Relative error that sums may have
  double rounding() const { return 1e-13; }

  /// The residual that rounding leaves of a map of n vertices; 0: none that could be in the way of the user's accuracy
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
    for_each(x.size(), [&](int i) { y[i] = x[i]; });
  }

  /// returns x . y
  double dot(const Vectors& x, const Vectors& y) const
  {
    return sum<1>(x.size(), [&](int i, auto& s) { s[0] += inner(x[i], y[i]); })[0];
  }

  /// y = A x; returns x . y
  double multiply(const Matrix& a, const Vectors& x, Vectors& y) const
  {
    const graph_view g = a->view();
    return sum<1>(x.size(), [&](int i, auto& s) {
      y[i] = laplacian(i, g, x.data());
      s[0] += inner(x[i], y[i]);
    })[0];
  }

  /// x += alpha p and r -= alpha q, in place
  void descend(double alpha, const Vectors& p, const Vectors& q, Vectors& x, Vectors& r) const
  {
    for_each(x.size(), [&](int i) {
      x[i] = add_scaled(x[i], alpha, p[i]);
      r[i] = add_scaled(r[i], -alpha, q[i]);
    });
  }

  /// p = s + beta p, in place
  void conjugate(double beta, const Vectors& s, Vectors& p) const
  {
    for_each(p.size(), [&](int i) { p[i] = add_scaled(s[i], beta, p[i]); });
  }

  /// Spring energy of exponent 2: sum over edges of w |x_i - x_j|^2 / 2
  double energy(const Matrix& a, const Vectors& x) const
  {
    const graph_view g = a->view();
    return sum<1>(x.size(), [&](int i, auto& s) { s[0] += spring_density(i, g, 2, x.data()); })[0] / 2;
  }

  /// r = b - A x
  void residual(const Matrix& a, const Vectors& b, const Vectors& x, Vectors& r) const
  {
    const graph_view g = a->view();
    for_each(x.size(), [&](int i) { r[i] = sub(b[i], laplacian(i, g, x.data())); });
  }

  /// x = gain D^-1 b, the damped Jacobi step from 0
  void start_smoothing(const Matrix& a, double gain, const Vectors& b, Vectors& x) const
  {
    for_each(x.size(), [&](int i) { x[i] = scale(gain * a->inverse_diagonal[i], b[i]); });
  }

  /// y = x + gain D^-1 (b - A x), a damped Jacobi step
  void smooth(const Matrix& a, double gain, const Vectors& b, const Vectors& x, Vectors& y) const
  {
    const graph_view g = a->view();
    for_each(x.size(), [&](int i) { y[i] = smoothing_step(i, g, gain, b.data(), x.data()); });
  }

  /// y = T x
  void transfer(const Transfer& t, const Vectors& x, Vectors& y) const
  {
    const sparse_view s = t.view();
    for_each(y.size(), [&](int i) { y[i] = row_times(i, s, x.data()); });
  }

  /// y += T x
  void transfer_add(const Transfer& t, const Vectors& x, Vectors& y) const
  {
    const sparse_view s = t.view();
    for_each(y.size(), [&](int i) { y[i] = add(y[i], row_times(i, s, x.data())); });
  }

  /// y = B x, B a dense square matrix by rows
  void multiply_dense(const Scalars& b, const Vectors& x, Vectors& y) const
  {
    const int n = static_cast<int>(x.size());
    for_each(n, [&](int i) {
      vec3 r = make_vec3(0, 0, 0);
      for(int j = 0; j < n; ++j)
        r = add_scaled(r, b[std::size_t(i) * n + j], x[j]);
      y[i] = r;
    });
  }
  /// @}

  /// \name Spring energy
  /// @{
  /// g = tangent gradient, density as in spring_gradient(); returns p E and the three sums of g
  std::array<double, 4> gradient(const Matrix& a, double p, const Vectors& v, Vectors& g, Scalars& density) const
  {
    const graph_view w = a->view();
    return sum<4>(v.size(), [&](int i, auto& s) {
      g[i] = spring_gradient(i, w, p, v.data(), &density[i]);
      s[0] += density[i];
      s[1] += g[i].x;
      s[2] += g[i].y;
      s[3] += g[i].z;
    });
  }

  /// m = spring density of exponent 2, or 0 where negative weights (of coarse levels) make it negative
  void spring_masses(const Matrix& a, const Vectors& v, Scalars& m) const
  {
    const graph_view w = a->view();
    for_each(v.size(), [&](int i) { m[i] = (std::max)(0., spring_density(i, w, 2, v.data())); });
  }

  /// g -= m_i P_i mu, in place; returns sum |g_i / D_i|^2
  double balance_gradient(const Matrix& a, const Scalars& mass, vec3 mu, const Vectors& v, Vectors& g) const
  {
    return sum<1>(v.size(), [&](int i, auto& s) {
      g[i] = add_scaled(g[i], -mass[i], tangent(mu, v[i]));
      const double inverse = a->inverse_diagonal[i];
      s[0] += inner(g[i], g[i]) * inverse * inverse;
    })[0];
  }

  /// What decides about the next direction beta d - s, projected: old_g . P s; for P s its product with g, sum m_i s_i
  /// and sum m_i v_i x s_i; and the same seven for P d
  std::array<double, 15> direction_products(const Scalars& mass, const Vectors& v, const Vectors& g,
                                            const Vectors& old_g, const Vectors& s, const Vectors& d) const
  {
    return sum<15>(v.size(), [&](int i, auto& t) {
      const vec3 step = tangent(s[i], v[i]);
      t[0] += inner(old_g[i], step);
      add_products(mass[i], v[i], g[i], step, &t[1]);
      add_products(mass[i], v[i], g[i], tangent(d[i], v[i]), &t[8]);
    });
  }

  /// d = P (beta d - s - y) - omega x v, in place: y and omega are an infinitesimal boost and rotation
  void direct(double beta, vec3 y, vec3 omega, const Vectors& v, const Vectors& s, Vectors& d) const
  {
    for_each(v.size(), [&](int i) { d[i] = next_direction(beta, y, omega, v[i], s[i], d[i]); });
  }

  /// Second derivative of the Lagrangian E - mu . sum m_i v_i along the geodesics with velocity d; sum m_i |d_i|^2;
  /// and sum m_i |d_i|^2 v_i
  std::array<double, 5> curvature(const Matrix& a, double p, const Scalars& mass, vec3 mu, const Vectors& v,
                                  const Vectors& d, const Scalars& density) const
  {
    const graph_view w = a->view();
    return sum<5>(v.size(), [&](int i, auto& s) {
      s[0] += spring_curvature(i, w, p, v.data(), d.data(), density[i] - mass[i] * inner(mu, v[i]));
      const double push = mass[i] * inner(d[i], d[i]);
      s[1] += push;
      s[2] += push * v[i].x;
      s[3] += push * v[i].y;
      s[4] += push * v[i].z;
    });
  }

  /// w = v moved by alpha d and a small boost with centre c; returns the moments of w
  Moments retract(const Scalars& mass, double alpha, vec3 c, const Vectors& v, const Vectors& d, Vectors& w) const
  {
    return moments_of(mass, v.size(), [&](int i) { return w[i] = displaced(v[i], alpha, d[i], c); });
  }

  /// returns the moments of v
  Moments moments(const Scalars& mass, const Vectors& v) const
  {
    return moments_of(mass, v.size(), [&](int i) { return v[i]; });
  }

  /// w = boost of v with centre c; returns the moments of w
  Moments transform(const Scalars& mass, vec3 c, const Vectors& v, Vectors& w) const
  {
    return moments_of(mass, v.size(), [&](int i) { return w[i] = boost(v[i], c); });
  }
  /// @}

  /// \name The published method
  /// @{
  /// One Jacobi sweep of Algorithm 1 from u to w.
  void jacobi_sweep(const Matrix& a, double omega, const Vectors& v, const Vectors& u, Vectors& w) const
  {
    const graph_view g = a->view();
    for_each(v.size(), [&](int i) { w[i] = saddle_point_relaxation(i, g, omega, v.data(), u.data()); });
  }

  /// One Gauss-Seidel sweep, in place, colour after colour: no two vertices of a colour are neighbours.
  void gauss_seidel_sweep(const Matrix& a, const Colouring& colours, double omega, const Vectors& v, Vectors& u) const
  {
    const graph_view g = a->view();
    for(const Host_array<int>& colour : colours)
      for_each(colour.size(), [&](int k) {
        const int i = colour[k];
        u[i] = saddle_point_relaxation(i, g, omega, v.data(), u.data());
      });
  }

  /// Squared L2 norm of P_v (u_i - neighbour mean of u): the residual of the saddle-point problem at u.
  double saddle_point_residual2(const Matrix& a, const Vectors& v, const Vectors& u) const
  {
    const graph_view g = a->view();
    return sum<1>(v.size(), [&](int i, auto& s) {
      const vec3 step = sub(saddle_point_relaxation(i, g, 1, v.data(), u.data()), u[i]);
      s[0] += inner(step, step);
    })[0];
  }

  /// v = u / |u|, but at fixed vertices
  void normalise(const Matrix& a, const Vectors& u, Vectors& v) const
  {
    for_each(v.size(), [&](int i) {
      if(a->inverse_diagonal[i] > 0)
        v[i] = unit(u[i]);
    });
  }

  /// Squared L2 norm of the residual of eq. (2).
  double barycentric_residual2(const Matrix& a, const Vectors& v) const
  {
    const graph_view g = a->view();
    return sum<1>(v.size(), [&](int i, auto& s) {
      const vec3 r = barycentric_residual(i, g, v.data());
      s[0] += inner(r, r);
    })[0];
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

  /// Waking other threads takes longer than a few blocks.
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

  /// Element i is added by lane i % lanes of its block, the lanes are added pairwise, the blocks in order: the
  /// reduction tree of a work-group.
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
          f(i, lane[l]);
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

  template <class F>
  Moments moments_of(const Scalars& mass, std::size_t n, F position) const
  {
    const auto s = sum<9>(n, [&](int i, auto& t) { add_moments(mass[i], position(i), t.data()); });
    Moments r;
    std::copy(s.begin(), s.begin() + 3, r.first.begin());
    std::copy(s.begin() + 3, s.end(), r.second.begin());
    return r;
  }

  Loop loop_;
};

template <>
class Backend<CGAL::Sequential_tag> : public Host_backend<Sequential_loop> {
public:
  explicit Backend(const CGAL::Sequential_tag&) {}
  std::string device_name() const { return "one core"; }
};

#ifdef CGAL_LINKED_WITH_TBB
template <>
class Backend<CGAL::Parallel_tag> : public Host_backend<Parallel_loop> {
public:
  explicit Backend(const CGAL::Parallel_tag&) {}
  std::string device_name() const { return std::to_string(tbb::this_task_arena::max_concurrency()) + " threads"; }
};
#endif

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_HOST_BACKEND_H
