// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COARSE_TO_FINE_MAP_LEVEL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COARSE_TO_FINE_MAP_LEVEL_H

#include <CGAL/Spherical_parameterization/internal/coarse_to_fine/Distortion.h>
#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/coarse_to_fine/Progressive_mesh.h>
#include <CGAL/Spherical_parameterization/internal/coarse_to_fine/Star.h>
#include <CGAL/Spherical_parameterization/internal/predicates/certificate.h>
#include <CGAL/Spherical_parameterization/internal/base/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/backend/vertex_formulas.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// A map of the vertices of a progressive mesh that are not removed.
struct Partial_map {
  Host_array<vec3> position;
  std::vector<int> colour; ///< neighbours differ
};

/// How many steps of a loop are worth a task: of about a microsecond, and of a few nanoseconds.
constexpr int few_steps = 32, many_steps = 512;
constexpr int least_tasks = 4; ///< for fewer, no other thread is worth waking

/// Runs f(begin) ... f(end-1), in parallel if there are enough.
template <int Enough = few_steps, class Loop, class F>
void for_each_of_level(const Loop& loop, int begin, int end, F f)
{
  if(end - begin < least_tasks * Enough)
    Host_loop().for_each(end - begin, [&](int i) { f(begin + i); });
  else
    for_each_part<Enough>(loop, end - begin, [&](int first, int last) {
      for(int i = first; i < last; ++i)
        f(begin + i);
    });
}

/// The sum of f(begin) ... f(end-1), the same for any number of threads.
template <int Enough = few_steps, class Loop, class F>
double sum_over_level(const Loop& loop, int begin, int end, F f)
{
  if(end - begin >= least_tasks * Enough)
    return sum_by_parts<Enough>(loop, end - begin, [&](int i) { return f(begin + i); });
  double sum = 0;
  for(int i = begin; i < end; ++i)
    sum += f(i);
  return sum;
}

/// The current mesh of a progressive mesh as compact arrays, with a map to the sphere: what is relaxed.
///
/// Vertices are sorted by colour. Those of one colour are not adjacent, so that all of them can be moved at once, with
/// the same result as one after the other.
class Map_level {
public:
  /// A face (i, j, k) at vertex i.
  struct Corner {
    int j, k;
    Face_metric metric; ///< of the source; the first corner is i
  };

  /// Takes the memory for the whole mesh at once: levels grow, and new memory for each would cost more than what they
  /// do.
  explicit Map_level(int number_of_vertices) : index_(number_of_vertices)
  {
    vertex_.reserve(number_of_vertices);
    offset_.reserve(number_of_vertices + 1);
    corner_.reserve(6 * static_cast<std::size_t>(number_of_vertices) - 12);
    position_.reserve(number_of_vertices);
  }

  /// The areas of source faces are bounded relative to their mean, as if the whole surface had so many faces as the
  /// level.
  template <class Loop>
  void assign(const Loop& loop, const Progressive_mesh& mesh, const Host_array<vec3>& points, double source_area,
              const Metric_bounds& bounds, const Partial_map& map)
  {
    sort_by_colour(loop, mesh, map);
    const int n = size();
    offset_.resize(n + 1);
    offset_[0] = 0;
    for(int i = 0; i < n; ++i)
      offset_[i + 1] = offset_[i] + mesh.degree(vertex_[i]);
    corner_.resize(offset_[n]);
    position_.resize(n);
    const Metric_bounds absolute = {bounds.aspect, bounds.area * source_area / (2. * n - 4)};
    // Two loops, since what another core has written has to be fetched: the first waits for all of it at once.
    for_each_vertex(loop, [&](int i) {
      int at = offset_[i];
      position_[i] = map.position[vertex_[i]];
      mesh.for_each_corner(vertex_[i], [&](int c) {
        Corner& corner = corner_[at++];
        corner.j = index_[mesh.vertex(Progressive_mesh::next(c))];
        corner.k = index_[mesh.vertex(Progressive_mesh::previous(c))];
      });
    });
    for_each_vertex(loop, [&](int i) {
      const vec3 p = points[vertex_[i]];
      for(int c = offset_[i]; c < offset_[i + 1]; ++c) {
        Corner& corner = corner_[c];
        corner.metric = face_metric(sub(points[vertex_[corner.j]], p), sub(points[vertex_[corner.k]], p), absolute);
      }
    });
    fit_scale(loop);
  }

  int size() const { return static_cast<int>(vertex_.size()); }
  int number_of_colours() const { return static_cast<int>(colour_begin_.size()) - 1; }
  /// The first vertex of a colour; the end of the vertices of the one before.
  int colour_begin(int colour) const { return colour_begin_[colour]; }
  int offset(int i) const { return offset_[i]; }
  const Corner& corner(int k) const { return corner_[k]; }
  const Host_array<vec3>& position() const { return position_; }
  Host_array<vec3>& position() { return position_; }

  /// Sphere area per source area
  double area_scale() const { return area_scale_; }
  /// Of the source, scaled to the sphere
  double area() const { return area_; }

  /// Runs f(i) for all vertices, colour by colour; those of a colour in parallel. Loops that need no order use it, too,
  /// so that a thread finds in its cache what it wrote in the loop before.
  template <int Enough = few_steps, class Loop, class F>
  void for_each_vertex(const Loop& loop, F f) const
  {
    for(int colour = 0; colour < number_of_colours(); ++colour)
      for_each_of_level<Enough>(loop, colour_begin_[colour], colour_begin_[colour + 1], f);
  }

