// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_ALIGN_MAPS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_ALIGN_MAPS_H

#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/base/rotations.h>
#include <CGAL/Spherical_parameterization/internal/mesh/midpoint_refinement.h>
#include <CGAL/Spherical_parameterization/transfer_properties.h>

#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationInverse
/// @{

/// A rotation of the sphere by its rows, orthonormal, determinant 1.
typedef std::array<std::array<double, 3>, 3> Rotation;

namespace internal {

/// By `angle` about a coordinate axis.
inline Rotation turn(int axis, double angle)
{
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  Rotation r = {};
  r[axis][axis] = 1;
  r[j][j] = r[k][k] = std::cos(angle);
  r[k][j] = std::sin(angle);
  r[j][k] = -r[k][j];
  return r;
}

/// The 60 rotations of an icosahedron: none of all rotations is farther than 44.5 degrees from one of them.
inline std::vector<Rotation> rotations_of_icosahedron(const Icosphere& icosahedron)
{
  const auto frame = [&](int a, int b) { // columns: at vertex a, towards its neighbour b
    const vec3 z = icosahedron.points[a], x = unit(tangent(icosahedron.points[b], z)), y = outer(z, x);
    return Rotation{{{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}}};
  };
  Rotation inverse = frame(icosahedron.triangles[0][0], icosahedron.triangles[0][1]);
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < i; ++j)
      std::swap(inverse[i][j], inverse[j][i]);
  std::vector<Rotation> rotations;
  for(const auto& triangle : icosahedron.triangles) // every directed edge belongs to one of them
    for(int k = 0; k < 3; ++k)
      rotations.push_back(product(frame(triangle[k], triangle[(k + 1) % 3]), inverse));
  return rotations;
}

/// Subtracts the mean and divides by the root of the mean square.
inline void normalize(std::vector<vec3>& points)
{
  vec3 mean = {0, 0, 0};
  for(vec3 p : points)
    mean = add_scaled(mean, 1. / static_cast<double>(points.size()), p);
  double square = 0;
  for(vec3& p : points) {
    p = sub(p, mean);
    square += inner(p, p) / static_cast<double>(points.size());
  }
  for(vec3& p : points)
    p = scale(1 / std::sqrt(square), p);
}

} // namespace internal

/// Registration of two maps: the rotation of the sphere that leads from the map `a` to the map `b`: maps are unique
/// only up to rotation, and data is transferred, and shapes are morphed, between maps in the same position. It is the
/// one for which the two shapes, both as functions on the sphere and freed from place and size, are correlated best.
/// The shapes have to stand in space in the same way.
///
/// Sixty starts and a pattern search from the best of them; the result is a good optimum, to 1e-3, and not proven to be
/// the best of all.
/// \param policy    `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param a         the inverse of the first map
/// \param points_a  readable, key vertex_descriptor of the mesh of `a`, value with x(), y(), z()
/// \param b         the inverse of the second map
/// \param points_b  readable, key vertex_descriptor of the mesh of `b`, value with x(), y(), z()
/// \return R such that R x under `b` is what x is under `a`; see `rotated_map()`
///
/// Complexity: about 400,000 queries.
template <class ExecutionPolicy, class MeshA, class PointMapA, class MeshB, class PointMapB>
Rotation aligning_rotation(const ExecutionPolicy& policy, const Spherical_locator<MeshA>& a, PointMapA points_a,
                           const Spherical_locator<MeshB>& b, PointMapB points_b)
{
  using internal::vec3;
  const auto loop = internal::host_loop(policy);
  const internal::Icosphere samples(3);
  const auto values = [&](const auto& locator, const auto& map, const Rotation& r) {
    internal::Host_array<vec3> directions;
    for(vec3 p : samples.points)
      directions.push_back(internal::rotated(r, p));
    std::vector<vec3> result;
    for(const auto& place : internal::locate_all(loop, locator, directions))
      result.push_back(internal::coordinates(interpolate(locator.mesh(), place, map)));
    internal::normalize(result);
    return result;
  };
  const std::vector<vec3> of_a = values(a, points_a, internal::rotation_about({0, 0, 0}));
  const auto correlation = [&](const Rotation& r) {
    const std::vector<vec3> of_b = values(b, points_b, r);
    double sum = 0;
    for(std::size_t i = 0; i < of_a.size(); ++i)
      sum += internal::inner(of_a[i], of_b[i]);
    return sum;
  };
  std::vector<std::pair<double, Rotation>> starts;
  for(const Rotation& r : internal::rotations_of_icosahedron(internal::Icosphere(0)))
    starts.emplace_back(correlation(r), r);
  std::sort(starts.begin(), starts.end(), [](const auto& x, const auto& y) { return x.first > y.first; });

  constexpr std::size_t refined = 6; // the best coarse start is not always the one that becomes best
  std::pair<double, Rotation> best = starts.front();
  for(std::size_t k = 0; k < refined; ++k) {
    auto [value, r] = starts[k];
    for(double step = 0.4; step > 1e-3;) {
      const double before = value;
      for(int axis = 0; axis < 3; ++axis)
        for(const double angle : {step, -step}) {
          const Rotation trial = internal::product(internal::turn(axis, angle), r);
          if(const double trial_value = correlation(trial); trial_value > value) {
            value = trial_value;
            r = trial;
          }
        }
      if(!(value > before))
        step /= 2;
    }
    if(value > best.first)
      best = {value, r};
  }
  return best.second;
}

/// \overload
/// \param a,points_a,b,points_b as above; on one core \return as above
template <class MeshA, class PointMapA, class MeshB, class PointMapB>
Rotation aligning_rotation(const Spherical_locator<MeshA>& a, PointMapA points_a, const Spherical_locator<MeshB>& b,
                           PointMapB points_b)
{
  return aligning_rotation(CGAL::Sequential_tag(), a, points_a, b, points_b);
}

/// A spherical map seen through a rotation: what `transfer_vertex_property()` and the like take for a map in another
/// position. Nothing is stored: rotated coordinates would be rounded, which can flip the faces of thin limbs.
template <class VertexSphereMap>
struct Rotated_map {
  /// \cond SKIP_IN_MANUAL
  typedef typename boost::property_traits<VertexSphereMap>::key_type key_type;
  typedef std::array<double, 3> value_type;
  typedef value_type reference;
  typedef boost::readable_property_map_tag category;
  /// \endcond

  VertexSphereMap sphere_map; ///< readable, key vertex_descriptor
  Rotation rotation;          ///< what its values are turned by

  friend value_type get(const Rotated_map& map, const key_type& key)
  {
    const internal::vec3 p = internal::rotated(map.rotation, internal::coordinates(get(map.sphere_map, key)));
    return {p.x, p.y, p.z};
  }
};

/// Makes a `Rotated_map`.
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors
/// \param rotation    what its values are turned by
/// \return a readable property map with values of type `std::array<double, 3>`
template <class VertexSphereMap>
Rotated_map<VertexSphereMap> rotated_map(VertexSphereMap sphere_map, const Rotation& rotation)
{
  return {sphere_map, rotation};
}

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_ALIGN_MAPS_H
