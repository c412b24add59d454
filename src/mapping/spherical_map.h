// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "input/mesh.h"
#include "options/mapping_options.h"

#include <CGAL/Spherical_parameterization/Any_policy.h>
#include <CGAL/Spherical_parameterization/values/Result.h>
#include <CGAL/Spherical_parameterization/values/methods.h>

#include <functional>
#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace tool {

/// What a map depends on besides the mesh and the options.
struct Map_data {
  SP::Any_policy policy;
  std::vector<Fixed_vertex> fixed_vertices;
  std::vector<double> density; ///< of every vertex, or of every face; empty: none
};

/// The policy. Looks for a device only if it is for the policy, since drivers take their time to start. Throws an
/// `OpenCL_error` if there is no such device. Can be called on any threads.
SP::Any_policy make_policy(const Mapping_options& options);

using Any_method = std::variant<SP::Balanced, SP::Saddle_point, SP::Isometric, SP::Automatic>;
Any_method method_of(const Mapping_options& options);

/// Does what `parameterize()` does: the one place where it is instantiated, and where names and numbers become types.
/// `go_on` is told the fraction of the work done, and stops it by returning `false`; from its first call on the
/// neighbours of the mesh are not needed any more. `sphere` gets the size that it needs.
SP::Result map_to_sphere(const Mesh& mesh, Sphere& sphere, const Mapping_options& options, const Map_data& data,
                         const std::function<bool(double)>& go_on);

/// Sizes and certificate of a map, with the cores of the policy, by exact predicates on the points as they are: these
/// need not be unit vectors, the map is their projection from the origin. Flipped faces are an error of the result.
SP::Result certify(const SP::Any_policy& policy, const Mesh& mesh, const std::vector<Point>& points);

/// The direction of a point that is not the origin. A unit vector up to rounding is not changed: where the sphere is
/// dense, every bit counts. Points with fewer digits are normalized, and those of a sphere of radius 100, as
/// neuroimaging programs have it.
Point on_unit_sphere(Point p);

/// A sphere about the origin, of any radius.
struct Given_sphere {
  std::vector<Point> points; ///< as they are in the file
  Sphere on_unit_sphere;
  double smallest_radius = std::numeric_limits<double>::infinity(); ///< of a point
  double largest_radius = 0;
};

/// Reads a sphere of `mesh`, which was read from `mesh_file`. Throws a `Refusal` if the file has not the same vertices
/// and faces in the same order, or a point without direction.
Given_sphere read_given_sphere(const std::string& file, const std::string& mesh_file, const Mesh& mesh);

/// Reads the map of `mesh`, which was read from `mesh_file`, from a file as `map` writes it, and certifies it again.
/// Returns sizes and certificate: flipped faces are an error of the result. Throws a `Refusal` if the file has not the
/// same vertices and faces in the same order, or a point that is not on the unit sphere.
SP::Result read_sphere(const SP::Any_policy& policy, const std::string& file, const std::string& mesh_file,
                       const Mesh& mesh, Sphere& sphere);

} // namespace tool
