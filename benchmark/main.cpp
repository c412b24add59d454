// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"

#include <CGAL/assertions.h>

#include <CLI/CLI.hpp>

#include <exception>
#include <iostream>

int main(int argc, char** argv)
{
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {}); // the exception says it all
  CLI::App app("Measures spherical parameterizations: every command makes one table, as Markdown and as CSV",
               "benchmark");
  app.require_subcommand(1);
  benchmark::add_models_command(app);
  benchmark::add_levels_command(app);
  benchmark::add_backends_command(app);
  benchmark::add_published_command(app);
  benchmark::add_order_command(app);
  benchmark::add_scaling_command(app);
  benchmark::add_foreign_command(app);
  benchmark::add_segmentation_command(app);
  benchmark::add_checks_command(app);
  benchmark::add_retrieval_command(app);
  benchmark::add_texture_command(app);
  benchmark::add_locate_command(app);
  benchmark::add_mass_command(app);
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
