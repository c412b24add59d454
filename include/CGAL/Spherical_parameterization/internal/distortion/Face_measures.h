// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DISTORTION_FACE_MEASURES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DISTORTION_FACE_MEASURES_H

#include <CGAL/Spherical_parameterization/internal/distortion/face_distortion.h>
#include <CGAL/Spherical_parameterization/internal/base/named_parameters.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

/// All that is measured about single faces of a map. The source mesh is scaled to a unit box, so that meshes of any
/// size and place have areas; limbs have areas down to 1e-150 on the sphere, below which everything counts as 1e-300.
template <class TriangleMesh, class VertexPointMap, class VertexSphereMap>
class Face_measures {
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;

public:
  Face_measures(const TriangleMesh& mesh, VertexPointMap points, VertexSphereMap sphere)
    : mesh_(mesh), points_(points), sphere_(sphere)
  {
    set_box();
    for(auto f : faces(mesh)) {
      const auto v = on_sphere(f);
      source_total_ += source_area(f);
      flat_total_ += flat_area(v);
      determinant_total_ += half_determinant(v);
    }
  }

  double source_area(face_descriptor f) const { return flat_area(in_source(f)); }

  /// Share of the source area over the share of the sphere, as a logarithm: positive where the map shrinks.
  double log_area_stretch(face_descriptor f) const
  {
    const auto v = on_sphere(f);
    return log_of_share(source_area(f) / source_total_) -
           log_of_share(spherical_area(v[0], v[1], v[2]) / (4 * std::acos(-1.)));
  }

  double angle_distortion(face_descriptor f) const { return internal::angle_distortion(in_source(f), on_sphere(f)); }

  double dilatation(face_descriptor f) const
  {
    const auto p = in_source(f), v = on_sphere(f);
    return ratio_of_singular_values(squared_singular_values(p, v), flat_area(v) / flat_area(p));
  }

  /// sigma_1^2 + sigma_2^2 + sigma_1^-2 + sigma_2^-2 between flat triangles.
  double flat_symmetric_dirichlet(face_descriptor f) const
  {
    const auto p = in_source(f), v = on_sphere(f);
    return symmetric_dirichlet(squared_singular_values(p, v), flat_area(v) / flat_area(p), flat_total_);
  }

  /// The same with det(a, b, c) / 2 in place of the area of the flat triangle abc.
  double spherical_symmetric_dirichlet(face_descriptor f) const
  {
    const auto p = in_source(f), v = on_sphere(f);
    return symmetric_dirichlet(squared_singular_values(p, v), half_determinant(v) / flat_area(p), determinant_total_);
  }

private:
  std::array<vec3, 3> on_sphere(face_descriptor f) const { return corners(mesh_, sphere_, f); }

  std::array<vec3, 3> in_source(face_descriptor f) const
  {
    auto p = corners(mesh_, points_, f);
    for(vec3& x : p)
      x = in_box(x);
    return p;
  }

  vec3 in_box(vec3 x) const
  {
    return {(x.x - centre_.x) / size_, (x.y - centre_.y) / size_, (x.z - centre_.z) / size_};
  }

  void set_box()
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    vec3 low = {infinity, infinity, infinity}, high = {-infinity, -infinity, -infinity};
    for(auto v : vertices(mesh_)) {
      const vec3 p = coordinates(get(points_, v));
      low = {(std::min)(low.x, p.x), (std::min)(low.y, p.y), (std::min)(low.z, p.z)};
      high = {(std::max)(high.x, p.x), (std::max)(high.y, p.y), (std::max)(high.z, p.z)};
    }
    centre_ = {low.x / 2 + high.x / 2, low.y / 2 + high.y / 2, low.z / 2 + high.z / 2};
    const double half = (std::max)({high.x / 2 - low.x / 2, high.y / 2 - low.y / 2, high.z / 2 - low.z / 2});
    size_ = half > 0 ? half : 1;
  }

  /// 1e-300 also for NaN, the share of a face in a surface without area.
  static double log_of_share(double share) { return std::log((std::max)(1e-300, share)); }

  /// With Q = sigma_1 / sigma_2 and d = sigma_1 sigma_2 the energy is (Q + 1/Q)(d + 1/d), after both surfaces have been
  /// scaled to equal area.
  double symmetric_dirichlet(double squared_sum, double product, double total) const
  {
    if(!(product > 0) || !std::isfinite(squared_sum))
      return std::numeric_limits<double>::infinity();
    const double stretch = product * (source_total_ / total);
    return (squared_sum / product) * (stretch + 1 / stretch);
  }

  const TriangleMesh& mesh_;
  VertexPointMap points_;
  VertexSphereMap sphere_;
  vec3 centre_ = {0, 0, 0};
  double size_ = 1;
  double source_total_ = 0, flat_total_ = 0, determinant_total_ = 0;
};

template <class TriangleMesh, class VertexSphereMap, class NamedParameters>
auto make_face_measures(const TriangleMesh& mesh, VertexSphereMap sphere_map, const NamedParameters& np)
{
  const auto points = vertex_points(mesh, np);
  return Face_measures<TriangleMesh, std::decay_t<decltype(points)>, VertexSphereMap>(mesh, points, sphere_map);
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DISTORTION_FACE_MEASURES_H
