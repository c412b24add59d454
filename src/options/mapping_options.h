// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "options/command_line.h"

#include <CGAL/Spherical_parameterization/values/methods.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tool {

/// The fastest policy that every machine can run: results do not depend on it.
#ifdef CGAL_LINKED_WITH_TBB
inline const std::string default_policy = "tbb";
#else
inline const std::string default_policy = "sequential";
#endif

/// What is done to a mesh before it is mapped.
enum class Prepare {
  NO,
  HARMLESS, ///< what does not change its shape
  ALL       ///< all that stands between it and one closed sphere
};

/// Which mesh a step works on, and how it comes by its spherical map. What has no value depends on the method.
struct Mapping_options {
  std::string input;
  std::vector<std::string> data; ///< files with values at the vertices of the input
  bool triangulate = false;
  Prepare prepare = Prepare::NO;
  bool can_prepare_all = false; ///< with --prepare, so that refusals name it
  std::string sphere;           ///< a map computed before; then nothing below is given

  std::string weights = "conformal";
  double min_angle = 5; ///< degrees
  double max_angle = 85;

  std::string method = "automatic";
  bool falls_back = false; ///< to what "automatic" does, where the method has no answer
  double spring_exponent = CGAL::Spherical_parameterization::Balanced().spring_exponent;
  std::optional<double> area_exponent;
  double largest_shrinkage = CGAL::Spherical_parameterization::Automatic().largest_shrinkage;
  std::string splitting = "jacobi";
  std::string start = "centroid";
  double relaxation = CGAL::Spherical_parameterization::Saddle_point().relaxation;
  int check_interval = int(CGAL::Spherical_parameterization::Saddle_point().check_interval);
  std::string fixed;
  std::optional<double> landmark_weight; ///< none: the fixed vertices are kept exactly
  std::string density;

  std::string policy = default_policy;
  std::string device;
  std::string precision;
  std::optional<double> accuracy;
  std::optional<std::int64_t> iterations;
  std::optional<double> max_time;
};

/// --triangulate, and in groups everything that says how to map: one mesh, or several, which have no vertices in common
/// that could be fixed.
void add_mapping_options(Options& all, Mapping_options& options, bool are_for_one = true);

/// Throws a `CLI::ValidationError` at combinations of values that make no sense.
void check_mapping_options(const Mapping_options& options);

/// The files that are read, for `check_files()`.
std::vector<File_option> input_files(const Mapping_options& options);

} // namespace tool
