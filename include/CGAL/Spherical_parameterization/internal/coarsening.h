// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// The set-up of smoothed aggregation on the host, for graph Laplacians: P. Vanek, J. Mandel, M. Brezina, "Algebraic
// multigrid by smoothed aggregation for second and fourth order elliptic problems", Computing 56 (1996). Every coarse
// matrix is again a weighted graph (a few weights may be negative) with its row sums kept apart, so that coarse levels,
// too, work on differences.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COARSENING_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COARSENING_H

#include <CGAL/Spherical_parameterization/internal/Weighted_graph.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

struct Aggregates {
  std::vector<int> of_vertex; ///< -1 for fixed vertices
  int count = 0;
};

/// Greedy aggregation. Two vertices are strongly connected if w_ij > threshold sqrt(a_ii a_jj).
inline Aggregates aggregate(const Weighted_graph& a, double threshold)
{
  const int n = a.size();
  const std::vector<double>& inverse = a.inverse_diagonal;
  const auto is_strong = [&](int i, int k) {
    const double w = a.weight[k];
    return w > 0 && w * w * inverse[i] * inverse[a.target[k]] > threshold * threshold;
  };
  Aggregates result;
  std::vector<int>& of = result.of_vertex;
  of.assign(n, -1);

  // Vertices without an aggregated neighbour become the roots, and take all strong neighbours along.
  for(int i = 0; i < n; ++i) {
    if(of[i] >= 0 || inverse[i] == 0)
      continue;
    bool is_free = true;
    for(int k = a.offset[i]; is_free && k < a.offset[i + 1]; ++k)
      is_free = !(is_strong(i, k) && of[a.target[k]] >= 0);
    if(!is_free)
      continue;
    of[i] = result.count;
    for(int k = a.offset[i]; k < a.offset[i + 1]; ++k)
      if(is_strong(i, k))
        of[a.target[k]] = result.count;
    ++result.count;
  }
  // The others join the neighbour that holds them most firmly, as long as that one belonged to a root's aggregate.
  const std::vector<int> roots = of;
  for(int i = 0; i < n; ++i) {
    if(of[i] >= 0 || inverse[i] == 0)
      continue;
    double best = 0;
    for(int k = a.offset[i]; k < a.offset[i + 1]; ++k)
      if(roots[a.target[k]] >= 0 && a.weight[k] > best) {
        best = a.weight[k];
        of[i] = roots[a.target[k]];
      }
    if(of[i] < 0)
      of[i] = result.count++;
  }
  return result;
}

/// Collects one sparse row at a time: values are added by column, and read out in the order of first use.
class Row_accumulator {
public:
  explicit Row_accumulator(int columns) : position_(columns, -1), column_(columns), value_(columns) {}

  void add(int column, double value)
  {
    int& at = position_[column];
    if(at < 0) {
      at = size_++;
      column_[at] = column;
      value_[at] = value;
    } else
      value_[at] += value;
  }

  int size() const { return size_; }
  int column(int k) const { return column_[k]; }
  double value(int k) const { return value_[k]; }

  void append_to(std::vector<int>& columns, std::vector<double>& values) const
  {
    columns.insert(columns.end(), column_.begin(), column_.begin() + size_);
    values.insert(values.end(), value_.begin(), value_.begin() + size_);
  }

  void clear()
  {
    for(int k = 0; k < size_; ++k)
      position_[column_[k]] = -1;
    size_ = 0;
  }

private:
  std::vector<int> position_;
  std::vector<int> column_;
  std::vector<double> value_;
  int size_ = 0;
};

