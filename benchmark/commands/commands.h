// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef BENCHMARK_COMMANDS_H
#define BENCHMARK_COMMANDS_H

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <thread>
#include <vector>

namespace benchmark {

/// What a command may be told. Each uses a part of it: main.cpp says which.
struct Options {
  std::string output = "benchmark_results";
  std::vector<std::string> meshes;   ///< files and folders
  std::string folder;                ///< of shapes
  std::vector<std::string> backends; ///< empty: all
  int repetitions = 3;
  int subdivisions = 0;
  double time_limit = std::numeric_limits<double>::infinity(); ///< seconds for a map
  std::size_t maximum_vertices = 500000;                       ///< scaling
  std::size_t queries = 1000000;                               ///< locate
  std::size_t rows = 1000000;                                  ///< index
  int rotations = 100;                                         ///< rotations
  bool skips_sdf = false;                                      ///< segmentation
  std::vector<std::string> variants_of;                        ///< retrieval: groups
  std::string order;                                           ///< sweep
  /// \name mass
  /// @{
  std::vector<std::string> methods = {"balanced", "balanced-3", "isometric", "automatic", "saddle-point"};
  std::vector<std::string> weights = {"conformal", "barycentric", "mean-value"};
  std::string list;
  int jobs = static_cast<int>((std::max)(1u, std::thread::hardware_concurrency()));
  /// @}
};

// What the tables are, and how they are measured, is in README.md. All throw std::runtime_error.
void tabulate_models(const Options& options);
void tabulate_levels(const Options& options);
void tabulate_backends(const Options& options);
void tabulate_published(const Options& options);
void tabulate_order(const Options& options);
void run_sweeps(const Options& options); ///< what `order` runs under cachegrind
void tabulate_scaling(const Options& options);
void tabulate_checks(const Options& options);
void tabulate_texture(const Options& options);
void tabulate_locate(const Options& options);
void tabulate_rotations(const Options& options);
void tabulate_mass(const Options& options);
void tabulate_foreign(const Options& options);
void tabulate_retrieval(const Options& options);
void tabulate_segmentation(const Options& options);
void tabulate_index(const Options& options);

} // namespace benchmark

#endif // BENCHMARK_COMMANDS_H
