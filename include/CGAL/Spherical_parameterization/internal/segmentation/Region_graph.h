// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_REGION_GRAPH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_REGION_GRAPH_H

#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/segmentation/Segmentation_mesh.h>
#include <CGAL/Spherical_parameterization/values/segmentation_methods.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <numeric>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// A cost for every side of every face, the same from both sides of an edge.
typedef std::vector<std::array<double, 3>> Side_costs;

/// The connected components of equal labels, numbered from 0 in the order of their first faces.
CGAL_SP_INLINE std::vector<int> connected_components(const Segmentation_mesh& mesh, const std::vector<int>& label)
{
  std::vector<int> component(label.size(), -1);
  int count = 0;
  for(int first = 0; first < mesh.number_of_faces(); ++first)
    if(component[first] < 0) {
      component[first] = count;
      flood(mesh, first, [&](int f) {
        const bool is_new = component[f] < 0 && label[f] == label[first];
        if(is_new)
          component[f] = count;
        return is_new;
      });
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

  /// `region` numbers the regions of the faces from 0 without gaps. `loop` is asked now and then whether to go on.
  CGAL_SP_INLINE Region_graph(const Watched_loop<Host_loop>& loop, const Segmentation_mesh& mesh,
                              std::vector<int> region, const Side_costs& costs)
    : loop_(loop), region_(std::move(region)), count_(1 + *std::max_element(region_.begin(), region_.end())),
      parent_(count_), area_(count_, 0), perimeter_(count_, 0), borders_(count_)
  {
    std::iota(parent_.begin(), parent_.end(), 0);
    for(int f = 0; f < mesh.number_of_faces(); ++f) {
      area_[region_[f]] += mesh.face_area[f];
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
  std::size_t number_of_regions() const { return static_cast<std::size_t>(count_); }
  bool is_region(int r) const { return parent_[r] == r; }
  double area(int r) const { return area_[r]; }
  double perimeter(int r) const { return perimeter_[r]; }
  const std::vector<Border>& borders(int r) const { return borders_[r]; }

  /// Of so many borders that were looked at. Asks the loop now and then whether to go on.
  void note_work(std::size_t borders)
  {
    work_ += borders;
    if(constexpr std::size_t work_at_once = 1 << 14; work_ >= work_at_once) {
      work_ = 0;
      loop_.check();
    }
  }

  /// Merges two neighbours. Returns the number of the union, which is one of theirs.
  int merge(int a, int b)
  {
    if(borders_[a].size() < borders_[b].size())
      std::swap(a, b);
    parent_[b] = a;
    --count_;
    area_[a] += area_[b];
    for(const Border& border : borders_[b]) {
      note_work(borders_[a].size());
      const int c = border.region;
      if(c == a)
        perimeter_[a] += perimeter_[b] - 2 * border.cost;
      else if(const auto common = find(a, c); common == borders_[a].end()) {
        borders_[a].push_back(border);
        find(c, b)->region = a;
      } else {
        common->cost += border.cost;
        find(c, a)->cost += border.cost;
        remove(c, b);
      }
    }
    remove(a, b);
    borders_[b] = {};
    return a;
  }

  /// The region of every face, numbered from 0 in the order of their first faces.
  std::vector<int> labels() const
  {
    std::vector<int> number(parent_.size(), -1), label(region_.size()), parent = parent_;
    int next = 0;
    for(std::size_t f = 0; f < region_.size(); ++f) {
      int r = region_[f];
      while(parent[r] != r)
        r = parent[r] = parent[parent[r]]; // shorter for those that follow
      if(number[r] < 0)
        number[r] = next++;
      label[f] = number[r];
    }
    return label;
  }

private:
  /// The border of region a with b.
  std::vector<Border>::iterator find(int a, int b)
  {
    return std::find_if(borders_[a].begin(), borders_[a].end(), [=](const Border& x) { return x.region == b; });
  }

  void remove(int a, int b)
  {
    *find(a, b) = borders_[a].back();
    borders_[a].pop_back();
  }

  CGAL_SP_INLINE static void sum_up(std::vector<Border>& row)
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

  const Watched_loop<Host_loop>& loop_;
  std::vector<int> region_; // of the faces, before all merging
  int count_;
  std::size_t work_ = 0; // since `loop_` was asked: borders that were looked at
  std::vector<int> parent_;
  std::vector<double> area_, perimeter_;
  std::vector<std::vector<Border>> borders_;
};

/// The length of every side: what borders are measured with where nothing else is known.
CGAL_SP_INLINE Side_costs side_lengths(const Segmentation_mesh& mesh)
{
  Side_costs length(mesh.face.size());
  for(int f = 0; f < mesh.number_of_faces(); ++f)
    for(int k = 0; k < 3; ++k)
      length[f][k] = mesh.side_length(f, k);
  return length;
}

/// What follows when regions a and b have become c, one of them: nothing.
inline constexpr auto ignore_merger = [](int /* a */, int /* b */, int /* c */) {};

/// Merges pairs of neighbours, those with the smallest `key(a, border)` first, for as long as `goes_on(key)`; calls
/// `merged(a, b, union)` after each. The key of two regions may only change by merging one of them.
///
/// A pair belongs to the region that has changed later, or to the one with the lower number if neither has. The queue
/// has the best pair of each region: no pair is better than the best of its owner. Where the other region has changed
/// since, the owner is looked at again.
template <class Key, class Goes_on, class Merged = decltype(ignore_merger)>
void merge_in_order(Region_graph& regions, Key key, Goes_on goes_on, Merged merged = ignore_merger)
{
  typedef std::tuple<double, int, int, int, int> Entry; // key, regions, the one that it belongs to, and its version
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  std::vector<int> version(regions.capacity(), 0); // the number of the last merger
  const auto owns = [&](int a, int b) { return version[a] > version[b] || (version[a] == version[b] && a < b); };
  const auto push_best_of = [&](int a) {
    std::optional<Entry> best;
    for(const Region_graph::Border& border : regions.borders(a)) {
      const int b = border.region;
      if(!owns(a, b))
        continue;
      const Entry entry(key(a, border), (std::min)(a, b), (std::max)(a, b), a, version[a]);
      if(!best || entry < *best)
        best = entry;
    }
    if(best)
      queue.push(*best);
    regions.note_work(regions.borders(a).size());
  };
  for(int a = 0; a < regions.capacity(); ++a)
    if(regions.is_region(a))
      push_best_of(a);
  for(int mergers = 0; !queue.empty();) {
    const auto [cost, low, high, owner, version_of_owner] = queue.top();
    queue.pop();
    if(!regions.is_region(owner) || version[owner] != version_of_owner)
      continue;
    const int other = owner == low ? high : low;
    if(!regions.is_region(other) || !owns(owner, other)) {
      push_best_of(owner);
      continue;
    }
    if(!goes_on(cost))
      break;
    const int c = regions.merge(low, high);
    merged(low, high, c);
    version[c] = ++mergers;
    push_best_of(c);
  }
}

/// Merges regions below `minimum_area`, the smallest first, into that neighbour for which `key(region, border)` is
/// smallest. `merged(a, b, union)` is called after each.
template <class Key, class Merged = decltype(ignore_merger)>
void absorb_small_regions(Region_graph& regions, double minimum_area, Key key, Merged merged = ignore_merger)
{
  typedef std::pair<double, int> Entry; // area, region
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  const auto push = [&](int r) {
    if(regions.area(r) < minimum_area)
      queue.emplace(regions.area(r), r);
  };
  for(int r = 0; r < regions.capacity(); ++r)
    if(regions.is_region(r))
      push(r);
  while(!queue.empty() && regions.number_of_regions() > 1) {
    const auto [area, r] = queue.top();
    queue.pop();
    if(!regions.is_region(r) || regions.area(r) != area)
      continue;
    int other = -1;
    double best = 0;
    for(const Region_graph::Border& border : regions.borders(r))
      if(const double candidate = key(r, border); other < 0 || candidate < best) {
        other = border.region;
        best = candidate;
      }
    const int c = regions.merge(r, other);
    merged(r, other, c);
    push(c);
  }
}

/// Connected segments from labels: parts that are too small go to the neighbour with the longest common border. While
/// there are too many, the least significant cut is taken back: that of the smallest area over its squared length.
CGAL_SP_INLINE std::vector<int> selected_segments(const Watched_loop<Host_loop>& loop, const Segmentation_mesh& mesh,
                                                  const std::vector<int>& label, const Segment_limits& limits)
{
  Region_graph regions(loop, mesh, connected_components(mesh, label), side_lengths(mesh));
  absorb_small_regions(regions, limits.minimum_area,
                       [](int, const Region_graph::Border& border) { return -border.cost; });
  const auto significance = [&](int a, const Region_graph::Border& border) {
    const double area = (std::min)(regions.area(a), regions.area(border.region));
    return area > 0 ? area / (border.cost * border.cost) : -1; // without area and length it would be no number
  };
  if(limits.number_of_segments > 0)
    merge_in_order(regions, significance,
                   [&](double) { return regions.number_of_regions() > limits.number_of_segments; });
  return regions.labels();
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_REGION_GRAPH_H
