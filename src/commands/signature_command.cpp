// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"

#include "collections/mpi_workers.h"
#include "collections/signature_batch.h"
#include "input/files.h"
#include "options/usage.h"
#include "system/interruption.h"
#include "system/refusal.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace tool {
namespace {

struct Signature_options {
  std::vector<std::string> inputs;
  std::string list;
  std::string output;
  bool uses_mpi = false;
  std::optional<int> jobs;
};

/// The index must not take the place of what it is made of.
void check(const Signature_options& options)
{
  if(options.inputs.empty() && options.list.empty())
    throw CLI::RequiredError("IN or --list");
  require(!is_mesh_file(options.output), "--output",
          "'" + options.output + "' has the extension of a mesh; the index is a database");
  const std::string index = index_of(options.output);
  check_files({{"--list", options.list}},
              {{"--output", options.output}, {"the index", index == options.output ? "" : index}});
}

int sign_all(const Signature_options& options, const Batch_workers& work)
{
  const std::vector<std::string> meshes = list_meshes(options.inputs, options.list);
  if(meshes.empty())
    throw Refusal(unreadable_file, options.list.empty() ? options.inputs.front() : options.list, "has no mesh file",
                  std::string("meshes are read from ") + mesh_extensions + " files");
  Signature_batch batch(meshes, options.output);
  work(batch);
  const Batch_summary summary = batch.finish();
  for(const std::string& why : summary.without_signature)
    std::cerr << "spherical-parameterization: " << why << '\n';
  const std::size_t signatures = summary.meshes - summary.without_signature.size();
  std::cout << options.output << ": " << summary.meshes << " meshes, " << signatures << " signatures";
  if(summary.resumed > 0)
    std::cout << ", " << summary.resumed << " rows from an earlier run";
  if(summary.removed > 0)
    std::cout << ", " << summary.removed << " rows of other meshes removed";
  std::cout << std::endl;
  return signatures > 0 ? 0 : 1;
}

int run(const Signature_options& options)
{
  watch_for_interruption();
  const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  const int jobs = options.jobs.value_or(options.uses_mpi ? 1 : cores); // mpirun starts a process for each
  if(options.uses_mpi)
    return run_on_all_ranks(jobs, [&](const Batch_workers& work) { return sign_all(options, work); });
  return sign_all(options, [jobs](Signature_batch& batch) { run_on_threads(jobs, [&batch] { batch.work(); }); });
}

} // namespace

void add_signature_command(CLI::App& app, int& exit_code)
{
  CLI::App* command =
    app.add_subcommand("signature", "Compute a shape descriptor of each mesh, for the command 'search'");
  const auto options = std::make_shared<Signature_options>();
  command
    ->add_option("IN", options->inputs,
                 "Closed triangle meshes of genus 0 (.off, .obj, .ply or .stl), or folders of them")
    ->type_name("FILE|FOLDER");
  command->add_option("--list", options->list, "Text file with one more IN per line")->type_name("FILE");
  command
    ->add_option("-o,--output", options->output,
                 "Output file of the index: a database of SQLite, one row per mesh. If its extension is .csv: this\n"
                 "table of the rows, and next to it the index, .db")
    ->required()
    ->type_name("FILE");
  command
    ->add_option("-j,--jobs", options->jobs,
                 "Number of meshes to process at the same time [all cores; with --mpi: 1 per process]")
    ->check(CLI::Range(1, 4096));
  command->add_flag("--mpi", options->uses_mpi,
                    "Share the work among the processes of mpirun: mpirun -n N spherical-parameterization ... --mpi");
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
