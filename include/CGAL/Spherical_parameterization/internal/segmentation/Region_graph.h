// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_REGION_GRAPH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_REGION_GRAPH_H

#include <CGAL/Spherical_parameterization/internal/segmentation/Segmentation_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// A cost for every side of every face, the same from both sides of an edge.
typedef std::vector<std::array<double, 3>> Side_costs;

/// The connected components of equal labels, numbered from 0 in the order of their first faces.
inline std::vector<int> connected_components(const Segmentation_mesh& mesh, const std::vector<int>& label)
{
  std::vector<int> component(label.size(), -1), front;
  int count = 0;
  for(int f = 0; f < mesh.number_of_faces(); ++f) {
    if(component[f] >= 0)
      continue;
    front.push_back(f);
    component[f] = count;
    while(!front.empty()) {
      const int g = front.back();
      front.pop_back();
      for(int k = 0; k < 3; ++k) {
        const int h = mesh.across(g, k);
        if(component[h] < 0 && label[h] == label[g]) {
          component[h] = count;
          front.push_back(h);
        }
      }
    }
    ++count;
  }
  return component;
}

/// Regions of faces and their borders, which can be merged.
class Region_graph {
public:
  struct Border {
    int region;  ///< on the other side
    double cost; ///< summed over the edges of the border
  };

  /// `region` numbers the regions of the faces from 0 without gaps.
  Region_graph(const Segmentation_mesh& mesh, std::vector<int> region, const Side_costs& costs)
    : region_(std::move(region)), count_(0)
  {
    for(int r : region_)
      count_ = (std::max)(count_, r + 1);
    area_.assign(count_, 0);
    perimeter_.assign(count_, 0);
    parent_.resize(count_);
    std::iota(parent_.begin(), parent_.end(), 0);
    borders_.resize(count_);
    place_.assign(count_, -1);
    for(int f = 0; f < mesh.number_of_faces(); ++f) {
      area_[region_[f]] += mesh.area[f];
      for(int k = 0; k < 3; ++k) {
        const int other = region_[mesh.across(f, k)];
        if(other != region_[f]) {
          borders_[region_[f]].push_back({other, costs[f][k]});
          perimeter_[region_[f]] += costs[f][k];
        }
      }
    }
    for(std::vector<Border>& row : borders_)
      sum_up(row);
  }

  int capacity() const { return static_cast<int>(parent_.size()); } ///< of region numbers
  int number_of_regions() const { return count_; }
  bool is_region(int r) const { return parent_[r] == r; }
  double area(int r) const { return area_[r]; }
  double perimeter(int r) const { return perimeter_[r]; }
  const std::vector<Border>& borders(int r) const { return borders_[r]; }

  /// Merges two neighbours. Returns the number of the union, which is one of theirs.
  int merge(int a, int b)
  {
    if(borders_[a].size() < borders_[b].size())
      std::swap(a, b);
    parent_[b] = a;
    --count_;
    area_[a] += area_[b];
    std::vector<Border>& row = borders_[a];
    for(std::size_t i = 0; i < row.size(); ++i)
      place_[row[i].region] = static_cast<int>(i);
    for(const Border& border : borders_[b]) {
      if(border.region == a) {
        perimeter_[a] += perimeter_[b] - 2 * border.cost;
        continue;
      }
      std::vector<Border>& back = borders_[border.region];
      const auto to = [&](int region) {
        return std::find_if(back.begin(), back.end(), [=](const Border& x) { return x.region == region; });
      };
      const auto to_b = to(b);
      if(place_[border.region] < 0) {
        row.push_back(border);
        to_b->region = a;
      } else {
        row[place_[border.region]].cost += border.cost;
        to(a)->cost += border.cost;
        *to_b = back.back();
        back.pop_back();
      }
    }
    const int place_of_b = place_[b];
    for(const Border& border : row)
      place_[border.region] = -1;
    row[place_of_b] = row.back();
    row.pop_back();
    borders_[b] = {};
    return a;
  }

  /// The region of every face, numbered from 0 in the order of their first faces.
  std::vector<int> labels() const
  {
    std::vector<int> number(parent_.size(), -1), label(region_.size());
    int next = 0;
    for(std::size_t f = 0; f < region_.size(); ++f) {
      int r = region_[f];
      while(parent_[r] != r)
        r = parent_[r];
      if(number[r] < 0)
        number[r] = next++;
      label[f] = number[r];
    }
    return label;
  }

private:
  static void sum_up(std::vector<Border>& row)
  {
    std::stable_sort(row.begin(), row.end(), [](const Border& a, const Border& b) { return a.region < b.region; });
    std::size_t kept = 0;
    for(std::size_t i = 0; i < row.size(); ++i)
      if(kept > 0 && row[kept - 1].region == row[i].region)
        row[kept - 1].cost += row[i].cost;
      else
        row[kept++] = row[i];
    row.resize(kept);
  }

  std::vector<int> region_; // of the faces, before all merging
  std::vector<int> parent_;
  std::vector<double> area_, perimeter_;
  std::vector<std::vector<Border>> borders_;
  std::vector<int> place_; // scratch of merge(): where a region is in a row; -1: nowhere
  int count_;
};

/// Merges pairs of neighbours, those with the smallest `key(a, border)` first, for as long as `goes_on(key)`; calls
/// `merged(a, b, union)` after each. The key of two regions may only change by merging one of them.
template <class Key, class Goes_on, class Merged>
void merge_in_order(Region_graph& regions, Key key, Goes_on goes_on, Merged merged)
{
  typedef std::tuple<double, int, int, int, int> Entry; // key, regions, their versions
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  std::vector<int> version(regions.capacity(), 0);
  const auto push = [&](int a, const Region_graph::Border& border) {
    const int b = border.region;
    queue.emplace(key(a, border), (std::min)(a, b), (std::max)(a, b), version[(std::min)(a, b)],
                  version[(std::max)(a, b)]);
  };
  for(int a = 0; a < regions.capacity(); ++a)
    if(regions.is_region(a))
      for(const Region_graph::Border& border : regions.borders(a))
        if(a < border.region)
          push(a, border);
  while(!queue.empty()) {
    const auto [cost, a, b, version_a, version_b] = queue.top();
    queue.pop();
    if(!regions.is_region(a) || !regions.is_region(b) || version[a] != version_a || version[b] != version_b)
      continue;
    if(!goes_on(cost))
      break;
    const int c = regions.merge(a, b);
    merged(a, b, c);
    ++version[c];
    for(const Region_graph::Border& border : regions.borders(c))
      push(c, border);
  }
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_REGION_GRAPH_H
