// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_MAP_SETTINGS_H
#define SPHERICAL_PARAMETERIZATION_TOOL_MAP_SETTINGS_H

#include "input/fixed_vertices.h"
#include "options/policies.h"

#include <CGAL/Spherical_parameterization/methods.h>

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

namespace tool {

struct Barycentric_weights {};
struct Mean_value_weights {};
struct Conformal_weights {
  double min_degrees = 5; ///< angles are clamped to this range
  double max_degrees = 85;
};

/// All that decides about the map of a given mesh.
struct Map_settings {
  std::variant<Barycentric_weights, Conformal_weights, Mean_value_weights> weights;
  std::variant<CGAL::Spherical_parameterization::Balanced, CGAL::Spherical_parameterization::Saddle_point,
               CGAL::Spherical_parameterization::Isometric, CGAL::Spherical_parameterization::Automatic>
    method;
  Policy policy;
  std::optional<double> accuracy;        ///< default: that of the method
  std::optional<std::size_t> iterations; ///< default: that of the method
  std::optional<double> max_time;        ///< seconds; default: no limit
  std::vector<Fixed_vertex> fixed_vertices;
};

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_MAP_SETTINGS_H
