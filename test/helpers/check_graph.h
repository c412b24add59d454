// SPDX-License-Identifier: GPL-3.0-or-later
// The same map whatever type the mesh has.

#ifndef TEST_HELPERS_CHECK_GRAPH_H
#define TEST_HELPERS_CHECK_GRAPH_H

#include "helpers/certificate.h"
#include "helpers/property_maps.h"
#include "helpers/solve.h"

#include <CGAL/Kernel_traits.h>
#include <CGAL/spherical_parameterization.h>

#include <catch2/catch.hpp>

#include <array>
#include <map>

namespace test {

/// Maps `graph` and compares with the map of `soup`, which has the same points and faces in any order.
template <class Graph>
void check_same_map(const Graph& graph, const Soup& soup, double tolerance = 1e-9)
{
  using vertex_descriptor = typename boost::graph_traits<Graph>::vertex_descriptor;
  using edge_descriptor = typename boost::graph_traits<Graph>::edge_descriptor;
  using Graph_point =
    typename boost::property_traits<typename boost::property_map<Graph, CGAL::vertex_point_t>::const_type>::value_type;
  using Graph_kernel = typename CGAL::Kernel_traits<Graph_point>::type;

  // points are the same in all types, numbers are not
  std::map<std::array<double, 3>, std::size_t> number;
  for(std::size_t i = 0; i < soup.points.size(); ++i)
    number[{soup.points[i].x(), soup.points[i].y(), soup.points[i].z()}] = i;
  REQUIRE(number.size() == soup.points.size());
  auto points = get(CGAL::vertex_point, graph);

  auto compare = [&](const Sphere& expected, const Result& result, const auto& images) {
    CAPTURE(result);
    CHECK(result);
    REQUIRE(images.size() == soup.points.size());
    Sphere sphere(soup.points.size(), Point(0, 0, 0));
    for(vertex_descriptor v : vertices(graph)) {
      const auto& p = get(points, v);
      const auto& q = images.at(v);
      sphere[number.at({CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])})] =
        Point(CGAL::to_double(q[0]), CGAL::to_double(q[1]), CGAL::to_double(q[2]));
    }
    CHECK(count_flipped_faces(soup, sphere) == 0);
    CHECK(distance_up_to_rotation(expected, sphere) < tolerance);
  };

  Settings settings;
  settings.accuracy = 1e-11;

  // conformal weights are the default
  settings.weights = Weights::CONFORMAL;
  std::map<vertex_descriptor, typename Graph_kernel::Point_3> images;
  const Writable_map<vertex_descriptor, typename Graph_kernel::Point_3> sphere_map{&images};
  Result result = SP::parameterize(graph, sphere_map, CGAL::parameters::accuracy(settings.accuracy));
  compare(solve_or_throw(soup, settings), result, images);

  // barycentric weights, as a map of the user's
  images.clear();
  settings.weights = Weights::BARYCENTRIC;
  const Readable_map<edge_descriptor, double> ones{[](const edge_descriptor&) { return 1.; }};
  result = SP::parameterize(CGAL::Sequential_tag(), graph, SP::Balanced(), sphere_map,
                            CGAL::parameters::edge_weight_map(ones).accuracy(settings.accuracy));
  compare(solve_or_throw(soup, settings), result, images);

  // what is measured on the graph agrees
  const Read_write_map<vertex_descriptor, typename Graph_kernel::Point_3> readable_map{&images};
  CHECK(SP::number_of_flipped_faces(graph, readable_map) == 0);
  CHECK(SP::degree_of_map(graph, readable_map) == 1);
}

} // namespace test

#endif // TEST_HELPERS_CHECK_GRAPH_H
