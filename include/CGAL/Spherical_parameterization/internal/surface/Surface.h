// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_SURFACE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_SURFACE_H

#include <CGAL/Spherical_parameterization/internal/algebra/Bounding_box.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/surface/match_halfedges.h>

#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

/// A quantity that is computed where it is asked for first, and kept.
///
/// Any number of threads may ask at once, and none waits for another: each that finds nothing computes the quantity,
/// the first one to be done keeps its own, and all others throw theirs away, which are the same. Whoever wants it
/// computed once asks before a parallel loop, and not in it.
template <class Quantity>
class Kept {
public:
  Kept() = default;
  Kept(const Kept& other) : value_(other.known() ? new Quantity(*other.known()) : nullptr) {}
  Kept(Kept&& other) noexcept : value_(other.value_.exchange(nullptr)) {}
  Kept& operator=(Kept&& other) noexcept
  {
    delete value_.exchange(other.value_.exchange(nullptr));
    return *this;
  }
  ~Kept() { delete value_.load(); }

  /// \param compute  returns the quantity
  template <class Compute>
  const Quantity& get(Compute compute) const
  {
    const Quantity* kept = value_.load();
    if(kept)
      return *kept;
    auto own = std::make_unique<const Quantity>(compute());
    return value_.compare_exchange_strong(kept, own.get()) ? *own.release() : *kept;
  }

  /// Null if it has not been asked for.
  const Quantity* known() const { return value_.load(); }

  void set(Quantity value) { delete value_.exchange(new Quantity(std::move(value))); }

private:
  mutable std::atomic<const Quantity*> value_ = nullptr;
};

/// Every vertex's third of the values of its faces, such as their areas, added up in the order of the faces.
template <class Value>
Host_array<double> thirds_at_vertices(const Host_loop& loop, const Host_array<std::array<int, 3>>& face, int n,
                                      Value of_face)
{
  Host_array<double> sum(n);
  for_each_fan(loop, face, n, [&](const Fan& fan) {
    double of_vertex = 0;
    for(int c : fan)
      of_vertex += of_face(c / 3) / 3;
    sum[fan.vertex] = of_vertex;
  });
  return sum;
}

/// Every vertex's third of the areas of its faces.
inline Host_array<double> vertex_areas(const Host_loop& loop, const Host_array<std::array<int, 3>>& face,
                                       const Host_array<vec3>& point)
{
  return thirds_at_vertices(loop, face, static_cast<int>(point.size()),
                            [&](int f) { return norm(normal(point, face[f])) / 2; });
}

/// A triangle mesh as arrays, as read_surface.h reads it. What follows from them is computed where it is asked for
/// first, and kept: see `Kept`. The arrays must not be changed after that.
struct Surface {
  Host_array<std::array<int, 3>> face; ///< in the order of the mesh, counterclockwise
  Host_array<vec3> point;              ///< in a box of size 1, for measures up to 4, anywhere; may be left out
  Host_array<int> position;            ///< the numbers of the vertices in the mesh; empty: they are the same
  int number_of_vertices = 0;
  bool is_simplicial = true; ///< no edge ends where it begins, no two have the same ends; of a mesh that was checked

  int number_of_faces() const { return static_cast<int>(face.size()); }
  std::array<vec3, 3> in_source(int f) const { return corners(point, f); }

  /// The opposite of every halfedge. Halfedge 3 f + k goes from corner k of face f to the next one.
  const Host_array<int>& twin(const Host_loop& loop) const
  {
    return twin_.get([&] { return matched_halfedges(loop); });
  }
  /// Of a surface that is not simplicial: its faces do not tell it.
  void set_twin(Host_array<int> twin) { twin_.set(std::move(twin)); }

  /// For those who change it. The opposite halfedges are not kept here.
  template <class Loop>
  Corner_table copy_of_corner_table(const Loop& loop) const
  {
    return {face, twin_.known() ? *twin_.known() : matched_halfedges(loop)};
  }

  double area_of_face(int f) const { return norm(normal(point, face[f])) / 2; }

  /// The areas of all faces.
  const Host_array<double>& face_area(const Host_loop& loop) const
  {
    return face_area_.get([&] {
      Host_array<double> area(face.size());
      for_each_index(loop, number_of_faces(), [&](int f) { area[f] = area_of_face(f); });
      return area;
    });
  }

  /// Every vertex's third of the areas of its faces.
  const Host_array<double>& vertex_area(const Host_loop& loop) const
  {
    return vertex_area_.get([&] { return vertex_areas(loop, face, point); });
  }

protected:
  std::array<vec3, 3> corners(const Host_array<vec3>& at, int f) const
  {
    return {at[face[f][0]], at[face[f][1]], at[face[f][2]]};
  }

private:
  template <class Loop>
  Host_array<int> matched_halfedges(const Loop& loop) const
  {
    Host_array<int> twin;
    match_halfedges(loop, face, number_of_vertices, twin);
    return twin;
  }

  Kept<Host_array<int>> twin_;
  Kept<Host_array<double>> face_area_, vertex_area_;
};

/// Moves the bounding box to the origin and scales it to size 1. Lengths and areas are only ever compared with each
/// other: this keeps their squares and products far from overflow and underflow.
inline void scale_to_unit_box(Host_array<vec3>& point)
{
  const Bounding_box box(point);
  const vec3 low = box.low;
  const double divisor = box.half_size();
  for(vec3& p : point)
    p = {(p.x / 2 - low.x / 2) / divisor, (p.y / 2 - low.y / 2) / divisor, (p.z / 2 - low.z / 2) / divisor};
}

/// The same by a power of 2 and without moving, which rounds nothing: for measures.
inline void scale_exactly(Host_array<vec3>& point)
{
  const int exponent = std::ilogb(Bounding_box(point).half_size());
  for(vec3& p : point)
    p = {std::scalbn(p.x, -exponent), std::scalbn(p.y, -exponent), std::scalbn(p.z, -exponent)};
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_SURFACE_H
