// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"
#include "tables/table.h"

#include "collections/compute_in_parallel.h"
#include "collections/database.h"
#include "input/files.h"
#include "mapping/mapped_mesh.h"
#include "mapping/spherical_map.h"
#include "output/atomic_file.h"
#include "output/text_writer.h"
#include "output/quantile.h"
#include "system/interruption.h"
#include "system/refusal.h"

#include <CGAL/Spherical_parameterization/distortion_summary.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/format.hpp>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <exception>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <map>
#include <optional>
#include <stdexcept>

namespace benchmark {
namespace {

namespace SP = CGAL::Spherical_parameterization;

/// Of mass_rows.csv. An outcome is OK if the map is certified, and by an independent count of the flipped faces; else
/// it says why not. The method used is what the automatic one chose. What stands between CPU s and message is known of
/// certified maps only.
const char* const header = "mesh,method,weights,outcome,method used,vertices,flipped faces,CPU s,smallest area,"
                           "smallest edge,symmetric Dirichlet,spherical symmetric Dirichlet,log area deviation,"
                           "mean angle distortion,message";
const std::vector<std::string> columns = csv_fields(header);

/// What is known of one map, by column: of a mesh file, with a method and weights.
typedef std::map<std::string, std::string> Row;

/// Unlike that of any other row.
std::string name(const Row& row) { return row.at("method") + ' ' + row.at("weights") + ' ' + row.at("mesh"); }

bool is_certified(const Row& row) { return row.at("outcome") == "OK"; }

std::string to_line(const Row& row)
{
  std::vector<std::string> fields;
  for(const std::string& column : columns)
    fields.push_back(tool::csv_quoted(row.at(column)));
  return boost::algorithm::join(fields, ",");
}

/// None if the line is not complete.
std::optional<Row> to_row(const std::string& line)
{
  const std::vector<std::string> fields = csv_fields(line);
  if(fields.size() != columns.size())
    return std::nullopt;
  Row row;
  for(std::size_t i = 0; i < columns.size(); ++i)
    row[columns[i]] = fields[i];
  return row;
}

/// Rows of which nothing but the job is known, mesh by mesh. The isometric method, which has no weights, gets one.
std::vector<Row> jobs_of(const Options& options)
{
  std::vector<Row> jobs;
  for(const std::string& mesh : tool::list_meshes(tool::named_inputs(options.meshes, options.list)))
    for(const std::string& method : options.methods)
      for(const std::string& weights : method == "isometric" ? std::vector<std::string>{"none"} : options.weights) {
        Row job = {{"mesh", mesh}, {"method", method}, {"weights", weights}, {"method used", ""}, {"message", ""}};
        for(const std::string& column : columns)
          job.emplace(column, "0");
        jobs.push_back(job);
      }
  return jobs;
}

double cpu_seconds_of_thread()
{
  timespec time = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::string digits(double number) { return (boost::format("%.6g") % number).str(); }

/// Fills the row on this thread. Throws.
void compute(const Options& options, Row& row)
{
  tool::Mapping_options mapping;
  mapping.input = row["mesh"];
  mapping.weights = row["weights"];
  mapping.method = row["method"];
  mapping.policy = "sequential"; // the other cores have meshes of their own
  if(std::isfinite(options.time_limit))
    mapping.max_time = options.time_limit;
  if(row["method"] == "balanced-3") {
    mapping.method = "balanced";
    mapping.spring_exponent = 3;
  }
  tool::Mapped_mesh map;
  tool::read_input(mapping, map);
  row["vertices"] = std::to_string(map.result.number_of_vertices);
  const double start = cpu_seconds_of_thread();
  const SP::Result result =
    tool::map_to_sphere(map.mesh(), map.sphere, mapping, map.data, [](double) { return !tool::was_interrupted(); });
  row["CPU s"] = digits(cpu_seconds_of_thread() - start);
  row["outcome"] = CGAL::Spherical_parameterization::get_error_name(result.error);
  row["method used"] = result.method;
  row["message"] = result.detail;
  row["flipped faces"] = std::to_string(result.flipped_faces);
  if(!result)
    return;
  const auto [flipped_faces, degree] = SP::certify_map(map.mesh(), tool::as_map(map.sphere));
  row["flipped faces"] = std::to_string(flipped_faces);
  if(flipped_faces > 0 || degree != 1) {
    row["outcome"] = "WRONG_CERTIFICATE";
    return;
  }
  const SP::Distortion_summary distortion = SP::distortion_summary(map.mesh(), tool::as_map(map.sphere));
  row["smallest area"] = digits(result.smallest_area);
  row["smallest edge"] = digits(result.smallest_edge);
  row["symmetric Dirichlet"] = digits(distortion.symmetric_dirichlet.mean);
  row["spherical symmetric Dirichlet"] = digits(distortion.spherical_symmetric_dirichlet.mean);
  row["log area deviation"] = digits(distortion.log_area_stretch.deviation);
  row["mean angle distortion"] = digits(distortion.angle_distortion.mean);
}

/// None if it was interrupted.
std::optional<Row> computed(Row row, const Options& options)
{
  try {
    compute(options, row);
  } catch(const tool::Refusal& refusal) {
    row["outcome"] = refusal.code();
    row["message"] = refusal.what();
  } catch(const std::exception& exception) {
    row["outcome"] = "EXCEPTION";
    row["message"] = exception.what();
  }
  std::replace_if(
    row["message"].begin(), row["message"].end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return tool::was_interrupted() ? std::nullopt : std::optional(row);
}

constexpr tool::Database::Format format = {0x4d415353, "the rows of a mass run",
                                           "CREATE TABLE row(name TEXT PRIMARY KEY, line TEXT NOT NULL)"};

/// The finished row of a job.
std::optional<Row> row_of(const Row& job, const tool::Database& done)
{
  auto row = done.query("SELECT line FROM row WHERE name = ?", name(job));
  return row.next() ? to_row(row.text(0)) : std::nullopt;
}

/// Computes what is not done, each map on one core. Throws what is wrong with the database.
void compute_missing(const std::vector<Row>& jobs, const Options& options, tool::Database& done)
{
  std::vector<Row> missing;
  std::copy_if(jobs.begin(), jobs.end(), std::back_inserter(missing),
               [&](const Row& job) { return !row_of(job, done); });
  std::size_t count = jobs.size() - missing.size();
  tool::compute_in_parallel(missing.size(), options.jobs, [&](std::size_t i) -> tool::Store {
    const std::optional<Row> row = computed(missing[i], options);
    if(!row)
      return nullptr;
    return [&done, &jobs, &count, row] {
      done.run("INSERT OR REPLACE INTO row VALUES(?, ?)", name(*row), to_line(*row));
      std::cerr << ++count << " of " << jobs.size() << ": " << name(*row) << ": " << row->at("outcome") << std::endl;
    };
  });
  if(tool::was_interrupted())
    throw std::runtime_error("interrupted with " + std::to_string(count) +
                             " rows done; the same command goes on from there");
}

void summarize(const std::vector<Row>& rows, const Options& options)
{
  Table table(
    options.output, "mass", "Mass run",
    {"every map on one core; CPU seconds of parameterize(); " +
       (std::isfinite(options.time_limit) ? "time limit of every map: " + Cell(options.time_limit).text() + " s"
                                          : "no time limit"),
     "certified: by the result and by a second count of flipped faces and degree",
     "distortion of the certified maps: area-weighted mean symmetric Dirichlet energy after scaling to equal "
     "area, 4 = isometric; spherical: with det(a, b, c) / 2 as area of a triangle; deviation: that of log "
     "area; smallest edge: in units of 2^-52",
     "every map: mass_rows.csv; every failure: mass_failures.md"},
    {"method", "weights", "maps", "certified", "CPU s: sum", "median", "largest", "distortion: median", "95 %",
     "spherical: median", "95 %", "deviation: median", "smallest edge"});
  std::map<std::pair<std::string, std::string>, std::vector<Row>> groups;
  for(const Row& row : rows)
    groups[{row.at("method"), row.at("weights")}].push_back(row);
  for(const auto& [key, group] : groups) {
    std::vector<Row> certified;
    std::copy_if(group.begin(), group.end(), std::back_inserter(certified), is_certified);
    const auto quantile = [](const std::vector<Row>& of, const std::string& column, double share) {
      std::vector<double> values;
      for(const Row& row : of)
        values.push_back(std::stod(row.at(column)));
      return tool::quantile(values, share);
    };
    double sum = 0;
    for(const Row& row : group)
      sum += std::stod(row.at("CPU s"));
    table.add_row({key.first, key.second, group.size(), certified.size(), sum, quantile(group, "CPU s", 0.5),
                   quantile(group, "CPU s", 1), quantile(certified, "symmetric Dirichlet", 0.5),
                   quantile(certified, "symmetric Dirichlet", 0.95),
                   quantile(certified, "spherical symmetric Dirichlet", 0.5),
                   quantile(certified, "spherical symmetric Dirichlet", 0.95),
                   quantile(certified, "log area deviation", 0.5), quantile(certified, "smallest edge", 0)});
  }

  Table failures(options.output, "mass_failures", "Mass run: maps that are not certified", {},
                 {"mesh", "method", "weights", "outcome", "flipped faces", "message"});
  for(const Row& row : rows)
    if(!is_certified(row))
      failures.add_row({row.at("mesh"), row.at("method"), row.at("weights"), row.at("outcome"), row.at("flipped faces"),
                        row.at("message")});
}

} // namespace

void tabulate_mass(const Options& options)
{
  tool::watch_for_interruption();
  const std::vector<Row> jobs = jobs_of(options);
  std::filesystem::create_directories(options.output);
  const std::string output = (std::filesystem::path(options.output) / "mass_rows.csv").string();
  const std::string database = output + ".db";
  {
    tool::Database done(database, format, tool::Database::Access::WRITE);
    compute_missing(jobs, options, done);
    std::vector<Row> rows;
    tool::Atomic_files file;
    std::ostream& out = file.open(output);
    out << header << '\n';
    for(const Row& job : jobs) {
      rows.push_back(row_of(job, done).value());
      out << to_line(rows.back()) << '\n';
    }
    file.commit();
    summarize(rows, options);
  }
  std::filesystem::remove(database);
}

} // namespace benchmark
