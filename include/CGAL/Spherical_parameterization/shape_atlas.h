// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SHAPE_ATLAS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SHAPE_ATLAS_H

#include <CGAL/Spherical_parameterization/Indexed_triangle_mesh.h>
#include <CGAL/Spherical_parameterization/register_maps.h>
#include <CGAL/Spherical_parameterization/resample.h>
#include <CGAL/Spherical_parameterization/shape_statistics.h>
#include <CGAL/Spherical_parameterization/transfer_properties.h>
#include <CGAL/Spherical_parameterization/internal/algebra/point_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_numbering.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationStatistics
/// @{

/// What is removed before the shapes of an atlas are compared.
enum class Atlas_placement {
  AS_THEY_STAND, ///< nothing
  CENTRED,       ///< translations: centres are moved to the origin
  RIGID,         ///< rotations, too
  SIMILARITY     ///< sizes, too
};

/// The vertices and faces of all shapes of an atlas, and the directions of the vertices on the sphere.
struct Atlas_mesh {
  Indexed_triangle_mesh mesh;                    ///< its points are not used
  std::vector<std::array<double, 3>> directions; ///< of the vertices
};

/// \param level  of the icosphere
/// \return an icosphere with its own vertices as directions
CGAL_SP_INLINE Atlas_mesh icosphere_of_atlas(int level)
{
  std::vector<std::array<double, 3>> directions;
  std::vector<std::array<int, 3>> triangles;
  make_icosphere_soup(level, directions, triangles);
  return {Indexed_triangle_mesh(directions, triangles), directions};
}

/// \cond SKIP_IN_MANUAL
namespace internal {
/// What is stored by the position of a vertex in vertices(mesh).
template <class TriangleMesh, class Values>
auto by_vertex(const Vertex_numbering<TriangleMesh>& number, Values& values)
{
  return boost::make_function_property_map<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>([&](auto v)
                                                                                                            -> auto& {
    return values[static_cast<std::size_t>(number(v))];
  });
}

/// The same of an atlas, which has numbers for vertices.
template <class Values>
auto by_vertex(Values& values)
{
  typedef Indexed_triangle_mesh::Vertex_index Vertex;
  return boost::make_function_property_map<Vertex>([&](Vertex v) -> auto& {
    return values[static_cast<std::size_t>(v.idx())];
  });
}
} // namespace internal
/// \endcond

/// The shape of a mesh at the vertices of an atlas.
/// \param policy  `CGAL::Sequential_tag`, the default, or `CGAL::Parallel_tag`; the result does not depend on it
/// \param shape   the mesh, with a map that was registered to the template
/// \param atlas   the vertices to sample at
/// \return the points, by vertex of the atlas
/// \throws Error if the map is not valid
template <class ExecutionPolicy, class TriangleMesh, class SphereMap, class PointMap,
          internal::If_policy<ExecutionPolicy> = 0>
Shape_points shape_at(const ExecutionPolicy& policy, const Mapped_mesh<TriangleMesh, SphereMap, PointMap>& shape,
                      const Atlas_mesh& atlas)
{
  Shape_points points(atlas.directions.size());
  const Spherical_locator<TriangleMesh> inverse(policy, shape.mesh, shape.sphere_map);
  const auto point = boost::make_function_property_map<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>(
    [&](auto v) { return internal::array_of(internal::coordinates(get(shape.points, v))); });
  transfer_vertex_property(policy, inverse, point, atlas.mesh, internal::by_vertex(atlas.directions),
                           internal::by_vertex(points));
  return points;
}
CGAL_SP_ON_ONE_CORE(shape_at)

