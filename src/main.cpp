// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"
#include "options/usage.h"
#include "system/guarded.h"
#include "system/interruption.h"

#include <CGAL/assertions.h>
#include <CGAL/version.h>

#include <CLI/CLI.hpp>

#include <csignal>
#include <exception>
#include <iostream>
#include <new>

namespace {

constexpr int failure = 1;
constexpr int wrong_usage = 2;

/// CGAL prints several lines before it throws; what the exception says is enough.
void print_nothing(const char*, const char*, const char*, int, const char*) {}

int run(int argc, char** argv)
{
  int exit_code = 0;
  CLI::App app("Spherical parameterization of closed triangle meshes of genus 0", "spherical-parameterization");
  app.set_version_flag("--version",
                       "spherical-parameterization " SPHERICAL_PARAMETERIZATION_VERSION " (CGAL " CGAL_VERSION_STR ")");
  app.formatter(tool::help_formatter()); // of the commands, too
  app.footer("'spherical-parameterization COMMAND --help' lists the options of a command.\n"
             "Example: spherical-parameterization map bunny.ply -o sphere.off --stretch-ply stretch.ply");
  app.require_subcommand(1);
  tool::add_map_command(app, exit_code);
  tool::add_segment_command(app, exit_code);
  tool::add_texture_command(app, exit_code);
  tool::add_resample_command(app, exit_code);
  tool::add_signature_command(app, exit_code);
  tool::add_search_command(app, exit_code);
  tool::add_view_command(app, exit_code);
  tool::add_devices_command(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch(const CLI::ParseError& stop) { // also what --help and --version throw
    if(stop.get_exit_code() != 0) {
      std::cerr << "spherical-parameterization: " << tool::usage_error(app, stop)
                << "\nRun with --help for more information.\n";
      return wrong_usage;
    }
    app.exit(stop); // prints the help or the version
  }
  if(exit_code == 0)
    tool::flush_standard_output();
  return exit_code;
}

int run_guarded(int argc, char** argv)
{
  try {
    return run(argc, argv);
  } catch(const std::bad_alloc&) {
    std::cerr << "spherical-parameterization: not enough memory" << std::endl;
  } catch(const std::exception& exception) {
    std::cerr << "spherical-parameterization: " << exception.what() << std::endl;
  }
  return failure;
}

} // namespace

int main(int argc, char** argv)
{
  CGAL::set_error_handler(print_nothing);
  std::signal(SIGXFSZ, SIG_IGN); // a file that exceeds its limit is then an error like a full disk
  const int exit_code = run_guarded(argc, argv);
  if(exit_code != 0)
    tool::die_if_interrupted();
  return exit_code;
}
