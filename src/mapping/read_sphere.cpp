// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "mapping/spherical_map.h"

#include "input/mesh.h"
#include "system/refusal.h"

#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace tool {
namespace {

/// The vertices of a face, beginning with the smallest: files may begin with any corner.
std::array<int, 3> corners(const Mesh& mesh, std::size_t f)
{
  std::array<int, 3> corners = mesh.triangle(f);
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

void check_same_faces(const std::string& file, const std::string& mesh_file, const Mesh& sphere, const Mesh& mesh)
{
  const auto refuse = [&](const std::string& wrong) {
    throw Refusal("NOT_THE_SPHERE", file, wrong, "give the sphere that 'map' has written for this mesh");
  };
  const auto compare = [&](std::size_t count, std::size_t expected, const std::string& what) {
    if(count != expected)
      refuse("has " + std::to_string(count) + ' ' + what + ", and " + mesh_file + " has " + std::to_string(expected));
  };
  compare(sphere.number_of_vertices(), mesh.number_of_vertices(), "vertices");
  compare(sphere.number_of_faces(), mesh.number_of_faces(), "faces");
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    if(corners(sphere, f) != corners(mesh, f))
      refuse("face " + std::to_string(f) + " (counted from 0) has other vertices than in " + mesh_file);
}

/// A unit vector up to rounding is not changed: where the sphere is dense, every bit counts. Points with fewer digits
/// are normalized.
Point on_unit_sphere(const std::string& file, const Point& p, std::size_t index)
{
  const double length = std::hypot(p[0], p[1], p[2]);
  if(!(length > 0.5 && length < 2))
    throw Refusal("NOT_THE_SPHERE", file,
                  "vertex " + std::to_string(index) + " (counted from 0) is not on the unit sphere",
                  "give a sphere that 'map' has written");
  if(std::abs(length - 1) <= 4 * std::numeric_limits<double>::epsilon())
    return p;
  return {p[0] / length, p[1] / length, p[2] / length};
}

} // namespace

CGAL::Spherical_parameterization::Result read_sphere(const std::string& file, const std::string& mesh_file,
                                                     const Mesh& mesh, Sphere& sphere)
{
  namespace SP = CGAL::Spherical_parameterization;
  const Mesh read = read_mesh(file).mesh;
  check_same_faces(file, mesh_file, read, mesh);
  sphere.clear();
  for(const Point& p : read.points())
    sphere.push_back(on_unit_sphere(file, p, sphere.size()));

  SP::Result result;
  result.number_of_vertices = mesh.number_of_vertices();
  result.number_of_faces = mesh.number_of_faces();
  result.flipped_faces = SP::number_of_flipped_faces(mesh, as_map(sphere));
  result.degree = SP::degree_of_map(mesh, as_map(sphere));
  if(result.flipped_faces > 0 || result.degree != 1) {
    result.error = SP::Error_code::NOT_BIJECTIVE;
    result.detail = std::to_string(result.flipped_faces) + " faces are flipped, the degree is " +
                    std::to_string(result.degree) + "; map the mesh again, and keep all 17 digits";
  }
  return result;
}

} // namespace tool
