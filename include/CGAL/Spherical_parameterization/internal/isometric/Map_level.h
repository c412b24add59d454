// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_MAP_LEVEL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_MAP_LEVEL_H

#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/isometric/Carried_density.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/Star.h>
#include <CGAL/Spherical_parameterization/internal/predicates/certificate.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// A map of the vertices of a progressive mesh that are not removed.
struct Partial_map {
  Host_array<vec3> position;
  Host_array<int> colour; ///< neighbours differ
};

/// How many steps of a loop are worth a task: of about a microsecond, and of a few nanoseconds.
constexpr int few_steps = 32, many_steps = 512;
constexpr int least_tasks = 4; ///< for fewer, no other thread is worth waking

/// Runs f(begin) ... f(end-1), in parallel if there are enough.
template <int Enough = few_steps, class F>
void for_each_of_level(const Watched_loop<Host_loop>& loop, int begin, int end, F f)
{
  if(end - begin < least_tasks * Enough)
    for(int i = begin; i < end; ++i)
      f(i);
  else
    for_each_index<Enough>(loop, end - begin, [&](int i) { f(begin + i); });
}

/// What holds a vertex: it is pulled towards a place by the energy stiffness / 2 |x - place|^2, or pinned where it is,
/// if the stiffness is infinite.
struct Anchor {
  vec3 place;
  double stiffness;

  bool is_pin() const { return stiffness == std::numeric_limits<double>::infinity(); }
};

/// The current mesh of a progressive mesh as compact arrays, with a map to the sphere: what is relaxed.
///
/// Vertices are sorted by colour. Those of one colour are not adjacent, so that all of them can be moved at once, with
/// the same result as one after the other.
template <class...>
class Map_level {
public:
  /// A face (i, j, k) at vertex i.
  struct Corner {
    int j, k;
    int face, number;   ///< which corner of the face is at i: 0, 1, or 2; 0 is at its smallest vertex
    Face_metric metric; ///< of the source; the first corner is i
  };

  /// Takes the memory for the whole mesh at once: levels grow, and new memory for each would cost more than what they
  /// do.
  Map_level(const Watched_loop<Host_loop>& loop, int number_of_vertices)
    : loop_(loop), index_(number_of_vertices), corner_of_face_(2 * static_cast<std::size_t>(number_of_vertices) - 4)
  {
    vertex_.reserve(number_of_vertices);
    offset_.reserve(number_of_vertices + 1);
    first_face_.reserve(number_of_vertices + 1);
    corner_.reserve(6 * static_cast<std::size_t>(number_of_vertices) - 12);
    position_.reserve(number_of_vertices);
  }

  /// No vertex has an anchor then. The areas of source faces are bounded relative to their mean, as if the whole
  /// surface had so many faces as the level.
  void assign(const Progressive_mesh& mesh, const Host_array<vec3>& points, const Carried_density& density,
              double source_area, const Metric_bounds& bounds, const Partial_map& map)
  {
    release();
    sort_by_colour(mesh, map);
    const int n = size();
    offset_.resize(n + 1);
    offset_[0] = 0;
    for(int i = 0; i < n; ++i)
      offset_[i + 1] = offset_[i] + mesh.degree(vertex_[i]);
    corner_.resize(offset_[n]);
    position_.resize(n);
    // Several loops, since what another core has written has to be fetched: the first waits for all of it at once.
    first_face_.resize(n + 1);
    for_each_vertex([&](int i) {
      int at = offset_[i], faces = 0;
      position_[i] = map.position[vertex_[i]];
      mesh.for_each_corner(vertex_[i], [&](int c) {
        const int j = index_[mesh.target(c)], k = index_[mesh.apex(c)];
        const int number = i < (std::min)(j, k) ? 0 : k < j ? 1 : 2;
        corner_[at++] = {j, k, c, number, {}}; // the face is a corner of the whole mesh, at first
        faces += number == 0;
      });
      first_face_[i + 1] = faces;
    });
    first_face_[0] = 0;
    std::partial_sum(first_face_.begin(), first_face_.end(), first_face_.begin());
    const Metric_bounds absolute = {bounds.aspect, bounds.area * source_area / (2. * n - 4)};
    for_each_vertex([&](int i) {
      const vec3 p = points[vertex_[i]];
      int face = first_face_[i];
      for(int c = offset_[i]; c < offset_[i + 1]; ++c) {
        Corner& corner = corner_[c];
        if(corner.number > 0)
          continue;
        corner.metric = in_six_digits(face_metric(p, points[vertex_[corner.j]], points[vertex_[corner.k]], absolute));
        density.apply(mesh, corner.face, absolute.area, corner.metric);
        corner_of_face_[std::exchange(corner.face, face++) / 3] = c;
      }
    });
    for_each_vertex([&](int i) {
      for(int c = offset_[i]; c < offset_[i + 1]; ++c) {
        Corner& corner = corner_[c];
        if(corner.number == 0)
          continue;
        const Corner& first = corner_[corner_of_face_[corner.face / 3]];
        corner.face = first.face;
        for(int k = 0; k < 3; ++k)
          corner.metric.cotangent[k] = first.metric.cotangent[(k + corner.number) % 3];
        corner.metric.twice_area = first.metric.twice_area;
      }
    });
    fit_scale();
  }

