// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_MAP_SETTINGS_H
#define SPHERICAL_PARAMETERIZATION_TOOL_MAP_SETTINGS_H

#include "input/mesh_readers.h"

#include <CGAL/Spherical_parameterization/Any_policy.h>
#include <CGAL/Spherical_parameterization/values/methods.h>

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

namespace tool {

struct Mapping_options;

struct Barycentric_weights {};
struct Conformal_weights {};
struct Mean_value_weights {};
struct Clamped_weights {
  double min_degrees = 5; ///< angles are clamped to this range
  double max_degrees = 85;
};

/// All that decides about the map of a given mesh.
struct Map_settings {
  std::variant<Conformal_weights, Barycentric_weights, Clamped_weights, Mean_value_weights> weights;
  std::variant<SP::Balanced, SP::Saddle_point, SP::Isometric, SP::Automatic> method;
  SP::Any_policy policy;
  std::optional<double> accuracy;        ///< default: that of the method
  std::optional<std::size_t> iterations; ///< default: that of the method
  std::optional<double> max_time;        ///< seconds; default: no limit
  std::vector<Fixed_vertex> fixed_vertices;
  std::vector<double> density; ///< of every vertex, or of every face; empty: none
};

/// The settings for the library without fixed vertices and densities, which are read when the size of the mesh is
/// known, and without the policy.
Map_settings map_settings(const Mapping_options& options);

/// The policy. Looks for a device only if it is for the policy, since drivers take their time to start. Throws an
/// `OpenCL_error` if there is no such device. Can be called on any threads.
SP::Any_policy make_policy(const Mapping_options& options);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_MAP_SETTINGS_H
