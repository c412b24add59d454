// SPDX-License-Identifier: GPL-3.0-or-later
// parameterize() on the meshes of the tests, compiled once.

#ifndef TEST_HELPERS_SOLVE_H
#define TEST_HELPERS_SOLVE_H

#include "helpers/certificate.h"
#include "helpers/policies.h"
#include "helpers/soup.h"

#include <CGAL/Spherical_parameterization/values/Result.h>
#include <CGAL/Spherical_parameterization/values/methods.h>

#include <functional>
#include <map>
#include <variant>
#include <vector>

namespace test {

namespace SP = CGAL::Spherical_parameterization;
using SP::Error_code;
using SP::Result;
using Splitting = SP::Saddle_point::Splitting;

/// The arguments and the named parameters of `parameterize()`, all of them.
struct Settings {
  Policy policy = default_policy();
  std::variant<SP::Balanced, SP::Saddle_point, SP::Isometric, SP::Automatic> method = SP::Balanced();
  Weights weights = Weights::CLAMPED; ///< springs that the checks know: those of the default are no edges of the mesh
  /// weights that differ from those of `weights`, which are not conformal, by the number of the edge
  std::map<std::size_t, double> weight_of_edge = {};
  double accuracy = SP::Balanced::default_accuracy;
  std::size_t number_of_iterations = SP::Balanced::default_number_of_iterations;
  double maximum_running_time = 1e9;
  std::function<bool(double)> callback = [](double) { return true; };
  /// fixed vertices and where they stay
  std::map<std::size_t, Point> fixed = {};
  /// one number for each, or none
  std::vector<double> vertex_density = {}, face_density = {};
};

/// What `sphere` holds on entry is what the sphere map holds on entry, where it has the right size.
Result solve(const Mesh& mesh, Sphere& sphere, const Settings& settings = {});
Result solve(const Soup& soup, Sphere& sphere, const Settings& settings = {});

/// The map of a mesh for which there has to be one: throws if the result is not OK.
Sphere solve_or_throw(const Soup& soup, const Settings& settings = {});

} // namespace test

#endif // TEST_HELPERS_SOLVE_H
