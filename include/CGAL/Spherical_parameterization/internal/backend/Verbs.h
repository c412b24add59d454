// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_VERBS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_VERBS_H

#include <CGAL/Spherical_parameterization/internal/backend/vertex_formulas.h>

#include <array>

namespace CGAL::Spherical_parameterization::internal {

/// The sums that decide about balance: sum m_i v_i and sum m_i v_i v_i^T (xx, xy, xz, yy, yz, zz).
typedef std::array<double, 9> Moments;

/// A loop over a formula, which adds to K sums. A host calls the formula; a device runs the kernel of this name, which
/// calls it.
template <auto Formula_at, int K = 0>
struct Verb {
  const char* kernel;
};

/// The verbs of a backend, once for all. A verb `v` is a loop over the formula `v_at` of vertex_formulas.h, which says
/// what is computed; verbs with sums return them. Overloads for `Steps` are loops over `float_v_at`. A machine has the
/// memory, and two functions:
/// - `run(verb, n, arguments...)` calls the formula for i = 0 ... n-1, in any order;
/// - `sum(verb, n, arguments...)` does, too, and returns the sums.
///
/// Sums are taken in one fixed order (see Host_machine::sum). So results are equal bit by bit on any number of threads
/// and on every backend. Arguments that are written come last. They must not alias those that are read. On a device,
/// verbs that return numbers wait for it. All others return at once.
template <class Machine>
class Verbs : public Machine {
  using Machine::run;
  using Machine::sum;

public:
  using Vectors = typename Machine::Vectors;
  using Scalars = typename Machine::Scalars;
  using Steps = typename Machine::Steps; ///< vectors of floats
  using Floats = typename Machine::Floats;
  using Matrix = typename Machine::Matrix;
  using Smoother = typename Machine::Smoother;
  using Aggregates = typename Machine::Aggregates;
  using Colouring = typename Machine::Colouring;
  using Machine::Machine;

  // Linear algebra

  /// On a device, too, by a kernel: drivers for CPUs copy buffers on one core.
  void copy(const Vectors& x, Vectors& y) const { run(Verb<copy_at>{"sp_copy"}, x.size(), x, y); }

  double dot(const Vectors& x, const Vectors& y) const { return sum(Verb<dot_at, 1>{"sp_dot"}, x.size(), x, y)[0]; }

  double multiply(const Matrix& a, const Vectors& x, Vectors& y) const
  {
    return sum(Verb<multiply_at, 1>{"sp_multiply"}, x.size(), a, x, y)[0];
  }

  void descend(double alpha, const Vectors& p, const Vectors& q, Vectors& x, Vectors& r) const
  {
    run(Verb<descend_at>{"sp_descend"}, x.size(), alpha, p, q, x, r);
  }

  void conjugate(double beta, const Vectors& s, Vectors& p) const
  {
    run(Verb<conjugate_at>{"sp_conjugate"}, p.size(), beta, s, p);
  }

  void residual(const Matrix& a, const Vectors& b, const Vectors& x, Vectors& r) const
  {
    run(Verb<residual_at>{"sp_residual"}, x.size(), a, b, x, r);
  }

  void start_smoothing(const Matrix& a, double gain, const Vectors& b, Vectors& x) const
  {
    run(Verb<start_smoothing_at>{"sp_start_smoothing"}, x.size(), a->inverse_diagonal, gain, b, x);
  }

  void smooth(const Matrix& a, double gain, const Vectors& b, const Vectors& x, Vectors& y) const
  {
    run(Verb<smooth_at>{"sp_smooth"}, x.size(), a, gain, b, x, y);
  }

  void correct(const Aggregates& of, const Vectors& e, Vectors& x) const
  {
    run(Verb<correct_at>{"sp_correct"}, x.size(), of, e, x);
  }

  void restrict(const Aggregates& of, const Vectors& r, Vectors& y) const
  {
    run(Verb<restrict_at>{"sp_restrict"}, y.size(), of, r, y);
  }

  void multiply_dense(const Scalars& b, const Vectors& x, Vectors& y) const
  {
    const int columns = static_cast<int>(x.size());
    run(Verb<multiply_dense_at>{"sp_multiply_dense"}, x.size(), columns, b, x, y);
  }

  // A multigrid cycle in floats

  void start_smoothing(const Smoother& a, double gain, double second_gain, const Steps& b, Steps& x) const
  {
    run(Verb<float_start_smoothing_at>{"sp_float_start_smoothing"}, x.size(), a, gain, second_gain, b, x);
  }

  void smooth(const Smoother& a, double gain, const Steps& b, const Steps& x, Steps& y) const
  {
    run(Verb<float_smooth_at>{"sp_float_smooth"}, x.size(), a, gain, b, x, y);
  }

  void residual(const Smoother& a, const Steps& b, const Steps& x, Steps& r) const
  {
    run(Verb<float_residual_at>{"sp_float_residual"}, x.size(), a, b, x, r);
  }

  void restrict(const Aggregates& of, const Floats& share, const Steps& r, Steps& y) const
  {
    run(Verb<float_restrict_at>{"sp_float_restrict"}, y.size(), of, share, r, y);
  }

