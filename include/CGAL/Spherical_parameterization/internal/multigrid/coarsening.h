// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// The set-up of smoothed aggregation on the host, for graph Laplacians: P. Vanek, J. Mandel, M. Brezina, "Algebraic
// multigrid by smoothed aggregation for second and fourth order elliptic problems", Computing 56 (1996). Every coarse
// matrix is again a weighted graph (a few weights may be negative) with its row sums kept apart, so that coarse levels,
// too, work on differences.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_COARSENING_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_COARSENING_H

#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/multigrid/sparse_rows.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Lists the vertices of every aggregate in ascending order. \pre `of_vertex` is set, and below `count`
inline void list_members(int count, Aggregates& aggregates)
{
  const Host_array<int>& of = aggregates.of_vertex;
  aggregates.member =
    sorted_by_key(static_cast<int>(of.size()), count, aggregates.offset, [&](int i) { return of[i]; });
}

/// Greedy aggregation. Two vertices are strongly connected if w_ij > threshold sqrt(a_ii a_jj).
///
/// Blocks of vertices are aggregated independently, so that they can be in parallel. The numbering is breadth-first:
/// a block is a band of the surface. A front of the numbering has about sqrt(pi n) vertices, so that a band is some 18
/// fronts wide at any size, and few aggregates are cut by its border.
inline Aggregates aggregate(const Host_loop& loop, const Weighted_graph& a, double threshold)
{
  constexpr int none = -1;
  constexpr int alone = -2;
  const int n = a.size();
  const int block_size = (std::max)(16384, static_cast<int>(32 * std::sqrt(double(n))));
  const Host_array<double>& inverse = a.inverse_diagonal;
  const auto is_strong = [&](int i, int k) {
    const double w = a.weight[k]; // its square may underflow
    return w > 0 && (w * inverse[i]) * (w * inverse[a.target[k]]) > threshold * threshold;
  };
  Aggregates result;
  Host_array<int>& of = result.of_vertex;
  of.resize(n);
  int total = 0;
  // Numbers the aggregates that f(begin, end) has counted on every block. Returns the first number of each block.
  const auto number_blocks = [&](auto f) {
    std::vector<int> count(n / block_size + 1);
    loop.for_each(n / block_size + 1, [&](int block) {
      const int begin = block * block_size;
      count[block] = f(begin, begin + (std::min)(block_size, n - begin));
    });
    for(int& c : count)
      total += std::exchange(c, total);
    return count;
  };

  // Vertices without an aggregated neighbour become the roots, and take all strong neighbours along.
  const std::vector<int> first = number_blocks([&](int begin, int end) {
    int count = 0;
    std::fill(of.begin() + begin, of.begin() + end, none);
    for(int i = begin; i < end; ++i) {
      if(of[i] >= 0 || inverse[i] == 0)
        continue;
      const auto is_candidate = [&](int k) { return a.target[k] >= begin && a.target[k] < end && is_strong(i, k); };
      bool is_free = true;
      for(int k = a.offset[i]; is_free && k < a.offset[i + 1]; ++k)
        is_free = !(is_candidate(k) && of[a.target[k]] >= 0);
      if(!is_free)
        continue;
      of[i] = count;
      for(int k = a.offset[i]; k < a.offset[i + 1]; ++k)
        if(is_candidate(k))
          of[a.target[k]] = count;
      ++count;
    }
    return count;
  });
  Host_array<int> roots(n);
  loop.for_each(n, [&](int i) { roots[i] = of[i] >= 0 ? of[i] + first[i / block_size] : of[i]; });

  // The others join the neighbour that holds them most firmly, as long as that one belonged to a root's aggregate.
  const std::vector<int> first_alone = number_blocks([&](int begin, int end) {
    int count = 0;
    for(int i = begin; i < end; ++i) {
      of[i] = roots[i];
      if(of[i] >= 0 || inverse[i] == 0)
        continue;
      double best = 0;
      for(int k = a.offset[i]; k < a.offset[i + 1]; ++k)
        if(roots[a.target[k]] >= 0 && a.weight[k] > best) {
          best = a.weight[k];
          of[i] = roots[a.target[k]];
        }
      if(of[i] < 0)
        of[i] = alone - count++;
    }
    return count;
  });
  loop.for_each(n, [&](int i) {
    if(of[i] <= alone)
      of[i] = first_alone[i / block_size] + alone - of[i];
  });
  list_members(total, result);
  return result;
}