namespace internal {

/// What vertices count: their areas, mean over the shapes; where sizes do not count, the shares of the areas of each.
template <class ExecutionPolicy, class NamedParameters>
std::vector<double> weights_of_atlas(const ExecutionPolicy& policy, const Atlas_mesh& atlas,
                                     const std::vector<Shape_points>& shapes, Atlas_placement placement,
                                     const NamedParameters& np)
{
  return vertex_weights_of_shapes(policy, atlas.mesh, shapes, placement == Atlas_placement::SIMILARITY, np);
}

template <class ExecutionPolicy, class NamedParameters>
Procrustes_alignment align_atlas(const ExecutionPolicy& policy, std::vector<Shape_points>& shapes,
                                 const std::vector<double>& weights, Atlas_placement placement,
                                 const NamedParameters& np)
{
  if(placement == Atlas_placement::AS_THEY_STAND)
    return {};
  Procrustes method;
  method.rotate = placement != Atlas_placement::CENTRED;
  method.scale = placement == Atlas_placement::SIMILARITY;
  return align_shapes(policy, shapes, method, weights, np);
}

} // namespace internal

/// Aligns the shapes of an atlas; vertices are weighted by their areas, mean over the shapes (of `SIMILARITY`: by their
/// shares of the area of each).
/// \param policy     as above
/// \param atlas      the atlas of the shapes
/// \param shapes     moved in place
/// \param placement  what is removed
/// \param np         see \ref pd_calls
/// \return the motions; none if the shapes are not moved
template <class ExecutionPolicy, class CGAL_NP_TEMPLATE_PARAMETERS, internal::If_policy<ExecutionPolicy> = 0>
Procrustes_alignment place_shapes(const ExecutionPolicy& policy, const Atlas_mesh& atlas,
                                  std::vector<Shape_points>& shapes, Atlas_placement placement,
                                  const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::align_atlas(policy, shapes, internal::weights_of_atlas(policy, atlas, shapes, placement, np),
                               placement, np);
}
CGAL_SP_ON_ONE_CORE(place_shapes)

/// The template of the next round: the mean of the aligned shapes.
/// \param policy,atlas,placement,np  as above
/// \param shapes  the shapes; a copy is moved
/// \return the points, by vertex of the atlas
template <class ExecutionPolicy, class CGAL_NP_TEMPLATE_PARAMETERS, internal::If_policy<ExecutionPolicy> = 0>
Shape_points mean_shape(const ExecutionPolicy& policy, const Atlas_mesh& atlas, std::vector<Shape_points> shapes,
                        Atlas_placement placement, const CGAL_NP_CLASS& np = parameters::default_values())
{
  place_shapes(policy, atlas, shapes, placement, np);
  Shape_points mean(num_vertices(atlas.mesh), {0, 0, 0});
  for(const Shape_points& shape : shapes)
    for(std::size_t v = 0; v < mean.size(); ++v)
      for(std::size_t c = 0; c < 3; ++c)
        mean[v][c] += shape[v][c] / static_cast<double>(shapes.size());
  return mean;
}
CGAL_SP_ON_ONE_CORE(mean_shape)

/// Mean and modes of shapes.
struct Atlas_statistics {
  Procrustes_alignment alignment; ///< the motions of the alignment
  std::vector<double> weights;    ///< of the vertices: areas, averaged over the shapes; of `SIMILARITY` sums of shares
  Shape_statistics<Shape_points> statistics; ///< with these weights
};

/// Aligns the shapes of an atlas, and computes mean and principal components.
/// \param policy,atlas,shapes,placement,np  as for `place_shapes()`
/// \param modes  at most so many
/// \return the statistics of the aligned shapes
template <class ExecutionPolicy, class CGAL_NP_TEMPLATE_PARAMETERS, internal::If_policy<ExecutionPolicy> = 0>
Atlas_statistics atlas_statistics(const ExecutionPolicy& policy, const Atlas_mesh& atlas,
                                  std::vector<Shape_points>& shapes, Atlas_placement placement,
                                  int modes = (std::numeric_limits<int>::max)(),
                                  const CGAL_NP_CLASS& np = parameters::default_values())
{
  Atlas_statistics result;
  result.weights = internal::weights_of_atlas(policy, atlas, shapes, placement, np);
  result.alignment = internal::align_atlas(policy, shapes, result.weights, placement, np);
  result.statistics = shape_statistics(policy, shapes, result.weights, modes, np);
  return result;
}
CGAL_SP_ON_ONE_CORE(atlas_statistics)

