// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"
#include "measure/backend.h"
#include "measure/measure.h"
#include "tables/table.h"

#include <CGAL/Cartesian_converter.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Spherical_parameterization/locate.h>
#include <CGAL/point_generators_3.h>

#include <algorithm>
#include <iterator>

namespace benchmark {
namespace {

using Locator = CGAL::Spherical_parameterization::Spherical_locator<Mesh>;

/// Distance of the weighted mean of the corners from the line along q, over the longest edge; with exact arithmetic.
double round_trip_error(const std::array<Point_3, 3>& corner, const std::array<double, 3>& weight, const Point_3& q)
{
  using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  const CGAL::Cartesian_converter<CGAL::Simple_cartesian<double>, Exact> exact;
  Exact::Vector_3 mean = CGAL::NULL_VECTOR;
  double longest = 0;
  for(std::size_t k = 0; k < 3; ++k) {
    mean = mean + exact(weight[k]) * (exact(corner[k]) - CGAL::ORIGIN);
    longest = std::max(longest, CGAL::squared_distance(corner[k], corner[(k + 1) % 3]));
  }
  const Exact::Vector_3 offset = CGAL::cross_product(mean, exact(q) - CGAL::ORIGIN);
  return std::sqrt(CGAL::to_double(offset.squared_length()) / longest);
}

struct Rate {
  double millions_per_second;
  double largest_error; ///< of at most 20,000 of them, since exact arithmetic takes its time
};

Rate rate(const Locator& locator, const Mesh& mesh, Sphere_map sphere, const std::vector<Point_3>& directions)
{
  double sum = 0; // so that nothing is optimised away
  const Stopwatch watch;
  for(const Point_3& q : directions)
    sum += locator.locate(q).second[0];
  Rate result = {1e-6 * static_cast<double>(directions.size()) / watch.seconds(), sum < 0 ? 1. : 0.};
  for(std::size_t i = 0; i < directions.size(); i += directions.size() / 20000 + 1) {
    const auto [f, weights] = locator.locate(directions[i]);
    result.largest_error =
      std::max(result.largest_error, round_trip_error(corners(mesh, sphere, f), weights, directions[i]));
  }
  return result;
}

} // namespace

void tabulate_locate(const Options& options)
{
  const Backend backend = backends(options.backends).front();
  Table table(options.output, "locate", "From the sphere back to the mesh",
              {"million queries per second on one core: random directions; all vertices; the centres of all faces",
               "error: largest one of the round trip, over the longest edge of the face, in exact arithmetic"},
              {"model", "weights", "vertices", "map", "build s", "random", "vertices M/s", "centres", "error: random",
               "error: vertices", "error: centres"});
  CGAL::Random seeded(1);
  std::vector<Point_3> random;
  std::copy_n(CGAL::Random_points_on_sphere_3<Point_3>(1, seeded), options.queries, std::back_inserter(random));
  for_each_mesh(options.meshes, [&](const std::string& model, Mesh& mesh, Sphere_map sphere) {
    subdivide(mesh, options.subdivisions);
    for(Weights weights : both_weights) {
      const Result map = compute_map(backend, mesh, weights, Balanced(), sphere);
      std::vector<Cell> row = {level_name(model, options.subdivisions), name(weights), mesh.number_of_vertices(),
                               verdict(map)};
      if(map) {
        const Stopwatch watch;
        const Locator locator(mesh, sphere);
        row.emplace_back(watch.seconds());
        std::vector<Point_3> vertices, centres;
        for(const Mesh::Vertex_index v : mesh.vertices())
          vertices.push_back(sphere[v]);
        for(const Mesh::Face_index f : mesh.faces()) {
          const auto [a, b, c] = corners(mesh, sphere, f);
          centres.push_back(normalized((a - CGAL::ORIGIN) + (b - CGAL::ORIGIN) + (c - CGAL::ORIGIN)));
        }
        const std::array<Rate, 3> rates = {rate(locator, mesh, sphere, random), rate(locator, mesh, sphere, vertices),
                                           rate(locator, mesh, sphere, centres)};
        for(const Rate& r : rates)
          row.emplace_back(r.millions_per_second);
        for(const Rate& r : rates)
          row.emplace_back(r.largest_error);
      }
      table.add_row(row);
    }
  });
}

} // namespace benchmark
