// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "preparation/mend.h"

#include "preparation/points.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/exceptions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>

namespace CGAL::Spherical_parameterization::preparation {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Cgal_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Cgal_mesh::Vertex_index;
using Face = Cgal_mesh::Face_index;
using Halfedge = Cgal_mesh::Halfedge_index;

Kernel::Point_3 point_of(const Glued_surface& surface, int vertex)
{
  const auto& [x, y, z] = surface.point(vertex);
  return {x, y, z};
}

/// In CGAL's data structure, with the same numbers; none if it does not fit in.
std::optional<Cgal_mesh> to_cgal(const Glued_surface& surface)
{
  Cgal_mesh mesh;
  const auto vertex = [](int v) { return Vertex(static_cast<Cgal_mesh::size_type>(v)); };
  for(int v = 0; v < surface.number_of_vertices(); ++v)
    mesh.add_vertex(point_of(surface, v));
  for(const auto& [a, b, c] : surface.faces)
    if(mesh.add_face(vertex(a), vertex(b), vertex(c)) == Cgal_mesh::null_face())
      return std::nullopt;
  return mesh;
}

/// Vertices and faces as they are in `before`, by the numbers that `vertex_before` and `face_before` give.
template <class Vertex_number, class Face_number>
Glued_surface from_cgal(const Cgal_mesh& mesh, const Glued_surface& before, const Vertex_number& vertex_before,
                        const Face_number& face_before)
{
  Glued_surface surface;
  std::vector<int> number(mesh.num_vertices() + mesh.number_of_removed_vertices(), Glued_surface::none);
  for(const Vertex v : mesh.vertices()) {
    const Kernel::Point_3& p = mesh.point(v);
    number[v.idx()] = surface.add_vertex({p.x(), p.y(), p.z()});
    if(const int old = vertex_before[v]; old != Glued_surface::none)
      surface.old_vertex.back() = before.old_vertex[place(old)];
  }
  std::vector<int> side_of(mesh.num_halfedges() + 2 * mesh.number_of_removed_edges(), Glued_surface::none);
  for(const Face f : mesh.faces()) {
    const int old = face_before[f];
    Halfedge h = mesh.prev(mesh.halfedge(f)); // where the face begins
    std::array<int, 3> corners, corners_before;
    bool is_as_before = false;
    for(int turn = 0; turn < 3 && !is_as_before; ++turn) {
      h = mesh.next(h);
      for(std::size_t k = 0; k < 3; ++k, h = mesh.next(h)) {
        corners[k] = number[mesh.source(h).idx()];
        corners_before[k] = vertex_before[mesh.source(h)];
      }
      is_as_before = old != Glued_surface::none && corners_before == before.faces[place(old)];
    }
    const int face = surface.add_face(corners, is_as_before ? before.old_face[place(old)] : Glued_surface::none);
    for(int k = 0; k < 3; ++k, h = mesh.next(h)) {
      side_of[h.idx()] = 3 * face + k;
      if(const int other = side_of[mesh.opposite(h).idx()]; other != Glued_surface::none)
        surface.glue(3 * face + k, other);
    }
  }
  return surface;
}

/// What must not change: components, and holes and handles of each.
std::vector<std::tuple<int, int>> topology(const Glued_surface& surface)
{
  std::vector<int> unused;
  std::vector<std::tuple<int, int>> result;
  for(const Component& component : components(surface, unused))
    result.emplace_back(component.holes, component.euler_characteristic);
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace

std::vector<int> degenerate_faces(const Glued_surface& surface)
{
  std::vector<int> result;
  for(int f = 0; f < surface.number_of_faces(); ++f) {
    const auto& [a, b, c] = surface.faces[place(f)];
    if(CGAL::collinear(point_of(surface, a), point_of(surface, b), point_of(surface, c)))
      result.push_back(f);
  }
  return result;
}

bool remove_degenerate_faces(Glued_surface& surface)
{
  std::optional<Cgal_mesh> mesh = to_cgal(surface);
  if(!mesh)
    return false;
  auto vertex_before = mesh->add_property_map<Vertex, int>("v:before", Glued_surface::none).first;
  auto face_before = mesh->add_property_map<Face, int>("f:before", Glued_surface::none).first;
  for(const Vertex v : mesh->vertices())
    vertex_before[v] = static_cast<int>(v.idx());
  for(const Face f : mesh->faces())
    face_before[f] = static_cast<int>(f.idx());
  try {
    PMP::remove_degenerate_faces(*mesh);
  } catch(const CGAL::Failure_exception&) { // an assertion of CGAL that a case it does not know breaks
    return false;
  }
  Glued_surface result = from_cgal(*mesh, surface, vertex_before, face_before);
  if(topology(result) != topology(surface))
    return false;
  surface = std::move(result);
  return true;
}

} // namespace CGAL::Spherical_parameterization::preparation