/// The prolongation P = (I - omega D^-1 A) T: T gives every vertex the value of its aggregate, and a damped Jacobi step
/// smooths that, but at vertices of a very high degree, as the poles of a globe have, for which P^T A P would be dense.
inline Sparse_matrix smoothed_prolongation(const Host_loop& loop, const Weighted_graph& a, const Aggregates& aggregates,
                                           double omega)
{
  const Host_array<int>& of = aggregates.of_vertex;
  return build_rows(loop, a.size(), [&](int begin, int end, Sparse_matrix& p) {
    constexpr double usual_row_length = 3.2;
    constexpr int longest_smoothed_row = 256;
    p.offset.reserve(end - begin + 1);
    p.column.reserve(static_cast<std::size_t>(usual_row_length * (end - begin)));
    p.value.reserve(static_cast<std::size_t>(usual_row_length * (end - begin)));
    for(int i = begin; i < end; ++i) {
      const std::size_t first = p.column.size();
      if(of[i] >= 0) {
        const bool is_smoothed = a.offset[i + 1] - a.offset[i] <= longest_smoothed_row;
        const double factor = is_smoothed ? omega * a.inverse_diagonal[i] : 0;
        p.column.push_back(of[i]);
        p.value.push_back(a.excess.empty() ? 1 : 1 - factor * a.excess[i]);
        for(int k = a.offset[i]; factor > 0 && k < a.offset[i + 1]; ++k) {
          const int j = of[a.target[k]];
          if(j == of[i])
            continue;
          const double w = factor * a.weight[k];
          p.value[first] -= w;
          if(j < 0)
            continue;
          // a handful of columns: found soonest one by one
          const auto at = std::find(p.column.begin() + first, p.column.end(), j);
          if(at == p.column.end()) {
            p.column.push_back(j);
            p.value.push_back(w);
          } else
            p.value[at - p.column.begin()] += w;
        }
      }
      p.offset.push_back(static_cast<int>(p.column.size()));
    }
  });
}

/// The Galerkin product P^T A P as a weighted graph, r = P^T. Where A has zero row sums (`is_singular`), so has the
/// product, and the excess stays empty instead of holding rounding errors.
inline Weighted_graph galerkin_product(const Host_loop& loop, const Weighted_graph& a, const Sparse_matrix& p,
                                       const Sparse_matrix& r, bool is_singular)
{
  const int coarse = r.rows();
  Weighted_graph c;
  c.inverse_diagonal.resize(coarse);
  if(!is_singular)
    c.excess.resize(coarse);
  Sparse_matrix rows = build_rows(loop, coarse, [&](int begin, int end, Sparse_matrix& out) {
    constexpr std::size_t usual_row_length = 16;
    out.offset.reserve(end - begin + 1);
    out.column.reserve(usual_row_length * (end - begin));
    out.value.reserve(usual_row_length * (end - begin));
    Row_accumulator ra(a.size()); // row of P^T A
    Row_accumulator rap(coarse);  // row of P^T A P
    for(int i = begin; i < end; ++i) {
      for(int k = r.offset[i]; k < r.offset[i + 1]; ++k) {
        const int f = r.column[k];
        const double share = r.value[k];
        const int row = a.offset[f];
        const double diagonal = a.diagonal(f);
        ra.add(a.target.data() + row, a.weight.data() + row, a.offset[f + 1] - row, -share);
        ra.add(&f, &diagonal, 1, share);
      }
      for(int k = 0; k < ra.size(); ++k) {
        const int row = p.offset[ra.column(k)];
        rap.add(p.column.data() + row, p.value.data() + row, p.offset[ra.column(k) + 1] - row, ra.value(k));
      }
      double diagonal = 0;
      double off_diagonal = 0;
      for(int k = 0; k < rap.size(); ++k) {
        if(rap.column(k) == i) {
          diagonal = rap.value(k);
          continue;
        }
        off_diagonal += rap.value(k);
        out.column.push_back(rap.column(k));
        out.value.push_back(-rap.value(k));
      }
      out.offset.push_back(static_cast<int>(out.column.size()));
      if(is_singular)
        diagonal = -off_diagonal;
      else
        c.excess[i] = diagonal + off_diagonal;
      c.inverse_diagonal[i] = diagonal > 0 ? 1 / diagonal : 0;
      ra.clear();
      rap.clear();
    }
  });
  c.offset = std::move(rows.offset);
  c.target = std::move(rows.column);
  c.weight = std::move(rows.value);
  return c;
}

