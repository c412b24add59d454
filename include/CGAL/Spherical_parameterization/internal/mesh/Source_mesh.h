// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_SOURCE_MESH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_SOURCE_MESH_H

#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/base/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/mesh/Vertex_numbering.h>
#include <CGAL/Spherical_parameterization/internal/mesh/breadth_first_numbering.h>
#include <CGAL/Spherical_parameterization/internal/mesh/check_face_graph.h>
#include <CGAL/Spherical_parameterization/internal/mesh/read_edge_weights.h>
#include <CGAL/Spherical_parameterization/internal/mesh/source_geometry.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <memory>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// A face graph as arrays, checked to be a closed, connected triangle mesh of genus 0 with finite points.
///
/// Vertices are renumbered in breadth-first order: neighbours then lie close together in memory, which more than halves
/// the time of every sweep on large meshes, whatever the order of the input.
template <class TriangleMesh>
class Source_mesh {
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;

public:
  std::vector<vertex_descriptor> vertex; ///< descriptor of vertex i, in breadth-first order
  Host_array<int> position;              ///< position of vertex i in vertices(mesh), for messages
  Host_array<vec3> point;
  Host_array<std::array<int, 3>> face; ///< in the order of faces(mesh)
  Host_array<double> area;             ///< every vertex's third of the areas of its faces
  std::shared_ptr<Weighted_graph> graph =
    std::make_shared<Weighted_graph>(); ///< neighbours in ascending order; weights are left to set_weights()
  double weight_unit = 1;               ///< what a weight of 1 in the graph is to the caller

  /// Throws Error.
  template <class VertexPointMap, class Loop = Host_loop>
  Source_mesh(const TriangleMesh& mesh, VertexPointMap points, const Loop& loop = Loop())
  {
    check_size(mesh);
    const Vertex_numbering<TriangleMesh> numbering(mesh);
    const std::vector<face_descriptor> face_descriptors(faces(mesh).begin(), faces(mesh).end());
    const std::vector<vertex_descriptor> vertex_descriptors(vertices(mesh).begin(), vertices(mesh).end());
    Neighbours neighbours;
    if(!are_triangles(mesh, face_descriptors, loop) ||
       !read_neighbours(mesh, numbering, vertex_descriptors, face_descriptors.size(), loop, neighbours))
      explain_what_is_wrong(mesh, numbering);
    const Host_array<int> index = number_breadth_first(neighbours, position);
    check_topology(position.size(), face_descriptors.size());
    vertex.reserve(position.size());
    for(int p : position)
      vertex.push_back(vertex_descriptors[p]);
    point = read_points(loop, vertex, position, points);
    scale_to_unit_box(point);
    face.resize(face_descriptors.size());
    for_each_part(loop, static_cast<int>(face.size()), [&](int begin, int end) {
      for(int f = begin; f < end; ++f) {
        const halfedge_descriptor h = halfedge(face_descriptors[f], mesh);
        face[f] = {index[numbering(source(h, mesh))], index[numbering(target(h, mesh))],
                   index[numbering(target(next(h, mesh), mesh))]};
      }
    });
    area = vertex_areas(loop, face, point);
    renumber(loop, neighbours, index, position, *graph);
  }

  /// Reads the weights of the edges. Throws Error.
  template <class EdgeWeightMap, class Loop>
  void set_weights(const TriangleMesh& mesh, EdgeWeightMap weights, const Loop& loop)
  {
    const Edge_weight_reader<TriangleMesh> read(mesh, vertex, position, point);
    weight_unit = read(loop, weights, *graph);
  }
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_SOURCE_MESH_H
