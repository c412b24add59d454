// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"

#include "collections/signatures.h"
#include "input/files.h"
#include "options/collection_options.h"
#include "options/usage.h"
#include "system/interruption.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <string>

namespace tool {
namespace {

struct Signature_options : Collection_options {
  std::string output;
  bool prepare = false;
};

/// The index must not take the place of what it is made of.
void check(const Signature_options& options)
{
  check_collection_options(options);
  require(!is_mesh_file(options.output), "--output",
          "'" + options.output + "' has the extension of a mesh; the index is a database");
  const std::string index = index_of(options.output);
  check_files({{"--list", options.list}},
              {{"--output", options.output}, {"the index", index == options.output ? "" : index}});
}

int run(const Signature_options& options)
{
  watch_for_interruption();
  const Batch_summary summary =
    update_index(options.meshes(), options.output, options.number_of_jobs(), options.prepare);
  for(const std::string& why : summary.without_signature)
    std::cerr << "spherical-parameterization: " << why << '\n';
  const std::size_t signatures = summary.meshes - summary.without_signature.size();
  std::cout << options.output << ": " << summary.meshes << " meshes, " << signatures << " signatures";
  if(summary.mended > 0)
    std::cout << ", " << summary.mended << " of mended meshes";
  if(summary.resumed > 0)
    std::cout << ", " << summary.resumed << " rows from an earlier run";
  if(summary.removed > 0)
    std::cout << ", " << summary.removed << " rows of other meshes removed";
  std::cout << std::endl;
  return signatures > 0 ? 0 : 1;
}

} // namespace

void add_signature_command(CLI::App& app, int& exit_code)
{
  CLI::App* command =
    app.add_subcommand("signature", "Compute a shape descriptor of each mesh, for the command 'search'");
  const auto options = std::make_shared<Signature_options>();
  add_collection_options(*command, *options);
  command
    ->add_option("-o,--output", options->output,
                 "Output file of the index: a database of SQLite, one row per mesh. If its extension is .csv: this\n"
                 "table of the rows, and next to it the index, .db")
    ->required()
    ->type_name("FILE");
  command->add_flag("--prepare", options->prepare,
                    "Mend meshes first as the command 'prepare' does: holes, handles, components, ...");
  command->footer("Meshes without a signature have a row that says why. The same command resumes a run that was\n"
                  "stopped, and brings an index up to date: only new and edited meshes are computed, rows of other\n"
                  "meshes are removed.\n"
                  "Example: spherical-parameterization signature scans/ -o index.db\n"
                  "Exit code: 0 the index was written, 1 no index was written or it has no signature (stderr says\n"
                  "why), 2 wrong usage, 130 interrupted.");
  command->callback([options, &exit_code] {
    check(*options);
    exit_code = run(*options);
  });
}

} // namespace tool
