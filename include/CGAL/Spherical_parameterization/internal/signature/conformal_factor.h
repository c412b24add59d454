// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SIGNATURE_CONFORMAL_FACTOR_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SIGNATURE_CONFORMAL_FACTOR_H

#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/internal/surface/Mapped_surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/midpoint_refinement.h>
#include <CGAL/Spherical_parameterization/internal/predicates/orientation.h>
#include <CGAL/Spherical_parameterization/internal/signature/Discrete_surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/Intrinsic_triangulation.h>

#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>

namespace CGAL::Spherical_parameterization::internal {

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
template <class Surface = Discrete_surface>
struct Conformal_factor {
  Triangle_surface fine; ///< the surface, refined; vertices keep their numbers, the pieces of a face stand together
  Surface surface;
  typename Surface::Vector u; ///< by vertex, those of the map first; the integral of e^u is 4 pi

  /// The mesh is refined until it has `fewest_vertices`.
  /// Throws Error where the surface has no area, or the map none, and if the loop is ended.
  Conformal_factor(const Watched_loop<Host_loop>& loop, const Mapped_surface& map, int fewest_vertices = 0)
    : fine(refined(checked(map, loop.bare()), fewest_vertices)), surface(Intrinsic_triangulation(fine, fine.point))
  {
    const typename Surface::Vector b = spherical_areas(map);
    const double total = b.sum();
    for(std::size_t i = 0; i < map.image.size(); ++i)
      if(!is_finite(map.image[i]))
        throw Input_error(Error_code::NON_FINITE_COORDINATE,
                          "the image of vertex " + std::to_string(map.position[i]) + " on the sphere");
    if(!(total > 0) || !std::isfinite(total))
      throw Input_error(Error_code::NOT_BIJECTIVE, "the sphere map has no area");
    Surface_solver<Surface> solve(loop, surface);
    typename Surface::Vector curvature = b * (4 * pi / total);
    for(int step = 0; step <= corrections; ++step) {
      u = 2 * solve(curvature - surface.defect());
      const double largest = u.maxCoeff();
      curvature = surface.mass().cwiseProduct((u.array() - largest).exp().matrix());
      const double integral = curvature.sum();
      u.array() += std::log(4 * pi / integral) - largest;
      curvature *= 4 * pi / integral;
    }
    if(!u.allFinite())
      throw Input_error(Error_code::DEGENERATE_FACE, "the surface has no usable metric");
  }

private:
  static constexpr int corrections = 2; // more make up for little of clamping, and let coarse meshes drift along boosts

  static Triangle_surface checked(const Mapped_surface& map, const Host_loop& loop)
  {
    const Host_array<double>& area = map.face_area(loop);
    if(!(std::accumulate(area.begin(), area.end(), 0.) > 0))
      throw Input_error(Error_code::DEGENERATE_FACE, "no face has an area");
    return {map.copy_of_corner_table(loop), map.point};
  }

  static Triangle_surface refined(Triangle_surface mesh, int fewest_vertices)
  {
    while(static_cast<int>(mesh.point.size()) < fewest_vertices)
      mesh = refined_at_midpoints(mesh);
    return mesh;
  }

  /// A third of the areas round every vertex, without sign. All pieces of a face have the same share of its image.
  typename Surface::Vector spherical_areas(const Mapped_surface& map) const
  {
    const std::size_t pieces = fine.face.size() / map.face.size();
    typename Surface::Vector area = Surface::Vector::Zero(surface.size());
    for(std::size_t f = 0; f < fine.face.size(); ++f) {
      const auto& [i, j, k] = map.face[f / pieces];
      const double third = std::abs(spherical_area(map.image[i], map.image[j], map.image[k])) / (3. * pieces);
      for(int corner : fine.face[f])
        area[corner] += third;
    }
    return area;
  }
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SIGNATURE_CONFORMAL_FACTOR_H
