// SPDX-License-Identifier: GPL-3.0-or-later

#include "mapping/spherical_map.h"

#include "system/refusal.h"
#include "system/stopwatch.h"

#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <tuple>

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
    throw Refusal(not_the_sphere, file, wrong, "give the sphere that 'map' has written for this mesh");
  };
  const auto compare = [&](std::size_t count, std::size_t expected, const std::string& what) {
    if(count != expected)
      refuse("has " + std::to_string(count) + ' ' + what + ", and " + mesh_file + " has " + std::to_string(expected));
  };
  compare(sphere.number_of_vertices(), mesh.number_of_vertices(), "vertices");
  compare(sphere.number_of_faces(), mesh.number_of_faces(), "faces");
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    if(corners(sphere, f) != corners(mesh, f))
      refuse("face " + std::to_string(f) + " (counted from 0) does not have the same vertices as in " + mesh_file);
}

} // namespace

Point on_unit_sphere(Point p)
{
  if(const double radius = std::hypot(p[0], p[1], p[2]); radius > 50 && radius < 200) // about 100
    for(double& x : p)
      x /= 100;
  const double length = std::hypot(p[0], p[1], p[2]);
  if(std::abs(length - 1) <= 4 * std::numeric_limits<double>::epsilon())
    return p;
  return {p[0] / length, p[1] / length, p[2] / length};
}

SP::Result certify(const SP::Any_policy& policy, const Mesh& mesh, const std::vector<Point>& points)
{
  SP::Result result;
  result.number_of_vertices = mesh.number_of_vertices();
  result.number_of_faces = mesh.number_of_faces();
  std::tie(result.flipped_faces, result.degree) =
    std::visit([&](const auto& chosen) { return SP::certify_map(chosen, mesh, as_map(points)); }, policy);
  if(result.flipped_faces > 0 || result.degree != 1) {
    result.error = SP::Error_code::NOT_BIJECTIVE;
    result.detail =
      std::to_string(result.flipped_faces) + " faces are flipped, the degree is " + std::to_string(result.degree);
  }
  return result;
}

Given_sphere read_given_sphere(const std::string& file, const std::string& mesh_file, const Mesh& mesh)
{
  const Mesh read = read_mesh(file).mesh;
  check_same_faces(file, mesh_file, read, mesh);
  Given_sphere sphere;
  sphere.points = read.points();
  for(const Point& p : sphere.points) {
    const double radius = std::hypot(p[0], p[1], p[2]);
    if(!(radius > std::numeric_limits<double>::min() && radius < std::numeric_limits<double>::infinity()))
      throw Refusal(not_the_sphere, file,
                    "vertex " + std::to_string(&p - sphere.points.data()) +
                      " (counted from 0) is at the origin, or farther away than numbers reach",
                    "the centre of the sphere must be the origin");
    sphere.smallest_radius = std::min(sphere.smallest_radius, radius);
    sphere.largest_radius = std::max(sphere.largest_radius, radius);
    sphere.on_unit_sphere.push_back(on_unit_sphere(p));
  }
  return sphere;
}

SP::Result read_sphere(const SP::Any_policy& policy, const std::string& file, const std::string& mesh_file,
                       const Mesh& mesh, Sphere& sphere)
{
  const Given_sphere given = read_given_sphere(file, mesh_file, mesh);
  constexpr double most_uneven = 1.05; // there are spheres of few digits, and not quite centred ones
  if(given.largest_radius > most_uneven * given.smallest_radius) {
    std::ostringstream distances;
    distances.precision(3);
    distances << given.smallest_radius << " to " << given.largest_radius;
    throw Refusal(not_the_sphere, file,
                  "is no sphere round the origin: points are at distances from " + distances.str(),
                  "give a sphere that 'map' has written");
  }
  sphere = given.on_unit_sphere;
  const Stopwatch certifying;
  auto result = certify(policy, mesh, sphere);
  result.seconds.certify = certifying.seconds();
  if(result.degree == -1)
    result.detail += "; it is a mirror image: negate one coordinate of the sphere, or reverse the faces of both";
  else if(!result && certify(policy, mesh, given.points))
    result.detail += " where its points are rounded to unit vectors; map the mesh again";
  else if(!result)
    result.detail += "; map the mesh again, and keep all digits";
  return result;
}

} // namespace tool
