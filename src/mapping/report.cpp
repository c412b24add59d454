// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "mapping/report.h"

#include "output/atomic_file.h"

#include <nlohmann/json.hpp>

#include <type_traits>
#include <variant>

#include <sys/resource.h>

namespace tool {
namespace {

std::size_t peak_memory_bytes()
{
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
  return static_cast<std::size_t>(usage.ru_maxrss);
#else
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
#endif
}

using Json = nlohmann::ordered_json;

Json to_json(const CGAL::Spherical_parameterization::Distribution& d)
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

Json to_json(const CGAL::Spherical_parameterization::Distortion_summary& d)
{
  return {{"log_area_stretch", to_json(d.log_area_stretch)},
          {"angle_distortion", to_json(d.angle_distortion)},
          {"dilatation", to_json(d.dilatation)},
          {"symmetric_dirichlet", to_json(d.symmetric_dirichlet)},
          {"spherical_symmetric_dirichlet", to_json(d.spherical_symmetric_dirichlet)},
          {"degenerate_faces", d.degenerate_faces}};
}

Json to_json(Barycentric_weights) { return Json::object(); }
Json to_json(const Conformal_weights& w) { return {{"min_angle", w.min_degrees}, {"max_angle", w.max_degrees}}; }
Json to_json(Mean_value_weights) { return Json::object(); }

namespace SP = CGAL::Spherical_parameterization;

Json to_json(const SP::Balanced& m) { return {{"spring_exponent", m.spring_exponent}}; }
Json to_json(const SP::Isometric& m) { return {{"area_exponent", m.area_exponent}}; }
Json to_json(const SP::Automatic& m)
{
  return {{"spring_exponent", m.spring_exponent}, {"area_exponent", m.area_exponent}};
}
Json to_json(const SP::Saddle_point& m)
{
  return {{"splitting", m.splitting == SP::Saddle_point::Splitting::GAUSS_SEIDEL ? "gauss-seidel" : "jacobi"},
          {"relaxation", m.relaxation},
          {"check_interval", m.check_interval},
          {"start", m.start == SP::Saddle_point::Start::HARMONIC ? "harmonic" : "centroid"}};
}

/// Every option on how to map by its name on the command line, given or default, as far as weights and method use it.
Json settings_of(const Mapping_options& options)
{
  const Map_settings settings = map_settings(options);
  const auto given = [](const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); };
  Json json;
  json["triangulate"] = options.triangulate;
  json["weights"] = options.weights;
  json.update(std::visit([](const auto& weights) { return to_json(weights); }, settings.weights));
  json["method"] = options.method;
  json.update(std::visit([](const auto& method) { return to_json(method); }, settings.method));
  json["fixed"] = given(options.fixed);
  json["policy"] = options.policy;
  json["device"] = given(options.device);
  json["precision"] = given(options.precision);
  std::visit(
    [&](const auto& method) {
      using Method = std::decay_t<decltype(method)>;
      json["accuracy"] = settings.accuracy.value_or(Method::default_accuracy);
      json["iterations"] = settings.iterations.value_or(Method::default_number_of_iterations);
    },
    settings.method);
  json["max_time"] = settings.max_time ? Json(*settings.max_time) : Json(nullptr);
  return json;
}

} // namespace

void write_report(const std::string& file, const Report& report)
{
  const CGAL::Spherical_parameterization::Result& result = report.result;
  const bool has_mesh = result.number_of_vertices > 0;
  const bool has_map = result.degree != 0 || result.residual != 0;
  const auto known = [](bool is_known, auto value) { return is_known ? Json(value) : Json(nullptr); };

  Json json;
  json["version"] = SPHERICAL_PARAMETERIZATION_VERSION;
  json["input"] = report.options.input;
  json["vertices"] = known(has_mesh, result.number_of_vertices);
  json["faces"] = known(has_mesh, result.number_of_faces);
  json["weights"] = report.options.weights;
  json["method"] = report.options.method;
  json["method_used"] = known(has_map, result.method);
  json["fallback_reason"] = known(!result.fallback_reason.empty(), result.fallback_reason);
  json["policy"] = report.options.policy;
  json["device"] = known(!result.device.empty(), result.device);
  json["settings"] = settings_of(report.options);
  json["start_iterations"] = known(has_map, result.start_iterations);
  json["iterations"] = known(has_map, result.iterations);
  json["sweeps"] = known(has_map, result.sweeps);
  json["residual"] = known(has_map, result.residual);
  json["energy"] = known(has_map, result.energy);
  json["flipped_faces"] = known(has_map, result.flipped_faces);
  json["degree"] = known(has_map, result.degree);
  json["smallest_area"] = known(has_map, result.smallest_area);
  json["smallest_edge"] = known(has_map, result.smallest_edge);
  json["distortion"] = report.distortion ? to_json(*report.distortion) : Json(nullptr);
  json["seconds"] = {{"read", report.seconds_read},       {"start_map", result.seconds.start_map},
                     {"solve", result.seconds.solve},     {"certify", result.seconds.certify},
                     {"measure", report.seconds_measure}, {"write", report.seconds_write},
                     {"total", report.seconds_total}};
  json["peak_memory_bytes"] = peak_memory_bytes();
  json["error"] = report.refusal ? Json(report.refusal->what()) : Json(nullptr);
  json["error_code"] = report.refusal ? report.refusal->code() : "OK";

  Atomic_file out(file);
  // file names need not be valid UTF-8, JSON must be
  out.stream() << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
  out.commit();
}

} // namespace tool
