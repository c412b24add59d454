// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"

#include "collections/signatures.h"
#include "input/files.h"
#include "options/usage.h"
#include "system/interruption.h"
#include "system/refusal.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>

namespace tool {
namespace {

struct Search_options {
  std::string query;
  std::string index;
  int count = 10;
  bool prepare = false;
};

void search(const Search_options& options)
{
  watch_for_interruption();
  const std::string file = index_of(options.index);
  if(std::error_code none; file != options.index && !std::filesystem::exists(file, none))
    throw Refusal(unreadable_file, options.index, "is not an index, and " + file + " does not exist",
                  "write it with the command 'signature'");
  const Shape_index index(file, Database::Access::READ); // before the work
  const std::optional<Signature_row> query = sign_mesh(options.query, options.prepare);
  if(!query)
    throw Refusal("INTERRUPTED", options.query, "interrupted", "");
  if(!query->signature)
    throw std::runtime_error(query->message);
  const auto neighbours = index.nearest(*query->signature, static_cast<std::size_t>(options.count));
  if(neighbours.empty())
    throw Refusal(unreadable_file, file, "has no signature", "the command 'signature' says why");
  std::cout << "distance  name\n" << std::fixed << std::setprecision(4);
  for(const auto& [distance, name] : neighbours)
    std::cout << std::setw(8) << distance << "  " << name << '\n';
  std::cout << std::flush;
}

} // namespace

void add_search_command(CLI::App& app, int& exit_code)
{
  CLI::App* command = app.add_subcommand("search", "Find the meshes of the most similar shape, in any pose");
  const auto options = std::make_shared<Search_options>();
  command->add_option("QUERY", options->query, std::string("Closed triangle mesh of genus 0: ") + mesh_extensions)
    ->required()
    ->type_name("FILE");
  command->add_option("--index", options->index, "Index that the command 'signature' has written")
    ->required()
    ->type_name("FILE");
  add_checked_option(*command, "-k", options->count, "Number of meshes to list", CLI::PositiveNumber);
  command->add_flag("--prepare", options->prepare, "Mend QUERY first as the command 'prepare' does");
  command->footer("Prints a line per mesh: the distance of its signature, and its name. Typical distances are 0.2\n"
                  "between poses of the same shape and 2 between different shapes.\n"
                  "Example: spherical-parameterization search bunny.ply --index index.db -k 5\n"
                  "Exit code: 0 found, 1 the mesh or the index was refused (stderr says why), 2 wrong usage,\n"
                  "130 interrupted.");
  command->callback([options, &exit_code] {
    search(*options);
    exit_code = 0;
  });
}

} // namespace tool
