// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_REGISTRATION_ENERGY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_REGISTRATION_ENERGY_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/Carried_face.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/Registered_surface.h>
#include <CGAL/Spherical_parameterization/internal/locate/Locator.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/Face_hessian.h>
#include <CGAL/Spherical_parameterization/internal/surface/fans.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Weights of the corners v of a face for which their mean has the direction q, and by the columns of `slope` their
/// derivatives: weight k changes by inner(slope[k], dq).
CGAL_SP_INLINE void weights_of_direction(const std::array<vec3, 3>& v, vec3 q, std::array<double, 3>& weight,
                                         std::array<vec3, 3>& slope)
{
  double sum = 0;
  for(int c = 0; c < 3; ++c) {
    const vec3 m = v[(c + 1) % 3], n = v[(c + 2) % 3];
    weight[c] = (std::max)(0., determinant(m, n, q));
    slope[c] = outer(m, sub(n, m));
    sum += weight[c];
  }
  const vec3 all = add(slope[0], add(slope[1], slope[2]));
  if(!(sum > 0)) { // a face that rounding has eaten: any of its corners is as good as another
    weight = {1, 0, 0};
    slope = {};
    return;
  }
  for(int c = 0; c < 3; ++c) {
    weight[c] /= sum;
    slope[c] = scale(1 / sum, add_scaled(slope[c], -weight[c], all));
  }
}

/// The energy of the map x of the vertices of A, and its gradient.
template <class...>
class Registration_energy {
public:
  Registration_energy(const Host_loop& loop, const Registered_surface& a, const Registered_surface& b,
                      const Registration_features& features, const std::vector<Registration_landmark>& landmarks,
                      const Refinement& settings, const Host_array<vec3>& x)
    : loop_(loop), a_(a), b_(b), features_(features), landmarks_(landmarks),
      landmark_stiffness_(landmarks.empty() ? 0 : settings.landmark_weight / double(landmarks.size())),
      isometry_weight_(settings.isometry_weight), metric_(a.face.size()), corner_offset_(a.point.size() + 1),
      corner_(3 * a.face.size()), surface_part_(vertex_areas(loop, a.face, a.point)), force_(3 * a.face.size()),
      face_of_(a.point.size(), -1)
  {
    constexpr Metric_bounds as_it_is = {1e100, 0};
    const int faces = static_cast<int>(a.face.size());
    Host_array<double> twice_area(faces);
    for_each_index(loop, faces, [&](int f) {
      const auto [i, j, k] = a.face[f];
      metric_[f] = face_metric(a.image[i], a.image[j], a.image[k], as_it_is);
      twice_area[f] = metric_[f].twice_area;
      metric_[f].twice_area = determinant(a.image[i], a.image[j], a.image[k]); // what determinants are compared with
    });
    for(double twice : twice_area)
      area_ += twice / 2;
    spring_.resize(a.point.size(), 0.);
    for(const Registration_landmark& l : landmarks)
      spring_[l.vertex] += landmark_stiffness_;
    corner_offset_.back() = 3 * faces;
    for_each_fan(loop, a.face, static_cast<int>(a.point.size()), [&](const Fan& fan) {
      corner_offset_[fan.vertex] = fan.first;
      for(int k = 0, corner = fan[0]; k < fan.size(); ++k, corner = a.twin[a.previous(corner)])
        corner_[fan.first + k] = corner;
    });
    find_faces(x);
  }

  int size() const { return static_cast<int>(face_of_.size()); }

  /// The corners of the faces of A round vertex i are corner()[k] with k from corner_offset()[i] on, in such an order
  /// that the apex of one is the target of the next.
  const Host_array<int>& corner_offset() const { return corner_offset_; }
  const Host_array<int>& corner() const { return corner_; }
  int target(int k) const { return a_.target(corner_[k]); }

  /// The terms at the x of the last `value()`
  double distortion() const { return distortion_; }
  double mismatch() const { return mismatch_; }
  double stretching() const { return stretching_; }

  /// Infinite where a face is flipped; nothing is compared then.
  double value(const Host_array<vec3>& x)
  {
    distortion_ =
      sum_by_parts(loop_, static_cast<int>(a_.face.size()), [&](int f) { return Face_of_map(*this, x, f).energy(); }) /
      area_;
    if(!(distortion_ < std::numeric_limits<double>::infinity()))
      return distortion_;
    compare(x);
    double energy = distortion_ + mismatch_;
    if(isometry_weight_ > 0)
      energy += isometry_weight_ * stretching_;
    for(const Registration_landmark& l : landmarks_)
      energy += landmark_stiffness_ * squared_distance(x[l.vertex], l.place);
    return energy;
  }

