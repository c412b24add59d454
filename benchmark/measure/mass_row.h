// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef BENCHMARK_MASS_ROW_H
#define BENCHMARK_MASS_ROW_H

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace benchmark {

/// One map to be computed: of a mesh file, with a method and weights.
struct Mass_job {
  std::string mesh, method, weights;

  /// Unlike that of any other job.
  std::string name() const { return method + ' ' + weights + ' ' + mesh; }
};

/// The methods of the tool by name, and "balanced-3" for `Balanced{3}`.
const std::vector<std::string>& mass_methods();
const std::vector<std::string>& mass_weights();

/// All jobs, mesh by mesh. The isometric method, which has no weights, gets one per mesh.
std::vector<Mass_job> mass_jobs(const std::vector<std::string>& meshes, const std::vector<std::string>& methods,
                                const std::vector<std::string>& weights);

/// What became of a job.
struct Mass_row {
  Mass_job job;
  std::string outcome; ///< "OK" if the map is certified, and by an independent count of the flipped faces; else why not
  std::string method_used; ///< which of its methods the automatic one chose
  std::size_t vertices = 0, flipped_faces = 0;
  double cpu_seconds = 0; ///< of `parameterize()`
  /// \name Of certified maps
  /// @{
  double smallest_area = 0, smallest_edge = 0;                       ///< as in `Result`
  double symmetric_dirichlet = 0, spherical_symmetric_dirichlet = 0; ///< area-weighted means
  double log_area_deviation = 0, mean_angle_distortion = 0;
  /// @}
  std::string message; ///< one line

  bool is_certified() const { return outcome == "OK"; }
};

/// Computes the map on this thread. Nothing is thrown. None if it was interrupted: `go_on` is asked again and again.
std::optional<Mass_row> compute_mass_row(const Mass_job& job, std::optional<double> time_limit,
                                         const std::function<bool()>& go_on);

/// \name Lines of a CSV file
/// @{
std::string mass_header();
std::string to_line(const Mass_row& row);
std::optional<Mass_row> mass_row(const std::string& line); ///< if it is complete
/// @}

} // namespace benchmark

#endif // BENCHMARK_MASS_ROW_H
