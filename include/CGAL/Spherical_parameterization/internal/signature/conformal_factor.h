// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SIGNATURE_CONFORMAL_FACTOR_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SIGNATURE_CONFORMAL_FACTOR_H

#include <CGAL/Spherical_parameterization/Result.h>
#include <CGAL/Spherical_parameterization/internal/signature/Discrete_surface.h>
#include <CGAL/Spherical_parameterization/Error.h>
#include <CGAL/Spherical_parameterization/internal/base/text.h>
#include <CGAL/Spherical_parameterization/internal/mesh/Source_mesh.h>
#include <CGAL/Spherical_parameterization/internal/mesh/midpoint_refinement.h>
#include <CGAL/Spherical_parameterization/internal/base/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/mesh/point_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/predicates/certificate.h>
#include <CGAL/Spherical_parameterization/internal/mesh/twins.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

/// The logarithm u of the factor by which the conformal map to the sphere enlarges areas, on a surface of area 4 pi.
///
/// The metric e^u g of the sphere has curvature 1, so that L u / 2 = b - K with K the angle defects and b the spherical
/// areas of the vertices (J. Kazdan, F. Warner, "Curvature functions for compact 2-manifolds", Annals of Mathematics
/// 99, 1974). A map is needed for b only, which it has to give where the sphere is large: what it says about limbs,
/// where triangles may be smaller than doubles resolve, does not matter. Since the map is not quite conformal where
/// angles had to be clamped, b is then corrected to M e^u, and u solved for again, a few times: on a round sphere this
/// divides a deviation that is a harmonic of degree l by l (l + 1) / 2, and leaves but the Moebius transformations (l =
/// 1) as the map has them. Read off the areas of the map itself, u depends much on the tessellation there.
///
/// On a coarse mesh linear functions do not follow u along a limb. So the faces may be cut into four, again and again;
/// the surface stays what it is.
template <class TriangleMesh>
struct Conformal_factor {
  Source_mesh<TriangleMesh> source;
  Triangle_arrays fine; ///< `source`, refined; vertices keep their numbers, the pieces of a face stand together
  Discrete_surface surface;
  Discrete_surface::Vector u; ///< by vertex, those of `source` first; the integral of e^u is 4 pi

  /// The mesh is refined until it has `fewest_vertices`.
  /// Throws std::invalid_argument where the mesh is no closed surface of genus 0 with an area, or the map no map.
  template <class VertexPointMap, class VertexSphereMap>
  Conformal_factor(const TriangleMesh& mesh, VertexPointMap points, VertexSphereMap sphere_map, int fewest_vertices = 0)
    : source(checked(mesh, points)), fine(refined({source.face, twins(mesh), source.point}, fewest_vertices)),
      surface(Intrinsic_triangulation(fine.face, fine.twin, fine.point))
  {
    const Discrete_surface::Vector b = spherical_areas(sphere_map);
    const double total = b.sum();
    if(!(total > 0) || !std::isfinite(total))
      throw std::invalid_argument("the sphere map has no area");
    const double pi = Discrete_surface::pi();
    Surface_solver solve(surface);
    Discrete_surface::Vector curvature = b * (4 * pi / total);
    for(int step = 0; step <= corrections; ++step) {
      u = 2 * solve(curvature - surface.defect());
      const double largest = u.maxCoeff();
      curvature = surface.mass().cwiseProduct((u.array() - largest).exp().matrix());
      const double integral = curvature.sum();
      u.array() += std::log(4 * pi / integral) - largest;
      curvature *= 4 * pi / integral;
    }
    if(!u.allFinite())
      throw std::invalid_argument("the surface has no usable metric");
  }

private:
  static constexpr int corrections = 2; // more make up for little of clamping, and let coarse meshes drift along boosts

  template <class VertexPointMap>
  static Source_mesh<TriangleMesh> checked(const TriangleMesh& mesh, VertexPointMap points)
  try {
    Source_mesh<TriangleMesh> result(mesh, points);
    double area = 0;
    for(double a : result.area)
      area += a;
    if(!(area > 0))
      throw Error(Error_code::DEGENERATE_FACE, "no face has an area");
    return result;
  } catch(const Error& error) {
    throw std::invalid_argument(std::string(get_error_message(error.code())) + ": " + error.detail());
  }

  static Triangle_arrays refined(Triangle_arrays mesh, int fewest_vertices)
  {
    while(static_cast<int>(mesh.point.size()) < fewest_vertices)
      mesh = refined_at_midpoints(mesh);
    return mesh;
  }

  /// A third of the areas round every vertex, without sign. All pieces of a face have the same share of its image.
  template <class VertexSphereMap>
  Discrete_surface::Vector spherical_areas(VertexSphereMap sphere_map) const
  {
    std::vector<vec3> image;
    image.reserve(source.vertex.size());
    for(auto v : source.vertex)
      image.push_back(coordinates(get(sphere_map, v)));
    const std::size_t pieces = fine.face.size() / source.face.size();
    Discrete_surface::Vector area = Discrete_surface::Vector::Zero(surface.size());
    for(std::size_t f = 0; f < fine.face.size(); ++f) {
      const auto& [i, j, k] = source.face[f / pieces];
      const double third = std::abs(spherical_area(image[i], image[j], image[k])) / (3. * pieces);
      for(int corner : fine.face[f])
        area[corner] += third;
    }
    return area;
  }
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SIGNATURE_CONFORMAL_FACTOR_H