  /// The terms of mismatch and stretching, also where a face is flipped.
  void compare(const Host_array<vec3>& x)
  {
    locate(x);
    mismatch_ =
      sum_by_parts(loop_, static_cast<int>(x.size()), [&](int i) { return surface_part_[i] * mismatch_at(i); }) /
      surface_area;
    if(isometry_weight_ > 0)
      stretching_ = sum_by_parts(loop_, static_cast<int>(a_.face.size()), [&](int f) { return carried(f).energy(); }) /
                    surface_area;
  }

  /// The gradient, tangent to the sphere, at the x of the last `value()`, which has to be finite.
  void gradient(const Host_array<vec3>& x, Host_array<vec3>& result)
  {
    for_each_index(loop_, static_cast<int>(a_.face.size()), [&](int f) {
      const Face_hessian of_map = Face_of_map(*this, x, f).derivatives(0);
      std::array<vec3, 3> of_surface = {};
      if(isometry_weight_ > 0)
        of_surface = carried(f).gradients();
      for(int c = 0; c < 3; ++c)
        force_[3 * f + c] = add_scaled(scale(1 / area_, of_map.gradient(c)), isometry_weight_ / surface_area,
                                       on_sphere(a_.face[f][c], of_surface[c]));
    });
    const int n = static_cast<int>(x.size());
    result.resize(n);
    for_each_index(loop_, n, [&](int i) {
      vec3 g = {0, 0, 0};
      for(int k = corner_offset_[i]; k < corner_offset_[i + 1]; ++k)
        g = add(g, force_[corner_[k]]);
      for(int k = 0; k < features_.number; ++k)
        g = add_scaled(g, 2 / surface_area * surface_part_[i] * difference(k, i), slope_of_feature(k, i));
      result[i] = g;
    });
    for(const Registration_landmark& l : landmarks_)
      result[l.vertex] = add_scaled(result[l.vertex], 2 * landmark_stiffness_, sub(x[l.vertex], l.place));
    for_each_index(loop_, n, [&](int i) { result[i] = tangent(result[i], x[i]); });
  }

  /// The second derivative of what a face adds to the energy, without what is negative of it, in tangents at its
  /// corners. The bending of the sphere adds to it.
  struct Face_blocks {
    std::array<Block, 3> diagonal, side; ///< the latter of the corners m and m + 1
    std::array<double, 3> bend;
  };

  /// At the x of the last `value()`
  /// \param tangents  of a vertex
  template <class Tangents_of_vertex>
  Face_blocks blocks_of_face(int f, const Host_array<vec3>& x, Tangents_of_vertex tangents) const
  {
    Face_blocks result;
    const std::array<int, 3>& corner = a_.face[f];
    const Face_hessian of_map = Face_of_map(*this, x, f).derivatives(1);
    std::array<Face_hessian::Frame, 3> frame;
    for(int m = 0; m < 3; ++m)
      frame[m] = of_map.frame(m, tangents(corner[m]));
    for(int m = 0; m < 3; ++m) {
      const int n = (m + 1) % 3;
      result.diagonal[m] = scaled(1 / area_, of_map.block(m, frame[m], m, frame[m]));
      result.side[m] = scaled(1 / area_, of_map.block(m, frame[m], n, frame[n]));
      result.bend[m] = -inner(of_map.gradient(m), x[corner[m]]) / area_;
    }
    if(isometry_weight_ > 0)
      carried(f).for_each_mode([&](double weight, const std::array<vec3, 3>& by_place) {
        const double part = weight * isometry_weight_ / surface_area;
        std::array<Planar, 3> change;
        for(int m = 0; m < 3; ++m)
          change[m] = frame[m].tangents.products(on_sphere(corner[m], by_place[m]));
        for(int m = 0; m < 3; ++m) {
          const Planar scaled_change = scaled(part, change[m]);
          result.diagonal[m] = sum(result.diagonal[m], internal::outer(scaled_change, change[m]));
          result.side[m] = sum(result.side[m], internal::outer(scaled_change, change[(m + 1) % 3]));
        }
      });
    return result;
  }

  /// The same of what a vertex adds: its features, which are linear on the faces of B, and landmarks.
  Block block_of_vertex(int i, const Tangents& tangents) const
  {
    const double spring = 2 * spring_[i];
    Block result = {spring, 0, 0, spring};
    const double part = 2 * surface_part_[i] / surface_area;
    for(int k = 0; k < features_.number; ++k) {
      const Planar slope = tangents.products(slope_of_feature(k, i));
      result = sum(result, internal::outer(scaled(part, slope), slope));
    }
    return result;
  }

private:
  /// A face of A in a map
  struct Face_of_map {
    vec3 x; ///< of its first corner
    Star_face face;

