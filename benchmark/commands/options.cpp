// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/options.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace benchmark {

namespace fs = std::filesystem;

std::vector<fs::path> Options::mesh_files() const
{
  static const std::set<std::string> extensions = {".off", ".obj", ".ply", ".stl"};
  std::vector<fs::path> files;
  for(const std::string& name : meshes)
    if(fs::is_directory(name)) {
      std::vector<fs::path> found;
      for(const fs::directory_entry& entry : fs::directory_iterator(name))
        if(extensions.count(entry.path().extension().string()) > 0)
          found.push_back(entry.path());
      if(found.empty())
        throw std::runtime_error(name + ": no mesh file in this folder");
      std::sort(found.begin(), found.end());
      files.insert(files.end(), found.begin(), found.end());
    } else
      files.emplace_back(name);
  return files;
}

void add_output_option(CLI::App& command, Options& options)
{
  command.add_option("-o,--output", options.output, "Folder for the Markdown and CSV files")->capture_default_str();
}

void add_all_options(CLI::App& command, Options& options)
{
  add_output_option(command, options);
  command.add_option("--repetitions", options.repetitions, "Of every map; the median is shown")
    ->check(CLI::PositiveNumber)
    ->capture_default_str();
  command.add_option("--backend", options.backend_names, "sequential, tbb, opencl; default: all that are available")
    ->delimiter(',')
    ->allow_extra_args(false);
  command.add_option("meshes", options.meshes, "Closed triangle meshes of genus 0, or folders of them")
    ->required()
    ->check(CLI::ExistingPath);
}

void add_subdivide_option(CLI::App& command, int& subdivisions, const char* description)
{
  command.add_option("--subdivide", subdivisions, description)->check(CLI::Range(0, 12))->capture_default_str();
}

void add_time_limit_option(CLI::App& command, double& seconds, const char* description)
{
  command.add_option("--time-limit", seconds, description)->check(CLI::PositiveNumber)->capture_default_str();
}

} // namespace benchmark
