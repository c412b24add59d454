// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "shapes/segmentations.h"

#include "measure/measure.h"

#include <CGAL/Spherical_parameterization/measure_distortion.h>
#include <CGAL/Spherical_parameterization/segmentation.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/mesh_segmentation.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <random>
#include <stdexcept>
#include <utility>

namespace benchmark {
namespace {

namespace SP = CGAL::Spherical_parameterization;
namespace PMP = CGAL::Polygon_mesh_processing;

/// What the segments of `a` (rows) and of `b` (columns) have in common.
Eigen::ArrayXXd overlaps(const Labels& a, const Labels& b, const Eigen::ArrayXd& weight)
{
  std::map<int, Eigen::Index> row, column; // of a label
  for(int label : a)
    row.emplace(label, row.size());
  for(int label : b)
    column.emplace(label, column.size());
  Eigen::ArrayXXd result = Eigen::ArrayXXd::Zero(row.size(), column.size());
  for(std::size_t f = 0; f < a.size(); ++f)
    result(row[a[f]], column[b[f]]) += weight[f];
  return result;
}

/// The faces nearest to `count` random ones.
Labels voronoi_cells(const Mesh& mesh, std::size_t count)
{
  std::vector<Point_3> centroids;
  for(Mesh::Face_index f : mesh.faces()) {
    const auto [p, q, r] = corners(mesh, mesh.points(), f);
    centroids.push_back(CGAL::centroid(p, q, r));
  }
  std::mt19937 random(1);
  std::vector<Point_3> sites;
  for(std::size_t i = 0; i < count; ++i)
    sites.push_back(centroids[random() % centroids.size()]);
  Labels labels;
  for(const Point_3& c : centroids) {
    const auto nearest = std::min_element(sites.begin(), sites.end(), [&](const Point_3& a, const Point_3& b) {
      return CGAL::squared_distance(c, a) < CGAL::squared_distance(c, b);
    });
    labels.push_back(static_cast<int>(nearest - sites.begin()));
  }
  return labels;
}

} // namespace

Segmentation_judge::Segmentation_judge(const Mesh& mesh) : mesh_(mesh), area_(mesh.number_of_faces())
{
  Vector_3 sum = CGAL::NULL_VECTOR;
  std::vector<Point_3> centroids;
  for(Mesh::Face_index f : mesh.faces()) {
    const auto [p, q, r] = corners(mesh, mesh.points(), f);
    area_[f] = PMP::face_area(f, mesh);
    centroids.push_back(CGAL::centroid(p, q, r));
    sum += area_[f] * (centroids.back() - CGAL::ORIGIN);
  }
  const Point_3 centre = CGAL::ORIGIN + sum / area_.sum();
  for(Mesh::Face_index f : mesh.faces())
    mean_radius_ += area_[f] / area_.sum() * std::sqrt(CGAL::squared_distance(centroids[f], centre));
}

double Segmentation_judge::cut_distance(const Labels& from, const Labels& to) const
{
  const auto is_cut = [&](const Labels& labels, Mesh::Edge_index e) {
    const auto h = mesh_.halfedge(e);
    return labels[mesh_.face(h)] != labels[mesh_.face(mesh_.opposite(h))];
  };
  std::vector<double> distance(mesh_.number_of_vertices(), std::numeric_limits<double>::infinity());
  typedef std::pair<double, Mesh::Vertex_index> Entry;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  const auto reach = [&](Mesh::Vertex_index v, double d) {
    if(d < distance[v]) {
      distance[v] = d;
      queue.emplace(d, v);
    }
  };
  for(Mesh::Edge_index e : mesh_.edges())
    if(is_cut(to, e))
      for(int end : {0, 1})
        reach(mesh_.vertex(e, end), 0);
  while(!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if(d == distance[v])
      for(Mesh::Halfedge_index h : mesh_.halfedges_around_target(mesh_.halfedge(v)))
        reach(mesh_.source(h), d + PMP::edge_length(h, mesh_));
  }
  double sum = 0, total = 0;
  for(Mesh::Edge_index e : mesh_.edges())
    if(is_cut(from, e)) {
      const double length = PMP::edge_length(e, mesh_);
      sum += length * (distance[mesh_.vertex(e, 0)] + distance[mesh_.vertex(e, 1)]) / 2;
      total += length;
    }
  const double mean = sum / total;                                              // 0/0 without a cut here
  return std::isfinite(mean) ? mean : std::numeric_limits<double>::quiet_NaN(); // infinite without a cut there
}

Segmentation_scores Segmentation_judge::compare(const Labels& a, const Labels& b) const
{
  const Eigen::ArrayXXd faces = overlaps(a, b, Eigen::ArrayXd::Ones(area_.size()));
  const auto pairs = [](const auto& count) { return (count * (count - 1) / 2).sum(); };
  const double all_pairs = area_.size() * (area_.size() - 1.) / 2;

  const Eigen::ArrayXXd areas = overlaps(a, b, area_);
  const double total = area_.sum();
  const Eigen::ArrayXd of_a = areas.rowwise().sum();
  const Eigen::ArrayXd of_b = areas.colwise().sum();
  const Eigen::ArrayXXd not_in_b = areas * (1 - areas.colwise() / of_a);
  const Eigen::ArrayXXd not_in_a = areas * (1 - areas.rowwise() / of_b.transpose());

  Segmentation_scores scores;
  scores << (pairs(faces.rowwise().sum().eval()) + pairs(faces.colwise().sum().eval()) - 2 * pairs(faces)) / all_pairs,
    (cut_distance(a, b) + cut_distance(b, a)) / mean_radius_,
    // what is left of every segment without its largest intersection
    1 - (areas.rowwise().maxCoeff().sum() + areas.colwise().maxCoeff().sum()) / (2 * total),
    (std::min)(not_in_b.sum(), not_in_a.sum()) / total, not_in_b.min(not_in_a).sum() / total;
  return scores;
}

std::vector<Segmenter_result> segment_by_all(Mesh& mesh, Sphere_map sphere, std::size_t number_of_cells, bool with_sdf)
{
  const auto segments = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  const auto values = mesh.add_property_map<Mesh::Face_index, double>("f:value").first;
  std::vector<Segmenter_result> results;
  const auto add = [&](const char* name, double seconds) {
    results.push_back({name, Labels(), seconds});
    for(Mesh::Face_index f : mesh.faces())
      results.back().labels.push_back(static_cast<int>(segments[f]));
  };
  const auto add_method = [&](const char* name, const auto& method) {
    const Stopwatch watch;
    const SP::Segmentation_result r = SP::segmentation_via_area_stretch(mesh, sphere, segments, method);
    if(!r)
      throw std::runtime_error(std::string(SP::get_error_message(r.error)) + ": " + r.detail);
    add(name, watch.seconds());
  };
  const auto add_graph_cut = [&](const char* name, std::size_t clusters, double lambda, double seconds_so_far) {
    const Stopwatch watch;
    CGAL::segmentation_from_sdf_values(mesh, values, segments, clusters, lambda);
    add(name, seconds_so_far + watch.seconds());
  };

  add_method("majority vote", SP::Majority_vote());
  add_method("girth profiles", SP::Girth_profiles());
  add_method("region growing", SP::Region_growing());
  const Stopwatch stretch_watch;
  const auto [least, greatest] = SP::face_log_area_stretch(mesh, sphere, values);
  for(Mesh::Face_index f : mesh.faces())
    values[f] = (values[f] - least) / (greatest - least);
  add_graph_cut("stretch, graph cut", 5, 0.26, stretch_watch.seconds());
  if(with_sdf) {
    const Stopwatch watch;
    CGAL::sdf_values(mesh, values);
    const double seconds = watch.seconds();
    add_graph_cut("SDF default", 5, 0.26, seconds); // CGAL's defaults
    add_graph_cut("SDF tuned", 4, 0.10, seconds);   // what suits the Princeton benchmark better
  }
  results.push_back({"one segment", Labels(mesh.number_of_faces(), 0)});
  results.push_back({"Voronoi cells", voronoi_cells(mesh, number_of_cells)});
  return results;
}

} // namespace benchmark
