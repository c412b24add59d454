// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "nearest_signatures.h"

#include <CGAL/Dimension.h>
#include <CGAL/K_neighbor_search.h>
#include <CGAL/Search_traits.h>
#include <CGAL/Weighted_Minkowski_distance.h>

#include <algorithm>
#include <utility>

namespace tool {
namespace {

/// A signature as a point of the k-d tree.
struct Signature_point {
  const Signature_row* row;
  const Shape_signature* signature;
};

struct Coordinates {
  typedef const double* result_type;

  const double* operator()(const Signature_point& p) const { return p.signature->values.data(); }
  const double* operator()(const Signature_point& p, int) const
  {
    return p.signature->values.data() + Shape_signature::size;
  }
};

typedef CGAL::Search_traits<double, Signature_point, const double*, Coordinates,
                            CGAL::Dimension_tag<static_cast<int>(Shape_signature::size)>>
  Traits;
typedef CGAL::Weighted_Minkowski_distance<Traits> L1;
typedef CGAL::K_neighbor_search<Traits, L1> Search;

} // namespace

std::vector<Neighbour> nearest_signatures(const std::vector<Signature_row>& rows, const Shape_signature& query,
                                          std::size_t k)
{
  std::vector<Signature_point> points;
  for(const Signature_row& row : rows)
    if(row.signature)
      points.push_back({&row, &*row.signature});
  if(points.empty() || k == 0)
    return {};
  Search::Tree tree(points.begin(), points.end());
  const std::vector<double> weights(Shape_signature::size, 1);
  const L1 distance(1, static_cast<int>(weights.size()), weights.begin(), weights.end());
  Search search(tree, {nullptr, &query}, static_cast<unsigned int>(std::min(k, points.size())), 0, true, distance);

  std::vector<Neighbour> neighbours;
  for(const auto& [point, sum] : search)
    neighbours.push_back({sum, static_cast<std::size_t>(point.row - rows.data())});
  std::sort(neighbours.begin(), neighbours.end(), [](const Neighbour& a, const Neighbour& b) {
    return std::pair(a.distance, a.row) < std::pair(b.distance, b.row);
  });
  return neighbours;
}

} // namespace tool