/// An atlas in memory.
struct Shape_atlas : Atlas_statistics {
  std::vector<Shape_points> shapes;                         ///< brought together
  std::vector<std::size_t> members;                         ///< for each shape the index of its mesh
  std::vector<std::pair<std::size_t, std::string>> refused; ///< indices of the other meshes, and why
};

/// Registers maps to the map of a template (from the second round on, the mean of the round before), samples the
/// shapes, and computes mean and principal components.
/// \param policy     as above
/// \param maps       meshes with valid maps of low isometric distortion
/// \param first      the index of the template of the first round
/// \param rounds     1 or more
/// \param atlas      the vertices that the shapes get
/// \param placement  what is removed before shapes are compared
/// \param modes      at most so many
/// \param np         `callback` and `maximum_running_time` of every step, see \ref pd_calls
/// \return the atlas
/// \throws Error the code of the first map that could not be registered, if fewer than two are left; `INTERRUPTED`; the
///               codes of `Spherical_locator` for the map of the template
/// \pre two or more maps
template <class ExecutionPolicy, class TriangleMesh, class SphereMap, class PointMap, class CGAL_NP_TEMPLATE_PARAMETERS,
          internal::If_policy<ExecutionPolicy> = 0>
Shape_atlas
shape_atlas(const ExecutionPolicy& policy, const std::vector<Mapped_mesh<TriangleMesh, SphereMap, PointMap>>& maps,
            std::size_t first, int rounds, const Atlas_mesh& atlas, Atlas_placement placement = Atlas_placement::RIGID,
            int modes = (std::numeric_limits<int>::max)(), const CGAL_NP_CLASS& np = parameters::default_values())
{
  CGAL_SP_PRECONDITION(maps.size() >= 2, "an atlas needs two shapes or more");
  CGAL_SP_PRECONDITION(rounds >= 1 && first < maps.size(), "one round or more, and a template among the maps");
  Shape_atlas result;
  Error_code code = Error_code::OK; // of the first refusal
  Shape_points mean;
  for(int round = 0; round < rounds; ++round) {
    result.shapes.clear();
    result.members.clear();
    result.refused.clear();
    for(std::size_t i = 0; i < maps.size(); ++i) {
      const auto& [mesh, sphere, points] = maps[i];
      std::vector<std::array<double, 3>> moved;
      for(const auto v : vertices(mesh))
        moved.push_back(internal::array_of(internal::coordinates(get(sphere, v))));
      const internal::Vertex_numbering<TriangleMesh> number(vertices(mesh));
      const auto registered = internal::by_vertex<TriangleMesh>(number, moved);
      Registration_result found;
      if(round > 0)
        found = register_maps(policy, maps[i],
                              mapped_mesh(atlas.mesh, internal::by_vertex(atlas.directions),
                                          parameters::vertex_point_map(internal::by_vertex(mean))),
                              registered, {}, {}, np);
      else if(i != first)
        found = register_maps(policy, maps[i], maps[first], registered, {}, {}, np);
      if(found.error == Error_code::INTERRUPTED)
        throw internal::Input_error(found.error, found.detail);
      if(!found) {
        code = code == Error_code::OK ? found.error : code;
        result.refused.emplace_back(i, std::string(get_error_message(found.error)) + ": " + found.detail);
        continue;
      }
      result.shapes.push_back(
        shape_at(policy, mapped_mesh(mesh, registered, parameters::vertex_point_map(points)), atlas));
      result.members.push_back(i);
    }
    if(result.shapes.size() < 2)
      throw internal::Input_error(code, "two or more shapes are needed, and of " + std::to_string(maps.size()) +
                                          " maps " + std::to_string(result.shapes.size()) + " could be registered");
    if(round + 1 < rounds)
      mean = mean_shape(policy, atlas, result.shapes, placement, np);
  }
  static_cast<Atlas_statistics&>(result) = atlas_statistics(policy, atlas, result.shapes, placement, modes, np);
  return result;
}
CGAL_SP_ON_ONE_CORE(shape_atlas)

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SHAPE_ATLAS_H
