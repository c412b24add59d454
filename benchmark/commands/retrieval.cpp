// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"
#include "measure/backend.h"
#include "measure/measure.h"
#include "shapes/descriptors.h"
#include "tables/table.h"

#include <CGAL/Spherical_parameterization/shape_signature.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace benchmark {
namespace {

namespace fs = std::filesystem;

/// The map that the descriptors are given: the conformal one, certified or not; where it does not converge, the
/// barycentric one if that is certified. Throws std::runtime_error where there is nothing to map.
void map_for_descriptors(Mesh& mesh, Sphere_map sphere)
{
  const Result result = compute_map(Backend(), mesh, Weights::CLAMPED, Balanced(), sphere);
  if(result.error != CGAL::Spherical_parameterization::Error_code::NOT_CONVERGED)
    return;
  const auto other = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:barycentric").first;
  if(compute_map(Backend(), mesh, Weights::BARYCENTRIC, Balanced(), other))
    for(auto v : mesh.vertices())
      sphere[v] = other[v];
}

/// What every descriptor says of a mesh, and how long it took.
struct Described {
  std::vector<Descriptor_values> values;
  std::vector<double> seconds; ///< the map included where it is needed
};

/// Slow descriptors may say nothing.
Described describe(Mesh& mesh, Sphere_map sphere, const std::vector<Descriptor>& descriptors, bool with_slow = true)
{
  Described result;
  const Stopwatch map_watch;
  map_for_descriptors(mesh, sphere);
  const double map_seconds = map_watch.seconds();
  for(const Descriptor& descriptor : descriptors) {
    const Stopwatch watch;
    result.values.push_back(descriptor.is_slow && !with_slow ? Descriptor_values()
                            : descriptor.derive              ? descriptor.derive(result.values.back())
                                                             : descriptor.compute(mesh, sphere));
    result.seconds.push_back(watch.seconds() + (descriptor.derive      ? result.seconds.back()
                                                : descriptor.needs_map ? map_seconds
                                                                       : 0));
  }
  return result;
}

/// L1
double distance(const Descriptor_values& a, const Descriptor_values& b)
{
  typedef Eigen::Map<const Eigen::ArrayXd> Array;
  return (Array(a.data(), a.size()) - Array(b.data(), b.size())).abs().sum();
}

/// Something that is searched, or searched for.
struct Model {
  fs::path file;
  std::string group, label;
  Described described;
};
typedef std::vector<Model> Models;

/// FOLDER/GROUP/CLASS/FILE, in the order of the names. Throws std::runtime_error if there is none.
Models read_models(const fs::path& folder, const std::vector<Descriptor>& descriptors)
{
  std::set<fs::path> files;
  for(auto it = fs::recursive_directory_iterator(folder); it != fs::recursive_directory_iterator(); ++it)
    if(it.depth() == 2)
      files.insert(it->path());
  if(files.empty())
    throw std::runtime_error(folder.string() + ": no files GROUP/CLASS/FILE in this folder");
  Models models;
  for(const fs::path& file : files)
    try {
      with_mesh(file, [&](Mesh& mesh, Sphere_map sphere) {
        models.push_back({file, file.parent_path().parent_path().filename(), file.parent_path().filename(),
                          describe(mesh, sphere, descriptors)});
      });
    } catch(const std::exception& error) {
      std::cerr << "left out: " << error.what() << std::endl;
    }
  return models;
}

/// With one class only, everything is a hit.
bool has_several_classes(const Models& models)
{
  return std::any_of(models.begin(), models.end(), [&](const Model& m) { return m.label != models.front().label; });
}

/// How well a search finds the other members of the query's class, means over all queries whose class has any:
/// P. Shilane, P. Min, M. Kazhdan, T. Funkhouser, "The Princeton Shape Benchmark", SMI 2004. In percent:
/// 0. nearest neighbour: the first result is of the class
/// 1. first tier: share of the class among the first k results, k being its size
/// 2. second tier: among the first 2k
/// 3. E-measure: harmonic mean of precision and recall of the first 32
/// 4. DCG: hits weighted with 1 / log2 of their rank, relative to the best possible
/// 5. average precision: share of hits among the first r results, mean over the ranks r of the hits
struct Retrieval_measures {
  std::size_t queries = 0;
  std::array<double, 6> percent = {};
};

/// `is_hit` says by rank, from 0 on, whether the result is of the query's class, which has so many other members.
std::array<double, 6> measures_of_query(const std::vector<bool>& is_hit, std::size_t members)
{
  constexpr std::size_t page = 32;
  const auto hits_among = [&](std::size_t n) {
    return static_cast<double>(std::count(is_hit.begin(), is_hit.begin() + std::min(n, is_hit.size()), true));
  };
  double gain = 0, best_gain = 0, hits = 0, precisions = 0;
  for(std::size_t rank = 1; rank <= is_hit.size(); ++rank) {
    const double discount = rank <= 2 ? 1 : 1 / std::log2(static_cast<double>(rank));
    gain += is_hit[rank - 1] ? discount : 0;
    best_gain += rank <= members ? discount : 0;
    if(is_hit[rank - 1])
      precisions += ++hits / static_cast<double>(rank);
  }
  return {is_hit[0] ? 1. : 0.,
          hits_among(members) / members,
          hits_among(2 * members) / members,
          2 * hits_among(page) / (std::min(page, is_hit.size()) + members),
          gain / best_gain,
          precisions / members};
}

/// How well descriptor `d` of the queries finds models other than themselves.
Retrieval_measures search(const Models& queries, const Models& models, std::size_t d)
{
  Retrieval_measures result;
  for(const Model& query : queries) {
    std::vector<std::pair<double, const Model*>> ranked;
    for(const Model& model : models)
      if(model.file != query.file)
        ranked.emplace_back(distance(query.described.values[d], model.described.values[d]), &model);
    std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<bool> is_hit;
    for(const auto& [distance, model] : ranked)
      is_hit.push_back(model->label == query.label);
    const std::size_t members = std::count(is_hit.begin(), is_hit.end(), true);
    if(members == 0)
      continue;
    ++result.queries;
    const std::array<double, 6> measures = measures_of_query(is_hit, members);
    for(std::size_t i = 0; i < measures.size(); ++i)
      result.percent[i] += 100 * measures[i];
  }
  for(double& percent : result.percent)
    percent /= std::max<std::size_t>(result.queries, 1);
  return result;
}

/// The models of every other class, in the order of the names.
Models half_of(const Models& models, std::size_t half)
{
  std::set<std::string> classes;
  for(const Model& model : models)
    classes.insert(model.label);
  Models result;
  for(const Model& model : models)
    if(static_cast<std::size_t>(std::distance(classes.begin(), classes.find(model.label))) % 2 == half)
      result.push_back(model);
  return result;
}

void tabulate_groups(const Options& options, const std::map<std::string, Models>& groups, const Models& all,
                     const std::vector<Descriptor>& descriptors)
{
  Table table(options.output, "retrieval", "Retrieval",
              {"every model is a query among the others of its group; means over the queries, in percent",
               "odd, even: queries of the 1st, 3rd, ... and of the 2nd, 4th, ... class of the group; a choice that was "
               "made on one half can be judged by the other",
               "seconds: per mesh on one core, the map included where it is needed"},
              {"group", "queries", "descriptor", "nearest neighbour", "first tier", "second tier", "E-measure", "DCG",
               "average precision", "seconds"});
  const auto add_rows_of = [&](const std::string& group, const Models& queries, const Models& models) {
    for(std::size_t d = 0; d < descriptors.size(); ++d) {
      const Retrieval_measures m = search(queries, models, d);
      double seconds = 0;
      for(const Model& query : queries)
        seconds += query.described.seconds[d] / queries.size();
      table.add_row({group, queries.size(), descriptors[d].name, m.percent[0], m.percent[1], m.percent[2], m.percent[3],
                     m.percent[4], m.percent[5], seconds});
    }
  };
  const auto add_rows = [&](const std::string& group, const Models& models) {
    add_rows_of(group, models, models);
    add_rows_of(group + ", odd", half_of(models, 0), models);
    add_rows_of(group + ", even", half_of(models, 1), models);
  };
  for(const auto& [group, models] : groups)
    if(has_several_classes(models))
      add_rows(group, models);
  add_rows("all", all);
}

/// How well the weights of the parts of the signature, the first descriptor, can be chosen: on one half of the classes,
/// by average precision, to be judged by the other half.
void tabulate_choice_of_weights(const Options& options, const std::map<std::string, Models>& groups)
{
  using CGAL::Spherical_parameterization::Shape_signature;
  constexpr std::size_t signature = 0;   // number of the descriptor
  typedef std::array<double, 4> Weights; // girths in coarse and in fine bins, lengths and areas of limbs
  constexpr std::size_t sizes[] = {Shape_signature::coarse_bins, Shape_signature::fine_bins, Shape_signature::limbs,
                                   Shape_signature::limbs};
  std::vector<Weights> choices = {{1, 1, 1, 1}}; // the default, which is kept where others are not better
  for(const double a : {0.5, 1., 2.})
    for(const double b : {0.5, 1., 2.})
      for(const double c : {0.5, 1., 2.})
        for(const double d : {0., 0.5, 1., 2.})
          choices.push_back({a, b, c, d});
  const auto weighted = [&](Models models, const Weights& weights) {
    for(Model& model : models) {
      double* value = model.described.values.front().data();
      for(std::size_t part = 0; part < weights.size(); ++part)
        for(std::size_t i = 0; i < sizes[part]; ++i)
          *value++ *= weights[part];
    }
    return models;
  };
  Table table(options.output, "retrieval_choice", "Weights of the signature, chosen on one half of the classes",
              {"first tier and average precision in percent; weights: of girths in coarse and in fine bins, of lengths "
               "and areas of limbs",
               std::to_string(choices.size() - 1) + " choices, by average precision"},
              {"group", "chosen on", "weights", "first tier there", "average precision there", "first tier, other half",
               "average precision, other half", "first tier, other half, default",
               "average precision, other half, default"});
  for(const auto& [group, models] : groups) {
    if(!has_several_classes(models))
      continue;
    std::vector<std::array<Retrieval_measures, 2>> found; // by choice and half
    for(const Weights& weights : choices) {
      const Models all = weighted(models, weights);
      found.push_back({search(half_of(all, 0), all, signature), search(half_of(all, 1), all, signature)});
    }
    for(const std::size_t half : {0, 1}) {
      const auto best = std::max_element(found.begin(), found.end(), [half](const auto& a, const auto& b) {
        return a[half].percent[5] < b[half].percent[5];
      });
      std::ostringstream text;
      for(const double weight : choices[static_cast<std::size_t>(best - found.begin())])
        text << weight << ' ';
      const auto &here = (*best)[half].percent, &there = (*best)[1 - half].percent,
                 &by_default = found.front()[1 - half].percent;
      table.add_row({group, half == 0 ? "odd" : "even", text.str(), here[1], here[5], there[1], there[5], by_default[1],
                     by_default[5]});
    }
  }
}

void tabulate_pairs_of_groups(const Options& options, const std::map<std::string, Models>& groups,
                              const std::vector<Descriptor>& descriptors)
{
  Table table(
    options.output, "retrieval_across_groups", "Retrieval across groups",
    {"models of the first group are searched for among those of the second one; classes that both have count"},
    {"queries from", "searched", "descriptor", "queries", "nearest neighbour", "first tier"});
  for(const auto& [from, queries] : groups)
    for(const auto& [to, models] : groups)
      for(std::size_t d = 0; from != to && has_several_classes(models) && d < descriptors.size(); ++d) {
        const Retrieval_measures m = search(queries, models, d);
        if(m.queries > 0)
          table.add_row({from, to, descriptors[d].name, m.queries, m.percent[0], m.percent[1]});
      }
}

/// How far variants of a mesh are from it, compared with how far other classes are; without slow descriptors.
void tabulate_variants(const Options& options, const std::string& group, const Models& models,
                       const std::vector<Descriptor>& descriptors)
{
  Table table(options.output, "retrieval_variants_" + group, "Retrieval of variants: " + group,
              {"within: mean distance of a variant from its own original; between: mean distance of originals of "
               "different classes",
               "own original first: in percent of the variants, of all originals of the group",
               "noise: of every vertex along its normal, relative to the mean length of edges"},
              {"variant", "vertices", "descriptor", "within / between", "own original first"});
  for(const Mesh_variant& variant : mesh_variants()) {
    std::vector<Described> described;
    std::size_t vertices = 0;
    for(const Model& model : models)
      with_mesh(model.file, [&](const Mesh& mesh, Sphere_map) {
        Mesh changed = variant.make(mesh);
        vertices += changed.number_of_vertices();
        described.push_back(describe(changed, sphere_map(changed), descriptors, false));
      });
    for(std::size_t d = 0; d < descriptors.size(); ++d) {
      if(descriptors[d].is_slow)
        continue;
      double within = 0, between = 0, pairs = 0, first = 0;
      for(std::size_t i = 0; i < models.size(); ++i) {
        const auto distance_to = [&](const Model& other) {
          return distance(described[i].values[d], other.described.values[d]);
        };
        within += distance_to(models[i]) / models.size();
        first += std::all_of(models.begin(), models.end(), [&](const Model& other) {
          return &other == &models[i] || distance_to(other) > distance_to(models[i]);
        });
        for(const Model& other : models)
          if(other.label != models[i].label) {
            between += distance(models[i].described.values[d], other.described.values[d]);
            ++pairs;
          }
      }
      table.add_row({variant.name, vertices / models.size(), descriptors[d].name, within / (between / pairs),
                     100 * first / models.size()});
    }
  }
}

} // namespace

void tabulate_retrieval(const Options& options)
{
  std::vector<Descriptor> descriptors = own_descriptors();
  for(const Descriptor& descriptor : other_descriptors())
    descriptors.push_back(descriptor);
  const Models models = read_models(options.folder, descriptors);
  std::map<std::string, Models> groups;
  for(const Model& model : models)
    groups[model.group].push_back(model);
  tabulate_groups(options, groups, models, descriptors);
  std::map<std::string, Models> with_all = groups;
  with_all["all"] = models;
  tabulate_choice_of_weights(options, with_all);
  tabulate_pairs_of_groups(options, groups, descriptors);
  for(const std::string& group : options.variants_of) {
    if(groups.count(group) == 0)
      throw std::runtime_error("no group '" + group + "' in " + options.folder);
    tabulate_variants(options, group, groups.at(group), descriptors);
  }
}

} // namespace benchmark
