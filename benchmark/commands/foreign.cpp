// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"
#include "tables/table.h"

#include "mapping/mapped_mesh.h"

#include <CGAL/Spherical_parameterization/distortion_summary.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>

namespace benchmark {
namespace {

/// Maps the mesh, or reads the sphere if there is one.
void add_row(Table& table, const char* name, const tool::Mapping_options& mapping)
{
  tool::Mapped_mesh map;
  tool::read_input(mapping, map);
  tool::map_input(mapping, map, tool::Map_quality::CONVERGED);
  const auto d = CGAL::Spherical_parameterization::distortion_summary(map.mesh(), tool::as_map(map.sphere));
  const double degrees = 180 / std::acos(-1.);
  table.add_row({std::filesystem::path(mapping.input).stem().string(), map.result.number_of_vertices, name,
                 map.result.flipped_faces, map.result.degree, degrees * d.angle_distortion.mean,
                 degrees * d.angle_distortion.max, d.log_area_stretch.deviation, d.log_area_stretch.min,
                 d.log_area_stretch.max, mapping.sphere.empty() ? Cell(map.result.seconds.total) : Cell()});
}

} // namespace

void tabulate_foreign(const Options& options)
{
  if(options.meshes.size() % 2 != 0)
    throw std::runtime_error("foreign: the files have to be pairs SOURCE SPHERE");
  Table table(options.output, "foreign", "Foreign spheres and ours",
              {"flips: faces with orientation(O, a, b, c) <= 0 by an exact predicate",
               "angles: face_angle_distortion(), in degrees, weighted by area",
               "stretch: face_log_area_stretch(), the logarithm of the area stretch (Definition 1 of the paper)",
               "ours: Balanced on one core"},
              {"model", "vertices", "map", "flips", "degree", "angles: mean", "angles: largest", "stretch: deviation",
               "stretch: smallest", "stretch: largest", "total s"});
  for(std::size_t i = 0; i < options.meshes.size(); i += 2) {
    tool::Mapping_options mapping;
    mapping.input = options.meshes[i];
    mapping.policy = "sequential";
    mapping.sphere = options.meshes[i + 1];
    add_row(table, "foreign", mapping);
    mapping.sphere.clear();
    for(const char* weights : {"barycentric", "conformal"}) {
      mapping.weights = weights;
      add_row(table, weights, mapping);
    }
  }
}

} // namespace benchmark
