// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_REGISTER_MAPS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_REGISTER_MAPS_H

#include <CGAL/Spherical_parameterization/values/Registration.h>
#include <CGAL/Spherical_parameterization/internal/api/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/context/make_monitor.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/register_surfaces.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <set>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationInverse
/// @{

/// A vertex of the first mesh and the corresponding vertex of the second mesh.
template <class MeshA, class MeshB>
using Landmark_pair = std::pair<typename boost::graph_traits<MeshA>::vertex_descriptor,
                                typename boost::graph_traits<MeshB>::vertex_descriptor>;

/// A mesh and its map. Refers to the mesh.
template <class TriangleMesh, class VertexSphereMap, class VertexPointMap>
struct Mapped_mesh {
  const TriangleMesh& mesh;   ///< a closed triangle mesh, a model of `FaceListGraph` and `HalfedgeListGraph`
  VertexSphereMap sphere_map; ///< readable, key vertex_descriptor, value unit vectors
  VertexPointMap points;      ///< readable, key vertex_descriptor
};

/// Makes a `Mapped_mesh`.
/// \param mesh        must outlive the result
/// \param sphere_map  of its vertices
/// \param np          optional named parameters: `vertex_point_map`, by default the mesh's own
/// \return the mesh with its map
template <class TriangleMesh, class VertexSphereMap, class CGAL_NP_TEMPLATE_PARAMETERS>
auto mapped_mesh(const TriangleMesh& mesh, VertexSphereMap sphere_map,
                 const CGAL_NP_CLASS& np = parameters::default_values())
{
  const auto points = internal::vertex_points(mesh, np);
  return Mapped_mesh<TriangleMesh, VertexSphereMap, std::decay_t<decltype(points)>>{mesh, sphere_map, points};
}

/// Registration of two shapes: moves the map of the first shape on the sphere until corresponding points of the two
/// shapes have the same image. With the registered map, properties can be transferred (`transfer_vertex_property()`),
/// shapes sampled at one icosphere (`resample()`), and meshes morphed.
///
/// Eigenfunctions of the Laplacian and the orientation of the two maps determine corresponding points. The first mesh
/// gets a new map near these, which is then deformed: this minimizes the mean symmetric Dirichlet energy of the
/// deformation, the mean squared differences of curvatures, and the stretching of one surface onto the other (see
/// `Registration`). If differences and stretching are not smaller than after a rotation, the map is only rotated.
/// Meshes of fewer than 100 vertices, meshes with own features (`Registration::features`), and shapes in the same
/// position (`Registration::position_weight`), start with a rotation instead: that of three or more landmarks, or else
/// one of five candidates, the one with the best coarse deformation. The candidates are the best rotation for the
/// coordinates (`best_alignment()`), and up to four for curvature, stretch and own features. Then they are deformed,
/// coarse features first. The maps should have low isometric distortion (`Isometric`).
///
/// Guarantee: the stored registered map has no flipped face and degree 1, exactly, or the result says that it has
/// not. There is no guarantee that the points correspond: `Registration_result::trust()` says how far to trust
/// them.
///
/// \param policy      `CGAL::Sequential_tag`, the default, or `CGAL::Parallel_tag`; the result does not depend on it
/// \param a           the first mesh with a valid map of it: `mapped_mesh()`
/// \param b           the second mesh, whose map is not moved
/// \param registered  readable and writable, key vertex_descriptor of the first mesh, value constructible from three
///                    numbers: the registered map; may be its sphere map. It is written unless the input is refused.
/// \param method      how far to go, and the weights
/// \param landmarks   pairs of corresponding vertices. They are put exactly onto each other, that is, onto the images
///                    in the second map, scaled to length 1 in doubles, unless the first mesh is too coarse for that;
///                    with fewer than three the rotation is found without them.
/// \param np          optional: `callback`, `maximum_running_time` and `verbose`, as in `parameterize()`
/// \return the certificate, and what was reached; `NOT_BIJECTIVE` and the like for maps and meshes that cannot be
///         registered, also where a map has faces so small that it cannot be turned without losing them to rounding;
///         `INTERRUPTED` if callback or time limit ended it: what is stored then is a certified map, too
/// \pre weights are not negative; there is at least one level; scale and accuracy are positive; landmarks
///      are vertices of their meshes, none of them in two pairs
///
/// Complexity: linear in the sizes of the meshes; two of 5,000 vertices take 3 seconds on one core.
template <class ExecutionPolicy, class MeshA, class SphereMapA, class PointMapA, class MeshB, class SphereMapB,
          class PointMapB, class RegisteredMap, class CGAL_NP_TEMPLATE_PARAMETERS,
          internal::If_policy<ExecutionPolicy> = 0>
Registration_result register_maps(const ExecutionPolicy& policy, const Mapped_mesh<MeshA, SphereMapA, PointMapA>& a,
                                  const Mapped_mesh<MeshB, SphereMapB, PointMapB>& b, RegisteredMap registered,
                                  const Registration& method = Registration(),
                                  const std::vector<Landmark_pair<MeshA, MeshB>>& landmarks = {},
                                  const CGAL_NP_CLASS& np = parameters::default_values())
{
  using namespace internal;
  check_registration(method);
  const Host_loop loop = host_loop(policy);
  Monitor monitor = make_monitor(np);
  const Stopwatch total;
  Registration_result result;
  try {
    const Vertex_numbering<MeshA> number_a(vertices(a.mesh));
    const Vertex_numbering<MeshB> number_b(vertices(b.mesh));
    std::vector<std::pair<int, int>> pairs;
    std::set<int> seen[2];
    for(const auto& [v, w] : landmarks) {
      pairs.emplace_back(number_a.checked(v), number_b.checked(w));
      CGAL_SP_PRECONDITION(pairs.back().first >= 0 && pairs.back().second >= 0, "a landmark is no vertex of its mesh");
      const bool are_new = seen[0].insert(pairs.back().first).second && seen[1].insert(pairs.back().second).second;
      CGAL_SP_PRECONDITION(are_new, "a vertex has two landmarks");
    }
    const auto read = [&](const auto& m) {
      return Valid_map(read_map(m.mesh, m.points, m.sphere_map, Reading::CHECKED, loop), loop);
    };
    const Valid_map map_a = read(a), map_b = read(b);
    const auto store = [&](const Host_array<vec3>& x) {
      put_vectors(vertices(a.mesh), x, registered);
      return vectors_at(vertices(a.mesh), registered);
    };
    result = register_surfaces(loop, map_a, map_b, pairs, method, monitor, store);
  } catch(const Input_error& error) {
    result.error = error.code();
    result.detail = error.detail();
  }
  result.seconds.total = total.seconds();
  return result;
}
CGAL_SP_ON_ONE_CORE(register_maps)

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_REGISTER_MAPS_H
