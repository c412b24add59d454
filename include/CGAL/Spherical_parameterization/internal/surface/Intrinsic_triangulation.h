// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_INTRINSIC_TRIANGULATION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_INTRINSIC_TRIANGULATION_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/surface/Corner_table.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// A closed triangulated surface given by nothing but the lengths of its edges, made Delaunay by flipping edges inside
/// the surface: the shape stays, to rounding, and all cotangent weights become nonnegative, however bad the triangles
/// of the mesh. M. Fisher, B. Springborn, A. Bobenko, P. Schroeder, "An algorithm for the construction of intrinsic
/// Delaunay triangulations with applications to digital geometry processing", Computing 81 (2007).
///
/// Triangles may end up with two equal corners.
class Intrinsic_triangulation : public Corner_table {
public:
  /// \param table  the triangles
  /// \param points by vertex
  /// \param loop   a Host_loop or a Watched_loop; flips are made one by one all the same
  template <class Loop = Host_loop>
  Intrinsic_triangulation(Corner_table table, const Host_array<vec3>& points, const Loop& loop = Loop())
    : Corner_table(std::move(table)), length_(number_of_halfedges()), cotangent_(number_of_halfedges()),
      number_of_vertices_(static_cast<int>(points.size()))
  {
    for_each_part(loop, number_of_faces(), [&](int begin, int end) {
      for_each_face(
        face, begin, end,
        [&](int f, const std::array<vec3, 3>& p) {
          for(int k = 0; k < 3; ++k)
            length_[3 * f + k] = norm(sub(p[(k + 1) % 3], p[k]));
        },
        points);
    });
    mollify(loop);
    for_each_index(loop, number_of_faces(), [&](int f) { set_cotangents(f); });
    make_delaunay(loop);
  }

  int number_of_vertices() const { return number_of_vertices_; }
  int number_of_faces() const { return number_of_halfedges() / 3; }

  /// Length of halfedge h, inside the surface.
  double length(int h) const { return length_[h]; }

  /// False where the halfedge is one of the mesh for sure, and not one of a flipped edge.
  bool may_be_new(int h) const { return is_to_be_seen_[h] != 0; }

  /// By how much all edges were lengthened, so that every triangle has an area.
  double slack() const { return slack_; }

  /// Area of the triangle of halfedge h, by Heron's formula as W. Kahan writes it: accurate for needles, too.
  double area(int h) const
  {
    double a = length_[h], b = length_[next(h)], c = length_[next(next(h))];
    if(a < b)
      std::swap(a, b);
    if(b < c)
      std::swap(b, c);
    if(a < b)
      std::swap(a, b);
    const double product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
    return std::sqrt((std::max)(product, 0.)) / 4;
  }

  /// Cotangent of the angle opposite to halfedge h.
  double cotangent(int h) const { return cotangent_[h]; }

  void prefetch_cotangent(int h) const { __builtin_prefetch(&cotangent_[h]); }
  void prefetch_may_be_new(int h) const { __builtin_prefetch(&is_to_be_seen_[h]); }

  /// The angle opposite to halfedge h.
  double angle(int h) const { return std::atan2(4 * area(h), twice_cosine(h)); }

private:
  /// b^2 + c^2 - a^2 for the side a = h
  double twice_cosine(int h) const
  {
    const double a = length_[h], b = length_[next(h)], c = length_[next(next(h))];
    return b * b + c * c - a * a;
  }

  /// Lengthens all edges by the same little, so that every triangle has an area: N. Sharp, K. Crane, "A Laplacian for
  /// nonmanifold triangle meshes", SGP 2020.
  template <class Loop>
  void mollify(const Loop& loop)
  {
    constexpr double relative_slack = 1e-6; // of the triangle inequality, in mean edge lengths
    double mean = 0;
    for(double l : length_)
      mean += l / number_of_halfedges();
    const std::vector<double> excesses = results_of_parts(loop, number_of_halfedges(), [&](int begin, int end) {
      double excess = 0;
      for(int h = begin; h < end; ++h)
        excess = (std::max)(excess, relative_slack * mean + length_[h] - length_[next(h)] - length_[next(next(h))]);
      return excess;
    });
    slack_ = *std::max_element(excesses.begin(), excesses.end());
    if(slack_ > 0)
      for_each_index(loop, number_of_halfedges(), [&](int h) { length_[h] += slack_; });
  }

  void set_cotangents(int f)
  {
    const double four_areas = 4 * area(3 * f);
    for(int h = 3 * f; h < 3 * f + 3; ++h)
      cotangent_[h] = twice_cosine(h) / four_areas;
  }

  bool is_delaunay(int h) const
  {
    constexpr double tolerance = 1e-10; // cocircular points may be triangulated in either way
    return cotangent(h) + cotangent(twin[h]) >= -tolerance;
  }

