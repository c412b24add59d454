// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_ORDER_ON_SPHERE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_ORDER_ON_SPHERE_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/surface/Mapped_surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/breadth_first.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// An order of the vertices and faces of a map that does not depend on their numbers, in which neighbours are near each
/// other in memory: that of the images on G. Morton's curve through the cube round the sphere (1966). A registration of
/// 80,000 vertices whose numbers have no order, as subdivision leaves them, takes half the time so. Nor does it depend
/// on the radius of the sphere.
class Order_on_sphere {
public:
  Order_on_sphere(const Host_loop& loop, const Host_array<vec3>& image) : old_(image.size())
  {
    std::vector<std::uint64_t> key;
    key.reserve(image.size());
    for(const vec3& image_of_vertex : image) {
      const vec3 p = on_unit_sphere(image_of_vertex);
      key.push_back(spread(p.x) | spread(p.y) << 1 | spread(p.z) << 2);
    }
    const auto rank = [&](int i) { return std::make_tuple(key[i], image[i].x, image[i].y, image[i].z); };
    std::iota(old_.begin(), old_.end(), 0);
    std::stable_sort(old_.begin(), old_.end(), [&](int i, int j) { return rank(i) < rank(j); });
    new_ = inverse_permutation(loop, old_);
  }

  std::size_t size() const { return old_.size(); }

  /// The place of a vertex.
  int operator()(int vertex) const { return new_[vertex]; }

  /// Values of the vertices, in this order.
  template <class Values>
  Host_array<typename Values::value_type> ordered(const Values& values) const
  {
    return picked(values, old_);
  }

  /// Values in this order, by the numbers of the vertices again.
  template <class T>
  Host_array<T> by_number(const Host_array<T>& ordered) const
  {
    return picked(ordered, new_);
  }

  /// Vertices and faces in this order.
  Valid_map ordered(const Host_loop& loop, const Mapped_surface& map) const
  {
    Mapped_surface result;
    result.number_of_vertices = map.number_of_vertices;
    result.point = ordered(map.point);
    result.image = ordered(map.image);
    result.face.reserve(map.face.size());
    for(const auto& [i, j, k] : map.face) {
      std::array<int, 3> f = {new_[i], new_[j], new_[k]};
      std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
      result.face.push_back(f);
    }
    std::sort(result.face.begin(), result.face.end());
    return Valid_map(std::move(result), loop);
  }

private:
  /// The direction of p; p itself where rounding alone has moved it: vertices on a plane of symmetry stay on it.
  static vec3 on_unit_sphere(const vec3& p)
  {
    constexpr double rounding = 1e-6; // of floats
    return std::abs(norm(p) - 1) < rounding ? p : unit(p);
  }

  /// The bits of a coordinate, with two of others between each and the next.
  static std::uint64_t spread(double x)
  {
    constexpr int bits = 21;
    const auto cell = static_cast<std::uint64_t>((std::clamp)(x / 2 + 0.5, 0., 1.) * ((1 << bits) - 1));
    std::uint64_t result = 0;
    for(int b = 0; b < bits; ++b)
      result |= (cell >> b & 1) << 3 * b;
    return result;
  }

  template <class Values>
  static Host_array<typename Values::value_type> picked(const Values& values, const Host_array<int>& from)
  {
    Host_array<typename Values::value_type> result;
    result.reserve(values.size());
    for(int i : from)
      result.push_back(values[i]);
    return result;
  }

  Host_array<int> old_, new_; ///< numbers by place, and places by number
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_ORDER_ON_SPHERE_H
