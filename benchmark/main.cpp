// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"

#include <CGAL/assertions.h>

#include <CLI/CLI.hpp>

#include <exception>
#include <iostream>
#include <memory>
#include <tuple>

namespace benchmark {
namespace {

/// A subcommand, and the options that it understands.
struct Command {
  std::shared_ptr<Options> options = std::make_shared<Options>();
  CLI::App& app;

  Command(CLI::App& program, const char* name, const char* description, void (*run)(const Options&))
    : app(*program.add_subcommand(name, description))
  {
    app.callback([run, given = options] { run(*given); });
    add("-o,--output", &Options::output, "Folder for the Markdown and CSV files")->capture_default_str();
  }

  template <class T>
  CLI::Option* add(const char* name, T Options::*value, const char* description)
  {
    return app.add_option(name, (*options).*value, description);
  }
  /// Names with commas between them.
  CLI::Option* add_list(const char* name, std::vector<std::string> Options::*value, const char* description)
  {
    return add(name, value, description)->delimiter(',')->allow_extra_args(false);
  }
  template <class Number>
  void add_positive(const char* name, Number Options::*value, const char* description)
  {
    add(name, value, description)->check(CLI::PositiveNumber)->capture_default_str();
  }
  void add_time_limit(double seconds, const char* description)
  {
    options->time_limit = seconds;
    add_positive("--time-limit", &Options::time_limit, description);
  }
  void add_subdivisions(const char* description)
  {
    add("--subdivide", &Options::subdivisions, description)->check(CLI::Range(0, 12))->capture_default_str();
  }
};

/// A command that computes maps of a few meshes.
struct Map_command : Command {
  Map_command(CLI::App& program, const char* name, const char* description, void (*run)(const Options&))
    : Command(program, name, description, run)
  {
    add_positive("--repetitions", &Options::repetitions, "Of every map; the median is shown");
    add_list("--backend", &Options::backends, "sequential, tbb, opencl; default: all that are available");
    add("meshes", &Options::meshes, "Closed triangle meshes of genus 0, or folders of them")
      ->required()
      ->check(CLI::ExistingPath);
  }
};

void add_commands(CLI::App& app)
{
  Map_command(app, "models", "Table 1: every model, both weights, every backend", tabulate_models);
  Map_command(app, "levels", "Table 2: levels of detail, with and without reordering", tabulate_levels)
    .add_subdivisions("Also the meshes subdivided 1 ... N times");
  Map_command(app, "backends", "Table 3: both methods on every device, and on fewer cores", tabulate_backends)
    .add_time_limit(5, "Seconds for every run of the published method");
  Map_command published(app, "published", "Table 4: the published method against the fast one, on one core",
                        tabulate_published);
  published.options->backends = {"sequential"}; // as the paper: on one core
  published.options->repetitions = 1;           // the published method takes all the time it is given
  published.add_time_limit(30, "Seconds for every map");
  Map_command(app, "order", "Figure 2: time and cache misses of a sweep in several vertex orders", tabulate_order)
    .add_subdivisions("Subdivide the meshes N times before");
  Map_command(app, "scaling", "Cost in sweeps, time and memory of ever larger meshes", tabulate_scaling)
    .add_positive("--maximum-vertices", &Options::maximum_vertices, "Subdivide as long as there are no more");
  Command(app, "foreign", "Judges spheres of other programs beside ours", tabulate_foreign)
    .add("files", &Options::meshes, "Pairs SOURCE SPHERE of files with the same vertices and faces")
    ->required()
    ->check(CLI::ExistingFile);
  Command segmentation(app, "segmentation", "Segmentation against humans, SDF values and trivial methods",
                       tabulate_segmentation);
  segmentation.app.add_flag("--skip-sdf", segmentation.options->skips_sdf,
                            "Leave the SDF values out, which take nearly all of the time");
  segmentation.add("folder", &Options::folder, "Folder of folders CLASS_NUMBER, each with a mesh and *.seg files")
    ->required()
    ->check(CLI::ExistingDirectory);
  Map_command(app, "checks", "What it costs to test the published method for convergence often", tabulate_checks)
    .add_time_limit(1, "Seconds for every run");
  Command retrieval(app, "retrieval", "How well signatures and other descriptors find other poses", tabulate_retrieval);
  retrieval.add_list("--variants", &Options::variants_of,
                     "Groups of which remeshed, decimated, subdivided and noisy variants are searched for, too");
  retrieval.add("folder", &Options::folder, "Of files GROUP/CLASS/FILE: closed triangle meshes of genus 0")
    ->required()
    ->check(CLI::ExistingDirectory);
  Command(app, "index", "The index of shape search: size, inserts and searches per second", tabulate_index)
    .add_positive("--rows", &Options::rows, "Signatures in it");
  Map_command(app, "texture", "Texture coordinates: flipped faces, faces that had to be moved", tabulate_texture);
  Map_command locate(app, "locate", "The inverse map: queries per second, error of the round trip", tabulate_locate);
  locate.add_subdivisions("How often the meshes are subdivided");
  locate.add_positive("--queries", &Options::queries, "Random directions");
  Command rotations(app, "rotations", "The rotation between two maps of a shape: how well it is found",
                    tabulate_rotations);
  rotations.add_positive("--rotations", &Options::rotations, "Of every mesh");
  rotations.add("meshes", &Options::meshes, "Closed triangle meshes of genus 0, or folders of them")
    ->required()
    ->check(CLI::ExistingPath);
  Command mass(app, "mass",
               "Maps every mesh with every method and weight, meshes in parallel; goes on where it was stopped",
               tabulate_mass);
  for(const auto& [name, value, description] : {std::tuple("--method", &Options::methods, "Which methods"),
                                                std::tuple("--weights", &Options::weights, "Which weights")})
    mass.add_list(name, value, description)->check(CLI::IsMember((*mass.options).*value))->capture_default_str();
  mass.add_positive("--time-limit", &Options::time_limit, "Seconds for every map");
  mass.add_positive("-j,--jobs", &Options::jobs, "So many maps at the same time");
  mass.add("--list", &Options::list, "Text file with one more mesh or folder per line")->check(CLI::ExistingFile);
  mass.add("meshes", &Options::meshes, "Meshes, or folders whose meshes are meant, at any depth")
    ->check(CLI::ExistingPath);
  Map_command sweep(app, "sweep", "What order runs under cachegrind", run_sweeps);
  sweep.app.group(""); // hidden
  sweep.add_subdivisions("As for order");
  sweep.add("--order", &Options::order, "Of the vertices")->required();
}

} // namespace
} // namespace benchmark

int main(int argc, char** argv)
{
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {}); // the exception says it all
  CLI::App app("Measures spherical parameterizations: every command makes one table, as Markdown and as CSV",
               "benchmark");
  app.require_subcommand(1);
  benchmark::add_commands(app);
  try {
    app.parse(argc, argv);
  } catch(const CLI::ParseError& error) {
    if(error.get_exit_code() == 0) // --help
      return app.exit(error);
    std::cerr << "benchmark: " << error.what() << std::endl;
    return 2;
  } catch(const std::exception& error) {
    std::cerr << "benchmark: " << error.what() << std::endl;
    return 1;
  }
  return 0;
}
