// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_WEIGHTED_GRAPH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_WEIGHTED_GRAPH_H

#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/backend/formulas/float_cycle.h>

#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// A symmetric weighted graph in compressed rows, on the host. Seen as a matrix it is the Laplacian L = D - W plus the
/// diagonal `excess`. Rows of fixed vertices are present; their inverse diagonal is 0, so that nothing moves them.
struct Weighted_graph {
  Host_array<int> offset = {0};
  Host_array<int> target;
  Host_array<double> weight;
  Host_array<double> excess;           ///< empty: zero
  Host_array<double> inverse_diagonal; ///< by which Jacobi steps are scaled; on coarse levels see drop_weak_edges()

  /// Of the matrix
  double diagonal(int i) const
  {
    double sum = excess.empty() ? 0 : excess[i];
    for(int k = offset[i]; k < offset[i + 1]; ++k)
      sum += weight[k];
    return sum;
  }

  int size() const { return static_cast<int>(offset.size()) - 1; }

  graph_view view() const
  {
    return {offset.data(), target.data(), weight.data(), excess.empty() ? nullptr : excess.data(),
            inverse_diagonal.data()};
  }

  /// Recomputes the inverse diagonal from weights and excess; `is_fixed` is empty or has one entry per vertex.
  template <class Loop = Host_loop>
  void update_diagonal(const std::vector<char>& is_fixed, const Loop& loop = Loop())
  {
    inverse_diagonal.resize(size());
    loop.for_each(size(), [&](int i) {
      const double sum = diagonal(i);
      inverse_diagonal[i] = (!is_fixed.empty() && is_fixed[i]) || !(sum > 0) ? 0 : 1 / sum;
    });
  }
};

/// Graphs are large: all that use one share it.
typedef std::shared_ptr<const Weighted_graph> Shared_graph;

/// A graph as a Float_cycle sees it, on the host: see smoother_view.
struct Weighted_smoother {
  Shared_graph graph;
  Host_array<float> weight;
  Host_array<float> excess; ///< empty: zero

  template <class Loop>
  Weighted_smoother(const Loop& loop, Shared_graph of)
    : graph(std::move(of)), weight(graph->weight.size()), excess(graph->excess.size())
  {
    loop.for_each(graph->size(), [&](int i) {
      const double factor = graph->inverse_diagonal[i];
      for(int k = graph->offset[i]; k < graph->offset[i + 1]; ++k)
        weight[k] = static_cast<float>(factor * graph->weight[k]);
      if(!excess.empty())
        excess[i] = static_cast<float>(factor * graph->excess[i]);
    });
  }

  int size() const { return graph->size(); }
  smoother_view view() const
  {
    return {graph->offset.data(), graph->target.data(), weight.data(), excess.empty() ? nullptr : excess.data()};
  }
};

typedef std::shared_ptr<const Weighted_smoother> Shared_smoother;

/// Disjoint sets of vertices, each of which is one vertex of a coarser graph, on the host.
struct Aggregates {
  Host_array<int> of_vertex;            ///< -1 for fixed vertices
  Host_array<int> offset = {0}, member; ///< member[offset[c]] ... member[offset[c+1]-1] are those of aggregate c

  int count() const { return static_cast<int>(offset.size()) - 1; }
  aggregates_view view() const { return {of_vertex.data(), offset.data(), member.data()}; }
};

typedef std::shared_ptr<const Aggregates> Shared_aggregates;

/// A sparse rectangular matrix in compressed rows, on the host.
struct Sparse_matrix {
  Host_array<int> offset = {0};
  Host_array<int> column;
  Host_array<double> value;

  int rows() const { return static_cast<int>(offset.size()) - 1; }
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_WEIGHTED_GRAPH_H
