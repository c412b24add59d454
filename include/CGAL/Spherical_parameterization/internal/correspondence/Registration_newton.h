// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_REGISTRATION_NEWTON_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_REGISTRATION_NEWTON_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/backend/Host_backend.h>
#include <CGAL/Spherical_parameterization/internal/context/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/Registration_energy.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/multigrid/Multigrid.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/Face_hessian.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Newton's direction for the registration energy, of which every part is made positive. The system is solved by
/// conjugate gradients, preconditioned by a multigrid cycle of the graph whose weights are what the blocks of the
/// matrix are in the mean over all directions, so that the number of iterations hardly depends on the size.
template <class...>
class Registration_newton {
public:
  /// \param is_held  which vertices do not move
  Registration_newton(const Host_loop& loop, const Registration_energy<>& energy, const std::vector<char>& is_held,
                      Monitor& monitor)
    : loop_(loop), backend_(loop), energy_(energy), is_held_(is_held), monitor_(monitor), row_(energy.size()),
      entry_(energy.corner_offset().back())
  {}

  /// Less exact if the work has to end.
  /// \param g         the gradient at x, where the energy was looked at last
  /// \param progress  how far the work has come
  Host_array<vec3> direction(const Host_array<vec3>& x, const Host_array<vec3>& g, double progress)
  {
    assemble(x);
    return solve(g, progress);
  }

private:
  struct Entry {
    int column;
    Block block;
  };
  struct Row {
    Tangents tangents;
    Block diagonal;
  };
  typedef typename Registration_energy<>::Face_blocks Face_blocks;

  int size() const { return static_cast<int>(row_.size()); }

  template <class F>
  void for_each_vertex(F f) const
  {
    for_each_index(loop_, size(), f);
  }

  /// The blocks of the faces first, then the rows that they add up to.
  void assemble(const Host_array<vec3>& x)
  {
    for_each_vertex([&](int i) { row_[i].tangents = tangents_at(x[i]); });
    const auto tangents = [&](int i) { return row_[i].tangents; };
    Host_array<Face_blocks> blocks(entry_.size() / 3);
    for_each_index(loop_, static_cast<int>(blocks.size()),
                   [&](int f) { blocks[f] = energy_.blocks_of_face(f, x, tangents); });
    for_each_vertex([&](int i) {
      const int begin = energy_.corner_offset()[i], end = energy_.corner_offset()[i + 1];
      Block& diagonal = row_[i].diagonal = energy_.block_of_vertex(i, row_[i].tangents);
      for(int k = begin; k < end; ++k)
        entry_[k] = {energy_.target(k), {0, 0, 0, 0}};
      double bend = 0;
      for(int k = begin; k < end; ++k) {
        const int corner = energy_.corner()[k], m = corner % 3;
        const Face_blocks& of_face = blocks[corner / 3];
        Block &to_target = entry_[k].block, &to_apex = entry_[k + 1 < end ? k + 1 : begin].block;
        bend += of_face.bend[m];
        diagonal = sum(diagonal, of_face.diagonal[m]);
        to_target = sum(to_target, of_face.side[m]);
        to_apex = sum(to_apex, transposed(of_face.side[(m + 2) % 3]));
      }
      bend = (std::max)(0., bend); // the sphere bends away from the tangent plane
      diagonal = sum(diagonal, {bend, 0, 0, bend});
      if(is_held_[i])
        diagonal = {1, 0, 0, 1};
      for(int k = begin; k < end; ++k)
        if(is_held_[i] || is_held_[entry_[k].column])
          entry_[k].block = {0, 0, 0, 0};
    });
  }

  /// Half the trace of a block: what it is in the mean over all directions.
  static double mean(const Tangents& row, const Block& b, const Tangents& column)
  {
    return (b.ss * inner(row.s, column.s) + b.st * inner(row.s, column.t) + b.ts * inner(row.t, column.s) +
            b.tt * inner(row.t, column.t)) /
           2;
  }

