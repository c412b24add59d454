// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"
#include "shapes/descriptors.h"
#include "meshes/mesh_variants.h"
#include "commands/options.h"
#include "shapes/retrieval_measures.h"
#include "tables/table.h"
#include "measure/timing.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <stdexcept>

namespace benchmark {
namespace {

namespace fs = std::filesystem;

struct Model {
  fs::path file;
  std::string group, label;
};

/// FOLDER/GROUP/CLASS/FILE, in the order of the names. Throws std::runtime_error if there is none.
std::vector<Model> find_models(const fs::path& folder)
{
  std::vector<Model> models;
  for(const fs::directory_entry& group : fs::directory_iterator(folder))
    if(group.is_directory())
      for(const fs::directory_entry& label : fs::directory_iterator(group))
        if(label.is_directory())
          for(const fs::directory_entry& file : fs::directory_iterator(label))
            models.push_back({file.path(), group.path().filename(), label.path().filename()});
  if(models.empty())
    throw std::runtime_error(folder.string() + ": no files GROUP/CLASS/FILE in this folder");
  std::sort(models.begin(), models.end(), [](const Model& a, const Model& b) { return a.file < b.file; });
  return models;
}

/// What every descriptor says of a mesh, and how long it took.
struct Described {
  std::vector<Descriptor_values> values;
  std::vector<double> seconds; ///< the map included where it is needed
};

Described describe(Mesh mesh, const std::vector<Descriptor>& descriptors)
{
  Described result;
  const Sphere_map sphere = sphere_map(mesh);
  const Stopwatch map_watch;
  map_for_descriptors(mesh, sphere);
  const double map_seconds = map_watch.seconds();
  for(const Descriptor& descriptor : descriptors) {
    const Stopwatch watch;
    result.values.push_back(descriptor.compute(mesh, sphere));
    result.seconds.push_back(watch.seconds() + (descriptor.needs_map ? map_seconds : 0));
  }
  return result;
}

/// Everything that is searched, or searched for.
struct Collection {
  std::vector<Descriptor> descriptors;
  std::vector<Model> models;
  std::vector<Described> described;

  /// The models of a group ("" for all) as descriptor d sees them.
  std::vector<Labelled> labelled(const std::string& group, std::size_t d) const
  {
    std::vector<Labelled> result;
    for(std::size_t i = 0; i < models.size(); ++i)
      if(group.empty() || models[i].group == group)
        result.push_back({models[i].label, described[i].values[d]});
    return result;
  }

  double mean_seconds(const std::string& group, std::size_t d) const
  {
    double sum = 0, count = 0;
    for(std::size_t i = 0; i < models.size(); ++i)
      if(group.empty() || models[i].group == group) {
        sum += described[i].seconds[d];
        ++count;
      }
    return sum / count;
  }

