// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef BENCHMARK_MESH_H
#define BENCHMARK_MESH_H

#include "input/files.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace benchmark {

using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Vector_3 = CGAL::Simple_cartesian<double>::Vector_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Sphere_map = Mesh::Property_map<Mesh::Vertex_index, Point_3>;

/// Throws std::runtime_error.
Mesh read_mesh(const std::filesystem::path& file);

/// The property map that spheres are written to.
inline Sphere_map sphere_map(Mesh& mesh)
{
  return mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
}

/// Reads a mesh and calls `f` with it and its sphere map. What is wrong is thrown with the name of the file in front.
template <class F>
void with_mesh(const std::filesystem::path& file, F f)
try {
  Mesh mesh = read_mesh(file);
  f(mesh, sphere_map(mesh));
} catch(const std::runtime_error& error) {
  throw std::runtime_error(file.string() + ": " + error.what());
}

/// Calls `f` with the name of every model, its mesh and its sphere map.
template <class F>
void for_each_mesh(const std::vector<std::string>& files_and_folders, F f)
{
  const std::vector<std::string> files = tool::list_meshes(files_and_folders);
  if(files.empty())
    throw std::runtime_error("there is no mesh file in these folders");
  for(const std::filesystem::path file : files)
    with_mesh(file, [&](Mesh& mesh, Sphere_map sphere) { f(file.stem().string(), mesh, sphere); });
}

/// Every triangle into four, so many times, with the new points on the middle of the edges: the shape stays what it is.
void subdivide(Mesh& mesh, int times = 1);

/// Collapses edges until so many of them are left.
Mesh decimated(Mesh mesh, double share_of_edges);

/// "armadillo", and "armadillo/2" after two subdivisions
inline std::string level_name(const std::string& model, int subdivisions)
{
  return subdivisions > 0 ? model + '/' + std::to_string(subdivisions) : model;
}

/// The corners of a face, on the mesh or on the sphere.
inline std::array<Point_3, 3> corners(const Mesh& mesh, Sphere_map points, Mesh::Face_index f)
{
  const auto h = mesh.halfedge(f);
  return {points[mesh.source(h)], points[mesh.target(h)], points[mesh.target(mesh.next(h))]};
}

inline Point_3 normalized(const Vector_3& v) { return CGAL::ORIGIN + v / std::sqrt(v.squared_length()); }

/// The same shape by other triangles, or nearly the same.
struct Mesh_variant {
  std::string name;
  std::function<Mesh(const Mesh&)> make;
};

/// Remeshed, decimated, subdivided, with noise.
std::vector<Mesh_variant> mesh_variants();

} // namespace benchmark

#endif // BENCHMARK_MESH_H
