// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "input/mesh.h"

#include <CGAL/Spherical_parameterization/edge_weights.h>

#include <functional>
#include <string>
#include <variant>

namespace tool {

/// Any of the weights of edges, so that `parameterize()` is compiled once per policy and method only.
using Weight_map = boost::function_property_map<std::function<double(Mesh::Edge_index)>, Mesh::Edge_index, double>;
using Any_weights = std::variant<SP::Conformal_weights, Weight_map>;

template <class Map>
Weight_map weight_map(const Map& weights)
{
  return Weight_map([weights](Mesh::Edge_index e) { return get(weights, e); });
}

/// By their name; the angles bound those of clamped ones.
inline Any_weights weights_of(const Mesh& mesh, const std::string& name, double min_angle, double max_angle)
{
  if(name == "barycentric")
    return weight_map(SP::barycentric_weights(mesh));
  if(name == "clamped")
    return weight_map(SP::clamped_weights(mesh, min_angle, max_angle));
  if(name == "mean-value")
    return weight_map(SP::mean_value_weights(mesh));
  return SP::Conformal_weights();
}

} // namespace tool
