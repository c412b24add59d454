// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"

#include "input/mesh_format.h"
#include "options/usage.h"
#include "system/standard_output.h"

#include <CGAL/version.h>

#include <CLI/CLI.hpp>

#include <iostream>

namespace tool {

int run(int argc, char** argv)
{
  int exit_code = 0;
  CLI::App app("Spherical parameterization of closed triangle meshes of genus 0", "spherical-parameterization");
  app.set_version_flag("--version",
                       "spherical-parameterization " SPHERICAL_PARAMETERIZATION_VERSION " (CGAL " CGAL_VERSION_STR ")");
  app.formatter(help_formatter()); // of the commands, too
  app.footer("'spherical-parameterization COMMAND --help' lists the options of a command.\n" + list_of_formats() +
             "\n"
             "Example: spherical-parameterization map bunny.ply -o sphere.off --stretch-ply stretch.ply");
  app.require_subcommand(1);
  app.add_flag_callback("-q,--quiet", be_quiet, "Print nothing but errors");
  app.add_flag_callback("-v,--verbose", be_verbose, "Print what was tried, with its outcome and time, and the memory");
  app.fallthrough(); // behind the command, too
  add_map_command(app, exit_code);
  add_segment_command(app, exit_code);
  add_texture_command(app, exit_code);
  add_resample_command(app, exit_code);
  add_harmonics_command(app, exit_code);
  add_atlas_command(app, exit_code);
  add_register_command(app, exit_code);
  add_morph_command(app, exit_code);
  add_signature_command(app, exit_code);
  add_search_command(app, exit_code);
  add_prepare_command(app, exit_code);
  add_certify_command(app, exit_code);
  add_view_command(app, exit_code);
  add_devices_command(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch(const CLI::ParseError& stop) { // also what --help and --version throw
    if(stop.get_exit_code() != 0) {
      std::cerr << "spherical-parameterization: " << usage_error(app, stop)
                << "\nRun with --help for more information.\n";
      return 2;
    }
    app.exit(stop); // prints the help or the version
  }
  if(exit_code == 0)
    flush_standard_output();
  return exit_code;
}

} // namespace tool
