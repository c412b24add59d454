// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"
#include "commands/options.h"
#include "tables/table.h"
#include "measure/timing.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Spherical_parameterization/locate.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

namespace benchmark {
namespace {

namespace SP = CGAL::Spherical_parameterization;
using Locator = SP::Spherical_locator<Mesh>;
using Vector_3 = CGAL::Simple_cartesian<double>::Vector_3;

std::array<Point_3, 3> corners(const Mesh& mesh, Sphere_map sphere, Mesh::Face_index f)
{
  const auto h = mesh.halfedge(f);
  return {sphere[mesh.source(h)], sphere[mesh.target(h)], sphere[mesh.target(mesh.next(h))]};
}

Point_3 normalized(const Vector_3& v) { return CGAL::ORIGIN + v / std::sqrt(v.squared_length()); }

std::vector<Point_3> random_directions(std::size_t n)
{
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<Point_3> directions;
  while(directions.size() < n) {
    const double x = normal(random), y = normal(random), z = normal(random);
    directions.push_back(normalized(Vector_3(x, y, z)));
  }
  return directions;
}

/// Distance of the weighted mean of the corners from the line along q, over the longest edge; with exact arithmetic.
double round_trip_error(const std::array<Point_3, 3>& corner, const std::array<double, 3>& weight, const Point_3& q)
{
  using FT = CGAL::Exact_rational;
  std::array<FT, 3> mean = {0, 0, 0};
  for(int i = 0; i < 3; ++i)
    for(std::size_t k = 0; k < 3; ++k)
      mean[i] += FT(weight[k]) * FT(corner[k][i]);
  double squared = 0, longest = 0;
  for(int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double x = CGAL::to_double(FT(mean[j] * FT(q[k]) - mean[k] * FT(q[j])));
    squared += x * x;
    longest = std::max(longest, CGAL::squared_distance(corner[j], corner[k]));
  }
  return std::sqrt(squared / longest);
}

struct Rate {
  double per_second;
  double largest_error; ///< of at most 20,000 of them, since exact arithmetic takes its time
};

Rate rate(const Locator& locator, const Mesh& mesh, Sphere_map sphere, const std::vector<Point_3>& directions)
{
  double sum = 0; // so that nothing is optimised away
  const Stopwatch watch;
  for(const Point_3& q : directions)
    sum += locator.locate(q).second[0];
  Rate result = {static_cast<double>(directions.size()) / watch.seconds(), sum < 0 ? 1. : 0.};
  for(std::size_t i = 0; i < directions.size(); i += directions.size() / 20000 + 1) {
    const auto [f, weights] = locator.locate(directions[i]);
    result.largest_error =
      std::max(result.largest_error, round_trip_error(corners(mesh, sphere, f), weights, directions[i]));
  }
  return result;
}

void measure(const Options& options, int subdivisions, std::size_t number_of_queries)
{
  const Backend backend = options.backends().front();
  Table table(options.output, "locate", "From the sphere back to the mesh",
              {"million queries per second on one core: random directions; all vertices; the centres of all faces",
               "error: largest one of the round trip, over the longest edge of the face, in exact arithmetic"},
              {"model", "weights", "vertices", "map", "build s", "random", "vertices M/s", "centres", "error: random",
               "error: vertices", "error: centres"});
  const std::vector<Point_3> random = random_directions(number_of_queries);
  for(const auto& file : options.mesh_files())
    with_mesh(file, [&](Mesh& mesh) {
      for(int k = 0; k < subdivisions; ++k)
        subdivide(mesh);
      const Sphere_map sphere = sphere_map(mesh);
      for(Weights weights : both_weights) {
        const Result map = compute_map(backend, mesh, weights, SP::Balanced(), sphere);
        if(!map) {
          table.add_row({model_name(file, subdivisions), name(weights), mesh.number_of_vertices(), verdict(map), "", "",
                         "", "", "", "", ""});
          continue;
        }
        const Stopwatch watch;
        const Locator locator(mesh, sphere);
        const double build = watch.seconds();
        std::vector<Point_3> vertices, centres;
        for(const Mesh::Vertex_index v : mesh.vertices())
          vertices.push_back(sphere[v]);
        for(const Mesh::Face_index f : mesh.faces()) {
          const auto c = corners(mesh, sphere, f);
          centres.push_back(normalized((c[0] - CGAL::ORIGIN) + (c[1] - CGAL::ORIGIN) + (c[2] - CGAL::ORIGIN)));
        }
        const Rate r = rate(locator, mesh, sphere, random), v = rate(locator, mesh, sphere, vertices),
                   c = rate(locator, mesh, sphere, centres);
        table.add_row({model_name(file, subdivisions), name(weights), mesh.number_of_vertices(), verdict(map), build,
                       1e-6 * r.per_second, 1e-6 * v.per_second, 1e-6 * c.per_second, r.largest_error, v.largest_error,
                       c.largest_error});
      }
    });
}

} // namespace

void add_locate_command(CLI::App& app)
{
  const auto options = std::make_shared<Options>();
  const auto subdivisions = std::make_shared<int>(0);
  const auto queries = std::make_shared<std::size_t>(1000000);
  CLI::App* command = app.add_subcommand("locate", "The inverse map: queries per second, error of the round trip");
  add_all_options(*command, *options);
  add_subdivide_option(*command, *subdivisions, "How often the meshes are subdivided");
  command->add_option("--queries", *queries, "Random directions")->check(CLI::PositiveNumber)->capture_default_str();
  command->callback([=] { measure(*options, *subdivisions, *queries); });
}

} // namespace benchmark