/// P = (I - omega D^-1 A) T, T the piecewise constant interpolation from the aggregates.
inline Sparse_matrix smoothed_prolongation(const Weighted_graph& a, const Aggregates& aggregates, double omega)
{
  const int n = a.size();
  const std::vector<int>& of = aggregates.of_vertex;
  Sparse_matrix p;
  p.offset.reserve(n + 1);
  p.column.reserve(3 * std::size_t(n));
  p.value.reserve(3 * std::size_t(n));
  Row_accumulator row(aggregates.count);
  for(int i = 0; i < n; ++i) {
    if(of[i] >= 0) {
      const double factor = omega * a.inverse_diagonal[i];
      row.add(of[i], a.excess.empty() ? 1 : 1 - factor * a.excess[i]);
      for(int k = a.offset[i]; k < a.offset[i + 1]; ++k) {
        const int j = of[a.target[k]];
        if(j != of[i]) {
          row.add(of[i], -factor * a.weight[k]);
          if(j >= 0)
            row.add(j, factor * a.weight[k]);
        }
      }
    }
    row.append_to(p.column, p.value);
    p.offset.push_back(static_cast<int>(p.column.size()));
    row.clear();
  }
  return p;
}

/// The Galerkin product P^T A P as a weighted graph. Where A has zero row sums (`is_singular`), so has the product,
/// and the excess stays empty instead of holding rounding errors.
inline Weighted_graph galerkin_product(const Weighted_graph& a, const Sparse_matrix& p, const Sparse_matrix& r,
                                       bool is_singular)
{
  const int n = a.size();
  const int coarse = r.rows();
  Row_accumulator row(coarse);

  Sparse_matrix ap;
  ap.offset.reserve(n + 1);
  ap.column.reserve(2 * p.column.size());
  ap.value.reserve(2 * p.column.size());
  for(int i = 0; i < n; ++i) {
    if(a.inverse_diagonal[i] > 0) {
      for(int k = a.offset[i]; k < a.offset[i + 1]; ++k) {
        const int j = a.target[k];
        for(int q = p.offset[j]; q < p.offset[j + 1]; ++q)
          row.add(p.column[q], -a.weight[k] * p.value[q]);
      }
      const double diagonal = 1 / a.inverse_diagonal[i];
      for(int q = p.offset[i]; q < p.offset[i + 1]; ++q)
        row.add(p.column[q], diagonal * p.value[q]);
    }
    row.append_to(ap.column, ap.value);
    ap.offset.push_back(static_cast<int>(ap.column.size()));
    row.clear();
  }

  Weighted_graph c;
  c.offset.reserve(coarse + 1);
  c.inverse_diagonal.resize(coarse);
  if(!is_singular)
    c.excess.resize(coarse);
  for(int i = 0; i < coarse; ++i) {
    for(int k = r.offset[i]; k < r.offset[i + 1]; ++k) {
      const int f = r.column[k];
      for(int q = ap.offset[f]; q < ap.offset[f + 1]; ++q)
        row.add(ap.column[q], r.value[k] * ap.value[q]);
    }
    double diagonal = 0;
    double off_diagonal = 0;
    for(int k = 0; k < row.size(); ++k) {
      if(row.column(k) == i) {
        diagonal = row.value(k);
        continue;
      }
      off_diagonal += row.value(k);
      c.target.push_back(row.column(k));
      c.weight.push_back(-row.value(k));
    }
    c.offset.push_back(static_cast<int>(c.target.size()));
    if(is_singular)
      diagonal = -off_diagonal;
    else
      c.excess[i] = diagonal + off_diagonal;
    c.inverse_diagonal[i] = diagonal > 0 ? 1 / diagonal : 0;
    row.clear();
  }
  return c;
}

/// Upper estimate of the largest eigenvalue of D^-1 A by power iteration from a fixed start, at most Gershgorin's
/// bound.
inline double spectral_radius(const Weighted_graph& a)
{
  constexpr int iterations = 6;
  constexpr double safety = 1.15;
  const int n = a.size();
  const std::vector<double>& inverse = a.inverse_diagonal;
  double bound = 0;
  for(int i = 0; i < n; ++i) {
    double sum = 0;
    for(int k = a.offset[i]; k < a.offset[i + 1]; ++k)
      sum += std::abs(a.weight[k]);
    if(inverse[i] > 0)
      bound = (std::max)(bound, 1 + sum * inverse[i]);
  }
  std::vector<double> x(n), y(n);
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
        sum += a.weight[k] * (x[i] - x[a.target[k]]);
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
  return (std::min)(bound, safety * radius);
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COARSENING_H
