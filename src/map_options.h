// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_MAP_OPTIONS_H
#define SPHERICAL_PARAMETERIZATION_TOOL_MAP_OPTIONS_H

#include "map_settings.h"

#include <cstdint>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace tool {

/// The command line of `map`. What is not given has no value, so that the library's defaults apply.
struct Map_options {
  std::string input;
  std::string sphere;
  std::string report;
  std::string stretch_ply;
  std::string fixed;
  bool triangulate = false;

  std::string weights = "conformal";
  std::optional<double> min_angle;
  std::optional<double> max_angle;

  std::string method = "balanced";
  std::optional<double> spring_exponent;
  std::optional<double> area_exponent;
  std::optional<std::string> splitting;
  std::optional<std::string> start;
  std::optional<double> relaxation;
  std::optional<std::int64_t> check_interval;  // signed: CLI11 would take -3 for a huge unsigned number

  std::string policy = default_policy_name();
  std::string device;
  std::string precision;
  std::optional<double> accuracy;
  std::optional<std::int64_t> iterations;
  std::optional<double> max_time;
};

void add_map_options(CLI::App& command, Map_options& options);

/// Throws a `CLI::ValidationError` at values and combinations that make no sense.
void check_map_options(const Map_options& options);

/// The settings for the library, but for the fixed vertices, which only a mesh gives a meaning.
/// Throws what `make_policy()` throws.
Map_settings map_settings(const Map_options& options);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_MAP_OPTIONS_H
