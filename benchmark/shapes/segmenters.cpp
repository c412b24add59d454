// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "shapes/segmenters.h"
#include "measure/timing.h"

#include <CGAL/Spherical_parameterization/segmentation.h>

#include <CGAL/mesh_segmentation.h>

#include <limits>
#include <random>
#include <stdexcept>
#include <utility>

namespace benchmark {
namespace {

namespace SP = CGAL::Spherical_parameterization;
typedef Mesh::Property_map<Mesh::Face_index, std::size_t> Segment_map;
typedef Mesh::Property_map<Mesh::Face_index, double> Value_map;

/// CGAL's defaults, and what suits the Princeton benchmark better.
struct Graph_cut {
  std::size_t clusters;
  double lambda;
};
constexpr Graph_cut default_cut = {5, 0.26}, tuned_cut = {4, 0.10};

Labels labels_of(const Mesh& mesh, Segment_map segments)
{
  Labels labels;
  for(Mesh::Face_index f : mesh.faces())
    labels.push_back(static_cast<int>(segments[f]));
  return labels;
}

template <class Method>
Timed_labels segment(Mesh& mesh, Sphere_map sphere, Segment_map segments, const Method& method)
{
  const Stopwatch watch;
  const SP::Segmentation_result r = SP::segmentation_via_area_stretch(mesh, sphere, segments, method);
  const double seconds = watch.seconds();
  if(!r)
    throw std::runtime_error(std::string(SP::get_error_message(r.error)) + ": " + r.detail);
  return {labels_of(mesh, segments), seconds};
}

Timed_labels cut_graph(Mesh& mesh, Value_map values, Segment_map segments, Graph_cut cut, double seconds_so_far)
{
  const Stopwatch watch;
  CGAL::segmentation_from_sdf_values(mesh, values, segments, cut.clusters, cut.lambda);
  return {labels_of(mesh, segments), seconds_so_far + watch.seconds()};
}

Timed_labels cut_stretch(Mesh& mesh, Sphere_map sphere, Value_map values, Segment_map segments)
{
  const Stopwatch watch;
  const auto [least, greatest] = SP::face_log_area_stretch(mesh, sphere, values);
  for(Mesh::Face_index f : mesh.faces())
    values[f] = (values[f] - least) / (greatest - least);
  return cut_graph(mesh, values, segments, default_cut, watch.seconds());
}

/// The faces nearest to `count` random ones.
Labels voronoi_cells(const Mesh& mesh, std::size_t count)
{
  std::vector<Point_3> centroids;
  for(Mesh::Face_index f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    centroids.push_back(
      CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h)))));
  }
  std::mt19937 random(1);
  std::vector<Point_3> sites;
  for(std::size_t i = 0; i < count; ++i)
    sites.push_back(centroids[random() % centroids.size()]);
  Labels labels;
  for(const Point_3& c : centroids) {
    std::size_t nearest = 0;
    for(std::size_t i = 1; i < sites.size(); ++i)
      if(CGAL::squared_distance(c, sites[i]) < CGAL::squared_distance(c, sites[nearest]))
        nearest = i;
    labels.push_back(static_cast<int>(nearest));
  }
  return labels;
}

} // namespace

std::vector<Segmenter_result> segment_by_all(Mesh& mesh, Sphere_map sphere, std::size_t number_of_cells, bool with_sdf)
{
  const Segment_map segments = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  const Value_map values = mesh.add_property_map<Mesh::Face_index, double>("f:value").first;
  std::vector<Segmenter_result> results = {{"majority vote", segment(mesh, sphere, segments, SP::Majority_vote())},
                                           {"girth profiles", segment(mesh, sphere, segments, SP::Girth_profiles())},
                                           {"region growing", segment(mesh, sphere, segments, SP::Region_growing())},
                                           {"stretch, graph cut", cut_stretch(mesh, sphere, values, segments)}};
  if(with_sdf) {
    const Stopwatch watch;
    CGAL::sdf_values(mesh, values);
    const double seconds = watch.seconds();
    results.push_back({"SDF default", cut_graph(mesh, values, segments, default_cut, seconds)});
    results.push_back({"SDF tuned", cut_graph(mesh, values, segments, tuned_cut, seconds)});
  }
  results.push_back({"one segment", {Labels(mesh.number_of_faces(), 0), 0}});
  results.push_back({"Voronoi cells", {voronoi_cells(mesh, number_of_cells), 0}});
  return results;
}

} // namespace benchmark
