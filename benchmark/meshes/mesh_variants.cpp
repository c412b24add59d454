// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "meshes/mesh.h"

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Random.h>

namespace benchmark {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

double mean_edge_length(const Mesh& mesh)
{
  double sum = 0;
  for(auto e : mesh.edges())
    sum += PMP::edge_length(mesh.halfedge(e), mesh);
  return sum / mesh.number_of_edges();
}

Mesh remeshed(Mesh mesh, double relative_edge_length)
{
  PMP::isotropic_remeshing(mesh.faces(), relative_edge_length * mean_edge_length(mesh), mesh,
                           CGAL::parameters::number_of_iterations(5));
  mesh.collect_garbage();
  return mesh;
}

/// Every vertex along its normal, by up to so many mean edge lengths.
Mesh noisy(const Mesh& mesh, double amplitude)
{
  Mesh copy = mesh;
  CGAL::Random random(0);
  const double length = amplitude * mean_edge_length(mesh);
  for(auto v : mesh.vertices()) {
    const auto normal = PMP::compute_vertex_normal(v, mesh);
    copy.point(v) = mesh.point(v) + random.get_double(-length, length) * normal;
  }
  return copy;
}

} // namespace

std::vector<Mesh_variant> mesh_variants()
{
  return {{"remeshed, edges x 1", [](const Mesh& mesh) { return remeshed(mesh, 1); }},
          {"remeshed, edges x 2", [](const Mesh& mesh) { return remeshed(mesh, 2); }},
          {"decimated to 50 %", [](const Mesh& mesh) { return decimated(mesh, .5); }},
          {"decimated to 20 %", [](const Mesh& mesh) { return decimated(mesh, .2); }},
          {"decimated to 5 %", [](const Mesh& mesh) { return decimated(mesh, .05); }},
          {"subdivided",
           [](Mesh mesh) {
             subdivide(mesh);
             return mesh;
           }},
          {"noise 5 %", [](const Mesh& mesh) { return noisy(mesh, .05); }},
          {"noise 20 %", [](const Mesh& mesh) { return noisy(mesh, .2); }}};
}

} // namespace benchmark
