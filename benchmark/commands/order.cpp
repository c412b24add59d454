// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"
#include "measure/measure.h"
#include "measure/sweep_graph.h"
#include "tables/table.h"

#include <boost/algorithm/string/replace.hpp>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>

namespace benchmark {
namespace {

namespace fs = std::filesystem;

/// Of data, read and written, in the first-level cache and in the last one.
typedef std::array<double, 2> Cache_misses;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

bool has_valgrind() { return std::system("command -v valgrind >/dev/null 2>&1") == 0; }

/// Those of so many Jacobi sweeps on one core with the set-up before: runs this program under cachegrind, always with
/// the same caches, so that figures of different machines compare.
Cache_misses cache_misses(const Options& options, const std::string& order, const std::string& mesh, int sweeps)
{
  const fs::path report = fs::path(options.output) / "cachegrind.out";
  std::string command = "valgrind --tool=cachegrind --cache-sim=yes --I1=32768,8,64 --D1=32768,8,64 --LL=1048576,16,64";
  for(const std::string& argument :
      {"--cachegrind-out-file=" + report.string(), fs::read_symlink("/proc/self/exe").string(), std::string("sweep"),
       "--order=" + order, "--subdivide=" + std::to_string(options.subdivisions),
       "--repetitions=" + std::to_string(sweeps), mesh})
    command += " '" + boost::replace_all_copy(argument, "'", "'\\''") + "'";
  Cache_misses misses = {unknown, unknown}; // without valgrind
  if(std::system((command + " >/dev/null 2>&1").c_str()) == 0) {
    std::ifstream in(report);
    for(std::string word; in >> word;)
      if(word == "summary:") {
        std::array<double, 9> n{}; // Ir I1mr ILmr Dr D1mr DLmr Dw D1mw DLmw
        for(double& x : n)
          in >> x;
        misses = {n[4] + n[7], n[5] + n[8]};
      }
  }
  std::error_code none;
  fs::remove(report, none);
  return misses;
}

/// By one sweep. One sweep more in both runs than the difference counts: it fills the caches.
Cache_misses misses_of_sweep(const Options& options, const std::string& order, const std::string& mesh)
{
  const Cache_misses one = cache_misses(options, order, mesh, 1), three = cache_misses(options, order, mesh, 3);
  return {(three[0] - one[0]) / 2, (three[1] - one[1]) / 2};
}

struct Measured_order {
  std::string name;
  double seconds; ///< to compute it
  Sweep_graph graph;
  Cache_misses misses;
};

} // namespace

void run_sweeps(const Options& options)
{
  for_each_mesh(options.meshes, [&](const std::string&, Mesh& mesh, Sphere_map) {
    subdivide(mesh, options.subdivisions);
    const Sweep_graph graph(mesh, Weights::BARYCENTRIC);
    graph.renumbered(vertex_orders.at(options.order)(graph)).sweeps(Backend(), Sweep::JACOBI)(options.repetitions);
  });
}

void tabulate_order(const Options& options)
{
  const std::vector<Backend> devices = backends(options.backends);
  std::vector<std::string> notes = {
    "sweep: one Jacobi sweep with the vertices numbered in this order, barycentric weights; medians of 11, orders in "
    "turn; relative: to breadth-first, the order of the library",
    "misses: of a sweep on one core, simulated by cachegrind: D1 32 KiB (8 ways), LL 1 MiB (16 ways), lines of 64 "
    "bytes; half the difference of a run with three sweeps and one with one",
    "order ms: to compute the order, once the mesh has been read",
    "the paper's Figure 2 is a diagram without numbers, and is not repeated here"};
  if(!has_valgrind())
    notes.emplace_back("There is no valgrind here: no misses.");
#ifndef BENCHMARK_WITH_MESHOPTIMIZER
  notes.emplace_back("There is no order vertex-cache: this build has no meshoptimizer (Debian: libmeshoptimizer-dev).");
#endif
  Table table(options.output, "order", "Vertex orders (Figure 2 of the paper)", notes,
              {"model", "vertices", "order", "backend", "sweep ms", "relative", "D1 misses per vertex",
               "LL misses per vertex", "order ms"});
  for(const std::string& file : tool::list_meshes(options.meshes))
    with_mesh(file, [&](Mesh& mesh, Sphere_map) {
      subdivide(mesh, options.subdivisions);
      const Sweep_graph library(mesh, Weights::BARYCENTRIC);
      std::vector<Measured_order> orders;
      for(const auto& [name, compute] : vertex_orders) {
        const Stopwatch watch;
        const std::vector<int> vertices = compute(library);
        orders.push_back({name, watch.seconds(), library.renumbered(vertices), misses_of_sweep(options, name, file)});
      }
      for(const Backend& b : devices) {
        std::vector<std::function<void(int)>> sweeps;
        for(const Measured_order& order : orders)
          sweeps.push_back(order.graph.sweeps(b, Sweep::JACOBI));
        const std::vector<double> sweep = seconds_per_sweep(sweeps);
        for(std::size_t i = 0; i < orders.size(); ++i)
          table.add_row({level_name(fs::path(file).stem().string(), options.subdivisions), library.size(),
                         orders[i].name, b.label(), 1e3 * sweep[i], sweep[i] / sweep[0],
                         orders[i].misses[0] / library.size(), orders[i].misses[1] / library.size(),
                         i == 0 ? Cell() : Cell(1e3 * orders[i].seconds)});
      }
    });
}

} // namespace benchmark
