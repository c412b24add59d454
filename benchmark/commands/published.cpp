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

struct Named_method {
  const char* name;
  Method method;
};

std::vector<Named_method> methods()
{
  Saddle_point gauss_seidel;
  gauss_seidel.splitting = Saddle_point::Splitting::GAUSS_SEIDEL;
  gauss_seidel.relaxation = 1.9;
  return {{"Balanced", Balanced()},
          {"published, Jacobi 0.95", Saddle_point()},
          {"published, Gauss-Seidel 1.9", gauss_seidel}};
}

void measure(const Options& options, double time_limit)
{
  const std::vector<Backend> backends = options.backends();
  Table table(options.output, "published", "The published method against the fast one (Table 4 of the paper)",
              {"all methods are stopped at the first test after " + Cell(time_limit).markdown() + " s; medians of " +
                 std::to_string(options.repetitions) + " runs, methods in turn",
               "residual: what the method drives down. residual of eq. (2): sqrt(sum_i |v_i - m_i / |m_i||^2), m_i the "
               "weighted mean of the neighbours; a balanced map has the boost forces left in it",
               "paper: its method and that of Saba et al. (2005), in seconds on an Intel Core Duo E6600"},
              {"model", "weights", "vertices", "backend", "method", "total s", "iterations", "sweeps", "residual",
               "residual of eq. (2)", "flips", "degree", "verdict", "paper: vertices", "paper: published s",
               "paper: Saba et al. s"});
  for(const auto& file : options.mesh_files())
    with_mesh(file, [&](Mesh& mesh) {
      const Sphere_map sphere = sphere_map(mesh);
      for(Weights weights : both_weights) {
        const Sweep_graph graph(mesh, weights);
        const published::Comparison_row* paper =
          find(published::table_4, model_name(file), weights, mesh.number_of_vertices());
        for(const Backend& b : backends) {
          std::vector<double> residual(methods().size());
          std::vector<std::function<Result()>> maps;
          for(std::size_t i = 0; i < methods().size(); ++i)
            maps.emplace_back([&, i] {
              Result result = compute_map(b, mesh, weights, methods()[i].method, sphere, time_limit);
              residual[i] = graph.residual(mesh, sphere);
              return result;
            });
          const std::vector<Result> results = median_maps(options.repetitions, maps);
          for(std::size_t i = 0; i < results.size(); ++i) {
            const Result& r = results[i];
            table.add_row({model_name(file), name(weights), r.number_of_vertices, b.label(), methods()[i].name,
                           r.seconds.total, std::to_string(r.start_iterations) + " + " + std::to_string(r.iterations),
                           r.sweeps, r.residual, residual[i], r.flipped_faces, r.degree, verdict(r),
                           paper ? Cell(paper->vertices) : Cell(), paper ? Cell(paper->seconds) : Cell(),
                           paper ? Cell(paper->saba_seconds) : Cell()});
          }
        }
      }
    });
}

} // namespace

void add_published_command(CLI::App& app)
{
  const auto options = std::make_shared<Options>();
  const auto time_limit = std::make_shared<double>(30);
  options->backend_names = {"sequential"}; // as the paper: on one core
  options->repetitions = 1;                // the published method takes all the time it is given
  CLI::App* command =
    app.add_subcommand("published", "Table 4: the published method against the fast one, on one core");
  add_all_options(*command, *options);
  add_time_limit_option(*command, *time_limit, "Seconds for every map");
  command->callback([options, time_limit] { measure(*options, *time_limit); });
}

} // namespace benchmark
