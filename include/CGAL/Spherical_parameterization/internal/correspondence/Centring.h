// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_CENTRING_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_CENTRING_H

#include <CGAL/Spherical_parameterization/internal/backend/vertex_formulas.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/algebra/symmetric_solver.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The Moebius transformation without rotation (boosts of the ball) that brings the centroid of masses on the sphere to
/// the centre. There is exactly one, up to rotation, unless half of the mass or more is in one point; Newton's method
/// in the ball with backtracking. A. Baden, K. Crane, M. Kazhdan, "Moebius registration", SGP 2018.
class Centring {
public:
  Centring(const Host_array<double>& mass, Host_array<vec3> v)
  {
    constexpr int maximum_steps = 100, maximum_halvings = 30;
    constexpr double tolerance = 1e-13, longest = 0.9; // the ball ends at 1
    double total = 0;
    for(double m : mass)
      total += m;
    vec3 centroid = centroid_of(mass, v);
    for(int step = 0; step < maximum_steps && norm(centroid) > tolerance * total; ++step) {
      vec3 c = scale(0.5, newton_step(mass, v, centroid));
      if(norm(c) > longest)
        c = scale(longest / norm(c), c);
      bool is_nearer = false;
      for(int h = 0; !is_nearer && h < maximum_halvings; ++h, c = scale(0.5, c)) {
        Host_array<vec3> next = v;
        for(vec3& p : next)
          p = boost(p, c);
        const vec3 moved = centroid_of(mass, next);
        is_nearer = norm(moved) < norm(centroid);
        if(is_nearer) {
          centre_.push_back(c);
          centroid = moved;
          v = std::move(next);
        }
      }
      if(!is_nearer)
        break;
    }
    distance_ = norm(centroid) / total;
  }

  /// Of the centroid from the centre, in the end
  double distance() const { return distance_; }

  vec3 operator()(vec3 p) const
  {
    for(const vec3& c : centre_)
      p = boost(p, c);
    return p;
  }

  vec3 inverse(vec3 p) const
  {
    for(std::size_t k = centre_.size(); k-- > 0;)
      p = boost(p, scale(-1, centre_[k]));
    return p;
  }

private:
  static vec3 centroid_of(const Host_array<double>& mass, const Host_array<vec3>& v)
  {
    vec3 sum = {0, 0, 0};
    for(std::size_t i = 0; i < v.size(); ++i)
      sum = add_scaled(sum, mass[i], v[i]);
    return sum;
  }

  /// From d v = -2 P_v c: (sum m P_v) 2c = sum m v
  static vec3 newton_step(const Host_array<double>& mass, const Host_array<vec3>& v, vec3 centroid)
  {
    Symmetric_solver<3>::Matrix matrix = {};
    for(std::size_t i = 0; i < v.size(); ++i) {
      const double x[3] = {v[i].x, v[i].y, v[i].z};
      for(int k = 0; k < 3; ++k)
        for(int l = 0; l < 3; ++l)
          matrix[k][l] += mass[i] * ((k == l ? 1. : 0.) - x[k] * x[l]);
    }
    const std::array<double, 3> step = Symmetric_solver<3>(matrix).solve({centroid.x, centroid.y, centroid.z});
    return {step[0], step[1], step[2]};
  }

  std::vector<vec3> centre_; ///< of the boosts, one after the other
  double distance_ = 0;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_CENTRING_H
