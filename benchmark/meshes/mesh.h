// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef BENCHMARK_MESH_H
#define BENCHMARK_MESH_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spherical_parameterization/edge_weights.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace benchmark {

using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Sphere_map = Mesh::Property_map<Mesh::Vertex_index, Point_3>;

/// Throws std::runtime_error.
Mesh read_mesh(const std::filesystem::path& file);

/// Reads a mesh and calls `f` with it. What is wrong with either is thrown with the name of the file in front.
template <class F>
void with_mesh(const std::filesystem::path& file, F f)
try {
  Mesh mesh = read_mesh(file);
  f(mesh);
} catch(const std::runtime_error& error) {
  throw std::runtime_error(file.string() + ": " + error.what());
}

/// The property map that spheres are written to.
inline Sphere_map sphere_map(Mesh& mesh)
{
  return mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
}

/// Every triangle into four, with the new points on the middle of the edges: the shape stays what it is.
void subdivide(Mesh& mesh);

/// "armadillo", and "armadillo/2" after two subdivisions
std::string model_name(const std::filesystem::path& file, int subdivisions = 0);

/// The two weights of the paper.
enum class Weights { BARYCENTRIC, CONFORMAL };
constexpr std::array<Weights, 2> both_weights = {Weights::BARYCENTRIC, Weights::CONFORMAL};
inline const char* name(Weights weights) { return weights == Weights::BARYCENTRIC ? "barycentric" : "conformal"; }

/// Calls `f` with the weight map, and returns what it does.
template <class F>
auto visit_weights(Weights weights, const Mesh& mesh, F f)
{
  return weights == Weights::BARYCENTRIC ? f(CGAL::Spherical_parameterization::barycentric_weights(mesh))
                                         : f(CGAL::Spherical_parameterization::conformal_weights(mesh));
}

} // namespace benchmark

#endif // BENCHMARK_MESH_H
