// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_MESH_COMMAND_H
#define SPHERICAL_PARAMETERIZATION_TOOL_MESH_COMMAND_H

#include "collections/mesh_collection.h"
#include "commands/commands.h"
#include "input/files.h"
#include "mapping/mapped_mesh.h"
#include "options/collection_options.h"
#include "options/mapping_options.h"
#include "options/mesh_output.h"
#include "options/usage.h"
#include "output/atomic_file.h"
#include "system/refusal.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace tool {

/// The command line of a command that works on a mesh or on many, each by itself.
struct Mesh_options : Mapping_options, Collection_options, Mesh_output {};

/// A command that works on a mesh: `Options` is derived from `Mesh_options`.
template <class Options>
struct Mesh_command {
  typedef std::vector<File_option> (*Files)(const Options&);

  std::string extension;                 ///< of outputs in a folder, without --format; empty: --output is no file
  void (*check)(const Options&);         ///< throws what is wrong usage
  void (*run)(const Options&, Outcome&); ///< does it; throws
  std::vector<std::pair<const char*, std::string Options::*>> more_files = {}; ///< options that name further outputs
  Files more_inputs = nullptr;                                                 ///< besides those of every command
  Files more_outputs = nullptr; ///< besides those that are named by options

  /// The files that are read, IN first.
  std::vector<File_option> inputs(const Options& options) const
  {
    return joined(input_files(options), more_inputs, options);
  }

  /// The files that are written.
  std::vector<File_option> outputs(const Options& options) const
  {
    std::vector<File_option> files;
    if(!extension.empty())
      files.emplace_back("--output", options.output);
    for(const auto& [option, file] : more_files)
      files.emplace_back(option, options.*file);
    return joined(std::move(files), more_outputs, options);
  }

  void check_one(const Options& options) const
  {
    check(options);
    check_files(inputs(options), outputs(options));
  }

  Outcome run_one(const Options& options) const
  {
    Outcome outcome;
    outcome.refusal = guarded(options.input, [&] { run(options, outcome); });
    return outcome;
  }

private:
  static std::vector<File_option> joined(std::vector<File_option> files, Files more, const Options& options)
  {
    for(const File_option& file : more != nullptr ? more(options) : std::vector<File_option>())
      files.push_back(file);
    return files;
  }
};

/// What was given on the command line: all that results depend on besides the program and the files. `left_out` are
/// options, by their long names, on which they do not depend.
std::string settings_text(const CLI::App& command, const std::set<std::string>& left_out = {});

/// Throws what is wrong usage of a folder of outputs.
void check_output_folder(const std::string& folder);

/// Runs the command on the mesh, or on the meshes: then OUT is a folder, and further outputs get the names that the
/// options say behind the names of the meshes. Returns the exit code.
template <class Options>
int run_mesh_command(const CLI::App& command, const Mesh_command<Options>& mesh_command, Options options)
{
  check_collection_options(options);
  if(!options.are_many(options.output)) {
    options.input = options.inputs.front();
    mesh_command.check_one(options);
    const Outcome outcome = mesh_command.run_one(options);
    if(!outcome.text.empty())
      std::cout << outcome.text << std::endl;
    return exit_code_of(outcome.refusal);
  }

  check_output_folder(options.output);
  while(options.output.size() > 1 && options.output.back() == '/')
    options.output.pop_back();
  for(const auto& [option, file] : mesh_command.more_files) {
    require((options.*file).empty() || !options.output.empty(), "--output",
            "is required: a folder for the files '" + options.*file + "' of several meshes");
    require((options.*file).find('/') == std::string::npos, "--output",
            "is a folder: '" + options.*file + "' goes behind the names of the meshes, and may not have a '/'");
  }
  const int threads = options.number_of_jobs();
  const auto is_given = [&command](const char* name) {
    const CLI::Option* option = command.get_option_no_throw(name);
    return option != nullptr && option->count() > 0;
  };
  if(threads > 1 && !is_given("--policy"))
    options.policy = "sequential"; // the other cores have meshes of their own
  const std::string sphere_folder = options.sphere;
  const std::map<std::string, std::string> spheres = spheres_in(sphere_folder);

  const auto of_item = [&](const Item& item) {
    Options one = options;
    one.input = item.mesh;
    if(!options.output.empty()) {
      const std::string name = options.output + '/' + item.name;
      one.output = name + (options.format.empty() ? mesh_command.extension : extension_of_format(options.format));
      for(const auto& [option, file] : mesh_command.more_files)
        if(!(one.*file).empty())
          one.*file = name + '.' + options.*file;
    }
    if(const auto sphere = spheres.find(item.name); sphere != spheres.end())
      one.sphere = sphere->second;
    else if(!sphere_folder.empty())
      one.sphere = sphere_folder + '/' + item.name + ".ply"; // which is missing
    return one;
  };
  const auto files = [](const std::vector<File_option>& all) {
    std::vector<std::string> names;
    for(const auto& [option, file] : all)
      if(!file.empty())
        names.push_back(file);
    return names;
  };
  const Collection collection = {
    options.output, settings_text(command),
    items_of(options, {{"--output", options.output}, {is_given("--sphere") ? "--sphere" : "SPHERE", options.sphere}}),
    [&](const Item& item) {
      const Options one = of_item(item);
      std::vector<std::string> inputs = files(mesh_command.inputs(one));
      inputs.erase(inputs.begin());
      return Job{inputs, files(mesh_command.outputs(one)), [&mesh_command, one] { return mesh_command.run_one(one); }};
    },
    threads};
  const Options first = of_item(collection.items.front());
  mesh_command.check(first);
  for(const auto& [option, file] : mesh_command.inputs(first))
    if(!file.empty() && file != first.input && file != first.sphere) // one for all meshes: without it none is done
      check_readable(file);
  return run_collection(collection);
}

/// Adds the command with IN, --list and --jobs, and runs it when it is called. Returns its options, for which others
/// may be added.
template <class Options>
std::shared_ptr<Options> add_mesh_command(CLI::App& command, const Mesh_command<Options>& mesh_command, int& exit_code)
{
  const auto options = std::make_shared<Options>();
  add_collection_options(command, *options);
  command.callback(
    [options, &command, &mesh_command, &exit_code] { exit_code = run_mesh_command(command, mesh_command, *options); });
  return options;
}

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_MESH_COMMAND_H
