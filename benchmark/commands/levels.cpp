// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"
#include "commands/options.h"
#include "measure/published_figures.h"
#include "measure/sweep_graph.h"
#include "tables/table.h"
#include "meshes/vertex_orders.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace benchmark {
namespace {

void measure_level(Table& table, const Options& options, const std::vector<Backend>& backends, const std::string& model,
                   Mesh& mesh)
{
  const Weights weights = Weights::BARYCENTRIC;
  const Sphere_map sphere = sphere_map(mesh);
  const Sweep_graph library(mesh, weights);
  const Sweep_graph file = library.renumbered(vertex_order("file").compute(library));
  const Sweep_graph shuffled = library.renumbered(vertex_order("shuffled").compute(library));
  const published::Level_row* paper = find(published::table_2, model, weights, mesh.number_of_vertices());
  std::vector<std::function<Result()>> maps;
  for(const Backend& b : backends)
    maps.emplace_back([&] { return compute_map(b, mesh, weights, Balanced(), sphere); });
  const std::vector<Result> results = median_maps(options.repetitions, maps);
  for(std::size_t i = 0; i < backends.size(); ++i) {
    const Backend& b = backends[i];
    const std::vector<double> sweep = seconds_per_sweep(
      {library.sweeps(b, Sweep::JACOBI), file.sweeps(b, Sweep::JACOBI), shuffled.sweeps(b, Sweep::JACOBI)});
    const Result& r = results[i];
    table.add_row({model, r.number_of_vertices, r.number_of_faces, b.label(),
                   std::to_string(r.start_iterations) + " + " + std::to_string(r.iterations), r.residual,
                   r.flipped_faces, r.seconds.total, 1e3 * sweep[0], sweep[1] / sweep[0], sweep[2] / sweep[0],
                   paper ? Cell(paper->vertices) : Cell(), paper ? Cell(paper->optimized_seconds) : Cell(),
                   paper ? Cell(paper->seconds / paper->optimized_seconds) : Cell()});
  }
}

void measure(const Options& options, int subdivisions)
{
  const std::vector<Backend> backends = options.backends();
  Table table(
    options.output, "levels", "Levels of detail, barycentric weights (Table 2 of the paper)",
    {"method: Balanced, which always renumbers the vertices breadth-first; total: median of " +
       std::to_string(options.repetitions) + " runs, backends in turn",
     "sweep: one Jacobi sweep in the library's order; the two columns after it: the same sweep with the "
     "vertices as in the file, and shuffled, over it; all in turn",
     "paper: on an NVIDIA GTX 480 with its vertex locality optimization; without: its time without, over that"},
    {"model", "vertices", "faces", "backend", "iterations", "residual", "flips", "total s", "sweep ms", "file order",
     "shuffled", "paper: vertices", "paper: GTX 480 s", "paper: without"});
  for(const auto& file : options.mesh_files())
    with_mesh(file, [&](Mesh& mesh) {
      for(int level = 0; level <= subdivisions; ++level) {
        if(level > 0)
          subdivide(mesh);
        measure_level(table, options, backends, model_name(file, level), mesh);
      }
    });
}

} // namespace

void add_levels_command(CLI::App& app)
{
  const auto options = std::make_shared<Options>();
  const auto subdivisions = std::make_shared<int>(0);
  CLI::App* command = app.add_subcommand("levels", "Table 2: levels of detail, with and without reordering");
  add_all_options(*command, *options);
  add_subdivide_option(*command, *subdivisions, "Also the meshes subdivided 1 ... N times");
  command->callback([options, subdivisions] { measure(*options, *subdivisions); });
}

} // namespace benchmark
