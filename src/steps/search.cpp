// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "runner/step.h"

#include "collections/signatures.h"
#include "input/files.h"

#include <filesystem>
#include <iomanip>
#include <memory>
#include <optional>
#include <sstream>
#include <system_error>

namespace tool {
namespace {

struct Search_options {
  std::string index;
  int number = 10;
};

void search(const Search_options& options, Run& run)
{
  const std::string file = index_of(options.index), &query = run.options.input;
  if(std::error_code none; file != options.index && !std::filesystem::exists(file, none))
    throw Refusal(unreadable_file, options.index, "is not an index, and " + file + " does not exist",
                  "write it with the command 'signature'");
  const Shape_index index(file, Database::Access::READ); // before the work
  const std::optional<Signature_row> row = sign_mesh(query, run.options.prepare != Prepare::NO);
  if(!row)
    throw Refusal(Error_code::INTERRUPTED, query, "interrupted", "");
  if(!row->signature)
    throw Refusal(*row->refusal);
  const auto neighbours = index.nearest(*row->signature, static_cast<std::size_t>(options.number));
  if(neighbours.empty())
    throw Refusal(unreadable_file, file, "has no signature", "the command 'signature' says why");
  std::ostringstream text;
  text << "distance  name" << std::fixed << std::setprecision(4);
  for(const auto& [distance, name] : neighbours) {
    text << '\n' << std::setw(8) << distance << "  " << name;
    run.details["found"].push_back({{"distance", distance}, {"name", name}});
  }
  run.text = text.str();
}

Work search_work()
{
  const auto own = std::make_shared<Search_options>();
  Work work = {[own](Run& run) { search(*own, run); }};
  work.options
    .add("--index", own->index,
         "Index that the command 'signature' has written; for a table .csv, the file .db "
         "next to it is read")
    .is("FILE")
    .required();
  work.options.add("-k,--number", own->number, "Number of meshes to list").in("[1,2147483647]");
  work.reads = [own](const Request&) {
    return Work::Files{{"--index", own->index}, {"--index", index_of(own->index)}};
  };
  return work;
}

} // namespace

Step search_step()
{
  Takes takes;
  takes.meshes = Takes::ONE;
  takes.prepare = Prepare::ALL;
  takes.prepared = "as 'signature --prepare' does";
  return {
    "search",
    "Find the meshes with the most similar shapes, in any pose",
    takes,
    {},
    search_work,
    "search bunny.ply --index index.db -k 5",
    "Prints a line for each mesh: the distance of its signature, and its name. Typical distances are 0.2 between poses "
    "of the same shape and 2 between different shapes."};
}

} // namespace tool
