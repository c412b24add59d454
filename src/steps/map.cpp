// SPDX-License-Identifier: GPL-3.0-or-later

#include "runner/step.h"

#include <CGAL/Spherical_parameterization/distortion_summary.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include <cmath>
#include <sstream>

namespace tool {
namespace {

void say(Run& run)
{
  const Mapped_mesh& input = run.input;
  const SP::Result& result = input.result;
  const std::string name = run.name_of_input();
  std::ostringstream text, line;
  text.precision(3);
  line << "valid spherical map: " << result.flipped_faces << " flipped faces, degree " << result.degree;
  text << triangulation_text(name, input, "of the sphere");
  const std::string preparation = preparation_text(name, input.prepared);
  if(!preparation.empty())
    text << preparation
         << "the sphere has the vertices and faces of the prepared mesh, which 'prepare --steps merge,orient' writes\n";
  text << name << ": " << result.number_of_vertices << " vertices, " << result.number_of_faces << " faces\n"
       << line.str();
  if(std::isnan(result.residual))
    text << ", rounded to floats";
  else
    text << ", residual " << result.residual;
  const std::string shortfall = SP::get_shortcoming(result);
  if(!shortfall.empty())
    text << "\nvalid, but " << shortfall;
  if(!run.options.density.empty() && !std::isnan(result.density_deviation))
    text << "\nroot mean square of log(area / target area): " << result.density_deviation;
  text << '\n'
       << result.method << ", " << (result.method == "isometric" ? "" : run.options.weights + " weights, ")
       << run.options.policy << " on " << result.device << ": " << result.start_iterations
       << " iterations for the start map, " << result.iterations << " from there";
  if(result.sweeps > 0)
    text << " of " << result.sweeps << " sweeps in total";
  text << '\n';
  if(!result.fallback_reason.empty())
    text << "automatic: " << result.fallback_reason << '\n';
  text << run.figures.seconds_total << " s: read " << input.seconds_read << ", weights " << result.seconds.weights
       << ", start map " << result.seconds.start_map << ", solve " << result.seconds.solve << ", certify "
       << result.seconds.certify;
  if(run.figures.seconds_measure > 0)
    text << ", measure " << run.figures.seconds_measure;
  text << ", write " << run.figures.seconds_write << '\n'
       << "written: " << run.name_of_output() << (run.has("--stretch-ply") ? " and " + run.file("--stretch-ply") : "");
  line << ", " << result.number_of_vertices << " vertices, " << result.method;
  if(input.file->triangulated_polygons > 0)
    line << ", " << input.file->triangulated_polygons << " polygons were triangulated";
  if(!shortfall.empty())
    line << "; " << shortfall;
  run.text = text.str();
  run.line = line.str();
}

void map(Run& run)
{
  Mapped_mesh& input = run.input;
  run.read();
  input.needs_neighbours = run.has("--stretch-ply");
  run.map();
  const Mesh_format format = run.mesh_format().format;
  certify_as_stored(run.file(), format, input, input.sphere);
  Sphere exact; // where the file has floats
  if(stores_floats(format)) {
    exact = input.sphere;
    take_as_stored(format, input);
  }

  const Stopwatch measuring;
  if(run.has("--report"))
    run.figures.distortion = on_host(
      input, [&](const auto& policy) { return SP::distortion_summary(policy, input.mesh(), as_map(input.sphere)); });
  std::vector<double> stretch;
  if(run.has("--stretch-ply")) {
    stretch.resize(input.mesh().number_of_vertices());
    on_host(input, [&](const auto& policy) {
      return SP::vertex_log_area_stretch(policy, input.mesh(), as_map(input.sphere),
                                         as_map<Mesh::Vertex_index>(stretch));
    });
  }
  if(run.has("--report") || !stretch.empty())
    run.figures.seconds_measure = measuring.seconds();
  run.write("--output", input.mesh(), exact.empty() ? input.sphere : exact, Surface::SPHERE);
  if(std::ostream* const file = run.out("--stretch-ply"))
    write_coloured_ply(*file, run.ascii, input.mesh(), input.mesh().points(), "log_area_stretch", stretch);
  run.commit();
  say(run);
}

} // namespace

Step map_step()
{
  return {"map",
          "Map a closed genus-0 triangle mesh to the sphere, certified",
          {Takes::EACH, "automatic", "conformal", Takes::NO_SPHERE, Prepare::HARMLESS},
          {{"-o,--output",
            "Output file of the sphere, whose vertices and faces are those of IN, in the same order",
            {},
            Output::MESH,
            Output::REQUIRED},
           {"--stretch-ply",
            "Write IN as PLY, coloured by the logarithm of the area stretch: red where the map shrinks, blue where it "
            "enlarges",
            {".ply"}}},
          [] { return Work{map}; },
          "map bunny.ply -o sphere.off --report report.json"};
}

} // namespace tool
