// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"
#include "commands/options.h"
#include "tables/table.h"
#include "measure/timing.h"

#include <CLI/CLI.hpp>

#include <array>
#include <memory>

namespace benchmark {
namespace {

void measure(const Options& options, double time_limit)
{
  constexpr std::array<std::size_t, 4> intervals = {1000, 100, 10, 1};
  const std::vector<Backend> backends = options.backends();
  Table table(options.output, "checks", "Sparse tests for convergence of the published method (section 4 of the paper)",
              {"Saddle_point::check_interval: sweeps between two tests of the residual; each stopped at the first test "
               "after " +
                 Cell(time_limit).markdown() + " s; medians of " + std::to_string(options.repetitions) +
                 " runs, intervals in turn",
               "ms per sweep: solve time over sweeps; relative: to that of 1000"},
              {"model", "weights", "vertices", "backend", "check interval", "sweeps", "ms per sweep", "relative"});
  for(const auto& file : options.mesh_files())
    with_mesh(file, [&](Mesh& mesh) {
      const Sphere_map sphere = sphere_map(mesh);
      for(const Backend& b : backends) {
        std::vector<std::function<Result()>> maps;
        for(std::size_t interval : intervals)
          maps.emplace_back([&, interval] {
            Saddle_point method;
            method.check_interval = interval;
            return compute_map(b, mesh, Weights::CONFORMAL, method, sphere, time_limit);
          });
        const auto per_sweep = [](const Result& r) { return r.seconds.solve / r.sweeps; };
        const std::vector<Result> results = interleaved_medians(
          options.repetitions, maps, [&](const Result& a, const Result& c) { return per_sweep(a) < per_sweep(c); });
        for(std::size_t i = 0; i < results.size(); ++i)
          table.add_row({model_name(file), name(Weights::CONFORMAL), mesh.number_of_vertices(), b.label(), intervals[i],
                         results[i].sweeps, 1e3 * per_sweep(results[i]),
                         per_sweep(results[i]) / per_sweep(results[0])});
      }
    });
}

} // namespace

void add_checks_command(CLI::App& app)
{
  const auto options = std::make_shared<Options>();
  const auto time_limit = std::make_shared<double>(1);
  CLI::App* command = app.add_subcommand("checks", "What it costs to test the published method for convergence often");
  add_all_options(*command, *options);
  add_time_limit_option(*command, *time_limit, "Seconds for every run");
  command->callback([options, time_limit] { measure(*options, *time_limit); });
}

} // namespace benchmark
