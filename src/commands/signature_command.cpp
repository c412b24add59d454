// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"

#include "collections/mpi_workers.h"
#include "collections/signature_batch.h"
#include "collections/signature_pool.h"
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

/// mpirun usually starts as many processes as there are cores.
int default_jobs(bool uses_mpi)
{
  return uses_mpi ? 1 : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

/// The index must not take the place of what it is made of.
void check(const Signature_options& options)
{
  if(options.inputs.empty() && options.list.empty())
    throw CLI::RequiredError("IN or --list");
  require(!is_mesh_file(options.output), "--output",
          "'" + options.output + "' has the extension of a mesh; the index is a CSV file");
  check_files({{"--list", options.list}}, {{"--output", options.output}, {"the journal", journal_of(options.output)}});
}

int batch(const Signature_options& options, Signature_workers& workers)
{
  const std::vector<std::string> meshes = list_meshes(options.inputs, options.list);
  if(meshes.empty())
    throw Refusal(unreadable_file, options.list.empty() ? options.inputs.front() : options.list, "has no mesh file",
                  std::string("meshes are read from ") + mesh_extensions + " files");
  const Batch_summary summary = run_batch(meshes, options.output, workers);
  for(const std::string& why : summary.without_signature)
    std::cerr << "spherical-parameterization: " << why << '\n';
  const std::size_t signatures = summary.meshes - summary.without_signature.size();
  std::cout << options.output << ": " << summary.meshes << " meshes, " << signatures << " signatures";
  if(summary.resumed > 0)
    std::cout << ", " << summary.resumed << " rows from an earlier run";
  std::cout << std::endl;
  return signatures > 0 ? 0 : 1;
}

int run(const Signature_options& options)
{
  watch_for_interruption();
  const int jobs = options.jobs.value_or(default_jobs(options.uses_mpi));
  try {
    if(options.uses_mpi)
      return run_on_all_ranks(jobs, [&](Signature_workers& workers) { return batch(options, workers); });
    Signature_pool workers(jobs);
    return batch(options, workers);
  } catch(const Refusal& refusal) {
    std::cerr << "spherical-parameterization: " << refusal.what() << std::endl;
    return 1;
  }
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
  command->add_option("-o,--output", options->output, "Output file of the index: CSV, one row per mesh")
    ->required()
    ->type_name("FILE");
  command
    ->add_option("-j,--jobs", options->jobs,
                 "Number of meshes to process at the same time [all cores; with --mpi: 1 per process]")
    ->check(CLI::Range(1, 4096));
  command->add_flag("--mpi", options->uses_mpi,
                    "Share the work among the processes of mpirun: mpirun -n N spherical-parameterization ... --mpi");
  command->footer("Meshes without a signature have a row that says why. The same command resumes a run that was\n"
                  "stopped; meshes that have changed since are computed again.\n"
                  "Example: spherical-parameterization signature scans/ -o index.csv\n"
                  "Exit code: 0 the index was written, 1 no index was written or it has no signature (stderr says\n"
                  "why), 2 wrong usage, 130 interrupted.");
  command->callback([options, &exit_code] {
    check(*options);
    exit_code = run(*options);
  });
}

} // namespace tool
