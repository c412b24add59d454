// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// The tables that the paper has, too.

#include "commands/commands.h"
#include "measure/measure.h"
#include "measure/sweep_graph.h"
#include "tables/table.h"

namespace benchmark {
namespace {

double total_seconds(const Result& r) { return r.seconds.total; }
double seconds_of_sweep(const Result& r) { return r.seconds.solve / r.sweeps; }

std::string iterations(const Result& r)
{
  return std::to_string(r.start_iterations) + " + " + std::to_string(r.iterations);
}

/// Of the balanced method, the backends in turn.
std::vector<Result> median_maps(const Options& options, const std::vector<Backend>& devices, const Mesh& mesh,
                                Weights weights, Sphere_map sphere)
{
  return interleaved_medians(
    options.repetitions, devices, [&](const Backend& b) { return compute_map(b, mesh, weights, Balanced(), sphere); },
    total_seconds);
}

std::string median_of_runs(const Options& options, const std::string& in_turn)
{
  return "median of " + std::to_string(options.repetitions) + " runs, " + in_turn + " in turn";
}

/// TBB on all, on half, and on one of its threads.
std::vector<Backend> with_fewer_threads(const std::vector<Backend>& devices)
{
  std::vector<Backend> all;
  for(const Backend& device : devices) {
    all.push_back(device);
    for(int threads : {device.threads / 2, 1})
      if(device.name == "tbb" && threads > 0 && threads < all.back().threads)
        all.push_back({device.name, device.policy, threads});
  }
  return all;
}

} // namespace

void tabulate_models(const Options& options)
{
  const std::vector<Backend> devices = backends(options.backends);
  const Published_table paper(1);
  Table table(options.output, "models", "Models (Table 1 of the paper)",
              {"method: Balanced; iterations: of the start map + of the descent",
               "time: " + median_of_runs(options, "backends") + "; total: with checks, certificate and all copies",
               "paper: the published method on an NVIDIA GTX 480; iterations are saddle-point problems; its version of "
               "the model may be another one"},
              {"model", "weights", "vertices", "faces", "backend", "device", "iterations", "residual", "flips",
               "degree", "verdict", "start + solve s", "total s"},
              paper.columns());
  for_each_mesh(options.meshes, [&](const std::string& model, const Mesh& mesh, Sphere_map sphere) {
    for(Weights weights : both_weights) {
      const std::vector<Result> results = median_maps(options, devices, mesh, weights, sphere);
      for(std::size_t i = 0; i < devices.size(); ++i) {
        const Result& r = results[i];
        table.add_row({model, name(weights), r.number_of_vertices, r.number_of_faces, devices[i].label(), r.device,
                       iterations(r), r.residual, r.flipped_faces, r.degree, verdict(r),
                       r.seconds.start_map + r.seconds.solve, r.seconds.total},
                      paper.figures(model, name(weights), r.number_of_vertices));
      }
    }
  });
}

void tabulate_levels(const Options& options)
{
  const std::vector<Backend> devices = backends(options.backends);
  const Published_table paper(2);
  constexpr Weights weights = Weights::BARYCENTRIC;
  Table table(
    options.output, "levels", "Levels of detail, barycentric weights (Table 2 of the paper)",
    {"method: Balanced, which always renumbers the vertices breadth-first; total: " +
       median_of_runs(options, "backends"),
     "sweep: one Jacobi sweep in the library's order; the two columns after it: the same sweep with the vertices as in "
     "the file, and shuffled, over it; all in turn",
     "paper: on an NVIDIA GTX 480 with its vertex locality optimization; without: its time without, over that"},
    {"model", "vertices", "faces", "backend", "iterations", "residual", "flips", "total s", "sweep ms", "file order",
     "shuffled"},
    paper.columns());
  for_each_mesh(options.meshes, [&](const std::string& model, Mesh& mesh, Sphere_map sphere) {
    for(int level = 0; level <= options.subdivisions; ++level) {
      if(level > 0)
        subdivide(mesh);
      const Sweep_graph library(mesh, weights);
      const Sweep_graph file = library.renumbered(vertex_orders.at("file")(library));
      const Sweep_graph shuffled = library.renumbered(vertex_orders.at("shuffled")(library));
      const std::vector<Result> results = median_maps(options, devices, mesh, weights, sphere);
      for(std::size_t i = 0; i < devices.size(); ++i) {
        const Backend& b = devices[i];
        const std::vector<double> sweep = seconds_per_sweep(
          {library.sweeps(b, Sweep::JACOBI), file.sweeps(b, Sweep::JACOBI), shuffled.sweeps(b, Sweep::JACOBI)});
        const Result& r = results[i];
        table.add_row({level_name(model, level), r.number_of_vertices, r.number_of_faces, b.label(), iterations(r),
                       r.residual, r.flipped_faces, r.seconds.total, 1e3 * sweep[0], sweep[1] / sweep[0],
                       sweep[2] / sweep[0]},
                      paper.figures(model, name(weights), r.number_of_vertices));
      }
    }
  });
}

void tabulate_backends(const Options& options)
{
  const std::vector<Backend> devices = with_fewer_threads(backends(options.backends));
  const Published_table paper(3);
  Table table(
    options.output, "backends", "Backends (Table 3 of the paper)",
    {"Balanced: total time, " + median_of_runs(options, "backends") +
       "; speed-up: over the first row of the model and weights",
     "published: Algorithm 1 with Jacobi sweeps, stopped at the first test of its residual after " +
       Cell(options.time_limit).text() + " s; one run; ms per sweep: solve time over sweeps",
     "Jacobi: one sweep by itself; copy: y = x for as many bytes; both in turn",
     "bytes of a Jacobi sweep: 4 (V + 1) offsets + (4 + 8) 2E neighbours and weights + (8 + 3 * 24) V for the "
     "inverse diagonal, v, u and w: every array once, about 156 V. GB/s: these bytes over the time",
     "paper: the published method until convergence, in seconds, on an NVIDIA GTX 480 and on 4, 2 and 1 cores of an "
     "Intel i7-870"},
    {"model", "weights", "vertices", "backend", "device", "Balanced s", "speed-up", "published: sweeps",
     "published: ms per sweep", "published: residual", "Jacobi ms", "Jacobi GB/s", "copy GB/s", "Jacobi / copy"},
    paper.columns());
  for_each_mesh(options.meshes, [&](const std::string& model, const Mesh& mesh, Sphere_map sphere) {
    for(Weights weights : both_weights) {
      const std::vector<Result> balanced = median_maps(options, devices, mesh, weights, sphere);
      const Sweep_graph graph(mesh, weights);
      const double gigabytes = 1e-9 * graph.bytes_of_jacobi_sweep();
      for(std::size_t i = 0; i < devices.size(); ++i) {
        const Backend& b = devices[i];
        const Result published = compute_map(b, mesh, weights, Saddle_point(), sphere, options.time_limit);
        const std::vector<double> sweep =
          seconds_per_sweep({graph.sweeps(b, Sweep::JACOBI), graph.sweeps(b, Sweep::COPY)});
        table.add_row({model, name(weights), graph.size(), b.label(), balanced[i].device, balanced[i].seconds.total,
                       balanced[0].seconds.total / balanced[i].seconds.total, published.sweeps,
                       1e3 * seconds_of_sweep(published), published.residual, 1e3 * sweep[0], gigabytes / sweep[0],
                       gigabytes / sweep[1], sweep[1] / sweep[0]},
                      paper.figures(model, name(weights), mesh.number_of_vertices()));
      }
    }
  });
}

void tabulate_published(const Options& options)
{
  Saddle_point gauss_seidel;
  gauss_seidel.splitting = Saddle_point::Splitting::GAUSS_SEIDEL;
  gauss_seidel.relaxation = 1.9;
  const std::vector<std::pair<const char*, std::variant<Balanced, Saddle_point>>> methods = {
    {"Balanced", Balanced()},
    {"published, Jacobi 0.95", Saddle_point()},
    {"published, Gauss-Seidel 1.9", gauss_seidel}};
  const std::vector<Backend> devices = backends(options.backends);
  const Published_table paper(4);
  Table table(options.output, "published", "The published method against the fast one (Table 4 of the paper)",
              {"all methods are stopped at the first test after " + Cell(options.time_limit).text() + " s; " +
                 median_of_runs(options, "methods"),
               "residual: what the method drives down. residual of eq. (2): sqrt(sum_i |v_i - m_i / |m_i||^2), m_i the "
               "weighted mean of the neighbours; a balanced map has the boost forces left in it",
               "paper: its method and that of Saba et al. (2005), in seconds on an Intel Core Duo E6600"},
              {"model", "weights", "vertices", "backend", "method", "total s", "iterations", "sweeps", "residual",
               "residual of eq. (2)", "flips", "degree", "verdict"},
              paper.columns());
  for_each_mesh(options.meshes, [&](const std::string& model, const Mesh& mesh, Sphere_map sphere) {
    for(Weights weights : both_weights) {
      const Sweep_graph graph(mesh, weights);
      for(const Backend& b : devices) {
        const auto results = interleaved_medians(
          options.repetitions, methods,
          [&](const auto& method) {
            const Result r = compute_map(b, mesh, weights, method.second, sphere, options.time_limit);
            return std::pair(r, graph.residual(sphere));
          },
          [](const auto& result) { return total_seconds(result.first); });
        for(std::size_t i = 0; i < methods.size(); ++i) {
          const auto& [r, residual] = results[i];
          table.add_row({model, name(weights), r.number_of_vertices, b.label(), methods[i].first, r.seconds.total,
                         iterations(r), r.sweeps, r.residual, residual, r.flipped_faces, r.degree, verdict(r)},
                        paper.figures(model, name(weights), r.number_of_vertices));
        }
      }
    }
  });
}

void tabulate_checks(const Options& options)
{
  constexpr std::array<std::size_t, 4> intervals = {1000, 100, 10, 1};
  const std::vector<Backend> devices = backends(options.backends);
  Table table(options.output, "checks", "Sparse tests for convergence of the published method (section 4 of the paper)",
              {"Saddle_point::check_interval: sweeps between two tests of the residual; each stopped at the first test "
               "after " +
                 Cell(options.time_limit).text() + " s; " + median_of_runs(options, "intervals"),
               "ms per sweep: solve time over sweeps; relative: to that of 1000"},
              {"model", "weights", "vertices", "backend", "check interval", "sweeps", "ms per sweep", "relative"});
  for_each_mesh(options.meshes, [&](const std::string& model, const Mesh& mesh, Sphere_map sphere) {
    for(const Backend& b : devices) {
      const std::vector<Result> results = interleaved_medians(
        options.repetitions, intervals,
        [&](std::size_t interval) {
          Saddle_point method;
          method.check_interval = interval;
          return compute_map(b, mesh, Weights::CLAMPED, method, sphere, options.time_limit);
        },
        seconds_of_sweep);
      for(std::size_t i = 0; i < intervals.size(); ++i)
        table.add_row({model, name(Weights::CLAMPED), mesh.number_of_vertices(), b.label(), intervals[i],
                       results[i].sweeps, 1e3 * seconds_of_sweep(results[i]),
                       seconds_of_sweep(results[i]) / seconds_of_sweep(results[0])});
    }
  });
}

} // namespace benchmark
