// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"
#include "measure/Counting_policy.h"
#include "measure/measure.h"
#include "measure/sweep_graph.h"
#include "tables/table.h"

namespace benchmark {
namespace {

struct Run {
  Result result;
  double sweep;  ///< seconds for one application of the Laplacian, measured right before and right after
  double memory; ///< bytes

  double cost() const { return (result.seconds.start_map + result.seconds.solve) / sweep; }
};

Run run(const Backend& backend, const Mesh& mesh, Weights weights, Sphere_map sphere, const Sweep_graph& graph)
{
  const std::vector<std::function<void(int)>> sweeps = {graph.sweeps(backend, Sweep::LAPLACIAN)};
  Run r;
  const double sweep_before = seconds_per_sweep(sweeps)[0];
  const Peak_memory memory;
  r.result = compute_map(backend, mesh, weights, Balanced(), sphere);
  r.memory = memory.growth();
  r.sweep = (sweep_before + seconds_per_sweep(sweeps)[0]) / 2;
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

} // namespace

void tabulate_scaling(const Options& options)
{
  const std::vector<Backend> devices = backends(options.backends);
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
  for_each_mesh(options.meshes, [&](const std::string& model, Mesh& mesh, Sphere_map sphere) {
    for(int level = 0; level == 0 || 4 * mesh.number_of_vertices() - 6 <= options.maximum_vertices; ++level) {
      if(level > 0)
        subdivide(mesh);
      for(Weights weights : both_weights) {
        const Sweep_graph graph(mesh, weights);
        const double counted = counted_sweeps(mesh, weights, sphere);
        const std::vector<Run> runs = interleaved_medians(
          options.repetitions, devices, [&](const Backend& b) { return run(b, mesh, weights, sphere, graph); },
          [](const Run& r) { return r.cost(); });
        for(std::size_t i = 0; i < runs.size(); ++i) {
          const Result& r = runs[i].result;
          table.add_row({level_name(model, level), r.number_of_vertices, name(weights), devices[i].name,
                         r.start_iterations, r.iterations, r.seconds.start_map, r.seconds.solve, r.seconds.total,
                         1e3 * runs[i].sweep, counted, runs[i].cost(), runs[i].memory / r.number_of_vertices,
                         r.residual, r.flipped_faces, r.degree, verdict(r), r.device});
        }
      }
    }
  });
}

} // namespace benchmark
