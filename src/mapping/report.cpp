// SPDX-License-Identifier: GPL-3.0-or-later

#include "mapping/report.h"

#include "options/option.h"

#include <boost/algorithm/string/replace.hpp>
#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>
#include <string>
#include <tuple>
#include <type_traits>
#include <variant>

#include <sys/resource.h>

namespace tool {
namespace {

Json to_json(const SP::Distribution& d)
{
  return {{"mean", d.mean},
          {"standard_deviation", d.deviation},
          {"min", d.min},
          {"percentile_1", d.percentile_1},
          {"percentile_5", d.percentile_5},
          {"median", d.median},
          {"percentile_95", d.percentile_95},
          {"percentile_99", d.percentile_99},
          {"max", d.max}};
}

Json to_json(const SP::Distortion_summary& d)
{
  return {{"log_area_stretch", to_json(d.log_area_stretch)},
          {"angle_distortion", to_json(d.angle_distortion)},
          {"dilatation", to_json(d.dilatation)},
          {"symmetric_dirichlet", to_json(d.symmetric_dirichlet)},
          {"spherical_symmetric_dirichlet", to_json(d.spherical_symmetric_dirichlet)},
          {"degenerate_faces", d.degenerate_faces}};
}

Json to_json(const std::optional<SP::Termination>& termination)
{
  return termination ? Json(get_termination_name(*termination)) : Json(nullptr);
}

Json given(const std::string& text) { return known(!text.empty(), text); }

/// Every method that was tried.
Json attempts_of(const SP::Result& result)
{
  Json attempts = Json::array();
  for(const SP::Result::Attempt& attempt : result.attempts)
    attempts.push_back({{"method", attempt.method},
                        {"error_code", get_error_name(attempt.error)},
                        {"detail", given(attempt.detail)},
                        {"termination", to_json(attempt.termination)},
                        {"seconds", attempt.seconds.total}});
  return attempts;
}

/// Accuracy and largest number of iterations of the method that made the map: given, or its defaults.
std::pair<double, std::size_t> effort_of(const Mapping_options& options, const SP::Result& result)
{
  using SP::Isometric;
  if(options.method != "isometric" && result.method == "isometric") // what was given is for the springs
    return {Isometric::default_accuracy, Isometric::default_number_of_iterations};
  return std::visit(
    [&options](const auto& method) {
      using Method = std::decay_t<decltype(method)>;
      return std::pair<double, std::size_t>(options.accuracy.value_or(Method::default_accuracy),
                                            options.iterations.value_or(Method::default_number_of_iterations));
    },
    method_of(options));
}

/// Every option on how to map by its name on the command line, given or default, as far as weights and method use it.
Json settings_of(Mapping_options options, const SP::Result& result)
{
  std::tie(options.accuracy, options.iterations) = effort_of(options, result);
  if(!options.area_exponent)
    options.area_exponent =
      options.density.empty() ? SP::Isometric::default_area_exponent : SP::Isometric::area_exponent_of_densities;
  Options all;
  add_mapping_options(all, options);
  Json json;
  for(const Option& option : all)
    if(const Json value = option.json(); value.is_null() || all.is_of_use(option))
      json[boost::replace_all_copy(option.name().substr(2), "-", "_")] = value;
  if(options.method == "isometric")
    json.erase("weights");
  return json;
}

} // namespace

std::size_t peak_memory_bytes()
{
  std::ifstream status("/proc/self/status"); // of Linux, where rusage has that of the caller, if it was larger
  for(std::string word; status >> word;)
    if(std::size_t kilobytes = 0; word == "VmHWM:" && status >> kilobytes)
      return 1024 * kilobytes;
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
  return static_cast<std::size_t>(usage.ru_maxrss);
#else
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
#endif
}

std::string verbose_text(const SP::Result& result)
{
  std::ostringstream text;
  text.precision(3);
  for(const SP::Result::Attempt& attempt : result.attempts) {
    const bool was_said = result.fallback_reason.find(attempt.detail) < std::string::npos; // also if there is none
    text << "tried " << attempt.method << " for " << attempt.seconds.total << " s: " << get_error_message(attempt.error)
         << (was_said ? "" : ": " + attempt.detail) << '\n';
  }
  if(result.smallest_area > 0)
    text << "smallest area " << result.smallest_area << ", smallest edge " << result.smallest_edge << " roundings; ";
  text << "peak memory " << double(peak_memory_bytes()) / 1e6 << " MB";
  return text.str();
}

Json report_json(const Mapping_options& options, const Mapped_mesh& input, const Report& report)
{
  const SP::Result& result = input.result;
  const bool has_mesh = result.number_of_vertices > 0;
  const bool is_given = !options.sphere.empty();
  const bool has_map = !is_given && (result.degree != 0 || result.residual != 0);
  const bool has_certificate = has_map || (is_given && report.distortion);
  return {{"version", SPHERICAL_PARAMETERIZATION_VERSION},
          {"input", options.input},
          {"vertices", known(has_mesh, result.number_of_vertices)},
          {"faces", known(has_mesh, result.number_of_faces)},
          {"preparation", input.prepared ? Json(sentences(input.prepared->preparation)) : Json(nullptr)},
          {"weights", known(!is_given && options.method != "isometric", options.weights)},
          {"method", known(!is_given, options.method)},
          {"method_used", known(has_map, result.method)},
          {"fallback_reason", given(result.fallback_reason)},
          {"attempts", attempts_of(result)},
          {"policy", known(!is_given, options.policy)},
          {"device", given(result.device)},
          {"settings", is_given ? Json(nullptr) : settings_of(options, result)},
          {"start_iterations", known(has_map, result.start_iterations)},
          {"iterations", known(has_map, result.iterations)},
          {"sweeps", known(has_map, result.sweeps)},
          {"termination", to_json(result.termination)},
          {"residual", known(has_map, result.residual)},
          {"energy", known(has_map, result.energy)},
          {"density_deviation", known(has_map && !options.density.empty(), result.density_deviation)},
          {"flipped_faces", known(has_certificate, result.flipped_faces)},
          {"moved_vertices", known(has_map, result.moved_vertices)},
          {"degree", known(has_certificate, result.degree)},
          {"smallest_area", known(has_map, result.smallest_area)},
          {"smallest_edge", known(has_map, result.smallest_edge)},
          {"distortion", report.distortion ? to_json(*report.distortion) : Json(nullptr)},
          {"seconds",
           {{"read", input.seconds_read},
            {"weights", result.seconds.weights},
            {"start_map", result.seconds.start_map},
            {"solve", result.seconds.solve},
            {"certify", result.seconds.certify},
            {"measure", report.seconds_measure},
            {"write", report.seconds_write},
            {"total", report.seconds_total}}},
          {"peak_memory_bytes", peak_memory_bytes()},
          {"error", report.refusal ? Json(report.refusal->what()) : Json(nullptr)},
          {"error_code", report.refusal ? report.refusal->code() : "OK"}};
}

} // namespace tool
