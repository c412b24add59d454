// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"

#include "collections/nearest_signatures.h"
#include "collections/sign_mesh.h"
#include "collections/signature_index.h"
#include "system/interruption.h"
#include "system/refusal.h"

#include <CLI/CLI.hpp>

#include <iomanip>
#include <iostream>
#include <memory>
#include <string>

namespace tool {
namespace {

struct Search_options {
  std::string query;
  std::string index;
  int count = 10;
};

void search(const Search_options& options)
{
  watch_for_interruption();
  const std::vector<Signature_row> rows = read_index(options.index); // before the work
  const std::optional<Signature_row> query = sign_mesh(options.query, [] { return !was_interrupted(); });
  if(!query)
    throw Refusal("INTERRUPTED", options.query, "interrupted", "");
  if(!query->signature)
    throw std::runtime_error(query->message);
  const auto neighbours = nearest_signatures(rows, *query->signature, static_cast<std::size_t>(options.count));
  if(neighbours.empty())
    throw Refusal(unreadable_file, options.index, "has no signature", "see its column 'message'");
  std::cout << "distance  name\n" << std::fixed << std::setprecision(4);
  for(const Neighbour& neighbour : neighbours)
    std::cout << std::setw(8) << neighbour.distance << "  " << rows[neighbour.row].name << '\n';
  std::cout << std::flush;
}

} // namespace

void add_search_command(CLI::App& app, int& exit_code)
{
  CLI::App* command = app.add_subcommand("search", "Find the meshes of the most similar shape, in any pose");
  const auto options = std::make_shared<Search_options>();
  command->add_option("QUERY", options->query, "Closed triangle mesh of genus 0: .off, .obj, .ply or .stl")
    ->required()
    ->type_name("FILE");
  command->add_option("--index", options->index, "Index that the command 'signature' has written")
    ->required()
    ->type_name("FILE");
  command->add_option("-k", options->count, "Number of meshes to list")
    ->check(CLI::PositiveNumber)
    ->capture_default_str();
  command->footer("Prints a line per mesh: the distance of its signature, and its name. Typical distances are 0.2\n"
                  "between poses of the same shape and 2 between different shapes.\n"
                  "Example: spherical-parameterization search bunny.ply --index index.csv -k 5\n"
                  "Exit code: 0 found, 1 the mesh or the index was refused (stderr says why), 2 wrong usage,\n"
                  "130 interrupted.");
  command->callback([options, &exit_code] {
    try {
      search(*options);
      exit_code = 0;
    } catch(const std::runtime_error& error) {
      std::cerr << "spherical-parameterization: " << error.what() << std::endl;
      exit_code = 1;
    }
  });
}

} // namespace tool
