// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"
#include "commands/options.h"
#include "shapes/segmentation_scores.h"
#include "shapes/segmenters.h"
#include "tables/table.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>

namespace benchmark {
namespace {

namespace fs = std::filesystem;

/// A folder CLASS_NUMBER with a mesh of the same name and human segmentations *.seg.
struct Model {
  std::string name, class_name;
  fs::path mesh;
  std::vector<fs::path> segmentations;
};

std::vector<Model> models_in(const fs::path& folder)
{
  std::vector<Model> models;
  for(const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if(!entry.is_directory())
      continue;
    Model model = {entry.path().filename().string(), "", {}, {}};
    model.class_name = model.name.substr(0, model.name.rfind('_'));
    for(const fs::directory_entry& file : fs::directory_iterator(entry.path()))
      if(file.path().extension() == ".seg")
        model.segmentations.push_back(file.path());
      else if(file.path().stem() == model.name)
        model.mesh = file.path();
    std::sort(model.segmentations.begin(), model.segmentations.end());
    if(!model.mesh.empty() && !model.segmentations.empty())
      models.push_back(model);
  }
  if(models.empty())
    throw std::runtime_error(folder.string() + ": no folder CLASS_NUMBER with a mesh of that name and *.seg files");
  std::sort(models.begin(), models.end(), [](const Model& a, const Model& b) { return a.name < b.name; });
  return models;
}

Labels read_labels(const fs::path& file, std::size_t number_of_faces)
{
  std::ifstream in(file);
  Labels labels;
  for(int label; in >> label;)
    labels.push_back(label);
  if(!in.eof() || labels.size() != number_of_faces)
    throw std::runtime_error(file.string() + ": " + std::to_string(labels.size()) + " labels, but the mesh has " +
                             std::to_string(number_of_faces) + " faces");
  return labels;
}

std::size_t number_of_segments(const Labels& labels) { return std::set<int>(labels.begin(), labels.end()).size(); }

/// Means; what is not a number is left out.
class Mean {
public:
  void add(double x)
  {
    if(std::isnan(x))
      return;
    sum_ += x;
    ++count_;
  }
  double value() const { return count_ > 0 ? sum_ / count_ : std::numeric_limits<double>::quiet_NaN(); }

private:
  double sum_ = 0;
  int count_ = 0;
};

/// What is known of a method on a model: the scores, number of segments, seconds.
typedef std::array<double, all_scores.size() + 2> Row;
constexpr std::size_t segments_column = all_scores.size(), seconds_column = all_scores.size() + 1;

/// The mean over the reference segmentations.
Row score(const Segmentation_judge& judge, const Labels& labels, const std::vector<Labels>& references, double seconds)
{
  std::array<Mean, all_scores.size()> means;
  for(const Labels& reference : references) {
    const Segmentation_scores s = judge.compare(labels, reference);
    for(std::size_t i = 0; i < all_scores.size(); ++i)
      means[i].add(s.*all_scores[i]);
  }
  Row row;
  for(std::size_t i = 0; i < all_scores.size(); ++i)
    row[i] = means[i].value();
  row[segments_column] = static_cast<double>(number_of_segments(labels));
  row[seconds_column] = seconds;
  return row;
}

Row mean_of(const std::vector<Row>& rows)
{
  Row result;
  for(std::size_t i = 0; i < result.size(); ++i) {
    Mean mean;
    for(const Row& row : rows)
      mean.add(row[i]);
    result[i] = mean.value();
  }
  return result;
}

/// Every human against the others.
Row score_of_humans(const Segmentation_judge& judge, const std::vector<Labels>& humans)
{
  std::vector<Row> rows;
  for(std::size_t i = 0; i < humans.size(); ++i) {
    std::vector<Labels> others = humans;
    others.erase(others.begin() + i);
    rows.push_back(score(judge, humans[i], others, std::numeric_limits<double>::quiet_NaN()));
  }
  return mean_of(rows);
}

/// Classes of the Princeton benchmark without limbs to speak of, or of which limbs are the smaller part.
bool is_limbed(const std::string& class_name)
{
  static const std::set<std::string> others = {"bearing", "bust", "chair", "cup", "mech", "table", "vase"};
  return others.count(class_name) == 0;
}

/// Rows of models by method (in the order of their appearance) and class.
class Evaluation {
public:
  void add(const std::string& method, const std::string& class_name, const Row& row)
  {
    if(rows_.count(method) == 0)
      methods_.push_back(method);
    rows_[method][class_name].push_back(row);
  }
  const std::vector<std::string>& methods() const { return methods_; }
  std::vector<std::string> classes() const
  {
    std::vector<std::string> names;
    for(const auto& [name, rows] : rows_.at(methods_.front()))
      names.push_back(name);
    return names;
  }
  std::size_t number_of_models(const std::string& class_name) const
  {
    return rows_.at(methods_.front()).at(class_name).size();
  }
  Row class_mean(const std::string& method, const std::string& class_name) const
  {
    return mean_of(rows_.at(method).at(class_name));
  }
  Row mean(const std::string& method, bool limbed_only) const
  {
    std::vector<Row> rows;
    for(const std::string& name : classes())
      if(!limbed_only || is_limbed(name))
        rows.push_back(class_mean(method, name));
    return mean_of(rows);
  }

private:
  std::vector<std::string> methods_;
  std::map<std::string, std::map<std::string, std::vector<Row>>> rows_;
};

Evaluation evaluate(const std::vector<Model>& models, bool with_sdf)
{
  const Backend backend = available_backends().front();
  Evaluation evaluation;
  for(const Model& model : models)
    with_mesh(model.mesh, [&](Mesh& mesh) {
      std::vector<Labels> humans;
      std::vector<std::size_t> counts;
      for(const fs::path& file : model.segmentations) {
        humans.push_back(read_labels(file, mesh.number_of_faces()));
        counts.push_back(number_of_segments(humans.back()));
      }
      std::nth_element(counts.begin(), counts.begin() + counts.size() / 2, counts.end());
      const Sphere_map sphere = sphere_map(mesh);
      const Result map = compute_map(backend, mesh, Weights::CONFORMAL, Balanced(), sphere);
      if(map.degree == 0)
        throw std::runtime_error("no map: " + std::string(verdict(map)));
      const Segmentation_judge judge(mesh);
      if(humans.size() > 1)
        evaluation.add("humans", model.class_name, score_of_humans(judge, humans));
      Row map_row;
      map_row.fill(std::numeric_limits<double>::quiet_NaN());
      map_row[seconds_column] = map.seconds.total;
      for(const Segmenter_result& s : segment_by_all(mesh, sphere, counts[counts.size() / 2], with_sdf))
        evaluation.add(s.name, model.class_name, score(judge, s.result.labels, humans, s.result.seconds));
      evaluation.add("map", model.class_name, map_row);
    });
  return evaluation;
}

void measure(const Options& options, bool with_sdf)
{
  const Evaluation evaluation = evaluate(models_in(options.meshes.front()), with_sdf);
  const std::vector<std::string> notes = {
    "means over the human segmentations, then the models of a class, then the classes, all equally weighted",
    "limbed: all classes but bearing, bust, chair, cup, mech, table, vase",
    "humans: each against the others of its model; Voronoi cells: as many as the median human has segments",
    "SDF: CGAL, 5 clusters and lambda 0.26 (default), 4 and 0.10 (tuned); stretch, graph cut: 5 and 0.26",
    "seconds: one core, without the map, whose row is `map`"};

  Table table(options.output, "segmentation", "Segmentation against humans", notes,
              {"method", "Rand index error", "limbed", "cut discrepancy", "Hamming distance",
               "global consistency error", "local consistency error", "segments", "seconds"});
  for(const std::string& method : evaluation.methods()) {
    const Row all = evaluation.mean(method, false), limbed = evaluation.mean(method, true);
    table.add_row(
      {method, all[0], limbed[0], all[1], all[2], all[3], all[4], all[segments_column], all[seconds_column]});
  }

  std::vector<std::string> columns = {"class", "models"};
  for(const std::string& method : evaluation.methods())
    if(method != "map")
      columns.push_back(method);
  Table classes(options.output, "segmentation_classes", "Rand index error by class", notes, columns);
  for(const std::string& name : evaluation.classes()) {
    std::vector<Cell> row = {name, evaluation.number_of_models(name)};
    for(const std::string& method : evaluation.methods())
      if(method != "map")
        row.emplace_back(evaluation.class_mean(method, name)[0]);
    classes.add_row(row);
  }
}

} // namespace

void add_segmentation_command(CLI::App& app)
{
  const auto options = std::make_shared<Options>();
  const auto skips_sdf = std::make_shared<bool>(false);
  CLI::App* command = app.add_subcommand("segmentation", "Segmentation against humans, SDF values and trivial methods");
  add_output_option(*command, *options);
  command->add_flag("--skip-sdf", *skips_sdf, "Leave the SDF values out, which take nearly all of the time");
  command->add_option("folder", options->meshes, "Folder of folders CLASS_NUMBER, each with a mesh and *.seg files")
    ->required()
    ->expected(1)
    ->check(CLI::ExistingDirectory);
  command->callback([options, skips_sdf] { measure(*options, !*skips_sdf); });
}

} // namespace benchmark
