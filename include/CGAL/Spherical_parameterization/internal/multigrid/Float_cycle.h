// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_FLOAT_CYCLE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_FLOAT_CYCLE_H

#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/multigrid/Multigrid.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The cycle of a Multigrid in floats, for steps of which few digits count: it takes half the memory traffic, and a
/// register holds four floats. D^-1 A x = D^-1 b is what it solves, so that numbers have no unit.
template <class Backend>
class Float_cycle {
  typedef typename Backend::Steps Steps;

public:
  /// For level `finest` and those below it. `multigrid` is kept by reference.
  Float_cycle(const Backend& backend, const Multigrid<Backend>& multigrid, std::size_t finest = 0)
    : backend_(backend), multigrid_(multigrid), levels_(multigrid.number_of_levels())
  {
    const auto& loop = backend.host_loop();
    for(std::size_t k = finest; k < levels_.size(); ++k) {
      const auto& of = multigrid.level(k);
      Level& level = levels_[k];
      level.smoother = backend.upload(std::make_shared<const Weighted_smoother>(loop, of.graph), of.matrix);
      if(of.aggregates)
        level.share = backend.upload(shares(loop, *of.graph, *of.aggregates, *multigrid.level(k + 1).graph));
      if(k > finest) {
        level.b = backend.steps(of.size());
        level.x = backend.steps(of.size());
        level.scratch = backend.steps(of.size());
      }
    }
  }

  /// x = M^-1 D b on level k. y is work space.
  void apply(std::size_t k, const Steps& b, Steps& y, Steps& x)
  {
    const auto& of = multigrid_.level(k);
    const typename Backend::Smoother& smoother = levels_[k].smoother;
    if(k + 1 == levels_.size()) {
      if(multigrid_.bottom_inverse().size() > 0)
        backend_.multiply_dense(multigrid_.bottom_inverse(), of.matrix, b, x);
      else // as good as diagonal: x = b
        backend_.start_smoothing(smoother, 1, 0, b, x);
      return;
    }
    // as in Multigrid
    const auto [first, second] = of.gains;
    Level& coarse = levels_[k + 1];
    backend_.start_smoothing(smoother, first, second, b, x);
    backend_.smooth(smoother, of.damping, b, x, y);
    backend_.residual(smoother, b, y, x);
    backend_.restrict(of.on_backend, levels_[k].share, x, coarse.b);
    apply(k + 1, coarse.b, coarse.scratch, coarse.x);
    backend_.correct(of.on_backend, coarse.x, y);
    backend_.smooth(smoother, of.damping, b, y, x);
    backend_.smooth(smoother, second, b, x, y);
    backend_.smooth(smoother, first, b, y, x);
  }

private:
  struct Level {
    typename Backend::Smoother smoother = {};
    typename Backend::Floats share = {}; ///< see shares(); not of the last level
    Steps b = {}, x = {}, scratch = {};  ///< not of the finest level, whose are the caller's
  };

  /// d_i of each vertex over that of its aggregate; 0 if it is in none, as fixed vertices are
  template <class Loop>
  static Host_array<float> shares(const Loop& loop, const Weighted_graph& fine, const Aggregates& aggregates,
                                  const Weighted_graph& coarse)
  {
    Host_array<float> share(fine.size());
    loop.for_each(fine.size(), [&](int i) {
      const int own = aggregates.of_vertex[i];
      share[i] = own < 0 ? 0 : static_cast<float>(coarse.inverse_diagonal[own] / fine.inverse_diagonal[i]);
    });
    return share;
  }

  const Backend& backend_;
  const Multigrid<Backend>& multigrid_;
  std::vector<Level> levels_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_FLOAT_CYCLE_H
