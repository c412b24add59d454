// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "mapping/spherical_map.h"

#include <CGAL/Spherical_parameterization/edge_weights.h>
#include <CGAL/Spherical_parameterization/parameterize.h>

#include <limits>
#include <optional>
#include <type_traits>
#include <variant>
#include <vector>

namespace tool {
namespace {

/// Any of the weights, so that reading is compiled once per policy and method only.
using Weight_map = boost::function_property_map<std::function<double(Mesh::Edge_index)>, Mesh::Edge_index, double>;
using Weights = std::variant<SP::Conformal_weights, Weight_map>;

template <class Map>
Weights function_of(const Map& weights)
{
  return Weight_map([weights](Mesh::Edge_index e) { return get(weights, e); });
}

Weights weights_of(const Mesh&, Conformal_weights) { return SP::Conformal_weights(); }
Weights weights_of(const Mesh& mesh, Barycentric_weights) { return function_of(SP::barycentric_weights(mesh)); }
Weights weights_of(const Mesh& mesh, Clamped_weights w)
{
  return function_of(SP::clamped_weights(mesh, w.min_degrees, w.max_degrees));
}
Weights weights_of(const Mesh& mesh, Mean_value_weights) { return function_of(SP::mean_value_weights(mesh)); }

/// The density of a vertex or face. No lambda, which std::optional<function_property_map> of clang++ does not take: it
/// could not be made by default.
template <class Descriptor>
struct Density_of {
  const std::vector<double>* density;
  double operator()(Descriptor d) const { return (*density)[static_cast<std::size_t>(d.idx())]; }
};

} // namespace

SP::Result map_to_sphere(const Mesh& mesh, Sphere& sphere, const Map_settings& settings,
                         const std::function<bool(double)>& go_on)
{
  const std::size_t n = mesh.number_of_vertices();
  std::vector<bool> is_fixed(n, false);
  sphere.clear();
  if(!settings.fixed_vertices.empty())
    sphere.resize(n);
  for(const Fixed_vertex& fixed : settings.fixed_vertices) {
    is_fixed[fixed.index] = true;
    sphere[fixed.index] = fixed.position;
  }
  const auto is_fixed_map = boost::make_function_property_map<Mesh::Vertex_index>(
    [&is_fixed](Mesh::Vertex_index v) -> bool { return is_fixed[static_cast<std::size_t>(v.idx())]; });
  // Where nothing is read from it, the sphere takes its memory when the solver has given its own back.
  const auto sphere_map =
    boost::make_function_property_map<Mesh::Vertex_index>([&sphere, n](Mesh::Vertex_index v) -> Point& {
      if(sphere.empty())
        sphere.resize(n);
      return sphere[static_cast<std::size_t>(v.idx())];
    });
  const Weights weights =
    std::visit([&mesh](const auto& chosen) { return weights_of(mesh, chosen); }, settings.weights);

  const auto densities = [&settings](auto descriptor, std::size_t number) {
    using Descriptor = decltype(descriptor);
    const auto map = boost::make_function_property_map<Descriptor>(Density_of<Descriptor>{&settings.density});
    return settings.density.size() == number ? std::optional(map) : std::nullopt;
  };
  const auto of_vertices = densities(Mesh::Vertex_index(), n);
  const auto of_faces = densities(Mesh::Face_index(), of_vertices ? 0 : mesh.number_of_faces());

  return std::visit(
    [&](const auto& policy, const auto& method) {
      using Method = std::decay_t<decltype(method)>;
      const auto common = CGAL::parameters::edge_weight_map(weights)
                            .vertex_is_constrained_map(is_fixed_map)
                            .accuracy(settings.accuracy.value_or(Method::default_accuracy))
                            .number_of_iterations(settings.iterations.value_or(Method::default_number_of_iterations))
                            .maximum_running_time(settings.max_time.value_or(std::numeric_limits<double>::infinity()))
                            .callback(go_on);
      return SP::parameterize(
        policy, mesh, method, sphere_map,
        CGAL::parameters::vertex_density_map(of_vertices, CGAL::parameters::face_density_map(of_faces, common)));
    },
    settings.policy, settings.method);
}

} // namespace tool
