// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_MULTIGRID_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_MULTIGRID_H

#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/multigrid/Chebyshev_smoother.h>
#include <CGAL/Spherical_parameterization/internal/multigrid/coarsening.h>
#include <CGAL/Spherical_parameterization/internal/multigrid/dense_inverse.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// One symmetric V-cycle of smoothed aggregation as a preconditioner for the Laplacian of a weighted graph, applied to
/// three right-hand sides at once. Fixed vertices stay 0. Without fixed vertices and excess the matrix is singular; its
/// right-hand sides have to sum to zero, and the solution is then defined up to a constant.
///
/// Set up on the host; the cycle is written over the verbs of `Backend`. O(n) time and memory in both.
template <class Backend>
class Multigrid {
  typedef typename Backend::Vectors Vectors;
  typedef typename Backend::Matrix Matrix;

public:
  Multigrid(const Backend& backend, Shared_graph fine) : backend_(backend)
  {
    bool is_singular = fine->excess.empty();
    for(int i = 0; is_singular && i < fine->size(); ++i)
      is_singular = fine->inverse_diagonal[i] > 0;

    const auto& loop = backend.host_loop();
    Shared_graph a = std::move(fine);
    while(a->size() > bottom_size) {
      const double radius = spectral_radius(loop, *a);
      Aggregates aggregates = aggregate(loop, *a, strength_threshold);
      if(aggregates.count > slow_coarsening * a->size())
        aggregates = aggregate(loop, *a, 0);
      if(aggregates.count > no_coarsening * a->size()) // the excess is all that counts from here on
        break;
      Sparse_matrix p = smoothed_prolongation(loop, *a, aggregates, prolongation_damping / radius);
      Sparse_matrix r = transposed(loop, p, aggregates.count);
      const auto coarse = std::make_shared<Weighted_graph>(galerkin_product(loop, *a, p, r, is_singular));
      drop_weak_edges(loop, weakest_edge, *coarse);

      Level level;
      level.matrix = backend.upload(a);
      level.prolongation = backend.upload(std::move(p));
      level.restriction = backend.upload(std::move(r));
      level.aggregate = std::move(aggregates.of_vertex);
      level.smoother = Chebyshev_smoother(radius);
      level.scratch = backend.vectors(a->size());
      level.coarse_b = backend.vectors(coarse->size());
      level.coarse_x = backend.vectors(coarse->size());
      levels_.push_back(std::move(level));
      a = coarse;
    }
    bottom_size_ = a->size();
    bottom_scratch_ = backend.vectors(bottom_size_);
    if(bottom_size_ <= bottom_size)
      bottom_inverse_ = backend.upload(inverse(*a, is_singular));
    bottom_matrix_ = backend.upload(a);
  }

  /// Level 0 is the finest, the last one the smallest.
  std::size_t number_of_levels() const { return levels_.size() + 1; }
  int size(std::size_t k) const
  {
    return k < levels_.size() ? static_cast<int>(levels_[k].aggregate.size()) : bottom_size_;
  }
  const Matrix& matrix(std::size_t k) const { return k < levels_.size() ? levels_[k].matrix : bottom_matrix_; }
  /// from level k+1 to level k
  const typename Backend::Transfer& prolongation(std::size_t k) const { return levels_[k].prolongation; }
  /// the vertex of level k+1 into which each vertex of level k went; -1 for fixed ones
  const Host_array<int>& aggregate_of(std::size_t k) const { return levels_[k].aggregate; }
  /// for the caller's use on level k, too; apply() overwrites it
  Vectors& scratch(std::size_t k) { return k < levels_.size() ? levels_[k].scratch : bottom_scratch_; }

  /// x = M^-1 b on level k
  void apply(std::size_t k, const Vectors& b, Vectors& x)
  {
    if(k == levels_.size()) {
      if(bottom_size_ <= bottom_size)
        backend_.multiply_dense(bottom_inverse_, b, x);
      else // as good as diagonal
        backend_.start_smoothing(bottom_matrix_, 1, b, x);
      return;
    }
    Level& level = levels_[k];
    Vectors& y = level.scratch;
    level.smoother.smooth_from_zero(backend_, level.matrix, b, x, y);
    backend_.residual(level.matrix, b, y, x);
    backend_.transfer(level.restriction, x, level.coarse_b);
    apply(k + 1, level.coarse_b, level.coarse_x);
    backend_.transfer_add(level.prolongation, level.coarse_x, y);
    level.smoother.smooth_backwards(backend_, level.matrix, b, y, x);
    std::swap(x, y);
  }

private:
  static constexpr int bottom_size = 100;
  static constexpr double strength_threshold = 0.07;
  static constexpr double weakest_edge = 0.01;
  static constexpr double slow_coarsening = 0.4;
  static constexpr double no_coarsening = 0.9;
  static constexpr double prolongation_damping = 1.6;

  struct Level {
    Matrix matrix;
    typename Backend::Transfer prolongation, restriction;
    Host_array<int> aggregate;
    Chebyshev_smoother smoother;
    Vectors scratch, coarse_b, coarse_x;
  };

  /// Dense inverse. Of a singular matrix, whose kernel are the constants, that of A plus a multiple of 1 1^T: on
  /// right-hand sides that sum to zero it makes no difference which.
  static Host_array<double> inverse(const Weighted_graph& a, bool is_singular)
  {
    const int n = a.size();
    if(n == 0)
      return {};
    Host_array<double> m(std::size_t(n) * n, 0.);
    const auto at = [n](int i, int j) { return std::size_t(i) * n + j; };
    double scale = 0;
    for(int i = 0; i < n; ++i) {
      if(a.inverse_diagonal[i] == 0) {
        m[at(i, i)] = 1;
        continue;
      }
      m[at(i, i)] = 1 / a.inverse_diagonal[i];
      scale = (std::max)(scale, m[at(i, i)]);
      for(int k = a.offset[i]; k < a.offset[i + 1]; ++k)
        if(a.inverse_diagonal[a.target[k]] > 0)
          m[at(i, a.target[k])] -= a.weight[k];
    }
    if(is_singular)
      for(double& entry : m)
        entry += scale / n;
    const Host_array<double> x = Dense_inverse(std::move(m), n)();
    Host_array<double> rows(x.size());
    for(int i = 0; i < n; ++i)
      for(int j = 0; j < n; ++j) {
        const bool is_of_fixed = i == j && a.inverse_diagonal[i] == 0;
        rows[at(i, j)] = is_of_fixed ? 0 : (x[at(i, j)] + x[at(j, i)]) / 2;
      }
    return rows;
  }

  const Backend& backend_;
  std::vector<Level> levels_;
  typename Backend::Scalars bottom_inverse_;
  Matrix bottom_matrix_;
  Vectors bottom_scratch_;
  int bottom_size_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_MULTIGRID_H
