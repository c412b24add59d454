// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "collections/atlas.h"

#include "output/text_writer.h"
#include "output/write_json.h"
#include "output/write_mesh.h"
#include "system/interruption.h"

#include <CGAL/Spherical_parameterization/Any_policy.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <system_error>
#include <utility>

namespace tool {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Shapes = std::vector<std::vector<Point>>;

#ifdef CGAL_LINKED_WITH_TBB
const CGAL::Parallel_tag policy;
#else
const CGAL::Sequential_tag policy;
#endif

/// Shapes are left out one by one as long as that takes no time: n groups cost n^4.
constexpr std::size_t most_left_out_alone = 100;
constexpr int groups_beyond = 20;

/// From which specificity is taken.
constexpr int random_shapes = 1000;

/// Meshes of modes show so many standard deviations.
constexpr double deviations_shown = 2;

void write_scores(std::ostream& out, const std::vector<Atlas_shape>& shapes,
                  const SP::Shape_statistics<std::vector<Point>>& statistics)
{
  Text_writer write(out);
  write("name");
  for(std::size_t k = 1; k <= statistics.modes.size(); ++k)
    write(",score_", k);
  write('\n');
  for(std::size_t i = 0; i < shapes.size(); ++i) {
    write(csv_quoted(shapes[i].name));
    for(const double score : statistics.scores[i])
      write(',', score);
    write('\n');
  }
}

/// A line for every number of modes; generalization ends where the shapes that are not left out have no more.
void write_quality(std::ostream& out, const SP::Model_quality& quality)
{
  Text_writer write(out);
  write("modes,compactness,generalization,specificity,specificity_error\n");
  for(std::size_t k = 0; k < quality.compactness.size(); ++k) {
    write(k, ',', quality.compactness[k], ',');
    if(k < quality.generalization.size())
      write(quality.generalization[k]);
    write(',', quality.specificity[k], ',', quality.specificity_error[k], '\n');
  }
}

} // namespace

void remove_other_modes(const std::string& folder, std::size_t modes)
{
  std::error_code none;
  for(std::size_t k = modes + 1;; ++k) {
    const fs::path name = fs::path(folder) / ("mode_" + std::to_string(k));
    const bool plus = fs::remove(name.string() + "_plus.ply", none),
               minus = fs::remove(name.string() + "_minus.ply", none);
    if(!plus && !minus)
      return;
  }
}

Written_atlas write_atlas(const std::function<std::ostream&(const std::string&)>& open, const Atlas_mesh& mesh,
                          std::vector<Atlas_shape> named, SP::Atlas_placement placement, int modes, bool ascii,
                          Json& report)
{
  Shapes shapes;
  for(Atlas_shape& shape : named)
    shapes.push_back(std::move(shape.points));
  const auto [alignment, weights, statistics] =
    SP::atlas_statistics(policy, mesh, shapes, placement, modes, stopped_by_signals());
  const int groups = shapes.size() <= most_left_out_alone ? static_cast<int>(shapes.size()) : groups_beyond;
  const SP::Model_quality quality =
    SP::model_quality(policy, shapes, weights, groups, random_shapes, 1, stopped_by_signals());
  const std::vector<double>& errors = quality.generalization;
  const double variance = statistics.total_variance;

  report["alignment"] = {{"converged", alignment.has_converged}, {"iterations", alignment.iterations}};
  Json motions = Json::array();
  for(std::size_t i = 0; i < alignment.motions.size(); ++i) {
    const SP::Similarity& motion = alignment.motions[i];
    motions.push_back({{"name", named[i].name},
                       {"scale", motion.scale},
                       {"rotation", motion.rotation},
                       {"translation", motion.translation}});
  }
  report["alignment"]["motions"] = std::move(motions);
  report["total_variance"] = variance;
  Json rows = Json::array();
  double explained = 0;
  for(const double v : statistics.variances) {
    explained += v;
    rows.push_back({{"variance", v},
                    {"standard_deviation", std::sqrt(v)},
                    {"explained", v / variance},
                    {"explained_so_far", explained / variance}});
  }
  report["modes"] = std::move(rows);
  report["compactness_by_modes"] = quality.compactness;
  report["left_out"] = {{"groups", groups}, {"root_mean_square_by_modes", errors}};
  report["specificity"] = {{"random_shapes", random_shapes},
                           {"mean_by_modes", quality.specificity},
                           {"standard_error_by_modes", quality.specificity_error}};

  const Output_format ply = {Mesh_format::PLY, ascii};
  write_json(open("report.json"), report);
  write_mesh(open("mean.ply"), ply, mesh.mesh, statistics.mean, Surface::SHAPE);
  write_variance_ply(open("variance.ply"), ascii, mesh.mesh, statistics.mean,
                     SP::vertex_variances(policy, shapes, stopped_by_signals()));
  for(std::size_t k = 0; k < statistics.modes.size(); ++k)
    for(const auto& [word, sign] : {std::pair("plus", 1.), std::pair("minus", -1.)}) {
      std::vector<double> scores(k + 1, 0);
      scores[k] = sign * deviations_shown * std::sqrt(statistics.variances[k]);
      write_mesh(open("modes/mode_" + std::to_string(k + 1) + '_' + word + ".ply"), ply, mesh.mesh,
                 SP::shape_of_scores(statistics, scores), Surface::SHAPE);
    }
  write_scores(open("scores.csv"), named, statistics);
  write_quality(open("quality.csv"), quality);
  std::ostringstream text;
  text.precision(3);
  text << shapes.size() << " shapes of " << mesh.mesh.number_of_vertices()
       << " vertices; root mean square distance from "
       << "the mean "
       << std::sqrt(variance * (static_cast<double>(shapes.size()) - 1) / static_cast<double>(shapes.size()));
  if(!statistics.modes.empty())
    text << "; the first mode explains " << 100 * statistics.variances[0] / variance << " % of the variance, all "
         << statistics.modes.size() << " written modes " << 100 * explained / variance << " %";
  text << "\nleave-out error: " << errors.front() << " with the mean of the other shapes, " << errors.back()
       << " with all of their modes (" << errors.size() - 1
       << ")\nspecificity: a random shape of the model with all modes (" << quality.specificity.size() - 1 << ") is "
       << quality.specificity.back() << " +- " << quality.specificity_error.back() << " from the nearest shape";
  return {text.str(), statistics.modes.size()};
}

} // namespace tool