  /// Number of classes by group.
  std::map<std::string, std::size_t> groups() const
  {
    std::map<std::string, std::map<std::string, int>> classes;
    for(const Model& model : models)
      ++classes[model.group][model.label];
    std::map<std::string, std::size_t> result;
    for(const auto& [group, labels] : classes)
      result[group] = labels.size();
    return result;
  }
};

void tabulate_groups(const Options& options, const Collection& collection)
{
  Table table(
    options.output, "retrieval", "Retrieval",
    {"every model is a query among the others of its group; means over the queries, in percent",
     "seconds: per mesh on one core, the map included where it is needed"},
    {"group", "models", "descriptor", "nearest neighbour", "first tier", "second tier", "E-measure", "DCG", "seconds"});
  std::vector<std::string> groups;
  for(const auto& [group, classes] : collection.groups())
    if(classes > 1) // otherwise everything is a hit
      groups.push_back(group);
  groups.emplace_back(); // all together
  for(const std::string& group : groups)
    for(std::size_t d = 0; d < collection.descriptors.size(); ++d) {
      const std::vector<Labelled> models = collection.labelled(group, d);
      const Retrieval_measures m = measure_retrieval(models);
      table.add_row({group.empty() ? "all" : group, models.size(), collection.descriptors[d].name, m.nearest_neighbour,
                     m.first_tier, m.second_tier, m.e_measure, m.discounted_gain, collection.mean_seconds(group, d)});
    }
}

void tabulate_pairs_of_groups(const Options& options, const Collection& collection)
{
  Table table(
    options.output, "retrieval_across_groups", "Retrieval across groups",
    {"models of the first group are searched for among those of the second one; classes that both have count"},
    {"queries from", "searched", "descriptor", "queries", "nearest neighbour", "first tier"});
  for(const auto& [from, from_classes] : collection.groups())
    for(const auto& [to, to_classes] : collection.groups())
      for(std::size_t d = 0; from != to && to_classes > 1 && d < collection.descriptors.size(); ++d) {
        const Retrieval_measures m = measure_retrieval(collection.labelled(from, d), collection.labelled(to, d));
        if(m.queries > 0)
          table.add_row({from, to, collection.descriptors[d].name, m.queries, m.nearest_neighbour, m.first_tier});
      }
}

/// How far variants of a mesh are from it, compared with how far other classes are.
void tabulate_variants(const Options& options, const Collection& collection, const std::string& group)
{
  Table table(options.output, "retrieval_variants_" + group, "Retrieval of variants: " + group,
              {"within: mean distance of a variant from its own original; between: mean distance of originals of "
               "different classes",
               "own original first: in percent of the variants, of all originals of the group",
               "noise: of every vertex along its normal, relative to the mean length of edges"},
              {"variant", "vertices", "descriptor", "within / between", "own original first"});
  std::vector<std::size_t> members;
  for(std::size_t i = 0; i < collection.models.size(); ++i)
    if(collection.models[i].group == group)
      members.push_back(i);

  std::vector<double> between(collection.descriptors.size(), 0);
  double pairs = 0;
  for(std::size_t i : members)
    for(std::size_t j : members)
      if(collection.models[i].label != collection.models[j].label) {
        ++pairs;
        for(std::size_t d = 0; d < between.size(); ++d)
          between[d] += distance(collection.described[i].values[d], collection.described[j].values[d]);
      }

  for(const Mesh_variant& variant : mesh_variants()) {
    std::vector<double> within(between.size(), 0), first(between.size(), 0);
    double vertices = 0;
    for(std::size_t i : members)
      with_mesh(collection.models[i].file, [&](Mesh& mesh) {
        const Mesh changed = variant.make(mesh);
        vertices += changed.number_of_vertices();
        const Described described = describe(changed, collection.descriptors);
        for(std::size_t d = 0; d < between.size(); ++d) {
          const auto distance_to = [&](std::size_t j) {
            return distance(described.values[d], collection.described[j].values[d]);
          };
          within[d] += distance_to(i);
          first[d] += std::all_of(members.begin(), members.end(),
                                  [&](std::size_t j) { return j == i || distance_to(j) > distance_to(i); });
        }
      });
    for(std::size_t d = 0; d < between.size(); ++d)
      table.add_row({variant.name, static_cast<std::size_t>(vertices / members.size()), collection.descriptors[d].name,
                     within[d] / members.size() / (between[d] / pairs), 100 * first[d] / members.size()});
  }
}

/// Without those descriptors that are slow.
Collection fast_part(const Collection& collection)
{
  Collection result;
  result.models = collection.models;
  result.described.resize(collection.described.size());
  for(std::size_t d = 0; d < collection.descriptors.size(); ++d)
    if(!collection.descriptors[d].is_slow) {
      result.descriptors.push_back(collection.descriptors[d]);
      for(std::size_t i = 0; i < result.described.size(); ++i)
        result.described[i].values.push_back(collection.described[i].values[d]);
    }
  return result;
}

void measure(const Options& options, const std::string& folder, const std::vector<std::string>& variants_of)
{
  Collection collection;
  collection.descriptors = own_descriptors();
  const std::vector<Descriptor> others = other_descriptors();
  collection.descriptors.insert(collection.descriptors.end(), others.begin(), others.end());
  for(const Model& model : find_models(folder))
    try {
      with_mesh(model.file, [&](Mesh& mesh) {
        collection.described.push_back(describe(mesh, collection.descriptors));
        collection.models.push_back(model);
      });
    } catch(const std::exception& error) {
      std::cerr << "left out: " << error.what() << std::endl;
    }
  tabulate_groups(options, collection);
  tabulate_pairs_of_groups(options, collection);
  for(const std::string& group : variants_of) {
    if(collection.groups().count(group) == 0)
      throw std::runtime_error("no group '" + group + "' in " + folder);
    tabulate_variants(options, fast_part(collection), group);
  }
}

} // namespace

void add_retrieval_command(CLI::App& app)
{
  const auto options = std::make_shared<Options>();
  const auto folder = std::make_shared<std::string>();
  const auto variants_of = std::make_shared<std::vector<std::string>>();
  CLI::App* command = app.add_subcommand("retrieval", "How well signatures and other descriptors find other poses");
  add_output_option(*command, *options);
  command->add_option("folder", *folder, "Of files GROUP/CLASS/FILE: closed triangle meshes of genus 0")
    ->required()
    ->check(CLI::ExistingDirectory);
  command
    ->add_option("--variants", *variants_of,
                 "Groups of which remeshed, decimated, subdivided and noisy variants are searched for, too")
    ->delimiter(',')
    ->allow_extra_args(false);
  command->callback([=] { measure(*options, *folder, *variants_of); });
}

} // namespace benchmark
