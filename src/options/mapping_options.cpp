// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "options/mapping_options.h"

#include "options/map_settings.h"

#include <CLI/CLI.hpp>

#include <sstream>
#include <string>
#include <vector>

namespace tool {
namespace {

/// " [balanced 2e-09, saddle-point 1e-07, isometric 0.0005]"
template <class Number>
std::string defaults(Number balanced, Number saddle_point, Number isometric)
{
  std::ostringstream text;
  text << " [balanced " << balanced << ", saddle-point " << saddle_point << ", isometric " << isometric << ']';
  return text.str();
}

void check_weights(const Mapping_options& options)
{
  const bool is_clamped = options.weights == "clamped";
  require(is_clamped || !options.min_angle, "--min-angle", "requires --weights clamped");
  require(is_clamped || !options.max_angle, "--max-angle", "requires --weights clamped");
  const double minimum = options.min_angle.value_or(Clamped_weights().min_degrees);
  const double maximum = options.max_angle.value_or(Clamped_weights().max_degrees);
  require(minimum > 0 && minimum <= maximum && maximum < 90, options.min_angle ? "--min-angle" : "--max-angle",
          "the angles must satisfy 0 < --min-angle <= --max-angle < 90");
}

void check_method(const Mapping_options& options)
{
  const bool is_saddle_point = options.method == "saddle-point";
  const bool is_automatic = options.method == "automatic";
  const std::string saddle_point_only = "requires --method saddle-point";
  require(options.method == "balanced" || is_automatic || !options.spring_exponent, "--spring-exponent",
          "requires --method balanced or automatic");
  require(options.method == "isometric" || is_automatic || !options.area_exponent, "--area-exponent",
          "requires --method isometric or automatic");
  require(is_automatic || !options.largest_shrinkage, "--largest-shrinkage", "requires --method automatic");
  require(is_saddle_point || !options.splitting, "--splitting", saddle_point_only);
  require(is_saddle_point || !options.start, "--start", saddle_point_only);
  require(is_saddle_point || !options.relaxation, "--relaxation", saddle_point_only);
  require(is_saddle_point || !options.check_interval, "--check-interval", saddle_point_only);

  const double largest_relaxation = options.splitting == "gauss-seidel" ? 2 : 1;
  require(!options.relaxation || (*options.relaxation > 0 && *options.relaxation < largest_relaxation), "--relaxation",
          "must be in (0,1) with the Jacobi splitting and in (0,2) with the Gauss-Seidel splitting");
  require(!options.spring_exponent || (*options.spring_exponent >= 2 && *options.spring_exponent < 1e3),
          "--spring-exponent", "must be in [2,1000)");
  require(!options.area_exponent || (*options.area_exponent >= 0 && *options.area_exponent < 1e3), "--area-exponent",
          "must be in [0,1000)");
  require(!options.largest_shrinkage || *options.largest_shrinkage >= 1, "--largest-shrinkage", "must be 1 or more");
  require(!options.landmark_weight || options.method == "isometric", "--landmark-weight",
          "requires --method isometric");
  require(!options.landmark_weight || !options.fixed.empty(), "--landmark-weight", "requires --fixed");
  require(!options.landmark_weight || *options.landmark_weight > 0, "--landmark-weight", "must be positive");
  require(options.density.empty() || options.method == "isometric" || is_automatic, "--density",
          "requires --method isometric or automatic");
  require(options.check_interval.value_or(1) > 0, "--check-interval", "must be positive");
}

void check_device(const Mapping_options& options)
{
  const std::string opencl_only = "requires --policy opencl";
  const bool is_opencl = options.policy == "opencl";
  require(is_opencl || options.device.empty(), "--device", opencl_only);
  require(is_opencl || options.precision.empty(), "--precision", opencl_only);
}

} // namespace

const std::vector<std::string>& policy_names()
{
  static const std::vector<std::string> names = {
    "sequential",
#ifdef CGAL_LINKED_WITH_TBB
    "tbb",
#endif
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
    "opencl",
#endif
  };
  return names;
}

const std::string& default_policy_name()
{
#ifdef CGAL_LINKED_WITH_TBB
  static const std::string name = "tbb";
#else
  static const std::string name = "sequential";
#endif
  return name;
}

void add_input_option(CLI::App& command, Mapping_options& options)
{
  command
    .add_option(
      "IN", options.input,
      "Closed triangle mesh of genus 0: OFF, OBJ, PLY, STL, GIFTI, FreeSurfer, GLB or glTF; - is the standard input")
    ->required()
    ->type_name("FILE");
}

void add_mapping_options(CLI::App& command, Mapping_options& options)
{
  command.add_flag("--triangulate", options.triangulate, "Triangulate the polygons of IN instead of refusing them");

  std::string group = "Weights"; // those in groups say how to map
  const auto add = [&](const char* name, auto& value, const std::string& description) {
    return command.add_option(name, value, description)->group(group);
  };
  add("--weights", options.weights,
      "Edge weights: conformal (preserves angles), clamped (cotangents of clamped angles, as published), barycentric "
      "(all 1), mean-value")
    ->check(CLI::IsMember({"conformal", "clamped", "barycentric", "mean-value"}))
    ->capture_default_str();
  add("--min-angle", options.min_angle, "Clamped: lower bound to which angles are clamped, in degrees [5]");
  add("--max-angle", options.max_angle, "Clamped: upper bound to which angles are clamped, in degrees [85]");

  group = "Method";
  add("--method", options.method,
      "automatic (balanced where that is of use, else isometric), balanced (harmonic, fast), isometric (low length "
      "distortion, for every mesh), saddle-point (as published)")
    ->check(CLI::IsMember({"automatic", "balanced", "isometric", "saddle-point"}))
    ->capture_default_str();
  add("--spring-exponent", options.spring_exponent,
      "Balanced, automatic: exponent of the spring energy, >= 2; larger values equalize areas [2]");
  add("--area-exponent", options.area_exponent,
      "Isometric, automatic: 0 preserves angles, 1 lengths, 30 or more areas [1; with --density 10]");
  add("--largest-shrinkage", options.largest_shrinkage,
      "Automatic: how many times lengths may shrink, against their mean; beyond, the next method is tried [10000]");
  add("--splitting", options.splitting, "Saddle-point: splitting of the Laplacian for the sweeps [jacobi]")
    ->check(CLI::IsMember({"jacobi", "gauss-seidel"}));
  add("--relaxation", options.relaxation,
      "Saddle-point: relaxation factor in (0,1), with gauss-seidel in (0,2) [0.95]");
  add("--check-interval", options.check_interval,
      "Saddle-point: number of sweeps between two convergence tests [1000]");
  add("--start", options.start, "Saddle-point: start map, a projection from the centroid or harmonic [centroid]")
    ->check(CLI::IsMember({"centroid", "harmonic"}));
  add("--fixed", options.fixed,
      "Text file of fixed vertices: three or more lines 'index x y z', indices from 0, positions on the sphere. "
      "isometric and automatic keep them anywhere, balanced and saddle-point where they fit the harmonic map")
    ->type_name("FILE");
  add(
    "--landmark-weight", options.landmark_weight,
    "Isometric: pull the fixed vertices to their places with this weight only, instead of keeping them exactly there");

  add("--density", options.density,
      "Isometric, automatic: text file of a positive number for every vertex or every face; areas on the sphere are to "
      "be proportional to these times the areas of IN")
    ->type_name("FILE");

  group = "Where to run";
  add("--policy", options.policy, "sequential (one core), tbb (all cores), opencl (a device). The map is the same")
    ->check(CLI::IsMember(policy_names()))
    ->capture_default_str();
  add("--device", options.device,
      "OpenCL: number of the device in the list of the command 'devices', or part of its name "
      "[$CGAL_SPHERICAL_PARAMETERIZATION_DEVICE, else the first GPU]")
    ->type_name("NUMBER|NAME");
  add("--precision", options.precision, "OpenCL: floating-point precision [double if the device supports it]")
    ->check(CLI::IsMember({"double", "single"}));

  group = "Effort";
  add("--accuracy", options.accuracy,
      "Residual to reach; isometric: relative energy decrease at which to stop" +
        defaults(SP::Balanced::default_accuracy, SP::Saddle_point::default_accuracy, SP::Isometric::default_accuracy));
  add("--iterations", options.iterations,
      "Maximum number of iterations" + defaults(SP::Balanced::default_number_of_iterations,
                                                SP::Saddle_point::default_number_of_iterations,
                                                SP::Isometric::default_number_of_iterations));
  add("--max-time", options.max_time, "Time limit in seconds [no limit]");
}

void add_sphere_option(CLI::App& command, Mapping_options& options)
{
  const auto how_to_map =
    command.get_options([](const CLI::Option* option) { return option->get_group() != "Options"; });
  CLI::Option* sphere = command.add_option(
    "--sphere", options.sphere,
    "Sphere of IN that 'map' has written; it is used instead of a new map, and excludes all mapping options");
  sphere->type_name("FILE");
  for(CLI::Option* option : how_to_map)
    sphere->excludes(option);
}

void add_prepare_option(CLI::App& command, Mapping_options& options, Prepare how)
{
  options.can_prepare_all = how == Prepare::ALL;
  command.add_flag_function(
    "--prepare", [&options, how](std::int64_t) { options.prepare = how; },
    how == Prepare::ALL
      ? "Mend IN first as the command 'prepare' does: holes, handles, components, ...; the result is for all faces of "
        "IN"
      : "Mend IN first where that does not change its shape: merge vertices at the same place, orient, remove what is "
        "repeated or isolated. The sphere is then that of the mended mesh ('prepare --steps merge,orient' writes it)");
}

void check_mapping_options(const Mapping_options& options)
{
  check_weights(options);
  check_method(options);
  check_device(options);
  require(!options.accuracy || (*options.accuracy > 0 && *options.accuracy < 1), "--accuracy", "must be in (0,1)");
  require(options.iterations.value_or(1) > 0, "--iterations", "must be positive");
  require(!options.max_time || *options.max_time > 0, "--max-time", "must be positive");
}

std::vector<File_option> input_files(const Mapping_options& options)
{
  return {
    {"IN", options.input}, {"--sphere", options.sphere}, {"--fixed", options.fixed}, {"--density", options.density}};
}

} // namespace tool
