// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DISTORTION_FACE_MEASURES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DISTORTION_FACE_MEASURES_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/surface/Mapped_surface.h>
#include <CGAL/Spherical_parameterization/internal/predicates/orientation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace CGAL::Spherical_parameterization::internal {

inline double flat_area(const std::array<vec3, 3>& p) { return norm(outer(sub(p[1], p[0]), sub(p[2], p[0]))) / 2; }

/// Half of det(a, b, c): the area of the flat triangle times the distance of its plane from the origin, with sign.
inline double half_determinant(const std::array<vec3, 3>& v) { return accurate_determinant(v[0], v[1], v[2]) / 2; }

inline double angle(vec3 u, vec3 w) { return std::atan2(norm(outer(u, w)), inner(u, w)); }

/// Mean over the corners of |angle on the sphere - angle in the source|, in radians.
inline double angle_distortion(const std::array<vec3, 3>& p, const std::array<vec3, 3>& v)
{
  double sum = 0;
  for(int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double between_great_circles = angle(tangent(sub(v[j], v[i]), v[i]), tangent(sub(v[k], v[i]), v[i]));
    sum += std::abs(between_great_circles - angle(sub(p[j], p[i]), sub(p[k], p[i])));
  }
  return sum / 3;
}

/// sigma_1^2 + sigma_2^2 of the affine map from one flat triangle, of this area, to another: its Dirichlet energy by
/// the cotangent formula, over the area. Infinite if the source triangle has no area.
inline double squared_singular_values(const std::array<vec3, 3>& p, double area, const std::array<vec3, 3>& v)
{
  if(!(area > 0))
    return std::numeric_limits<double>::infinity();
  double sum = 0;
  for(int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const vec3 opposite = sub(v[k], v[j]);
    sum += inner(sub(p[j], p[i]), sub(p[k], p[i])) * inner(opposite, opposite);
  }
  return (std::max)(0., sum / (4 * area * area));
}

/// sigma_1 / sigma_2 >= 1, from (sigma_1^2 + sigma_2^2) / (sigma_1 sigma_2).
inline double ratio_of_singular_values(double squared_sum, double product)
{
  if(!(product > 0) || !std::isfinite(squared_sum))
    return std::numeric_limits<double>::infinity();
  const double half = (std::max)(1., squared_sum / product / 2);
  return half + std::sqrt((half - 1) * (half + 1));
}

/// All that is measured about single faces of a map, valid or not. Limbs have areas down to 1e-150 on the sphere, below
/// which everything counts as 1e-300. Sums over all faces are taken in their order, on any number of threads.
class Face_measures {
public:
  /// The map has to outlive this.
  CGAL_SP_INLINE Face_measures(const Mapped_surface& map, const Host_loop& loop)
    : map_(map), source_area_(map.face_area(loop)), area_(map.face.size()),
      total_source_(std::accumulate(source_area_.begin(), source_area_.end(), 0.))
  {
    for_each_part(loop, number_of_faces(), [&](int begin, int end) {
      internal::for_each_face(
        map_.face, begin, end,
        [&](int f, const auto& v) {
          area_[f] = {flat_area(v), half_determinant(v)};
        },
        map_.image);
    });
    for(const Areas& area : area_) {
      total_.flat += area.flat;
      total_.determinant += area.determinant;
    }
  }

  int number_of_faces() const { return map_.number_of_faces(); }

  double source_area(int f) const { return source_area_[f]; }

  /// By the exact predicate, where the determinant does not tell.
  bool is_flipped(int f) const
  {
    if(area_[f].determinant > 0)
      return false;
    const auto [a, b, c] = map_.of_image(f);
    return !is_positively_oriented(a, b, c);
  }

  /// Share of the source area over the share of the sphere, as a logarithm: positive where the map shrinks.
  double log_area_stretch(int f) const { return log_stretch(f, map_.of_image(f)); }

  double angle_distortion(int f) const { return internal::angle_distortion(map_.in_source(f), map_.of_image(f)); }

