// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "measure/Counting_policy.h"
#include "commands/commands.h"
#include "commands/options.h"
#include "measure/peak_memory.h"
#include "measure/sweep_graph.h"
#include "tables/table.h"
#include "measure/timing.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace benchmark {
namespace {

struct Run {
  Result result;
  double sweep;  ///< seconds for one application of the Laplacian, measured right before and right after
  double memory; ///< bytes
};

Run run(const Backend& backend, const Mesh& mesh, Weights weights, Sphere_map sphere,
        const std::function<void(int)>& sweeps)
{
  Run r;
  const double sweep_before = seconds_per_sweep({sweeps})[0];
  const Peak_memory memory;
  r.result = compute_map(backend, mesh, weights, Balanced(), sphere);
  r.memory = memory.growth();
  r.sweep = (sweep_before + seconds_per_sweep({sweeps})[0]) / 2;
  return r;
}

/// The work of the solvers in entries of sparse matrices, over those of the Laplacian.
double counted_sweeps(const Mesh& mesh, Weights weights, Sphere_map sphere)
{
  std::size_t entries = 0;
  visit_weights(weights, mesh, [&](auto map) {
    return parameterize(Counting_policy{&entries}, mesh, Balanced(), sphere, CGAL::parameters::edge_weight_map(map));
  });
  return static_cast<double>(entries) / mesh.number_of_halfedges();
}

double cost(const Run& r) { return (r.result.seconds.start_map + r.result.seconds.solve) / r.sweep; }

void measure_level(Table& table, const Options& options, const std::vector<Backend>& backends, const std::string& model,
                   Mesh& mesh)
{
  const Sphere_map sphere = sphere_map(mesh);
  for(Weights weights : both_weights) {
    const Sweep_graph graph(mesh, weights);
    const double counted = counted_sweeps(mesh, weights, sphere);
    std::vector<std::function<Run()>> measurements;
    for(const Backend& b : backends)
      measurements.emplace_back(
        [&, weights, sweeps = graph.sweeps(b, Sweep::LAPLACIAN)] { return run(b, mesh, weights, sphere, sweeps); });
    const std::vector<Run> runs = interleaved_medians(options.repetitions, measurements,
                                                      [](const Run& a, const Run& b) { return cost(a) < cost(b); });
    for(std::size_t i = 0; i < runs.size(); ++i) {
      const Result& r = runs[i].result;
      table.add_row({model, r.number_of_vertices, name(weights), backends[i].name, r.start_iterations, r.iterations,
                     r.seconds.start_map, r.seconds.solve, r.seconds.total, 1e3 * runs[i].sweep, counted, cost(runs[i]),
                     runs[i].memory / r.number_of_vertices, r.residual, r.flipped_faces, r.degree, verdict(r),
                     r.device});
    }
  }
}

void measure(const Options& options, std::size_t maximum_vertices)
{
  const std::vector<Backend> backends = options.backends();
  Table table(options.output, "scaling", "Scaling with the number of vertices",
              {"models: subdivided, every triangle into four; method: Balanced; the run of median cost out of " +
                 std::to_string(options.repetitions) + ", backends in turn",
               "sweep: one application of the Laplacian to three vectors of doubles, on the same graph and backend, "
               "mean of right before and right after the map; cost in sweeps: (start map + solve) / sweep",
               "counted sweeps: the entries of all sparse matrices that start map and solve apply, on all levels, over "
               "those of the Laplacian; without the vector operations and the set-up of the hierarchy",
               "bytes per vertex: by how much the peak of the resident memory rises during the map, beyond mesh and "
               "sphere map, over the number of vertices; memory of a GPU is not in it"},
              {"model", "vertices", "weights", "backend", "start iterations", "iterations", "start map s", "solve s",
               "total s", "sweep ms", "counted sweeps", "cost in sweeps", "bytes per vertex", "residual", "flips",
               "degree", "verdict", "device"});
  for(const auto& file : options.mesh_files())
    with_mesh(file, [&](Mesh& mesh) {
      for(int level = 0;; ++level) {
        measure_level(table, options, backends, model_name(file, level), mesh);
        if(4 * mesh.number_of_vertices() > maximum_vertices) // a subdivided mesh has 4 V - 6 vertices
          break;
        subdivide(mesh);
      }
    });
}

} // namespace

void add_scaling_command(CLI::App& app)
{
  const auto options = std::make_shared<Options>();
  const auto maximum_vertices = std::make_shared<std::size_t>(500000);
  CLI::App* command = app.add_subcommand("scaling", "Cost in sweeps, time and memory of ever larger meshes");
  add_all_options(*command, *options);
  command->add_option("--maximum-vertices", *maximum_vertices, "Subdivide as long as there are no more")
    ->check(CLI::PositiveNumber)
    ->capture_default_str();
  command->callback([options, maximum_vertices] { measure(*options, *maximum_vertices); });
}

} // namespace benchmark
