// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"
#include "commands/options.h"
#include "measure/published_figures.h"
#include "measure/sweep_graph.h"
#include "tables/table.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace benchmark {
namespace {

/// TBB on all, on half, and on one of its threads.
std::vector<Backend> with_fewer_threads(const std::vector<Backend>& backends)
{
  std::vector<Backend> all;
  for(const Backend& backend : backends)
    if(backend.name == "tbb")
      for(int threads : {backend.threads, backend.threads / 2, 1}) {
        if(threads > 0 && (all.empty() || all.back().name != "tbb" || all.back().threads > threads)) {
          all.push_back(backend);
          all.back().threads = threads;
        }
      }
    else
      all.push_back(backend);
  return all;
}

void measure(const Options& options, double time_limit)
{
  const std::vector<Backend> backends = with_fewer_threads(options.backends());
  Table table(
    options.output, "backends", "Backends (Table 3 of the paper)",
    {"Balanced: total time, median of " + std::to_string(options.repetitions) +
       " runs, backends in turn; speed-up: over the first row of the model and weights",
     "published: Algorithm 1 with Jacobi sweeps, stopped at the first test of its residual after " +
       Cell(time_limit).markdown() + " s; one run; ms per sweep: solve time over sweeps",
     "Jacobi: one sweep by itself; copy: y = x for as many bytes; both in turn",
     "bytes of a Jacobi sweep: 4 (V + 1) offsets + (4 + 8) 2E neighbours and weights + (8 + 3 * 24) V for the "
     "inverse diagonal, v, u and w: every array once, about 156 V. GB/s: these bytes over the time",
     "paper: the published method until convergence, in seconds, on an NVIDIA GTX 480 and on 4, 2 and 1 cores of an "
     "Intel i7-870"},
    {"model", "weights", "vertices", "backend", "device", "Balanced s", "speed-up", "published: sweeps",
     "published: ms per sweep", "published: residual", "Jacobi ms", "Jacobi GB/s", "copy GB/s", "Jacobi / copy",
     "paper: vertices", "paper: GTX 480", "paper: 4 cores", "paper: 2 cores", "paper: 1 core"});
  for(const auto& file : options.mesh_files())
    with_mesh(file, [&](Mesh& mesh) {
      const Sphere_map sphere = sphere_map(mesh);
      for(Weights weights : both_weights) {
        std::vector<std::function<Result()>> maps;
        for(const Backend& b : backends)
          maps.emplace_back([&] { return compute_map(b, mesh, weights, Balanced(), sphere); });
        const std::vector<Result> balanced = median_maps(options.repetitions, maps);
        const Sweep_graph graph(mesh, weights);
        const double bytes = graph.bytes(Sweep::JACOBI);
        const published::Device_row* paper =
          find(published::table_3, model_name(file), weights, mesh.number_of_vertices());
        for(std::size_t i = 0; i < backends.size(); ++i) {
          const Backend& b = backends[i];
          const Result published = compute_map(b, mesh, weights, Saddle_point(), sphere, time_limit);
          const std::vector<double> sweep =
            seconds_per_sweep({graph.sweeps(b, Sweep::JACOBI), graph.sweeps(b, Sweep::COPY)});
          table.add_row({model_name(file), name(weights), graph.size(), b.label(), balanced[i].device,
                         balanced[i].seconds.total, balanced[0].seconds.total / balanced[i].seconds.total,
                         published.sweeps, 1e3 * published.seconds.solve / published.sweeps, published.residual,
                         1e3 * sweep[0], 1e-9 * bytes / sweep[0], 1e-9 * bytes / sweep[1], sweep[1] / sweep[0],
                         paper ? Cell(paper->vertices) : Cell(), paper ? Cell(paper->gtx_480) : Cell(),
                         paper ? Cell(paper->i7_4_cores) : Cell(), paper ? Cell(paper->i7_2_cores) : Cell(),
                         paper ? Cell(paper->i7_1_core) : Cell()});
        }
      }
    });
}

} // namespace

void add_backends_command(CLI::App& app)
{
  const auto options = std::make_shared<Options>();
  const auto time_limit = std::make_shared<double>(5);
  CLI::App* command = app.add_subcommand("backends", "Table 3: both methods on every device, and on fewer cores");
  add_all_options(*command, *options);
  add_time_limit_option(*command, *time_limit, "Seconds for every run of the published method");
  command->callback([options, time_limit] { measure(*options, *time_limit); });
}

} // namespace benchmark
