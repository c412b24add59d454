// SPDX-License-Identifier: GPL-3.0-or-later

#include "helpers/solve.h"

#include "helpers/property_maps.h"

#include <CGAL/spherical_parameterization.h>

#include <optional>
#include <sstream>
#include <stdexcept>

namespace test {
namespace {

using Vertex = Mesh::Vertex_index;
using Edge = Mesh::Edge_index;
using Face = Mesh::Face_index;

/// The map on a vector, with a position for every vertex.
struct Sphere_map {
  using key_type = Vertex;
  using value_type = Point;
  using reference = Point;
  using category = boost::read_write_property_map_tag;
  Sphere* sphere;

  friend Point get(const Sphere_map& map, Vertex v) { return (*map.sphere)[v]; }
  friend void put(const Sphere_map& map, Vertex v, const Point& p) { (*map.sphere)[v] = p; }
};

/// Maybe a map: none of no numbers.
template <class Key>
std::optional<Readable_map<Key, double>> density_map(const std::vector<double>& density)
{
  if(density.empty())
    return std::nullopt;
  return Readable_map<Key, double>{[&density](Key k) { return density.at(k.idx()); }};
}

template <class Map>
std::vector<double> values(const Mesh& mesh, const Map& map)
{
  std::vector<double> result;
  for(Edge e : edges(mesh))
    result.push_back(get(map, e));
  return result;
}

std::vector<double> edge_weights(const Mesh& mesh, Weights weights)
{
  switch(weights) {
  case Weights::BARYCENTRIC: return values(mesh, SP::barycentric_weights(mesh));
  case Weights::CLAMPED: return values(mesh, SP::clamped_weights(mesh));
  case Weights::MEAN_VALUE: return values(mesh, SP::mean_value_weights(mesh));
  case Weights::CONFORMAL: break;
  }
  throw std::logic_error("these weights are not of edges");
}

} // namespace

Result solve(const Mesh& mesh, Sphere& sphere, const Settings& settings)
{
  const bool is_conformal = settings.weights == Weights::CONFORMAL;
  std::vector<double> weights = is_conformal ? std::vector<double>() : edge_weights(mesh, settings.weights);
  for(const auto& [edge, weight] : settings.weight_of_edge)
    weights.at(edge) = weight;
  sphere.resize(mesh.number_of_vertices(), Point(0, 0, 0));
  for(const auto& [vertex, position] : settings.fixed)
    sphere.at(vertex) = position;

  typedef std::variant<SP::Conformal_weights, Readable_map<Edge, double>> Either;
  const Either weight_map = is_conformal ? Either(SP::Conformal_weights())
                                         : Readable_map<Edge, double>{[&](Edge e) { return weights[e.idx()]; }};
  const Readable_map<Vertex, bool> fixed_map{[&](Vertex v) { return settings.fixed.count(v) != 0; }};
  const auto common_parameters = CGAL::parameters::edge_weight_map(weight_map)
                                   .vertex_is_constrained_map(fixed_map)
                                   .accuracy(settings.accuracy)
                                   .number_of_iterations(settings.number_of_iterations)
                                   .maximum_running_time(settings.maximum_running_time)
                                   .callback(settings.callback);
  const auto named_parameters = CGAL::parameters::vertex_density_map(
    density_map<Vertex>(settings.vertex_density),
    CGAL::parameters::face_density_map(density_map<Face>(settings.face_density), common_parameters));
  return std::visit(
    [&](const auto& policy, const auto& method) {
      return SP::parameterize(policy, mesh, method, Sphere_map{&sphere}, named_parameters);
    },
    settings.policy, settings.method);
}

Result solve(const Soup& soup, Sphere& sphere, const Settings& settings)
{
  return solve(make_mesh(soup), sphere, settings);
}

Sphere solve_or_throw(const Soup& soup, const Settings& settings)
{
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  if(!result) {
    std::ostringstream message;
    message << result;
    throw std::runtime_error(message.str());
  }
  return sphere;
}

} // namespace test
