// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/cachegrind.h"
#include "commands/commands.h"
#include "commands/options.h"
#include "measure/sweep_graph.h"
#include "tables/table.h"
#include "measure/timing.h"
#include "meshes/vertex_orders.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace benchmark {
namespace {

/// What the program does under cachegrind: so many Jacobi sweeps on one core, with the vertices in an order.
struct Plain_sweeps {
  std::string order, mesh;
  int subdivisions = 0;
  int count = 0;

  std::vector<std::string> arguments() const
  {
    return {"sweep", "--order", order, "--subdivide", std::to_string(subdivisions), "--count", std::to_string(count),
            mesh};
  }

  void run() const
  {
    with_mesh(mesh, [&](Mesh& m) {
      for(int i = 0; i < subdivisions; ++i)
        subdivide(m);
      const Sweep_graph graph(m, Weights::BARYCENTRIC);
      const auto sweep =
        graph.renumbered(vertex_order(order).compute(graph)).sweeps(available_backends().front(), Sweep::JACOBI);
      for(int i = 0; i < count; ++i)
        sweep(1);
    });
  }
};

/// Per sweep. One sweep more in both runs than the difference counts: it fills the caches.
Cache_misses misses_per_sweep(Plain_sweeps sweeps)
{
  constexpr int measured = 2;
  sweeps.count = 1;
  const Cache_misses before = cache_misses(sweeps.arguments());
  sweeps.count = 1 + measured;
  const Cache_misses after = cache_misses(sweeps.arguments());
  return {(after.first_level - before.first_level) / measured, (after.last_level - before.last_level) / measured};
}

void measure_model(Table& table, const std::vector<Backend>& backends, const std::filesystem::path& file,
                   int subdivisions, Mesh& mesh)
{
  for(int i = 0; i < subdivisions; ++i)
    subdivide(mesh);
  const std::vector<Vertex_order>& orders = vertex_orders();
  const Sweep_graph library(mesh, Weights::BARYCENTRIC);
  std::vector<Sweep_graph> graphs;
  std::vector<double> seconds;
  std::vector<Cache_misses> misses(orders.size());
  for(std::size_t i = 0; i < orders.size(); ++i) {
    const Stopwatch watch;
    const std::vector<int> order = orders[i].compute(library);
    seconds.push_back(watch.seconds());
    graphs.push_back(library.renumbered(order));
    if(has_valgrind())
      misses[i] = misses_per_sweep({orders[i].name, file.string(), subdivisions});
  }
  for(const Backend& b : backends) {
    std::vector<std::function<void(int)>> sweeps;
    for(const Sweep_graph& graph : graphs)
      sweeps.push_back(graph.sweeps(b, Sweep::JACOBI));
    const std::vector<double> sweep = seconds_per_sweep(sweeps);
    for(std::size_t i = 0; i < orders.size(); ++i)
      table.add_row({model_name(file, subdivisions), library.size(), orders[i].name, b.label(), 1e3 * sweep[i],
                     sweep[i] / sweep[0], misses[i].first_level / library.size(), misses[i].last_level / library.size(),
                     i == 0 ? Cell() : Cell(1e3 * seconds[i])});
  }
}

void measure(const Options& options, int subdivisions)
{
  const std::vector<Backend> backends = options.backends();
  std::vector<std::string> notes = {
    "sweep: one Jacobi sweep with the vertices numbered in this order, barycentric weights; medians of 11, orders in "
    "turn; relative: to breadth-first, the order of the library",
    std::string("misses: of a sweep on one core, simulated by cachegrind: ") + simulated_caches +
      "; half the difference of a run with three sweeps and one with one",
    "order ms: to compute the order, once the mesh has been read",
    "the paper's Figure 2 is a diagram without numbers, and is not repeated here"};
  if(!has_valgrind())
    notes.emplace_back("There is no valgrind here: no misses.");
  if(!missing_vertex_orders().empty())
    notes.push_back(missing_vertex_orders());
  Table table(options.output, "order", "Vertex orders (Figure 2 of the paper)", notes,
              {"model", "vertices", "order", "backend", "sweep ms", "relative", "D1 misses per vertex",
               "LL misses per vertex", "order ms"});
  for(const auto& file : options.mesh_files())
    with_mesh(file, [&](Mesh& mesh) { measure_model(table, backends, file, subdivisions, mesh); });
}

} // namespace

void add_order_command(CLI::App& app)
{
  const auto options = std::make_shared<Options>();
  const auto subdivisions = std::make_shared<int>(0);
  CLI::App* command =
    app.add_subcommand("order", "Figure 2: time and cache misses of a sweep in several vertex orders");
  add_all_options(*command, *options);
  add_subdivide_option(*command, *subdivisions, "Subdivide the meshes N times before");
  command->callback([options, subdivisions] { measure(*options, *subdivisions); });

  const auto sweeps = std::make_shared<Plain_sweeps>();
  CLI::App* child = app.add_subcommand("sweep", "What order runs under cachegrind")->group(""); // hidden
  child->add_option("--order", sweeps->order)->required();
  child->add_option("--subdivide", sweeps->subdivisions);
  child->add_option("--count", sweeps->count);
  child->add_option("mesh", sweeps->mesh)->required();
  child->callback([sweeps] { sweeps->run(); });
}

} // namespace benchmark
