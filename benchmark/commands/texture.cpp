// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"
#include "measure/backend.h"
#include "measure/measure.h"
#include "tables/table.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spherical_parameterization/texture_coordinates.h>

#include <algorithm>

namespace benchmark {
namespace {

namespace SP = CGAL::Spherical_parameterization;
using Point_2 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
using Uv_map = Mesh::Property_map<Mesh::Halfedge_index, Point_2>;

/// Faces that are not counter-clockwise, by exact predicates.
std::size_t count_flipped(const Mesh& mesh, Uv_map uv)
{
  return std::count_if(mesh.faces_begin(), mesh.faces_end(), [&](Mesh::Face_index f) {
    const auto h = mesh.halfedge(f);
    return CGAL::orientation(uv[h], uv[mesh.next(h)], uv[mesh.prev(h)]) != CGAL::LEFT_TURN;
  });
}

} // namespace

void tabulate_texture(const Options& options)
{
  const Backend backend = backends(options.backends).front();
  Table table(
    options.output, "texture", "Texture coordinates",
    {"flipped: uv triangles that are not counter-clockwise, by exact predicates; moved: faces with a corner of "
     "their own; unresolved: of these the ones smaller than the grid"},
    {"model", "weights", "faces", "map", "chart", "bits", "flipped", "seam", "moved", "unresolved", "largest move",
     "s"});
  for_each_mesh(options.meshes, [&](const std::string& model, Mesh& mesh, Sphere_map sphere) {
    const Uv_map uv = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
    for(Weights weights : both_weights) {
      const Result map = compute_map(backend, mesh, weights, Balanced(), sphere);
      if(!map)
        table.add_row({model, name(weights), mesh.number_of_faces(), verdict(map)});
      else
        for(const auto& [chart, chart_name] : {std::pair(SP::Texture_chart::LATITUDE_LONGITUDE, "latitude-longitude"),
                                               std::pair(SP::Texture_chart::OCTAHEDRAL, "octahedral")})
          for(const int bits : {52, 23}) {
            SP::Texture_options texture;
            texture.chart = chart;
            texture.bits = bits;
            const Stopwatch watch;
            const SP::Texture_report r = SP::texture_coordinates(mesh, sphere, uv, texture);
            const double seconds = watch.seconds();
            table.add_row({model, name(weights), mesh.number_of_faces(), verdict(map), chart_name, bits,
                           count_flipped(mesh, uv), r.seam_faces, r.moved_faces, r.unresolved_faces, r.largest_move,
                           seconds});
          }
    }
  });
}

} // namespace benchmark
