// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SADDLE_POINT_SADDLE_POINT_SOLVER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SADDLE_POINT_SADDLE_POINT_SOLVER_H

#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/base/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/problem/Solution.h>
#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/methods.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Greedy colouring in vertex order: vertices of one colour have no edge between them, so that a Gauss-Seidel sweep may
/// treat them at once, and gives the same result on every backend.
inline std::vector<Host_array<int>> greedy_colouring(const Weighted_graph& a)
{
  std::vector<Host_array<int>> colours;
  Host_array<int> colour(a.size(), -1);
  std::vector<int> used_by;
  for(int i = 0; i < a.size(); ++i) {
    for(int k = a.offset[i]; k < a.offset[i + 1]; ++k)
      if(colour[a.target[k]] >= 0)
        used_by[colour[a.target[k]]] = i;
    const std::size_t c = std::find_if(used_by.begin(), used_by.end(), [i](int u) { return u != i; }) - used_by.begin();
    if(c == colours.size()) {
      colours.emplace_back();
      used_by.push_back(-1);
    }
    colours[c].push_back(i);
    colour[i] = static_cast<int>(c);
  }
  return colours;
}

/// The published method: minimise the spring energy subject to u_i . v_i = 1, normalize, repeat.
///
/// In coordinates of the tangent planes the constrained problem is a symmetric positive definite system with diagonal
/// blocks D_i I. Algorithm 1 is its Jacobi iteration; its block Gauss-Seidel iteration, which converges for relaxation
/// in (0, 2) by the theorem of Ostrowski and Reich, relaxes one vertex after the other by the same formula.
template <class Backend>
class Saddle_point_solver {
  typedef typename Backend::Vectors Vectors;

public:
  Saddle_point_solver(const Backend& backend, const typename Backend::Matrix& matrix, const Weighted_graph& graph,
                      const Saddle_point& method)
    : backend_(backend), matrix_(matrix), method_(method)
  {
    if(method.splitting == Saddle_point::Splitting::GAUSS_SEIDEL)
      colours_ = backend.colouring(greedy_colouring(graph));
  }

  Solver_report solve(Vectors& v, double accuracy, std::size_t maximum_iterations, Monitor& monitor)
  {
    // The outer iteration contracts slowly or not at all along the boosts; ten of them without progress are a stall.
    constexpr std::size_t patience = 10;
    const int n = static_cast<int>(v.size());
    Vectors u = backend_.vectors(n), w = backend_.vectors(n);
    backend_.copy(v, u);
    Solver_report report;
    double first = 0, best = 0;
    std::size_t best_at = 0;
    for(;; ++report.iterations) {
      report.residual = std::sqrt(backend_.barycentric_residual2(matrix_, v));
      report.energy = backend_.energy(matrix_, v);
      monitor.log("saddle point", report.iterations, report.residual, report.energy);
      report.has_converged = report.residual <= accuracy;
      if(report.iterations == 0)
        first = report.residual;
      if(report.iterations == 0 || report.residual < best) {
        best = report.residual;
        best_at = report.iterations;
      }
      report.has_stalled = report.iterations >= best_at + patience;
      const double share = Monitor::share(report.residual, first, accuracy);
      if(report.has_converged || report.has_stalled || report.iterations == maximum_iterations ||
         !monitor.advance(share))
        return report;
      report.sweeps += solve_saddle_point(v, u, w, accuracy, monitor, share);
      // Any u with u_i . v_i = 1 and lower energy will do (Proposition 1), an interrupted one, too.
      backend_.normalize(matrix_, u, v);
      backend_.copy(v, u);
    }
  }

private:
  /// Sweeps until the residual of the saddle-point problem has fallen by the factor `accuracy`, or far below what the
  /// outer iteration aims at. Tested every check_interval sweeps. Returns the number of sweeps.
  std::size_t solve_saddle_point(const Vectors& v, Vectors& u, Vectors& w, double accuracy, Monitor& monitor,
                                 double share)
  {
    constexpr double far_below = 1e-2;
    const double first = std::sqrt(backend_.saddle_point_residual2(matrix_, v, u));
    const double goal = (std::max)(accuracy * first, far_below * accuracy);
    std::size_t sweeps = 0;
    double residual = first;
    while(residual > goal && monitor.advance(share)) {
      for(std::size_t k = 0; k < method_.check_interval; ++k)
        if(method_.splitting == Saddle_point::Splitting::JACOBI) {
          backend_.jacobi_sweep(matrix_, method_.relaxation, v, u, w);
          std::swap(u, w);
        } else
          backend_.gauss_seidel_sweep(matrix_, colours_, method_.relaxation, v, u);
      sweeps += method_.check_interval;
      const double next = std::sqrt(backend_.saddle_point_residual2(matrix_, v, u));
      if(!(next < residual)) // rounding has the last word
        break;
      residual = next;
    }
    return sweeps;
  }

  const Backend& backend_;
  const typename Backend::Matrix& matrix_;
  Saddle_point method_;
  typename Backend::Colouring colours_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SADDLE_POINT_SADDLE_POINT_SOLVER_H