  double dilatation(int f) const { return ratio_of_singular_values(f, squared_singular_values(f)); }

  /// sigma_1^2 + sigma_2^2 + sigma_1^-2 + sigma_2^-2 between flat triangles.
  double flat_symmetric_dirichlet(int f) const
  {
    return symmetric_dirichlet(f, squared_singular_values(f), &Areas::flat);
  }

  /// All of these of a face, and the last one with det(a, b, c) / 2 in place of the area of the flat triangle abc.
  struct Values {
    double log_area_stretch, angle_distortion, dilatation, flat_symmetric_dirichlet, spherical_symmetric_dirichlet;
  };
  /// Calls visit(face, values) for all faces, in any order: faster than the functions above one by one.
  template <class Visit>
  void for_each_face(const Host_loop& loop, Visit visit) const
  {
    map_.for_each_face(loop, [&](int f, const auto& p, const auto& v) {
      const double squared_sum = internal::squared_singular_values(p, source_area(f), v);
      visit(f, Values{log_stretch(f, v), internal::angle_distortion(p, v), ratio_of_singular_values(f, squared_sum),
                      symmetric_dirichlet(f, squared_sum, &Areas::flat),
                      symmetric_dirichlet(f, squared_sum, &Areas::determinant)});
    });
  }

  /// The values of a measure, one of the functions above, by face.
  CGAL_SP_INLINE Host_array<double> values(const Host_loop& loop, double (Face_measures::*measure)(int) const) const
  {
    Host_array<double> result(map_.face.size());
    for_each_index(loop, number_of_faces(), [&](int f) { result[f] = (this->*measure)(f); });
    return result;
  }

private:
  struct Areas {
    double flat, determinant; ///< of the image
  };

  /// 1e-300 also for NaN, the share of a face in a surface without area.
  static double log_of_share(double share) { return std::log((std::max)(1e-300, share)); }

  double log_stretch(int f, const std::array<vec3, 3>& v) const
  {
    return log_of_share(source_area(f) / total_source_) - log_of_share(spherical_area(v[0], v[1], v[2]) / (4 * pi));
  }

  double squared_singular_values(int f) const
  {
    return internal::squared_singular_values(map_.in_source(f), source_area(f), map_.of_image(f));
  }

  double ratio_of_singular_values(int f, double squared_sum) const
  {
    return internal::ratio_of_singular_values(squared_sum, area_[f].flat / source_area_[f]);
  }

  /// With Q = sigma_1 / sigma_2 and d = sigma_1 sigma_2 the energy is (Q + 1/Q)(d + 1/d), after both surfaces have been
  /// scaled to equal area.
  double symmetric_dirichlet(int f, double squared_sum, double Areas::*of_image) const
  {
    const double product = area_[f].*of_image / source_area_[f];
    if(!(product > 0) || !std::isfinite(squared_sum))
      return std::numeric_limits<double>::infinity();
    const double stretch = product * (total_source_ / total_.*of_image);
    return (squared_sum / product) * (stretch + 1 / stretch);
  }

  const Mapped_surface& map_;
  const Host_array<double>& source_area_;
  Host_array<Areas> area_;
  Areas total_ = {0, 0};
  double total_source_;
};

/// For every vertex the mean of the values of its faces.
template <class Values>
Host_array<double> means_over_faces(const Host_loop& loop, const Surface& surface, const Values& value)
{
  Host_array<double> mean(surface.number_of_vertices);
  for_each_fan(loop, surface.face, surface.number_of_vertices, [&](const Fan& fan) {
    double sum = 0;
    for(int c : fan)
      sum += value[c / 3];
    mean[fan.vertex] = sum / fan.size();
  });
  return mean;
}

/// The logarithmic area stretch of the vertices.
CGAL_SP_INLINE Host_array<double> vertex_stretch(const Host_loop& loop, const Mapped_surface& map)
{
  return means_over_faces(loop, map, Face_measures(map, loop).values(loop, &Face_measures::log_area_stretch));
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DISTORTION_FACE_MEASURES_H
