// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef BENCHMARK_OPTIONS_H
#define BENCHMARK_OPTIONS_H

#include "measure/backend.h"

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace benchmark {

/// What all commands understand.
struct Options {
  std::string output = "benchmark_results";
  int repetitions = 3;
  std::vector<std::string> backend_names; ///< empty: all
  std::vector<std::string> meshes;        ///< files and folders

  /// Throws std::runtime_error if one is not available.
  std::vector<Backend> backends() const { return backends_by_name(backend_names); }
  /// The files, and all mesh files of the folders. Throws std::runtime_error where there are none.
  std::vector<std::filesystem::path> mesh_files() const;
};

void add_output_option(CLI::App& command, Options& options);
void add_all_options(CLI::App& command, Options& options);
void add_subdivide_option(CLI::App& command, int& subdivisions, const char* description);
void add_time_limit_option(CLI::App& command, double& seconds, const char* description);

} // namespace benchmark

#endif // BENCHMARK_OPTIONS_H
