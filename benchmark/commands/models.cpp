// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"
#include "commands/options.h"
#include "measure/published_figures.h"
#include "tables/table.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace benchmark {
namespace {

void measure(const Options& options)
{
  const std::vector<Backend> backends = options.backends();
  Table table(options.output, "models", "Models (Table 1 of the paper)",
              {"method: Balanced; iterations: of the start map + of the descent",
               "time: medians of " + std::to_string(options.repetitions) +
                 " runs, backends in turn; total: with checks, certificate and all copies",
               "paper: the published method on an NVIDIA GTX 480; iterations are saddle-point problems; its version of "
               "the model may be another one"},
              {"model", "weights", "vertices", "faces", "backend", "device", "iterations", "residual", "flips",
               "degree", "verdict", "start + solve s", "total s", "paper: vertices", "paper: iterations",
               "paper: residual", "paper: GTX 480 s"});
  for(const auto& file : options.mesh_files())
    with_mesh(file, [&](Mesh& mesh) {
      const Sphere_map sphere = sphere_map(mesh);
      for(Weights weights : both_weights) {
        std::vector<std::function<Result()>> maps;
        for(const Backend& b : backends)
          maps.emplace_back([&] { return compute_map(b, mesh, weights, Balanced(), sphere); });
        const std::vector<Result> results = median_maps(options.repetitions, maps);
        const published::Map_row* paper =
          find(published::table_1, model_name(file), weights, mesh.number_of_vertices());
        for(std::size_t i = 0; i < backends.size(); ++i) {
          const Result& r = results[i];
          table.add_row({model_name(file), name(weights), r.number_of_vertices, r.number_of_faces, backends[i].label(),
                         r.device, std::to_string(r.start_iterations) + " + " + std::to_string(r.iterations),
                         r.residual, r.flipped_faces, r.degree, verdict(r), r.seconds.start_map + r.seconds.solve,
                         r.seconds.total, paper ? Cell(paper->vertices) : Cell(),
                         paper ? Cell(paper->iterations) : Cell(), paper ? Cell(1e-8 * paper->residual_1e8) : Cell(),
                         paper ? Cell(paper->seconds) : Cell()});
        }
      }
    });
}

} // namespace

void add_models_command(CLI::App& app)
{
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("models", "Table 1: every model, both weights, every backend");
  add_all_options(*command, *options);
  command->callback([options] { measure(*options); });
}

} // namespace benchmark