  Multigrid<Host_backend<Host_loop>> multigrid() const
  {
    auto graph = std::make_shared<Weighted_graph>();
    graph->offset = energy_.corner_offset();
    graph->target.resize(entry_.size());
    graph->weight.resize(entry_.size());
    graph->excess.resize(size());
    for_each_vertex([&](int i) {
      double excess = mean(row_[i].tangents, row_[i].diagonal, row_[i].tangents);
      for(int k = graph->offset[i]; k < graph->offset[i + 1]; ++k) {
        const Entry& e = entry_[k];
        graph->target[k] = e.column;
        graph->weight[k] = (std::max)(0., -mean(row_[i].tangents, e.block, row_[e.column].tangents));
        excess -= graph->weight[k];
      }
      graph->excess[i] = (std::max)(0., excess);
    });
    graph->update_diagonal({}, loop_);
    return Multigrid<Host_backend<Host_loop>>(backend_, graph);
  }

  Planar product(int i, const Host_array<Planar>& p) const
  {
    const Block& d = row_[i].diagonal;
    Planar sum = {d.ss * p[i].s + d.st * p[i].t, d.ts * p[i].s + d.tt * p[i].t};
    for(int k = energy_.corner_offset()[i]; k < energy_.corner_offset()[i + 1]; ++k) {
      const auto& [j, b] = entry_[k];
      sum = {sum.s + b.ss * p[j].s + b.st * p[j].t, sum.t + b.ts * p[j].s + b.tt * p[j].t};
    }
    return sum;
  }

  /// As far as the matrix is positive.
  Host_array<vec3> solve(const Host_array<vec3>& g, double progress) const
  {
    constexpr double tolerance = 0.3; // what is left is for the next direction
    constexpr int most_iterations = 200;
    auto cycle = multigrid();
    const int n = size();
    Host_array<Planar> x(n, Planar{0, 0}), r(n), z(n), p(n, Planar{0, 0}), q(n);
    Host_array<vec3> in_space(n), result(n);
    for_each_vertex([&](int i) { r[i] = is_held_[i] ? Planar{0, 0} : scaled(-1, row_[i].tangents.products(g[i])); });
    double first = 0, before = 0;
    for(int it = 0; it < most_iterations && (it == 0 || monitor_.advance(progress)); ++it) {
      for_each_vertex([&](int i) { in_space[i] = row_[i].tangents.combined(r[i]); });
      cycle.apply(0, in_space, result);
      for_each_vertex([&](int i) { z[i] = row_[i].tangents.products(result[i]); });
      const double rz = sum_by_parts(loop_, n, [&](int i) { return inner(r[i], z[i]); });
      if(it == 0)
        first = rz;
      if(!(rz > tolerance * tolerance * first))
        break;
      const double beta = it == 0 ? 0 : rz / before;
      for_each_vertex([&](int i) { p[i] = add_scaled(z[i], beta, p[i]); });
      const double curvature = sum_by_parts(loop_, n, [&](int i) { return inner(p[i], q[i] = product(i, p)); });
      if(!(curvature > 0)) { // what the sphere bends is not made positive
        if(it == 0)
          x = p;
        break;
      }
      for_each_vertex([&](int i) {
        x[i] = add_scaled(x[i], rz / curvature, p[i]);
        r[i] = add_scaled(r[i], -rz / curvature, q[i]);
      });
      before = rz;
    }
    for_each_vertex([&](int i) { result[i] = row_[i].tangents.combined(x[i]); });
    return result;
  }

  const Host_loop& loop_;
  Host_backend<Host_loop> backend_;
  const Registration_energy<>& energy_;
  const std::vector<char>& is_held_;
  Monitor& monitor_;
  Host_array<Row> row_;
  Host_array<Entry> entry_; ///< by corner, row by row
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_REGISTRATION_NEWTON_H
