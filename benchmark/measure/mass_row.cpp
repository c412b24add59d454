// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "measure/mass_row.h"

#include "input/mesh.h"
#include "mapping/spherical_map.h"
#include "options/map_settings.h"
#include "output/csv.h"
#include "system/error_code_names.h"
#include "system/refusal.h"

#include <CGAL/Spherical_parameterization/distortion_summary.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <ctime>
#include <exception>
#include <iterator>

namespace benchmark {
namespace {

namespace SP = CGAL::Spherical_parameterization;

double cpu_seconds_of_thread()
{
  timespec time = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

tool::Map_settings settings_of(const Mass_job& job)
{
  tool::Map_settings settings;
  settings.policy = CGAL::Sequential_tag(); // the other cores have meshes of their own
  if(job.method == "balanced-3")
    settings.method = SP::Balanced{3};
  else if(job.method == "saddle-point")
    settings.method = SP::Saddle_point();
  else if(job.method == "isometric")
    settings.method = SP::Isometric();
  else if(job.method == "automatic")
    settings.method = SP::Automatic();
  if(job.weights == "conformal")
    settings.weights = tool::Conformal_weights();
  else if(job.weights == "mean-value")
    settings.weights = tool::Mean_value_weights();
  return settings;
}

/// Fills the row but for its job. Throws.
void compute(std::optional<double> time_limit, const std::function<bool()>& go_on, Mass_row& row)
{
  const tool::Mesh mesh = tool::read_mesh(row.job.mesh).mesh;
  row.vertices = mesh.number_of_vertices();
  tool::Sphere positions;
  tool::Map_settings settings = settings_of(row.job);
  settings.max_time = time_limit;
  const double start = cpu_seconds_of_thread();
  const SP::Result result = tool::map_to_sphere(mesh, positions, settings, [&](double) { return go_on(); });
  row.cpu_seconds = cpu_seconds_of_thread() - start;
  row.outcome = tool::name(result.error);
  row.method_used = result.method;
  row.message = result.detail;
  row.flipped_faces = result.flipped_faces;
  if(!result)
    return;
  const auto sphere = tool::as_map(positions);
  row.flipped_faces = SP::number_of_flipped_faces(mesh, sphere);
  if(row.flipped_faces > 0 || SP::degree_of_map(mesh, sphere) != 1) {
    row.outcome = "WRONG_CERTIFICATE";
    return;
  }
  row.smallest_area = result.smallest_area;
  row.smallest_edge = result.smallest_edge;
  const SP::Distortion_summary distortion = SP::distortion_summary(mesh, sphere);
  row.symmetric_dirichlet = distortion.symmetric_dirichlet.mean;
  row.spherical_symmetric_dirichlet = distortion.spherical_symmetric_dirichlet.mean;
  row.log_area_deviation = distortion.log_area_stretch.deviation;
  row.mean_angle_distortion = distortion.angle_distortion.mean;
}

constexpr double Mass_row::*numbers[] = {&Mass_row::cpu_seconds,
                                         &Mass_row::smallest_area,
                                         &Mass_row::smallest_edge,
                                         &Mass_row::symmetric_dirichlet,
                                         &Mass_row::spherical_symmetric_dirichlet,
                                         &Mass_row::log_area_deviation,
                                         &Mass_row::mean_angle_distortion};
constexpr std::size_t number_of_numbers = std::size(numbers);

template <class Number>
bool read_number(const std::string& text, Number& number)
{
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

} // namespace

const std::vector<std::string>& mass_methods()
{
  static const std::vector<std::string> methods = {"balanced", "balanced-3", "isometric", "automatic", "saddle-point"};
  return methods;
}

const std::vector<std::string>& mass_weights()
{
  static const std::vector<std::string> weights = {"conformal", "barycentric", "mean-value"};
  return weights;
}

std::vector<Mass_job> mass_jobs(const std::vector<std::string>& meshes, const std::vector<std::string>& methods,
                                const std::vector<std::string>& weights)
{
  std::vector<Mass_job> jobs;
  for(const std::string& mesh : meshes)
    for(const std::string& method : methods)
      for(const std::string& weight : method == "isometric" ? std::vector<std::string>{"none"} : weights)
        jobs.push_back({mesh, method, weight});
  return jobs;
}

std::optional<Mass_row> compute_mass_row(const Mass_job& job, std::optional<double> time_limit,
                                         const std::function<bool()>& go_on)
{
  Mass_row row;
  row.job = job;
  try {
    compute(time_limit, go_on, row);
  } catch(const tool::Refusal& refusal) {
    row.outcome = refusal.code();
    row.message = refusal.what();
  } catch(const std::exception& exception) {
    row.outcome = "EXCEPTION";
    row.message = exception.what();
  }
  if(!go_on())
    return std::nullopt;
  std::replace_if(
    row.message.begin(), row.message.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return row;
}

std::string mass_header()
{
  return "mesh,method,weights,outcome,method used,vertices,flipped faces,CPU s,smallest area,smallest edge,"
         "symmetric Dirichlet,spherical symmetric Dirichlet,log area deviation,mean angle distortion,message";
}

std::string to_line(const Mass_row& row)
{
  std::string line = tool::csv_quoted(row.job.mesh) + ',' + row.job.method + ',' + row.job.weights + ',' + row.outcome +
                     ',' + row.method_used + ',' + std::to_string(row.vertices) + ',' +
                     std::to_string(row.flipped_faces);
  for(double Mass_row::*number : numbers) {
    char text[32];
    std::snprintf(text, sizeof text, ",%.6g", row.*number);
    line += text;
  }
  return line + ',' + tool::csv_quoted(row.message);
}

std::optional<Mass_row> mass_row(const std::string& line)
{
  const std::vector<std::string> fields = tool::csv_fields(line);
  if(fields.size() != 8 + number_of_numbers)
    return std::nullopt;
  Mass_row row;
  row.job = {fields[0], fields[1], fields[2]};
  row.outcome = fields[3];
  row.method_used = fields[4];
  if(!read_number(fields[5], row.vertices) || !read_number(fields[6], row.flipped_faces))
    return std::nullopt;
  for(std::size_t i = 0; i < number_of_numbers; ++i)
    if(!read_number(fields[7 + i], row.*numbers[i]))
      return std::nullopt;
  row.message = fields.back();
  return row;
}

} // namespace benchmark