  /// Looks at all halfedges, from the last one down to the first one, and before it goes on once more at those that a
  /// flip has made edges of other triangles. All but the edges that are flipped and those around them are known to be
  /// Delaunay from the start.
  template <class Loop>
  void make_delaunay(const Loop& loop)
  {
    constexpr int looks_at_once = 1 << 16;
    constexpr int ahead = 32; // of the look at a halfedge its twin's memory is asked for, twice as far ahead its own
    std::vector<char> is_to_be_seen_again(number_of_halfedges(), 0);
    is_to_be_seen_.resize(number_of_halfedges());
    for_each_index(loop, number_of_halfedges(), [&](int h) { is_to_be_seen_[h] = h < twin[h] && !is_delaunay(h); });
    std::vector<int> again;
    int before = number_of_halfedges(); // those from here on have been looked at
    const auto is_open = [&](int h) { return h < before || is_to_be_seen_again[h]; };
    const auto take_next = [&] { // -1 at the end
      if(!again.empty()) {
        const int h = again.back();
        again.pop_back();
        is_to_be_seen_again[h] = 0;
        return h;
      }
      do {
        --before;
        if(before >= 2 * ahead && is_to_be_seen_[before - 2 * ahead])
          prefetch(before - 2 * ahead);
        if(before >= ahead && is_to_be_seen_[before - ahead])
          prefetch(twin[before - ahead]);
      } while(before >= 0 && !is_to_be_seen_[before]);
      return before;
    };
    const auto look_at = [&](int h) {
      const int t = twin[h];
      if((h > t && is_open(t)) || is_delaunay(h) || !flip(h)) // an open one will come up again
        return;
      for(int f : {h / 3, t / 3}) {
        set_cotangents(f);
        for(int e = 3 * f; e < 3 * f + 3; ++e)
          is_to_be_seen_[e] = is_to_be_seen_[twin[e]] = 1;
      }
      for(int e : {next(h), next(next(h)), next(t), next(next(t))})
        if(!is_open(e)) {
          is_to_be_seen_again[e] = 1;
          again.push_back(e);
        }
    };
    int h = take_next();
    while(h >= 0)
      loop.for_each(1, [&](int) { // a watched one asks before
        for(int k = 0; k < looks_at_once && h >= 0; ++k, h = take_next())
          look_at(h);
      });
  }

  /// What a flip will need of a halfedge and its triangle.
  void prefetch(int h) const
  {
    __builtin_prefetch(&face[h / 3]);
    __builtin_prefetch(&twin[h]);
    __builtin_prefetch(&length_[h]);
    __builtin_prefetch(&cotangent_[h]);
  }

  /// Replaces the common edge of two triangles by the other diagonal. Returns false where the quadrangle is not convex,
  /// which for an edge that is not Delaunay only rounding can bring about, or where both triangles are the same.
  bool flip(int h)
  {
    const int t = twin[h];
    if(h / 3 == t / 3)
      return false;
    // h: a -> b with apex c; t: b -> a with apex d. Laid out in the plane with a = (0, 0), b = (length, 0).
    const int bc = next(h), ca = next(bc), ad = next(t), db = next(ad);
    const double l = length_[h];
    const double cx = (l * l + length_[ca] * length_[ca] - length_[bc] * length_[bc]) / (2 * l);
    const double dx = (l * l + length_[ad] * length_[ad] - length_[db] * length_[db]) / (2 * l);
    const double cy = 2 * area(h) / l, dy = -2 * area(t) / l;
    const double crossing = cx - (dx - cx) * cy / (dy - cy); // of the line cd with the line ab
    if(!(crossing > 0 && crossing < l))
      return false;

    // The triangles become (d, b, c) in the place of h's, and (c, a, d) in the place of t's.
    const double diagonal = std::hypot(dx - cx, dy - cy);
    const int a = origin(h), b = origin(t), c = origin(ca), d = origin(db);
    const std::array<int, 4> outer_twins = {twin[bc], twin[ca], twin[ad], twin[db]};
    const std::array<double, 4> outer_lengths = {length_[bc], length_[ca], length_[ad], length_[db]};
    const std::array<int, 4> old_places = {bc, ca, ad, db};
    const std::array<int, 4> new_places = {ca, ad, db, bc}; // of the edges bc, ca, ad, db
    // h: c -> d, then db, bc; t: d -> c, then ca, ad
    for(const auto& [e, v] : {std::pair(h, c), {bc, d}, {ca, b}, {t, d}, {ad, c}, {db, a}})
      face[e / 3][e % 3] = v;
    length_[h] = length_[t] = diagonal;
    for(int k = 0; k < 4; ++k) {
      // the other side may be an edge of this quadrangle, too
      const auto own = std::find(old_places.begin(), old_places.end(), outer_twins[k]);
      const int other = own == old_places.end() ? outer_twins[k] : new_places[own - old_places.begin()];
      length_[new_places[k]] = outer_lengths[k];
      twin[new_places[k]] = other;
      twin[other] = new_places[k];
    }
    return true;
  }

  Host_array<double> length_;
  Host_array<double> cotangent_;   ///< of the angle opposite to a halfedge
  Host_array<char> is_to_be_seen_; ///< by halfedge: not Delaunay from the start, or one of a face that was flipped
  double slack_ = 0;
  int number_of_vertices_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_INTRINSIC_TRIANGULATION_H
