// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef BENCHMARK_COUNTING_POLICY_H
#define BENCHMARK_COUNTING_POLICY_H

// The solvers are compiled for this policy, too, which the compiled library does not know.
#include <CGAL/Spherical_parameterization/internal/backend/Host_backend.h>
#include <CGAL/Spherical_parameterization/internal/driver/solve_impl.h>
#include <CGAL/Spherical_parameterization/internal/harmonic/solve_balanced_impl.h>
#include <CGAL/Spherical_parameterization/internal/saddle_point/solve_saddle_point_impl.h>
#include <CGAL/Spherical_parameterization/parameterize.h>

#include <cstddef>
#include <string>
#include <type_traits>

namespace benchmark {

/// An execution policy like `CGAL::Sequential_tag` that counts the work of the solvers in entries of sparse matrices:
/// an edge of a weighted graph, seen from one end, or an entry of a transfer between levels, each time that it is used.
/// What is left out are vector operations and the set-up of the hierarchy.
struct Counting_policy {
  std::size_t* entries;
};

} // namespace benchmark

namespace CGAL::Spherical_parameterization::internal {

class Counting_backend : public Host_backend<Sequential_loop> {
  typedef Host_backend<Sequential_loop> Base;

public:
  explicit Counting_backend(const benchmark::Counting_policy& policy) : entries_(*policy.entries) {}
  std::string device_name() const { return "one core, counting"; }

  double multiply(const Matrix& a, const Vectors& x, Vectors& y) const
  {
    count(a);
    return Base::multiply(a, x, y);
  }
  void residual(const Matrix& a, const Vectors& b, const Vectors& x, Vectors& r) const
  {
    count(a);
    Base::residual(a, b, x, r);
  }
  void smooth(const Matrix& a, double gain, const Vectors& b, const Vectors& x, Vectors& y) const
  {
    count(a);
    Base::smooth(a, gain, b, x, y);
  }
  void transfer(const Transfer& t, const Vectors& x, Vectors& y) const
  {
    entries_ += t.column.size();
    Base::transfer(t, x, y);
  }
  void transfer_add(const Transfer& t, const Vectors& x, Vectors& y) const
  {
    entries_ += t.column.size();
    Base::transfer_add(t, x, y);
  }
  double energy(const Matrix& a, const Vectors& x) const
  {
    count(a);
    return Base::energy(a, x);
  }
  std::array<double, 4> gradient(const Matrix& a, double p, const Vectors& v, Vectors& g, Scalars& density) const
  {
    count(a);
    return Base::gradient(a, p, v, g, density);
  }
  void spring_masses(const Matrix& a, const Vectors& v, Scalars& m) const
  {
    count(a);
    Base::spring_masses(a, v, m);
  }
  std::array<double, 5> curvature(const Matrix& a, double p, const Scalars& mass, vec3 mu, const Vectors& v,
                                  const Vectors& d, const Scalars& density) const
  {
    count(a);
    return Base::curvature(a, p, mass, mu, v, d, density);
  }
  void jacobi_sweep(const Matrix& a, double omega, const Vectors& v, const Vectors& u, Vectors& w) const
  {
    count(a);
    Base::jacobi_sweep(a, omega, v, u, w);
  }
  void gauss_seidel_sweep(const Matrix& a, const Colouring& colours, double omega, const Vectors& v, Vectors& u) const
  {
    count(a);
    Base::gauss_seidel_sweep(a, colours, omega, v, u);
  }
  double saddle_point_residual2(const Matrix& a, const Vectors& v, const Vectors& u) const
  {
    count(a);
    return Base::saddle_point_residual2(a, v, u);
  }
  double barycentric_residual2(const Matrix& a, const Vectors& v) const
  {
    count(a);
    return Base::barycentric_residual2(a, v);
  }

private:
  void count(const Matrix& a) const { entries_ += a->target.size(); }

  std::size_t& entries_;
};

template <class Loop>
struct Backend_for<benchmark::Counting_policy, Loop> {
  using type = Counting_backend;
};
template <>
struct Is_policy<benchmark::Counting_policy> : std::true_type {};

} // namespace CGAL::Spherical_parameterization::internal

#endif // BENCHMARK_COUNTING_POLICY_H
