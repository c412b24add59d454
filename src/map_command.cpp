// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "map_command.h"

#include "atomic_file.h"
#include "error_code_names.h"
#include "interruption.h"
#include "map_options.h"
#include "mesh_io.h"
#include "progress_bar.h"
#include "refusal.h"
#include "report.h"
#include "spherical_map.h"
#include "stopwatch.h"
#include "stretch_ply.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <exception>
#include <iostream>
#include <memory>
#include <new>
#include <optional>

namespace tool {
namespace {

using CGAL::Spherical_parameterization::Result;

void stop_if_interrupted(const Map_options& options)
{
  if(was_interrupted())
    throw Refusal(name(Error_code::INTERRUPTED), options.input, "interrupted", "nothing has been written");
}

/// What the options of this program can do about it; the other details of the library say what to do by themselves.
const char* remedy(Error_code code)
{
  switch(code) {
  case Error_code::NOT_CONVERGED: return "allow more --iterations, or try other --weights or the other --method";
  case Error_code::INTERRUPTED:   return "allow more --max-time";
  default:                        return "";
  }
}

/// Fills `report.result`, also where it then throws.
void compute(const Map_options& options, Map_settings settings, Mesh& mesh, Sphere_map sphere, Report& report)
{
  if(!options.fixed.empty())
    settings.fixed_vertices = read_fixed_vertices(options.fixed, mesh.number_of_vertices());

  Progress_bar bar;
  report.result = map_to_sphere(mesh, sphere, settings, [&bar](double fraction) {
    bar.show(fraction);
    return !was_interrupted();
  });
  const Result& result = report.result;
  report.seconds_read += result.seconds.read; // the library checks, too
  stop_if_interrupted(options);
  if(!result)
    throw Refusal(name(result.error), result.error == Error_code::BAD_CONSTRAINTS ? options.fixed : options.input,
                  get_error_message(result.error) + (result.detail.empty() ? "" : ": " + result.detail),
                  remedy(result.error));
}

/// Either all of the files get their names or none.
void write(const Map_options& options, const Mesh& mesh, Sphere_map sphere, Atomic_file& sphere_file,
           Atomic_file* stretch_file)
{
  write_mesh(sphere_file.stream(), output_format(options.sphere), mesh, sphere);
  if(stretch_file)
    write_stretch_ply(stretch_file->stream(), mesh, sphere);
  stop_if_interrupted(options);
  if(stretch_file)
    stretch_file->commit();
  sphere_file.commit();
}

void print_certificate(const Map_options& options, const Report& report, std::size_t triangulated_polygons)
{
  const Result& result = report.result;
  std::cout.precision(3);
  if(triangulated_polygons > 0)
    std::cout << triangulated_polygons << " polygons were triangulated: the faces of the sphere are not those of "
              << options.input << '\n';
  std::cout << options.input << ": " << result.number_of_vertices << " vertices, " << result.number_of_faces
            << " faces\n"
            << "valid spherical map: " << result.flipped_faces << " flipped faces, degree " << result.degree
            << ", residual " << result.residual << '\n'
            << options.method << ", " << options.weights << " weights, " << options.policy << " on " << result.device
            << ": " << result.start_iterations << " + " << result.iterations << " iterations";
  if(result.sweeps > 0)
    std::cout << " of " << result.sweeps << " sweeps in all";
  std::cout << '\n'
            << report.seconds_total << " s: read " << report.seconds_read << ", start map " << result.seconds.start_map
            << ", solve " << result.seconds.solve << ", certify " << result.seconds.certify << ", write "
            << report.seconds_write << '\n'
            << "written: " << options.sphere << (options.stretch_ply.empty() ? "" : " and " + options.stretch_ply)
            << std::endl;
}

void map(const Map_options& options, Report& report)
{
  const Stopwatch total;
  watch_for_interruption();
  const Map_settings settings = map_settings(options); // a device that is not there is better known before the work
  const Stopwatch reading;
  Input_mesh input = read_mesh(options.input, options.triangulate ? Polygons::TRIANGULATE : Polygons::REFUSE);
  report.seconds_read = reading.seconds();
  report.result.number_of_vertices = input.mesh.number_of_vertices();
  report.result.number_of_faces = input.mesh.number_of_faces();
  stop_if_interrupted(options);

  // files that cannot be written are better known before the work than after it
  Atomic_file sphere_file(options.sphere);
  const auto stretch_file = options.stretch_ply.empty() ? nullptr : std::make_unique<Atomic_file>(options.stretch_ply);
  if(!options.report.empty())
    Atomic_file(options.report);

  const Sphere_map sphere = input.mesh.add_property_map<Mesh::Vertex_index, Point>("v:sphere").first;
  compute(options, settings, input.mesh, sphere, report);

  const Stopwatch writing;
  write(options, input.mesh, sphere, sphere_file, stretch_file.get());
  report.seconds_write = writing.seconds();
  report.seconds_total = total.seconds();
  print_certificate(options, report, input.triangulated_polygons);
}

void set_error(Report& report, const std::string& code, std::string error)
{
  std::replace(error.begin(), error.end(), '\n', ' '); // the user gets exactly one line
  report.error_code = code;
  report.error = error;
}

/// Calls `action`; if it throws, notes why.
template <class Action>
void guarded(Report& report, const Action& action)
{
  try {
    action();
  }
  catch(const Refusal& refusal) {
    set_error(report, refusal.code(), refusal.what());
  }
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
  catch(const CGAL::Spherical_parameterization::OpenCL_error& error) {
    const std::string& log = error.build_log();
    const std::string text = error.what();
    set_error(report, "OPENCL_ERROR",
              report.input + ": " + (log.empty() ? text : text.substr(0, text.find('\n'))) +
                (error.code() == CL_DEVICE_NOT_FOUND ? "; see the command 'devices'" : ""));
    report.build_log = log;
  }
#endif
  catch(const std::bad_alloc&) {
    set_error(report, "OUT_OF_MEMORY", report.input + ": not enough memory; simplify the mesh");
  }
  catch(const std::exception& exception) {
    set_error(report, "INTERNAL_ERROR", report.input + ": " + exception.what() + "; please report this");
  }
}

int run(const Map_options& options)
{
  Report report;
  report.input = options.input;
  report.weights = options.weights;
  report.method = options.method;
  report.policy = options.policy;
  const Stopwatch total;
  guarded(report, [&] { map(options, report); });
  report.seconds_total = total.seconds();

  if(!options.report.empty()) {
    Report on_report = report;
    guarded(on_report, [&] { write_report(options.report, report); });
    if(report.error.empty())
      report.error = on_report.error;
  }
  if(!report.error.empty())
    std::cerr << "spherical-parameterization: " << report.error << std::endl;
  if(!report.build_log.empty())
    std::cerr << report.build_log << std::endl;
  return report.error.empty() ? 0 : 1;
}

} // namespace

void add_map_command(CLI::App& app, int& exit_code)
{
  CLI::App* command = app.add_subcommand("map", "Map a closed genus-0 triangle mesh to the sphere, certified");
  const auto options = std::make_shared<Map_options>();
  add_map_options(*command, *options);
  command->callback([options, &exit_code] {
    check_map_options(*options);
    exit_code = run(*options);
  });
}

} // namespace tool