  /// The same, last colour first.
  template <int Enough = few_steps, class Loop, class F>
  void for_each_vertex_backwards(const Loop& loop, F f) const
  {
    for(int colour = number_of_colours() - 1; colour >= 0; --colour)
      for_each_of_level<Enough>(loop, colour_begin_[colour], colour_begin_[colour + 1], f);
  }

  /// Runs for_each_vertex(), and returns the sum of the f(i), which is the same for any number of threads.
  template <int Enough = few_steps, class Loop, class F>
  double sum_over_vertices(const Loop& loop, F f) const
  {
    double sum = 0;
    for(int colour = 0; colour < number_of_colours(); ++colour)
      sum += sum_over_level<Enough>(loop, colour_begin_[colour], colour_begin_[colour + 1], f);
    return sum;
  }

  Star_face star_face(const Corner& c) const
  {
    const Face_metric& m = c.metric;
    return {position_[c.j], position_[c.k], m.cotangent[0], m.cotangent[1], m.cotangent[2], area_scale_ * m.twice_area};
  }

  void gather(int i, Star& star) const
  {
    star.clear();
    for(int c = offset_[i]; c < offset_[i + 1]; ++c)
      star.push_back(star_face(corner_[c]));
  }

  /// The mean distortion of the map, over the source area. Infinite unless all faces are positive.
  template <class Loop>
  double energy(const Loop& loop, const Distortion& distortion) const
  {
    return sum_over_faces(loop,
                          [&](vec3 x, const Star_face& f) {
                            const double determinant = f.determinant(x);
                            return determinant > 0 ? f.dirichlet(x) * distortion.value(determinant / f.twice_area)
                                                   : std::numeric_limits<double>::infinity();
                          }) /
           area_;
  }

  /// Whether the map is a bijection, exactly: all faces are positively oriented, and cover the sphere once.
  template <class Loop>
  bool is_bijective(const Loop& loop) const
  {
    const double flipped =
      sum_over_faces(loop, [](vec3 x, const Star_face& f) { return is_positively_oriented(x, f.j, f.k) ? 0. : 1.; });
    return flipped == 0 &&
           degree([&](vec3 q) {
             return sum_over_faces(loop, [q](vec3 x, const Star_face& f) { return covering(x, f.j, f.k, q); });
           }) == 1;
  }

  template <class Loop>
  void store(const Loop& loop, Partial_map& map) const
  {
    for_each_vertex(loop, [&](int i) { map.position[vertex_[i]] = position_[i]; });
  }

private:
  /// Counting sort, every part of the vertices for itself.
  template <class Loop>
  void sort_by_colour(const Loop& loop, const Progressive_mesh& mesh, const Partial_map& map)
  {
    typedef std::vector<int> Of_colours;
    const int n = mesh.capacity();
    std::vector<Of_colours> begin_of_part = results_of_parts(loop, n, [&](int begin, int end) {
      Of_colours count;
      for(int v = begin; v < end; ++v)
        if(!mesh.is_removed(v)) {
          const std::size_t c = static_cast<std::size_t>(map.colour[v]);
          if(count.size() <= c)
            count.resize(c + 1, 0);
          ++count[c];
        }
      return count;
    });
    colour_begin_ = {0};
    for(std::size_t c = 0, colours = 1; c < colours; ++c) {
      int total = colour_begin_.back();
      for(Of_colours& count : begin_of_part) {
        colours = (std::max)(colours, count.size());
        if(c < count.size())
          total += std::exchange(count[c], total);
      }
      colour_begin_.push_back(total);
    }
    vertex_.resize(colour_begin_.back());
    for_each_part(loop, n, [&](int begin, int end) {
      Of_colours& next = begin_of_part[begin / part_size];
      for(int v = begin; v < end; ++v)
        if(!mesh.is_removed(v)) {
          index_[v] = next[map.colour[v]]++;
          vertex_[index_[v]] = v;
        }
    });
  }

  /// f(x, face) summed over all faces, each from its smallest vertex.
  template <class Loop, class F>
  double sum_over_faces(const Loop& loop, F f) const
  {
    return sum_over_vertices(loop, [&](int i) {
      double sum = 0;
      for(int c = offset_[i]; c < offset_[i + 1]; ++c)
        if(i < corner_[c].j && i < corner_[c].k)
          sum += f(position_[i], star_face(corner_[c]));
      return sum;
    });
  }

  /// Scales the source to the area of the polyhedron that the map is, its faces weighted with their distances from the
  /// centre: what the determinants add up to.
  template <class Loop>
  void fit_scale(const Loop& loop)
  {
    area_scale_ = 1;
    const double source = sum_over_faces(loop, [](vec3, const Star_face& f) { return f.twice_area; });
    const double image = sum_over_faces(loop, [](vec3 x, const Star_face& f) { return f.determinant(x); });
    area_scale_ = image / source;
    area_ = image / 2;
  }

  Host_array<int> vertex_; ///< number of vertex i in the whole mesh
  Host_array<int> index_;  ///< the inverse
  std::vector<int> colour_begin_;
  Host_array<int> offset_; ///< of the corners at vertex i, which are counterclockwise
  Host_array<Corner> corner_;
  Host_array<vec3> position_;
  double area_scale_ = 1;
  double area_ = 0;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COARSE_TO_FINE_MAP_LEVEL_H