  /// Scales the source to the area of the polyhedron that the map is, its faces weighted with their distances from the
  /// centre: what the determinants add up to. As the map was when this was called last.
  void fit_scale()
  {
    area_scale_ = 1;
    const double source = sum_over_faces([](vec3, const Star_face& f) { return f.twice_area; });
    const double image = sum_over_faces([](vec3 x, const Star_face& f) { return f.determinant(x); });
    area_scale_ = image / source;
    area_ = image / 2;
  }

  /// Gives a vertex an anchor, or another one.
  void hold(int i, const Anchor& anchor)
  {
    if(anchor_of_.empty())
      anchor_of_.assign(size(), -1);
    if(anchor_of_[i] < 0) {
      anchor_of_[i] = static_cast<int>(anchor_.size());
      anchor_.emplace_back();
    }
    anchor_[anchor_of_[i]] = anchor;
  }

  /// Keeps a vertex where it is.
  void pin(int i) { hold(i, {position_[i], std::numeric_limits<double>::infinity()}); }

  /// Takes all anchors away.
  void release()
  {
    anchor_.clear();
    anchor_of_.clear();
  }

  /// Null if the vertex has none.
  const Anchor* anchor(int i) const
  {
    return anchor_of_.empty() || anchor_of_[i] < 0 ? nullptr : &anchor_[anchor_of_[i]];
  }
  bool is_pinned(int i) const { return anchor(i) && anchor(i)->is_pin(); }

  /// Of a vertex of the whole mesh that is not removed
  int index(int vertex) const { return index_[vertex]; }

  int size() const { return static_cast<int>(vertex_.size()); }
  int offset(int i) const { return offset_[i]; }
  const Corner& corner(int k) const { return corner_[k]; }
  int number_of_faces() const { return first_face_[size()]; }
  const Host_array<vec3>& position() const { return position_; }
  Host_array<vec3>& position() { return position_; }

  /// Sphere area per source area
  double area_scale() const { return area_scale_; }
  /// Of the source, scaled to the sphere
  double area() const { return area_; }

  /// Runs f(i) for all vertices, colour by colour; those of a colour in parallel. Loops that need no order use it, too,
  /// so that a thread finds in its cache what it wrote in the loop before.
  template <int Enough = few_steps, class F>
  void for_each_vertex(F f) const
  {
    for(std::size_t end = 1; end < colour_begin_.size(); ++end)
      for_each_of_level<Enough>(loop_, colour_begin_[end - 1], colour_begin_[end], f);
  }

  /// The same, last colour first.
  template <int Enough = few_steps, class F>
  void for_each_vertex_backwards(F f) const
  {
    for(std::size_t end = colour_begin_.size() - 1; end > 0; --end)
      for_each_of_level<Enough>(loop_, colour_begin_[end - 1], colour_begin_[end], f);
  }

  /// Runs for_each_vertex(), and returns the sum of the f(i), which is the same for any number of threads.
  template <int Enough = few_steps, class F>
  double sum_over_vertices(F f) const
  {
    double sum = 0;
    for(std::size_t c = 1; c < colour_begin_.size(); ++c) {
      const int begin = colour_begin_[c - 1], end = colour_begin_[c];
      double of_colour = 0;
      if(end - begin < least_tasks * Enough)
        for(int i = begin; i < end; ++i)
          of_colour += f(i);
      else
        of_colour = sum_by_parts<Enough>(loop_, end - begin, [&](int i) { return f(begin + i); });
      sum += of_colour;
    }
    return sum;
  }

  Star_face star_face(const Corner& c) const { return {position_[c.j], position_[c.k], c.metric, area_scale_}; }

  /// The mean distortion of the map, over the source area. Infinite unless all faces are positive.
  double energy(const Distortion& distortion) const
  {
    return sum_over_faces([&](vec3 x, const Star_face& f) { return f.energy(distortion, x); }) / area_;
  }

  /// The energy with that of the anchors, which is 0 without them.
  double objective(const Distortion& distortion) const
  {
    double pull = 0;
    if(!anchor_.empty())
      for(int i = 0; i < size(); ++i)
        if(anchor(i) && !is_pinned(i))
          pull += anchor(i)->stiffness / 2 * squared_distance(position_[i], anchor(i)->place);
    return energy(distortion) + pull / area_;
  }

  /// Whether the map is a bijection, exactly: all faces are positively oriented, and cover the sphere once.
  bool is_bijective() const
  {
    const auto is_flipped = [](vec3 x, const Star_face& f) { return is_positively_oriented(x, f.j, f.k) ? 0. : 1.; };
    const auto coverings = [&](vec3 q) {
      return sum_over_faces([q](vec3 x, const Star_face& f) { return covering(x, f.j, f.k, q); });
    };
    return sum_over_faces(is_flipped) == 0 && degree(coverings) == 1;
  }

