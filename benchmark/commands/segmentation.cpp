// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"
#include "measure/backend.h"
#include "shapes/segmentations.h"
#include "tables/table.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

namespace benchmark {
namespace {

namespace fs = std::filesystem;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// A folder CLASS_NUMBER with a mesh of the same name and human segmentations *.seg.
struct Model {
  std::string class_name;
  fs::path mesh;
  std::set<fs::path> segmentations;
};

std::vector<Model> models_in(const fs::path& folder)
{
  const std::set<fs::path> folders(fs::directory_iterator(folder), fs::directory_iterator{});
  std::vector<Model> models;
  for(const fs::path& path : folders) {
    if(!fs::is_directory(path))
      continue;
    const std::string name = path.filename().string();
    Model model = {name.substr(0, name.rfind('_')), {}, {}};
    for(const fs::directory_entry& file : fs::directory_iterator(path))
      if(file.path().extension() == ".seg")
        model.segmentations.insert(file.path());
      else if(file.path().stem() == name)
        model.mesh = file;
    if(!model.mesh.empty() && !model.segmentations.empty())
      models.push_back(model);
  }
  if(models.empty())
    throw std::runtime_error(folder.string() + ": no folder CLASS_NUMBER with a mesh of that name and *.seg files");
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

/// What is known of a method on a model: the five scores, number of segments, seconds.
typedef Eigen::Array<double, 7, 1> Row;
constexpr int segments_column = 5, seconds_column = 6;

/// What is not a number is left out.
Row mean_of(const std::vector<Row>& rows)
{
  Row sum = Row::Zero(), count = Row::Zero();
  for(const Row& row : rows) {
    sum += row.isNaN().select(Row::Zero(), row);
    count += (!row.isNaN()).cast<double>();
  }
  return sum / count;
}

/// The mean over the reference segmentations.
Row score(const Segmentation_judge& judge, const Labels& labels, const std::vector<Labels>& references, double seconds)
{
  std::vector<Row> rows;
  for(const Labels& reference : references) {
    rows.emplace_back();
    rows.back() << judge.compare(labels, reference), static_cast<double>(number_of_segments(labels)), seconds;
  }
  return mean_of(rows);
}

/// Every human against the others.
Row score_of_humans(const Segmentation_judge& judge, const std::vector<Labels>& humans)
{
  std::vector<Row> rows;
  for(std::size_t i = 0; i < humans.size(); ++i) {
    std::vector<Labels> others = humans;
    others.erase(others.begin() + i);
    rows.push_back(score(judge, humans[i], others, unknown));
  }
  return mean_of(rows);
}

/// The rows of the models by class, of every method.
struct Method_rows {
  std::string method;
  std::map<std::string, std::vector<Row>> of_class;

  /// Of the classes, all or those that have limbs to speak of.
  Row mean(bool limbed_only) const
  {
    static const std::set<std::string> others = {"bearing", "bust", "chair", "cup", "mech", "table", "vase"};
    std::vector<Row> means;
    for(const auto& [class_name, rows] : of_class)
      if(!limbed_only || others.count(class_name) == 0)
        means.push_back(mean_of(rows));
    return mean_of(means);
  }
};

/// In the order in which the methods appear.
std::vector<Method_rows> evaluate(const std::vector<Model>& models, bool with_sdf)
{
  std::vector<Method_rows> methods;
  for(const Model& model : models)
    with_mesh(model.mesh, [&](Mesh& mesh, Sphere_map sphere) {
      const auto add = [&](const std::string& method, const Row& row) {
        auto it = std::find_if(methods.begin(), methods.end(), [&](const auto& m) { return m.method == method; });
        if(it == methods.end())
          it = methods.insert(it, {method, {}});
        it->of_class[model.class_name].push_back(row);
      };
      std::vector<Labels> humans;
      std::vector<std::size_t> counts;
      for(const fs::path& file : model.segmentations) {
        humans.push_back(read_labels(file, mesh.number_of_faces()));
        counts.push_back(number_of_segments(humans.back()));
      }
      std::nth_element(counts.begin(), counts.begin() + counts.size() / 2, counts.end());
      const Result map = compute_map(Backend(), mesh, Weights::CLAMPED, Balanced(), sphere);
      if(map.degree == 0)
        throw std::runtime_error("no map: " + verdict(map));
      const Segmentation_judge judge(mesh);
      if(humans.size() > 1)
        add("humans", score_of_humans(judge, humans));
      for(const Segmenter_result& s : segment_by_all(mesh, sphere, counts[counts.size() / 2], with_sdf))
        add(s.name, score(judge, s.labels, humans, s.seconds));
      Row map_row = Row::Constant(unknown);
      map_row[seconds_column] = map.seconds.total;
      add("map", map_row);
    });
  return methods;
}

} // namespace

void tabulate_segmentation(const Options& options)
{
  std::vector<Method_rows> methods = evaluate(models_in(options.folder), !options.skips_sdf);
  const std::vector<std::string> notes = {
    "means over the human segmentations, then the models of a class, then the classes, all equally weighted",
    "limbed: all classes but bearing, bust, chair, cup, mech, table, vase",
    "humans: each against the others of its model; Voronoi cells: as many as the median human has segments",
    "SDF: CGAL, 5 clusters and lambda 0.26 (default), 4 and 0.10 (tuned); stretch, graph cut: 5 and 0.26",
    "seconds: one core, without the map, whose row is `map`"};

  Table table(options.output, "segmentation", "Segmentation against humans", notes,
              {"method", "Rand index error", "limbed", "cut discrepancy", "Hamming distance",
               "global consistency error", "local consistency error", "segments", "seconds"});
  for(const Method_rows& rows : methods) {
    const Row all = rows.mean(false), limbed = rows.mean(true);
    table.add_row(
      {rows.method, all[0], limbed[0], all[1], all[2], all[3], all[4], all[segments_column], all[seconds_column]});
  }

  methods.erase(std::find_if(methods.begin(), methods.end(), [](const auto& m) { return m.method == "map"; }));
  std::vector<Cell> columns = {"class", "models"};
  for(const Method_rows& rows : methods)
    columns.emplace_back(rows.method);
  Table classes(options.output, "segmentation_classes", "Rand index error by class", notes, columns);
  for(const auto& [class_name, models] : methods.front().of_class) {
    std::vector<Cell> row = {class_name, models.size()};
    for(const Method_rows& rows : methods)
      row.emplace_back(mean_of(rows.of_class.at(class_name))[0]);
    classes.add_row(row);
  }
}

} // namespace benchmark
