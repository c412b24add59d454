// SPDX-License-Identifier: GPL-3.0-or-later

#include "runner/step.h"

#include "preparation/prepare.h"

#include <CGAL/Spherical_parameterization/resample.h>
#include <CGAL/Spherical_parameterization/resampling_weights.h>
#include <CGAL/Spherical_parameterization/shape_statistics.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <sstream>

namespace tool {
namespace {

/// What may be lost without a word, of the diagonal and of a side of the bounding box.
constexpr double largest_distance = 0.01, largest_loss_of_box = 0.03;

struct Resample_options {
  int level = 6;
  std::string sphere; ///< empty: an icosphere
  std::string weights = "linear";
  std::vector<std::string> areas; ///< files of surfaces with the old and with the new vertices; or none
  std::string labels = "majority";
};

/// The new mesh and its map: a sphere, of which this is certified, or an icosphere.
Mapped_mesh sphere_of(const Resample_options& options, const Run& run)
{
  Mapped_mesh result;
  if(!options.sphere.empty()) {
    Mapping_options as_its_own_map;
    as_its_own_map.input = as_its_own_map.sphere = options.sphere;
    as_its_own_map.policy = run.options.policy;
    read_input(as_its_own_map, result);
    map_input(as_its_own_map, result);
    return result;
  }
  std::vector<std::array<int, 3>> triangles;
  SP::make_icosphere_soup(options.level, result.sphere, triangles);
  result.file = Input_mesh{Mesh(result.sphere, triangles), 0, {}, {}};
  return result;
}

/// Of the vertices: those of the surface, or of the one in that file of --area-surfaces.
template <class Policy>
std::vector<double> areas(const Policy& policy, const Resample_options& options, std::size_t file, const Mesh& mesh,
                          const std::vector<Point>& points)
{
  if(options.areas.empty())
    return SP::mean_vertex_areas(policy, mesh, std::vector<SP::Shape_points>{points});
  const Mesh surface = read_mesh(options.areas[file], Polygons::TRIANGULATE).mesh;
  if(surface.number_of_vertices() != mesh.number_of_vertices())
    throw Refusal(not_the_sphere, options.areas[file],
                  "has " + std::to_string(surface.number_of_vertices()) + " vertices instead of " +
                    std::to_string(mesh.number_of_vertices()),
                  file == 0 ? "give a surface with the vertices of IN" : "give a surface with the new vertices");
  return SP::mean_vertex_areas(policy, surface, std::vector<SP::Shape_points>{surface.points()});
}

/// Numbers are weighted means, and labels as `options` say; having none counts as one.
Vertex_data resampled(const Resample_options& options, const Vertex_data& data, const SP::Resampling_weights& weights)
{
  constexpr double none = std::numeric_limits<double>::infinity(); // which, unlike NaN, is equal to itself
  Vertex_data result = data;
  for(Vertex_column& column : result) {
    if(!column.is_label) {
      column.values = weights.means(column.values);
      continue;
    }
    for(double& value : column.values)
      value = std::isnan(value) ? none : value;
    column.values = options.labels == "majority" ? weights.majorities(column.values) : weights.nearest(column.values);
    for(double& value : column.values)
      value = value == none ? std::nan("") : value;
  }
  return result;
}

void resample(const Resample_options& options, Run& run)
{
  run.read();
  run.map();
  Mapped_mesh target = sphere_of(options, run);
  if(run.has("--output-sphere"))
    certify_as_stored(run.file("--output-sphere"), run.mesh_format("--output-sphere").format, target, target.sphere);
  const Mesh& out = target.mesh();
  const SP::Spherical_locator<Mesh> shape(run.mesh(), as_map(run.input.sphere));
  constexpr std::size_t points_at_once = 4096;
  std::vector<Point> points;
  for(const Point& direction : target.sphere) {
    if(points.size() % points_at_once == 0)
      stop_if_interrupted(run.options.input);
    points.push_back(SP::interpolate(run.mesh(), shape.locate(direction), as_map(run.mesh().points())));
  }
  if(!run.data.empty())
    run.data = on_host(run.input, [&](const auto& policy) {
      if(options.weights == "linear")
        return resampled(options, run.data, SP::linear_resampling(policy, shape, target.sphere));
      const SP::Spherical_locator<Mesh> to(policy, out, as_map(target.sphere));
      return resampled(options, run.data,
                       SP::area_preserving_resampling(policy, shape, run.input.sphere,
                                                      areas(policy, options, 0, run.mesh(), run.mesh().points()), to,
                                                      target.sphere, areas(policy, options, 1, out, points)));
    });
  run.write("--output", out, points, Surface::SHAPE);
  run.write("--output-sphere", out, target.sphere, Surface::SPHERE);
  if(!run.file().empty()) // the loss is that of the file
    for(Point& p : points)
      p = as_stored(run.mesh_format().format, Surface::SHAPE, p);
  const Sampling_loss loss = sampling_loss(run.mesh(), out, points);
  run.details["resample"] = {{"level", known(options.sphere.empty(), options.level)},
                             {"to_sphere", known(!options.sphere.empty(), options.sphere)},
                             {"vertices", out.number_of_vertices()},
                             {"distance", loss.distance},
                             {"bounding_box", loss.bounding_box}};
  run.commit();
  const std::string& method = run.input.result.method; // empty: the map was given
  std::ostringstream line;
  line.precision(2);
  line << out.number_of_vertices() << " vertices, " << out.number_of_faces() << " faces; " << method
       << (method.empty() ? "" : " map; ") << "99 % of the shape is within " << 100 * loss.distance
       << " % of its diagonal, the bounding box has lost " << 100 * loss.bounding_box << " %";
  if(loss.distance > largest_distance || loss.bounding_box > largest_loss_of_box)
    line << "; parts that are small on the sphere are lost: try "
         << (method.empty()          ? "a map of less distortion"
             : method == "isometric" ? "a larger --area-exponent"
                                     : "--method isometric")
         << " or a " << (options.sphere.empty() ? "larger --level" : "finer sphere");
  run.line = line.str();
  run.text = preparation_text(run.name_of_input(), run.input.prepared) + run.name_of_output() + ": " + run.line;
}

Work resample_work()
{
  const auto own = std::make_shared<Resample_options>();
  Work work = {[own](Run& run) { resample(*own, run); }};
  Options& options = work.options;
  options("--level", own->level, "The new mesh has 10 * 4^LEVEL + 2 vertices")
    .in("[0," + std::to_string(SP::largest_icosphere_level) + ']');
  options("--to-sphere", own->sphere,
          "The new mesh has the vertices and faces of this sphere instead, such as that of a template; the map of IN "
          "has to be registered to it, as --output-sphere of 'register' is");
  options("--data-weights", own->weights,
          "How values of --data are resampled: linearly in a face of IN, or such that every vertex of IN contributes "
          "in proportion to its area, even if the new mesh is coarser")
    .of({"linear", "area-preserving"});
  options("--area-surfaces", own->areas,
          "Two surfaces that give the areas: one with the vertices of IN, one with the new vertices [IN, the output]")
    .times(2)
    .only_with("--data-weights", {"area-preserving"});
  options("--data-labels", own->labels,
          "Labels of --data: the label with the largest sum of weights, or that of the vertex with the largest weight")
    .of({"majority", "nearest"});
  work.check = [own](const Request& request) {
    require(own->sphere.empty() || !request.has("--level"), "--to-sphere", "excludes --level");
  };
  work.reads = [own](const Request&) {
    Work::Files files(2, {"--to-sphere", own->sphere}); // as a mesh and as its map
    for(const std::string& file : own->areas)
      files.emplace_back("--area-surfaces", file);
    return files;
  };
  return work;
}

} // namespace

Step resample_step()
{
  return {"resample",
          "Sample a shape at the vertices of an icosphere or another sphere",
          {Takes::EACH, "isometric", "conformal", Takes::OPTION, Prepare::ALL, // which loses no limb
           "the repaired mesh is sampled"},
          {{"-o,--output", "Output file of the new mesh", {}, Output::MESH, Output::REQUIRED},
           {"--output-sphere", "Write that sphere, too, which is the map of the new mesh", {}, Output::MESH}},
          resample_work,
          "resample bunny.ply -o icosphere.off --level 7"};
}

} // namespace tool