  /// One Newton step for every vertex alone that has no anchor: a Gauss-Seidel sweep. Keeps a valid map valid.
  void relax(const Distortion& distortion)
  {
    for_each_vertex([&](int i) { relax_vertex(distortion, i); });
  }

  /// Some such sweeps over the vertices whose stars are distorted far more than the map, and over those around them.
  /// \param mean  the mean distortion of the map
  void relax_distorted(const Distortion& distortion, double mean)
  {
    constexpr int sweeps_of_regions = 3, rings = 2;
    constexpr double bad_factor = 20; // times the mean distortion
    const std::vector<int> region = distorted_region(distortion, bad_factor * mean, rings);
    for(int s = 0; s < sweeps_of_regions && !region.empty(); ++s) {
      auto begin = region.begin();
      for(int end_of_colour : colour_begin_) {
        const auto end = std::lower_bound(begin, region.end(), end_of_colour);
        for_each_of_level(loop_, 0, static_cast<int>(end - begin), [&](int k) { relax_vertex(distortion, begin[k]); });
        begin = end;
      }
    }
  }

  /// Also of a map that was interrupted.
  void store(Partial_map& map) const
  {
    for_each_index(loop_.bare(), size(), [&](int i) { map.position[vertex_[i]] = position_[i]; });
  }

  Star star(int i) const
  {
    Star result;
    for(int c = offset_[i]; c < offset_[i + 1]; ++c) {
      const Corner& corner = corner_[c];
      result.emplace_back(position_[corner.j], position_[corner.k], corner.metric, area_scale_);
    }
    return result;
  }

private:
  /// Counting sort, every part of the vertices for itself.
  void sort_by_colour(const Progressive_mesh& mesh, const Partial_map& map)
  {
    typedef std::vector<int> Of_colours;
    const int n = mesh.capacity();
    std::vector<Of_colours> begin_of_part = results_of_parts(loop_, n, [&](int begin, int end) {
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
    for_each_index(loop_, n, [&](int v) {
      if(!mesh.is_removed(v)) {
        index_[v] = begin_of_part[v / part_size][map.colour[v]]++;
        vertex_[index_[v]] = v;
      }
    });
  }

  void relax_vertex(const Distortion& distortion, int i)
  {
    if(anchor(i))
      return;
    const Star faces = star(i);
    vec3 x = position_[i];
    double energy;
    if(relax_centre(distortion, faces, x, energy) > 0)
      position_[i] = x;
  }

  /// The vertices whose stars are distorted more than `bound` in the mean, and those up to `rings` edges away. In
  /// ascending order, hence by colour.
  std::vector<int> distorted_region(const Distortion& distortion, double bound, int rings) const
  {
    std::vector<char> is_in_region(size());
    for_each_vertex([&](int i) {
      const Star faces = star(i);
      double area = 0;
      for(const Star_face& f : faces)
        area += f.twice_area / 2;
      is_in_region[i] = Star_trial(distortion, faces, position_[i]).energy > bound * area;
    });
    std::vector<int> region;
    for(int i = 0; i < size(); ++i)
      if(is_in_region[i])
        region.push_back(i);
    std::size_t begin = 0;
    for(int ring = 0; ring < rings; ++ring)
      for(const std::size_t end = region.size(); begin < end; ++begin)
        for(int c = offset_[region[begin]]; c < offset_[region[begin] + 1]; ++c)
          if(!std::exchange(is_in_region[corner_[c].j], true))
            region.push_back(corner_[c].j);
    std::sort(region.begin(), region.end());
    return region;
  }

  /// f(x, face) summed over all faces, each from its smallest vertex.
  template <class F>
  double sum_over_faces(F f) const
  {
    return sum_over_vertices([&](int i) {
      double sum = 0;
      for(int c = offset_[i]; c < offset_[i + 1]; ++c)
        if(corner_[c].number == 0)
          sum += f(position_[i], star_face(corner_[c]));
      return sum;
    });
  }

  const Watched_loop<Host_loop>& loop_;
  Host_array<int> vertex_; ///< number of vertex i in the whole mesh
  Host_array<int> index_;  ///< the inverse
  std::vector<int> colour_begin_;
  Host_array<int> offset_; ///< of the corners at vertex i, which are counterclockwise
  Host_array<Corner> corner_;
  Host_array<int> first_face_;     ///< of those whose smallest vertex is i, which are numbered in a row
  Host_array<int> corner_of_face_; ///< of the whole mesh: the one at the smallest vertex here
  Host_array<vec3> position_;
  double area_scale_ = 1;
  double area_ = 0;
  std::vector<Anchor> anchor_;
  std::vector<int> anchor_of_; ///< of every vertex, -1: none; empty if none has
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_MAP_LEVEL_H