    Face_of_map(const Registration_energy& e, const Host_array<vec3>& at, int f)
      : x(at[e.a_.face[f][0]]), face(at[e.a_.face[f][1]], at[e.a_.face[f][2]], e.metric_[f], 1)
    {}
    double energy() const { return face.energy(Distortion(1), x); }
    Face_hessian derivatives(double lift) const { return Face_hessian(Distortion(1), x, face, lift); }
  };

  Carried_face carried(int f) const
  {
    const auto [i, j, k] = a_.face[f];
    return {a_.point[i], a_.point[j], a_.point[k], place_[i], place_[j], place_[k]};
  }

  /// What a force on the place of vertex i of A, in space, does to its image.
  vec3 on_sphere(int i, vec3 force) const
  {
    return sum_of_slopes(i, [&](int v) { return inner(b_.point[v], force); });
  }

  double of_b(int k, int vertex) const { return features_.b[k * b_.point.size() + vertex]; }

  /// By the image of vertex i of A
  vec3 slope_of_feature(int k, int i) const
  {
    return sum_of_slopes(i, [&](int v) { return of_b(k, v); });
  }

  /// The gradient, by the image of vertex i of A, of what has such values at the vertices of B.
  template <class Value_of_vertex>
  vec3 sum_of_slopes(int i, Value_of_vertex value) const
  {
    const std::array<int, 3>& corner = b_.face[face_of_[i]];
    vec3 result = {0, 0, 0};
    for(int c = 0; c < 3; ++c)
      result = add_scaled(result, value(corner[c]), slope_[i][c]);
    return result;
  }

  double difference(int k, int i) const
  {
    const std::array<int, 3>& corner = b_.face[face_of_[i]];
    double value = -features_.a[k * a_.point.size() + i];
    for(int c = 0; c < 3; ++c)
      value += weight_[i][c] * of_b(k, corner[c]);
    return value;
  }
  double mismatch_at(int i) const
  {
    double sum = 0;
    for(int k = 0; k < features_.number; ++k)
      sum += difference(k, i) * difference(k, i);
    return sum;
  }

  /// The first time: every vertex from where a neighbour is.
  void find_faces(const Host_array<vec3>& x)
  {
    std::vector<int> queue = {0};
    face_of_[0] = 0;
    for(std::size_t next = 0; next < queue.size(); ++next) {
      const int i = queue[next];
      face_of_[i] = face_at(b_, b_.image, x[i], face_of_[i]);
      for(int k = corner_offset_[i]; k < corner_offset_[i + 1]; ++k)
        if(const int j = a_.target(corner_[k]); face_of_[j] < 0) {
          face_of_[j] = face_of_[i];
          queue.push_back(j);
        }
    }
  }

  void locate(const Host_array<vec3>& x)
  {
    const int n = static_cast<int>(x.size());
    weight_.resize(n);
    slope_.resize(n);
    place_.resize(n);
    for_each_index(loop_, n, [&](int i) {
      face_of_[i] = face_at(b_, b_.image, x[i], face_of_[i]);
      const auto [u, v, w] = b_.face[face_of_[i]];
      weights_of_direction({b_.image[u], b_.image[v], b_.image[w]}, x[i], weight_[i], slope_[i]);
      place_[i] = mean_of_corners(b_.face[face_of_[i]], weight_[i], b_.point);
    });
  }

  const Host_loop& loop_;
  const Registered_surface& a_;
  const Registered_surface& b_;
  const Registration_features& features_;
  const std::vector<Registration_landmark>& landmarks_;
  static constexpr double surface_area = 4 * pi; ///< of A and of B
  double landmark_stiffness_, isometry_weight_;
  Host_array<Face_metric> metric_;         ///< of the map that A came with
  Host_array<int> corner_offset_, corner_; ///< of every vertex
  Host_array<double> spring_;              ///< of landmarks, by vertex
  Host_array<double> surface_part_;        ///< of every vertex of A: its area on the surface
  Host_array<vec3> force_;                 ///< on every corner of the faces of A
  double area_ = 0, distortion_ = 0, mismatch_ = 0, stretching_ = 0;
  Host_array<int> face_of_; ///< of B, by vertex of A
  Host_array<std::array<double, 3>> weight_;
  Host_array<std::array<vec3, 3>> slope_;
  Host_array<vec3> place_; ///< on the surface of B
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_REGISTRATION_ENERGY_H
