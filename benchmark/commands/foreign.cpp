// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"
#include "commands/options.h"
#include "tables/table.h"

#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <tuple>

namespace benchmark {
namespace {

namespace SP = CGAL::Spherical_parameterization;
using Vector_3 = CGAL::Simple_cartesian<double>::Vector_3;

std::array<Mesh::Vertex_index, 3> corners(const Mesh& mesh, Mesh::Face_index f)
{
  const auto h = mesh.halfedge(f);
  return {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
}

void check_same_faces(const Mesh& a, const Mesh& b)
{
  const auto same = [&](Mesh::Face_index f) {
    std::array<Mesh::Vertex_index, 3> p = corners(a, f), q = corners(b, f);
    std::rotate(p.begin(), std::min_element(p.begin(), p.end()), p.end());
    std::rotate(q.begin(), std::min_element(q.begin(), q.end()), q.end());
    return p == q;
  };
  if(!is_triangle_mesh(a))
    throw std::runtime_error("not a triangle mesh");
  if(!is_triangle_mesh(b) || a.number_of_vertices() != b.number_of_vertices() ||
     a.number_of_faces() != b.number_of_faces() || !std::all_of(a.faces_begin(), a.faces_end(), same))
    throw std::runtime_error("the sphere does not have the same vertices and faces in the same order");
}

/// Angle at p between the rays to q and r, in degrees.
double angle(const Point_3& p, const Point_3& q, const Point_3& r)
{
  const Vector_3 a = q - p, b = r - p;
  return std::atan2(std::sqrt(CGAL::cross_product(a, b).squared_length()), a * b) * 180 / std::acos(-1.);
}

struct Distortion {
  double mean_angle = 0, largest_angle = 0;
  double mean_stretch = 0, smallest_stretch = 0, largest_stretch = 0;
};

Distortion distortion(Mesh& mesh, Sphere_map sphere)
{
  Distortion d;
  for(Mesh::Face_index f : mesh.faces()) {
    const auto v = corners(mesh, f);
    for(int i = 0; i < 3; ++i) {
      const auto p = v[i], q = v[(i + 1) % 3], r = v[(i + 2) % 3];
      const double change =
        std::abs(angle(sphere[p], sphere[q], sphere[r]) - angle(mesh.point(p), mesh.point(q), mesh.point(r)));
      d.mean_angle += change / (3. * mesh.number_of_faces());
      d.largest_angle = (std::max)(d.largest_angle, change);
    }
  }
  const auto stretch = mesh.add_property_map<Mesh::Vertex_index, double>("v:stretch").first;
  std::tie(d.smallest_stretch, d.largest_stretch) = SP::log_area_stretch(mesh, sphere, stretch);
  for(Mesh::Vertex_index v : mesh.vertices())
    d.mean_stretch += std::abs(stretch[v]) / mesh.number_of_vertices();
  return d;
}

void add_row(Table& table, const std::string& model, const char* map, std::size_t flips, Mesh& mesh, Sphere_map sphere,
             Cell seconds)
{
  const Distortion d = distortion(mesh, sphere);
  table.add_row({model, mesh.number_of_vertices(), map, flips, SP::degree_of_map(mesh, sphere), d.mean_angle,
                 d.largest_angle, d.mean_stretch, d.smallest_stretch, d.largest_stretch, seconds});
}

void measure(const Options& options)
{
  if(options.meshes.size() % 2 != 0)
    throw std::runtime_error("foreign: the files have to be pairs SOURCE SPHERE");
  const Backend backend = available_backends().front();
  Table table(
    options.output, "foreign", "Foreign spheres and ours",
    {"flips: faces with orientation(O, a, b, c) <= 0 by an exact predicate, on the coordinates as they are in "
     "the file; for all else they are normalised",
     "angles: change of the angles of the flat triangles, in degrees; mean over all corners",
     "stretch: log_area_stretch(), the logarithm of the area stretch of a vertex (Definition 1 of the "
     "paper); mean of its absolute value over the vertices",
     "ours: Balanced on one core"},
    {"model", "vertices", "map", "flips", "degree", "angles: mean", "angles: largest", "stretch: mean",
     "stretch: smallest", "stretch: largest", "total s"});
  for(std::size_t i = 0; i < options.meshes.size(); i += 2)
    with_mesh(options.meshes[i], [&](Mesh& mesh) {
      const Sphere_map sphere = sphere_map(mesh);
      const std::string model = model_name(options.meshes[i]);
      with_mesh(options.meshes[i + 1], [&](Mesh& foreign) {
        check_same_faces(mesh, foreign);
        for(Mesh::Vertex_index v : mesh.vertices()) {
          const Vector_3 d = foreign.point(v) - CGAL::ORIGIN;
          sphere[v] = CGAL::ORIGIN + d / std::sqrt(d.squared_length());
        }
        add_row(table, model, "foreign", SP::number_of_flipped_faces(mesh, foreign.points()), mesh, sphere, Cell());
      });
      for(Weights weights : both_weights) {
        const Result r = compute_map(backend, mesh, weights, Balanced(), sphere);
        add_row(table, model, name(weights), r.flipped_faces, mesh, sphere, r.seconds.total);
      }
    });
}

} // namespace

void add_foreign_command(CLI::App& app)
{
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("foreign", "Judges spheres of other programs beside ours");
  add_output_option(*command, *options);
  command->add_option("files", options->meshes, "Pairs SOURCE SPHERE of files with the same vertices and faces")
    ->required()
    ->check(CLI::ExistingFile);
  command->callback([options] { measure(*options); });
}

} // namespace benchmark
