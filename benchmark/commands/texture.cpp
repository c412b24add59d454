// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"
#include "commands/options.h"
#include "tables/table.h"
#include "measure/timing.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spherical_parameterization/texture_coordinates.h>

#include <CLI/CLI.hpp>

#include <memory>

namespace benchmark {
namespace {

namespace SP = CGAL::Spherical_parameterization;
using Point_2 = CGAL::Simple_cartesian<double>::Point_2;
using Uv_map = Mesh::Property_map<Mesh::Halfedge_index, Point_2>;

/// Faces that are not counter-clockwise, by exact predicates.
std::size_t count_flipped(const Mesh& mesh, Uv_map uv)
{
  using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::size_t flipped = 0;
  for(const Mesh::Face_index f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    const auto point = [&](Mesh::Halfedge_index k) { return Exact::Point_2(uv[k].x(), uv[k].y()); };
    flipped += CGAL::orientation(point(h), point(mesh.next(h)), point(mesh.prev(h))) != CGAL::LEFT_TURN;
  }
  return flipped;
}

void measure(const Options& options)
{
  const Backend backend = options.backends().front();
  Table table(
    options.output, "texture", "Texture coordinates",
    {"flipped: uv triangles that are not counter-clockwise, by exact predicates; moved: faces with a corner of "
     "their own; unresolved: of these the ones smaller than the grid"},
    {"model", "weights", "faces", "map", "chart", "bits", "flipped", "seam", "moved", "unresolved", "largest move",
     "s"});
  for(const auto& file : options.mesh_files())
    with_mesh(file, [&](Mesh& mesh) {
      const Sphere_map sphere = sphere_map(mesh);
      const Uv_map uv = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
      for(Weights weights : both_weights) {
        const Result map = compute_map(backend, mesh, weights, SP::Balanced(), sphere);
        if(!map) {
          table.add_row(
            {model_name(file), name(weights), mesh.number_of_faces(), verdict(map), "", "", "", "", "", "", "", ""});
          continue;
        }
        for(const auto chart : {SP::Texture_chart::LATITUDE_LONGITUDE, SP::Texture_chart::OCTAHEDRAL})
          for(const int bits : {52, 23}) {
            SP::Texture_options texture;
            texture.chart = chart;
            texture.bits = bits;
            const Stopwatch watch;
            const SP::Texture_report r = SP::texture_coordinates(mesh, sphere, uv, texture);
            const double seconds = watch.seconds();
            table.add_row({model_name(file), name(weights), mesh.number_of_faces(), verdict(map),
                           chart == SP::Texture_chart::OCTAHEDRAL ? "octahedral" : "latitude-longitude", bits,
                           count_flipped(mesh, uv), r.seam_faces, r.moved_faces, r.unresolved_faces, r.largest_move,
                           seconds});
          }
      }
    });
}

} // namespace

void add_texture_command(CLI::App& app)
{
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("texture", "Texture coordinates: flipped faces, faces that had to be moved");
  add_all_options(*command, *options);
  command->callback([options] { measure(*options); });
}

} // namespace benchmark
