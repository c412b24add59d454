// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "collections/nearest_signatures.h"

#include <CGAL/Dimension.h>
#include <CGAL/K_neighbor_search.h>
#include <CGAL/Kd_tree_rectangle.h>
#include <CGAL/Search_traits.h>

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

typedef CGAL::Dimension_tag<static_cast<int>(Shape_signature::size)> Dimension;
typedef CGAL::Search_traits<double, Signature_point, const double*, Coordinates, Dimension> Traits;

/// `distance()`, for the k-d tree. CGAL's Weighted_Minkowski_distance is not right in more than three dimensions of
/// fixed number (CGAL 5.5.1).
struct L1 {
  typedef double FT;
  typedef Signature_point Point_d;
  typedef Signature_point Query_item;
  typedef Dimension D;
  typedef CGAL::Kd_tree_rectangle<FT, D> Rectangle;

  FT transformed_distance(const Query_item& q, const Point_d& p) const { return distance(*q.signature, *p.signature); }
  FT min_distance_to_rectangle(const Query_item& q, const Rectangle& r) const
  {
    FT sum = 0;
    for(int i = 0; i < D::value; ++i) {
      const double x = q.signature->values[static_cast<std::size_t>(i)];
      sum += std::max({r.min_coord(i) - x, x - r.max_coord(i), 0.});
    }
    return sum;
  }
  FT max_distance_to_rectangle(const Query_item& q, const Rectangle& r) const
  {
    FT sum = 0;
    for(int i = 0; i < D::value; ++i) {
      const double x = q.signature->values[static_cast<std::size_t>(i)];
      sum += std::max(r.max_coord(i) - x, x - r.min_coord(i));
    }
    return sum;
  }
  FT transformed_distance(FT d) const { return d; }
  FT inverse_of_transformed_distance(FT d) const { return d; }
};

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
  Search search(tree, {nullptr, &query}, static_cast<unsigned int>(std::min(k, points.size())));

  std::vector<Neighbour> neighbours;
  for(const auto& [point, sum] : search)
    neighbours.push_back({sum, static_cast<std::size_t>(point.row - rows.data())});
  std::sort(neighbours.begin(), neighbours.end(), [](const Neighbour& a, const Neighbour& b) {
    return std::pair(a.distance, a.row) < std::pair(b.distance, b.row);
  });
  return neighbours;
}

} // namespace tool
