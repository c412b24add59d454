// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_COLLECTION_OPTIONS_H
#define SPHERICAL_PARAMETERIZATION_TOOL_COLLECTION_OPTIONS_H

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace tool {

/// Which meshes a command works on, and how many of them at the same time.
struct Collection_options {
  std::vector<std::string> inputs;
  std::string list;
  std::optional<int> jobs;

  /// That of a command that takes one mesh or many: whether there are many, or one whose output goes to a folder.
  bool are_many(const std::string& output) const;

  /// Each once, folders replaced by the mesh files in them and in their subfolders. Throws a `Refusal`, also if there
  /// is none.
  std::vector<std::string> meshes() const;

  /// All cores if it was not given.
  int number_of_jobs() const;
};

/// IN, --list and --jobs.
void add_collection_options(CLI::App& command, Collection_options& options);

/// Throws if there is neither IN nor --list, which is wrong usage.
void check_collection_options(const Collection_options& options);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_COLLECTION_OPTIONS_H