/// Drops the edges of a coarse graph with |w_ij| < threshold min(a_ii, a_jj), which matter to neither end, and of which
/// Galerkin products have many, where a detour over a third vertex is stronger in both of its edges. So no part of the
/// graph gets lost that hangs on weak edges only: of the edges that leave it the strongest one stays. The row sums
/// stay, and with them the kernel. The edges of vertices of very many neighbours stay, too: to look for detours would
/// take the square of their number.
///
/// Where weights are negative the Jacobi steps get shorter: they are scaled by the mean of a_ii and the sum of |w_ij|,
/// so that no eigenvalue of the scaled matrix is above 2 (S. Gershgorin; compare the l1-Jacobi smoother of A. Baker, R.
/// Falgout, T. Kolev, U. Yang, "Multigrid smoothers for ultraparallel computing", SIAM J. Sci. Comput. 33, 2011).
inline void drop_weak_edges(const Host_loop& loop, double threshold, Weighted_graph& a)
{
  constexpr double detour = 10; // times stronger than the edge
  constexpr int longest_row = 256;
  Host_array<double> inverse(a.size());
  Sparse_matrix rows = build_rows(loop, a.size(), [&](int begin, int end, Sparse_matrix& out) {
    Host_array<double> weight_to(a.size(), 0.); // from the vertex of the row
    const auto is_long = [&](int i) { return a.offset[i + 1] - a.offset[i] > longest_row; };
    for(int i = begin; i < end; ++i) {
      for(int k = a.offset[i]; k < a.offset[i + 1]; ++k)
        weight_to[a.target[k]] = a.weight[k];
      // Both ends of an edge come to the same decision: they see the same numbers, but for rounding.
      const auto has_detour = [&](int j, double w) {
        for(int k = a.offset[j]; k < a.offset[j + 1]; ++k)
          if((std::min)(weight_to[a.target[k]], a.weight[k]) > detour * w)
            return true;
        return false;
      };
      double diagonal = a.excess.empty() ? 0 : a.excess[i], magnitude = 0;
      for(int k = a.offset[i]; k < a.offset[i + 1]; ++k) {
        const int j = a.target[k];
        const double w = a.weight[k];
        if(std::abs(w) * (std::max)(a.inverse_diagonal[i], a.inverse_diagonal[j]) < threshold && !is_long(i) &&
           !is_long(j) && has_detour(j, std::abs(w)))
          continue;
        diagonal += w;
        magnitude += std::abs(w);
        out.column.push_back(j);
        out.value.push_back(w);
      }
      out.offset.push_back(static_cast<int>(out.column.size()));
      inverse[i] = diagonal > 0 ? 1 / (std::max)(diagonal, (diagonal + magnitude) / 2) : 0;
      for(int k = a.offset[i]; k < a.offset[i + 1]; ++k)
        weight_to[a.target[k]] = 0;
    }
  });
  a.offset = std::move(rows.offset);
  a.target = std::move(rows.column);
  a.weight = std::move(rows.value);
  a.inverse_diagonal = std::move(inverse);
}

/// Estimate from above of the largest eigenvalue of D^-1 A, which is at most 2: the weights of the finest graph are not
/// negative, and those of coarse ones are scaled (see drop_weak_edges()). Power iteration from a fixed start, on a
/// principal submatrix, since the eigenvectors in question are local.
inline double spectral_radius(const Weighted_graph& a)
{
  constexpr int iterations = 6;
  constexpr double safety = 1.15;
  constexpr int sample_size = 50000;
  const Host_array<double>& inverse = a.inverse_diagonal;
  const int n = (std::min)(a.size(), sample_size);
  Host_array<double> x(n), y(n);
  unsigned state = 1;
  for(double& e : x) {
    state = state * 1664525u + 1013904223u; // Numerical Recipes' generator: any fixed noise will do
    e = state / 4294967296. - 0.5;
  }
  double radius = 0;
  for(int it = 0; it < iterations; ++it) {
    double xx = 0, yy = 0;
    for(int i = 0; i < n; ++i) {
      double sum = a.excess.empty() ? 0 : a.excess[i] * x[i];
      for(int k = a.offset[i]; k < a.offset[i + 1]; ++k)
        sum += a.weight[k] * (a.target[k] < n ? x[i] - x[a.target[k]] : x[i]);
      y[i] = inverse[i] * sum;
      xx += x[i] * x[i];
      yy += y[i] * y[i];
    }
    if(!(yy > 0))
      break;
    radius = std::sqrt(yy / xx);
    const double s = 1 / std::sqrt(yy);
    for(int i = 0; i < n; ++i)
      x[i] = s * y[i];
  }
  constexpr double least = 1.7; // from here on the steps of a cycle do no harm to eigenvalues up to 2
  return (std::min)(2., (std::max)(least, safety * radius));
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_COARSENING_H
