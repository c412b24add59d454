// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_MAPPING_OPTIONS_H
#define SPHERICAL_PARAMETERIZATION_TOOL_MAPPING_OPTIONS_H

#include "options/usage.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace tool {

/// "sequential", "tbb", "opencl": those of this build.
const std::vector<std::string>& policy_names();

/// The fastest one that every machine can run: results do not depend on it.
const std::string& default_policy_name();

/// What is done to a mesh before it is mapped.
enum class Prepare {
  NO,
  HARMLESS, ///< what does not change its shape
  ALL       ///< all that stands between it and one closed sphere
};

/// Which mesh a command works on, and how it comes by its spherical map. What is not given has no value, so that the
/// library's defaults apply.
struct Mapping_options {
  std::string input;
  bool triangulate = false;
  Prepare prepare = Prepare::NO;
  bool can_prepare_all = false; ///< with --prepare, so that refusals name it
  std::string sphere;           ///< a map computed before; then nothing below is given

  std::string weights = "conformal";
  std::optional<double> min_angle;
  std::optional<double> max_angle;

  std::string method = "automatic";
  bool falls_back = false; ///< to what "automatic" does, where the method has no answer
  std::optional<double> spring_exponent;
  std::optional<double> area_exponent;
  std::optional<double> largest_shrinkage;
  std::optional<std::string> splitting;
  std::optional<std::string> start;
  std::optional<double> relaxation;
  std::optional<std::int64_t> check_interval; // signed: CLI11 would take -3 for a huge unsigned number
  std::string fixed;
  std::optional<double> landmark_weight;
  std::string density;

  std::string policy = default_policy_name();
  std::string device;
  std::string precision;
  std::optional<double> accuracy;
  std::optional<std::int64_t> iterations;
  std::optional<double> max_time;
};

/// IN, of a command that takes one mesh. `add_collection_options()` is for those that take many.
void add_input_option(CLI::App& command, Mapping_options& options);

/// Everything that says how to map it.
void add_mapping_options(CLI::App& command, Mapping_options& options);

/// --sphere, which excludes everything that says how to map. To be called after `add_mapping_options()`.
void add_sphere_option(CLI::App& command, Mapping_options& options);

/// --prepare, which does so much. Results are then for the faces of IN if `how` is `ALL`.
void add_prepare_option(CLI::App& command, Mapping_options& options, Prepare how);

/// Throws a `CLI::ValidationError` at values and combinations that make no sense.
void check_mapping_options(const Mapping_options& options);

/// The files that are read, for `check_files()`.
std::vector<File_option> input_files(const Mapping_options& options);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_MAPPING_OPTIONS_H