  void correct(const Aggregates& of, const Steps& e, Steps& x) const
  {
    run(Verb<float_correct_at>{"sp_float_correct"}, x.size(), of, e, x);
  }

  void multiply_dense(const Scalars& b, const Matrix& a, const Steps& x, Steps& y) const
  {
    const int columns = static_cast<int>(x.size());
    run(Verb<float_multiply_dense_at>{"sp_float_multiply_dense"}, x.size(), columns, b, a->inverse_diagonal, x, y);
  }

  // Spring energy

  double energy(const Matrix& a, const Vectors& v) const
  {
    return sum(Verb<energy_at, 1>{"sp_energy"}, v.size(), a, v)[0];
  }

  /// Exponents above 2 have kernels of their own.
  std::array<double, 4> gradient(const Matrix& a, double p, const Vectors& v, Vectors& g, Scalars& density) const
  {
    return p == 2 ? sum(Verb<gradient_at, 4>{"sp_gradient"}, v.size(), a, v, g, density)
                  : sum(Verb<stiffening_gradient_at, 4>{"sp_stiffening_gradient"}, v.size(), a, p, v, g, density);
  }

  void spring_masses(const Matrix& a, const Vectors& v, Scalars& m) const
  {
    run(Verb<spring_masses_at>{"sp_spring_masses"}, v.size(), a, v, m);
  }

  Moments tilt_masses(const Scalars& density, vec3 tilt, const Vectors& v, Scalars& m) const
  {
    return sum(Verb<tilt_masses_at, 9>{"sp_tilt_masses"}, v.size(), density, tilt, v, m);
  }

  std::array<double, 5> curvature(const Matrix& a, double p, const Scalars& mass, vec3 mu, const Vectors& v,
                                  const Steps& d, const Scalars& density) const
  {
    return p == 2 ? sum(Verb<curvature_at, 5>{"sp_curvature"}, v.size(), a, mass, mu, v, d, density)
                  : sum(Verb<stiffening_curvature_at, 5>{"sp_stiffening_curvature"}, v.size(), a, p, mass, mu, v, d,
                        density);
  }

  std::array<double, 2> balance_gradient(const Matrix& a, const Scalars& mass, vec3 mu, const Vectors& v,
                                         const Vectors& g, const Steps& step, Steps& b) const
  {
    return sum(Verb<balance_gradient_at, 2>{"sp_balance_gradient"}, v.size(), a->inverse_diagonal, mass, mu, v, g, step,
               b);
  }

  std::array<double, 14> direction_products(const Matrix& a, const Scalars& mass, const Vectors& v, const Steps& b,
                                            const Steps& step, const Steps& d) const
  {
    return sum(Verb<direction_products_at, 14>{"sp_direction_products"}, v.size(), a->inverse_diagonal, mass, v, b,
               step, d);
  }

  void next_direction(double beta, vec3 y, vec3 omega, const Vectors& v, const Steps& step, Steps& d) const
  {
    run(Verb<next_direction_at>{"sp_next_direction"}, v.size(), beta, y, omega, v, step, d);
  }

  Moments retract(const Scalars& mass, double alpha, vec3 c, const Vectors& v, const Steps& d, Vectors& w) const
  {
    return sum(Verb<retract_at, 9>{"sp_retract"}, v.size(), mass, alpha, c, v, d, w);
  }

  Moments moments(const Scalars& mass, const Vectors& v) const
  {
    return sum(Verb<moments_at, 9>{"sp_moments"}, v.size(), mass, v);
  }

  Moments transform(const Scalars& mass, vec3 c, const Vectors& v, Vectors& w) const
  {
    return sum(Verb<transform_at, 9>{"sp_transform"}, v.size(), mass, c, v, w);
  }

  // The published method

  void jacobi_sweep(const Matrix& a, double omega, const Vectors& v, const Vectors& u, Vectors& w) const
  {
    run(Verb<jacobi_sweep_at>{"sp_jacobi_sweep"}, v.size(), a, omega, v, u, w);
  }

  /// Colour after colour: no two vertices of a colour are neighbours.
  void gauss_seidel_sweep(const Matrix& a, const Colouring& colours, double omega, const Vectors& v, Vectors& u) const
  {
    for(const auto& colour : colours)
      run(Verb<gauss_seidel_sweep_at>{"sp_gauss_seidel_sweep"}, colour.size(), a, colour, omega, v, u);
  }

  double saddle_point_residual2(const Matrix& a, const Vectors& v, const Vectors& u) const
  {
    return sum(Verb<saddle_point_residual2_at, 1>{"sp_saddle_point_residual2"}, v.size(), a, v, u)[0];
  }

  void normalize(const Matrix& a, const Vectors& u, Vectors& v) const
  {
    run(Verb<normalize_at>{"sp_normalize"}, v.size(), a->inverse_diagonal, u, v);
  }

  double barycentric_residual2(const Matrix& a, const Vectors& v) const
  {
    return sum(Verb<barycentric_residual2_at, 1>{"sp_barycentric_residual2"}, v.size(), a, v)[0];
  }
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_VERBS_H
