// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "shapes/segmentation_scores.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <utility>

namespace benchmark {
namespace {

/// Faces and areas of the segments of two segmentations and of their intersections.
struct Overlaps {
  typedef std::map<std::pair<int, int>, double> Joint;
  typedef std::map<int, double> Single;
  Joint joint;
  Single a, b;

  Overlaps(const Labels& x, const Labels& y, const std::function<double(std::size_t)>& weight)
  {
    for(std::size_t f = 0; f < x.size(); ++f) {
      joint[{x[f], y[f]}] += weight(f);
      a[x[f]] += weight(f);
      b[y[f]] += weight(f);
    }
  }
};

double rand_index_error(const Overlaps& faces, std::size_t n)
{
  const auto pairs = [](double k) { return k * (k - 1) / 2; };
  double error = 0;
  for(const auto& [label, count] : faces.a)
    error += pairs(count);
  for(const auto& [label, count] : faces.b)
    error += pairs(count);
  for(const auto& [labels, count] : faces.joint)
    error -= 2 * pairs(count);
  return error / pairs(static_cast<double>(n));
}

/// What is left of every segment without its largest intersection: with the segments of the first, and of the second.
std::pair<double, double> hamming(const Overlaps& areas)
{
  Overlaps::Single best_of_a, best_of_b;
  for(const auto& [labels, area] : areas.joint) {
    best_of_a[labels.first] = (std::max)(best_of_a[labels.first], area);
    best_of_b[labels.second] = (std::max)(best_of_b[labels.second], area);
  }
  double rest_of_a = 0, rest_of_b = 0;
  for(const auto& [label, area] : areas.a)
    rest_of_a += area - best_of_a[label];
  for(const auto& [label, area] : areas.b)
    rest_of_b += area - best_of_b[label];
  return {rest_of_a, rest_of_b};
}

} // namespace

Segmentation_judge::Segmentation_judge(const Mesh& mesh) : mesh_(mesh)
{
  double total = 0;
  std::array<double, 3> sum = {0, 0, 0};
  std::vector<Point_3> centroids;
  for(Mesh::Face_index f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    const Point_3 &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)),
                  &r = mesh.point(mesh.target(mesh.next(h)));
    area_.push_back(std::sqrt(CGAL::squared_area(p, q, r)));
    centroids.push_back(CGAL::centroid(p, q, r));
    total += area_.back();
    for(int k = 0; k < 3; ++k)
      sum[k] += area_.back() * centroids.back()[k];
  }
  const Point_3 centre(sum[0] / total, sum[1] / total, sum[2] / total);
  for(std::size_t f = 0; f < area_.size(); ++f)
    mean_radius_ += area_[f] / total * std::sqrt(CGAL::squared_distance(centroids[f], centre));
}

double Segmentation_judge::cut_distance(const Labels& from, const Labels& to) const
{
  const auto is_cut = [&](const Labels& labels, Mesh::Edge_index e) {
    const auto h = mesh_.halfedge(e);
    return labels[mesh_.face(h)] != labels[mesh_.face(mesh_.opposite(h))];
  };
  const auto length = [&](Mesh::Halfedge_index h) {
    return std::sqrt(CGAL::squared_distance(mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h))));
  };
  std::vector<double> distance(mesh_.number_of_vertices(), std::numeric_limits<double>::infinity());
  typedef std::pair<double, Mesh::Vertex_index> Entry;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for(Mesh::Edge_index e : mesh_.edges())
    if(is_cut(to, e))
      for(Mesh::Vertex_index v : {mesh_.vertex(e, 0), mesh_.vertex(e, 1)})
        if(distance[v] > 0) {
          distance[v] = 0;
          queue.emplace(0, v);
        }
  while(!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if(d > distance[v])
      continue;
    for(Mesh::Halfedge_index h : mesh_.halfedges_around_target(mesh_.halfedge(v))) {
      const Mesh::Vertex_index w = mesh_.source(h);
      const double there = d + length(h);
      if(there < distance[w]) {
        distance[w] = there;
        queue.emplace(there, w);
      }
    }
  }
  double sum = 0, total = 0;
  for(Mesh::Edge_index e : mesh_.edges())
    if(is_cut(from, e)) {
      const double l = length(mesh_.halfedge(e));
      sum += l * (distance[mesh_.vertex(e, 0)] + distance[mesh_.vertex(e, 1)]) / 2;
      total += l;
    }
  const double mean = sum / total;                                              // 0/0 without a cut here
  return std::isfinite(mean) ? mean : std::numeric_limits<double>::quiet_NaN(); // infinite without a cut there
}

Segmentation_scores Segmentation_judge::compare(const Labels& a, const Labels& b) const
{
  Segmentation_scores scores;
  scores.rand_index_error = rand_index_error(Overlaps(a, b, [](std::size_t) { return 1.; }), a.size());
  scores.cut_discrepancy = (cut_distance(a, b) + cut_distance(b, a)) / mean_radius_;

  const Overlaps areas(a, b, [&](std::size_t f) { return area_[f]; });
  double total = 0;
  for(double area : area_)
    total += area;
  const auto [rest_of_a, rest_of_b] = hamming(areas);
  scores.hamming_distance = (rest_of_a + rest_of_b) / (2 * total);
  double a_not_in_b = 0, b_not_in_a = 0, least = 0;
  for(const auto& [labels, area] : areas.joint) {
    const double from_a = area * (1 - area / areas.a.at(labels.first));
    const double from_b = area * (1 - area / areas.b.at(labels.second));
    a_not_in_b += from_a;
    b_not_in_a += from_b;
    least += (std::min)(from_a, from_b);
  }
  scores.global_consistency = (std::min)(a_not_in_b, b_not_in_a) / total;
  scores.local_consistency = least / total;
  return scores;
}

} // namespace benchmark
