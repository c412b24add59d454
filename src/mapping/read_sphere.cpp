// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "mapping/read_sphere.h"

#include "mapping/mapped_mesh.h"
#include "input/refusal.h"

#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace tool {
namespace {

/// The vertices of a face from the smallest one on: files may list them from any corner on.
std::array<Mesh::Vertex_index, 3> corners(const Mesh& mesh, Mesh::Face_index f)
{
  std::array<Mesh::Vertex_index, 3> corners;
  std::size_t k = 0;
  for(const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
    corners[k++] = v;
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
  for(const Mesh::Face_index f : mesh.faces())
    if(corners(sphere, f) != corners(mesh, f))
      refuse("face " + std::to_string(f.idx()) + " (from 0 on) has other vertices than in " + mesh_file);
}

/// What is a unit vector up to rounding stays as it is: in tight limbs every bit counts. Files of few digits are
/// brought back to the sphere.
Point on_unit_sphere(const std::string& file, const Point& p, std::size_t index)
{
  const double length = std::hypot(p.x(), p.y(), p.z());
  if(!(length > 0.5 && length < 2))
    throw Refusal("NOT_THE_SPHERE", file, "vertex " + std::to_string(index) + " (from 0 on) is not on the unit sphere",
                  "give a sphere that 'map' has written");
  if(std::abs(length - 1) <= 4 * std::numeric_limits<double>::epsilon())
    return p;
  return Point(p.x() / length, p.y() / length, p.z() / length);
}

} // namespace

void read_sphere(const std::string& file, const std::string& mesh_file, Mapped_mesh& input)
{
  namespace SP = CGAL::Spherical_parameterization;
  const Mesh sphere = read_mesh(file).mesh;
  check_same_faces(file, mesh_file, sphere, input.mesh);
  for(const Mesh::Vertex_index v : input.mesh.vertices())
    input.sphere[v] = on_unit_sphere(file, sphere.point(v), v.idx());

  SP::Result& result = input.result;
  result.flipped_faces = SP::number_of_flipped_faces(input.mesh, input.sphere);
  result.degree = SP::degree_of_map(input.mesh, input.sphere);
  if(result.flipped_faces > 0 || result.degree != 1) {
    result.error = SP::Error_code::NOT_BIJECTIVE;
    result.detail = std::to_string(result.flipped_faces) + " faces are flipped, the degree is " +
                    std::to_string(result.degree) + "; map the mesh again, and keep all 17 digits";
  }
}

} // namespace tool
