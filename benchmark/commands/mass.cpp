// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "output/quantile.h"
#include "commands/commands.h"
#include "measure/mass_row.h"
#include "commands/options.h"
#include "tables/table.h"

#include "output/atomic_file.h"
#include "system/interruption.h"
#include "collections/journal.h"
#include "input/files.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <atomic>
#include <exception>
#include <filesystem>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>

namespace benchmark {
namespace {

struct Mass_options {
  Options common;
  std::string list;
  std::vector<std::string> methods, weights;
  std::optional<double> time_limit;
  int jobs = static_cast<int>((std::max)(1u, std::thread::hardware_concurrency()));
};

std::optional<std::string> name_of_line(const std::string& line)
{
  const std::optional<Mass_row> row = mass_row(line);
  return row ? std::optional(row->job.name()) : std::nullopt;
}

/// Computes what the journal does not have, each job on one core. Throws what is wrong with the journal.
void compute_missing(const std::vector<Mass_job>& jobs, const Mass_options& options, tool::Journal& journal)
{
  std::vector<Mass_job> missing;
  for(const Mass_job& job : jobs)
    if(journal.lines().count(job.name()) == 0)
      missing.push_back(job);
  std::atomic<std::size_t> next{0};
  std::atomic<bool> has_failed{false};
  std::mutex mutex; // of the journal and the failure
  std::exception_ptr failure;
  const auto go_on = [&] { return !tool::was_interrupted() && !has_failed; };
  const auto work = [&] {
    for(std::size_t i; go_on() && (i = next++) < missing.size();)
      if(const std::optional<Mass_row> row = compute_mass_row(missing[i], options.time_limit, go_on)) {
        const std::lock_guard<std::mutex> lock(mutex);
        try {
          journal.add(row->job.name(), to_line(*row));
          std::cerr << journal.lines().size() << " of " << jobs.size() << ": " << row->job.name() << ": "
                    << row->outcome << std::endl;
        } catch(...) {
          failure = std::current_exception();
          has_failed = true;
        }
      }
  };
  std::vector<std::thread> threads;
  for(int i = 0; i < options.jobs; ++i)
    threads.emplace_back(work);
  for(std::thread& thread : threads)
    thread.join();
  if(failure)
    std::rethrow_exception(failure);
  if(tool::was_interrupted())
    throw std::runtime_error("interrupted with " + std::to_string(journal.lines().size()) +
                             " rows done; the same command goes on from there");
}

void summarize(const std::vector<Mass_row>& rows, const Mass_options& options)
{
  const std::string limit =
    options.time_limit ? "time limit of every map: " + Cell(*options.time_limit).markdown() + " s" : "no time limit";
  Table table(options.common.output, "mass", "Mass run",
              {"every map on one core; CPU seconds of parameterize(); " + limit,
               "certified: by the result and by a second count of flipped faces and degree",
               "distortion of the certified maps: area-weighted mean symmetric Dirichlet energy after scaling to equal "
               "area, 4 = isometric; spherical: with det(a, b, c) / 2 as area of a triangle; deviation: that of log "
               "area; smallest edge: in units of 2^-52",
               "every map: mass_rows.csv; every failure: mass_failures.md"},
              {"method", "weights", "maps", "certified", "CPU s: sum", "median", "largest", "distortion: median",
               "95 %", "spherical: median", "95 %", "deviation: median", "smallest edge"});
  typedef std::pair<std::string, std::string> Key;
  std::map<Key, std::vector<const Mass_row*>> groups;
  for(const Mass_row& row : rows)
    groups[{row.job.method, row.job.weights}].push_back(&row);
  for(const auto& [key, group] : groups) {
    std::vector<double> seconds, flat, spherical, deviation, edge;
    double sum = 0;
    for(const Mass_row* row : group) {
      seconds.push_back(row->cpu_seconds);
      sum += row->cpu_seconds;
      if(!row->is_certified())
        continue;
      flat.push_back(row->symmetric_dirichlet);
      spherical.push_back(row->spherical_symmetric_dirichlet);
      deviation.push_back(row->log_area_deviation);
      edge.push_back(row->smallest_edge);
    }
    table.add_row({key.first, key.second, group.size(), flat.size(), sum, tool::quantile(seconds, 0.5),
                   tool::quantile(seconds, 1), tool::quantile(flat, 0.5), tool::quantile(flat, 0.95),
                   tool::quantile(spherical, 0.5), tool::quantile(spherical, 0.95), tool::quantile(deviation, 0.5),
                   tool::quantile(edge, 0)});
  }

  Table failures(options.common.output, "mass_failures", "Mass run: maps that are not certified", {},
                 {"mesh", "method", "weights", "outcome", "flipped faces", "message"});
  for(const Mass_row& row : rows)
    if(!row.is_certified())
      failures.add_row({row.job.mesh, row.job.method, row.job.weights, row.outcome, row.flipped_faces, row.message});
}

void measure(const Mass_options& options)
{
  tool::watch_for_interruption();
  const std::vector<Mass_job> jobs =
    mass_jobs(tool::list_meshes(options.common.meshes, options.list), options.methods, options.weights);
  std::filesystem::create_directories(options.common.output);
  const std::string output = (std::filesystem::path(options.common.output) / "mass_rows.csv").string();
  tool::Journal journal(output + ".journal", mass_header(), name_of_line);
  compute_missing(jobs, options, journal);

  std::vector<Mass_row> rows;
  tool::Atomic_file file(output);
  file.stream() << mass_header() << '\n';
  for(const Mass_job& job : jobs) {
    rows.push_back(mass_row(journal.lines().at(job.name())).value());
    file.stream() << to_line(rows.back()) << '\n';
  }
  file.commit();
  summarize(rows, options);
  journal.remove();
}

} // namespace

void add_mass_command(CLI::App& app)
{
  const auto options = std::make_shared<Mass_options>();
  options->methods = mass_methods();
  options->weights = mass_weights();
  CLI::App* command = app.add_subcommand(
    "mass", "Maps every mesh with every method and weight, meshes in parallel; goes on where it was stopped");
  add_output_option(*command, options->common);
  command->add_option("--method", options->methods, "Which methods")
    ->delimiter(',')
    ->allow_extra_args(false)
    ->check(CLI::IsMember(mass_methods()))
    ->capture_default_str();
  command->add_option("--weights", options->weights, "Which weights")
    ->delimiter(',')
    ->allow_extra_args(false)
    ->check(CLI::IsMember(mass_weights()))
    ->capture_default_str();
  command->add_option("--time-limit", options->time_limit, "Seconds for every map [none]")->check(CLI::PositiveNumber);
  command->add_option("-j,--jobs", options->jobs, "So many maps at the same time [all cores]")
    ->check(CLI::Range(1, 4096));
  command->add_option("--list", options->list, "Text file with one more mesh or folder per line")
    ->check(CLI::ExistingFile);
  command->add_option("meshes", options->common.meshes, "Meshes, or folders whose meshes are meant, at any depth")
    ->check(CLI::ExistingPath);
  command->callback([options] { measure(*options); });
}

} // namespace benchmark
