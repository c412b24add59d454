// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "options/collection_options.h"

#include "input/files.h"
#include "system/refusal.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <thread>

namespace tool {

bool Collection_options::are_many(const std::string& output) const
{
  std::error_code none; // of a file that does not exist
  return inputs.size() != 1 || !list.empty() || std::filesystem::is_directory(inputs.front(), none) ||
         (!output.empty() && output.back() == '/');
}

std::vector<std::string> Collection_options::meshes() const
{
  std::vector<std::string> files = list_meshes(inputs, list);
  if(files.empty())
    throw Refusal(unreadable_file, inputs.empty() ? list : inputs.front(), "has no mesh file",
                  std::string("meshes are read from ") + mesh_extensions + " files");
  return files;
}

int Collection_options::number_of_jobs() const
{
  return jobs.value_or(static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
}

void add_collection_options(CLI::App& command, Collection_options& options)
{
  command
    .add_option("IN", options.inputs,
                std::string("Closed triangle meshes of genus 0 (") + mesh_extensions + "), or folders of them")
    ->type_name("FILE|FOLDER");
  command.add_option("--list", options.list, "Text file with one more IN per line")->type_name("FILE");
  command.add_option("-j,--jobs", options.jobs, "Number of meshes to work on at the same time [all cores]")
    ->check(CLI::Range(1, 4096));
}

void check_collection_options(const Collection_options& options)
{
  if(options.inputs.empty() && options.list.empty())
    throw CLI::RequiredError("IN or --list");
}

} // namespace tool
