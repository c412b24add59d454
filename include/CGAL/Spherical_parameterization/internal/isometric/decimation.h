// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_DECIMATION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_DECIMATION_H

#include <CGAL/Spherical_parameterization/internal/algebra/rounded.h>
#include <CGAL/Spherical_parameterization/internal/isometric/Progressive_mesh.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/predicates/orientation.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The sum of squared distances to weighted planes, as a quadratic form: M. Garland and P. Heckbert, "Surface
/// simplification using quadric error metrics", SIGGRAPH 1997. Points are relative to an origin close to the planes:
/// so the distances keep their digits where a surface is flat.
class Quadric {
public:
  /// The plane through the origin with unit normal n.
  void add_plane(vec3 n, double weight)
  {
    const std::array<double, 6> plane = {n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.x * n.z, n.y * n.z};
    for(int k = 0; k < 6; ++k)
      square_[k] += weight * plane[k];
  }

  /// `shift` leads from the origin of the other one to this one.
  void add(const Quadric& other, vec3 shift)
  {
    at_origin_ += other(shift);
    linear_ = internal::add(linear_, internal::add(other.linear_, other.squared(shift)));
    for(int k = 0; k < 6; ++k)
      square_[k] += other.square_[k];
  }

  double operator()(vec3 p) const { return (std::max)(0., inner(p, add_scaled(squared(p), 2, linear_)) + at_origin_); }
  double at_origin() const { return at_origin_; }

private:
  /// The product with the matrix of the squares.
  vec3 squared(vec3 p) const
  {
    const auto& s = square_;
    return {s[0] * p.x + s[3] * p.y + s[4] * p.z, s[3] * p.x + s[1] * p.y + s[5] * p.z,
            s[4] * p.x + s[5] * p.y + s[2] * p.z};
  }

  std::array<double, 6> square_{};
  vec3 linear_ = {0, 0, 0};
  double at_origin_ = 0;
};

/// Coarsens a mesh to a tetrahedron, in rounds of independent half-edge collapses. It gets there whatever the mesh: a
/// triangulated sphere of more than four vertices has a collapsible edge (E. Steinitz, 1922).
///
/// Cheap is what keeps the shape, the quality of the triangles, and small degrees: the map is optimised on the coarse
/// meshes, and its distortion there has to be that of the fine one. A round takes the cheapest collapses that do not
/// touch each other, one after the other: first those within broad bands of the surface, all bands at once, then those
/// across their borders. The result is the same for any number of threads.
///
/// Vertices can be kept until only so many are left; no collapse makes them adjacent. With a map of the mesh to the
/// sphere, that is the end, and the map stays a bijection: no collapse is taken that would flip a face of it.
template <class...>
class Decimation {
public:
  /// Of the mesh as it is: vertices may have been removed before.
  /// \param is_kept  which vertices are to be kept while there are more than `kept_until`; empty: none
  /// \param map      null, or positions on the sphere for which all faces are positively oriented; then some are kept
  Decimation(const Watched_loop<Host_loop>& loop, const Host_array<vec3>& points, Progressive_mesh& mesh,
             std::vector<char> is_kept, int kept_until, const Host_array<vec3>* map = nullptr)
    : loop_(loop), point_(points), map_(map), mesh_(mesh), quadric_(points.size()), best_(points.size()),
      role_(points.size(), FREE), remaining_(points.size()), is_outdated_(points.size(), true),
      is_kept_(std::move(is_kept)), kept_until_(kept_until), band_size_(size_of_bands(mesh.capacity()))
  {
    std::iota(remaining_.begin(), remaining_.end(), 0);
    const double twice_area = sum_by_parts(loop, mesh.capacity(), [&](int v) { return initialise_quadric(v); });
    const double mean_area = twice_area / 2 / (2. * mesh.number_of_vertices()) / 3;
    if(mean_area * mean_area > 0)
      unit_ = mean_area * mean_area;
  }

  /// Collapses edges until a share of the vertices is removed, or no more can be at once. Returns the half-edges, in
  /// their order; empty if only a tetrahedron is left, or, with a map, as few vertices as asked for or possible.
  std::vector<int> round()
  {
    std::vector<int> collapsed;
    while(mesh_.number_of_vertices() > (map_ ? kept_until_ : 4) && collapsed.empty()) {
      if(keeps_vertices() && mesh_.number_of_vertices() <= kept_until_)
        release();
      update_costs();
      const double bound = cost_bound();
      std::vector<Band> bands(mesh_.capacity() / band_size_ + 1);
      loop_.for_each(static_cast<int>(bands.size()), [&](int b) { select_within(b, bound, bands[b]); });
      std::vector<Candidate> across;
      for(const Band& b : bands)
        across.insert(across.end(), b.across.begin(), b.across.end());
      for_each_index<steps_of_a_task>(loop_, static_cast<int>(across.size()), [&](int i) {
        const int u = across[i].second;
        if(is_outdated_[u] && is_untouched(u))
          update(u);
      });
      bands.push_back({select(std::move(across), bound), {}});
      loop_.for_each(static_cast<int>(bands.size()) - 1, [&](int b) { apply(bands[b].collapsed); });
      apply(bands.back().collapsed);
      for(const Band& b : bands)
        collapsed.insert(collapsed.end(), b.collapsed.begin(), b.collapsed.end());
      mesh_.count_collapses(static_cast<int>(collapsed.size()));
      if(collapsed.empty() && !has_candidates()) { // all that is left has a high degree, or is kept
        if(map_)
          break;
        if(keeps_vertices())
          release();
        else {
          maximum_degree_ *= 2;
          is_outdated_.assign(is_outdated_.size(), true);
        }
      }
    }
    return collapsed;
  }

  /// Whether all vertices that are to be kept are still there.
  bool keeps_vertices() const { return !is_kept_.empty(); }

private:
  enum Role : char { FREE, RING, BUSY };
  struct Collapse {
    double cost = infinity;
    int half_edge = -1;
  };

  typedef std::pair<double, int> Candidate; ///< cost, vertex
  /// A part of the numbering of the vertices, which is breadth-first.
  struct Band {
    std::vector<int> collapsed;    ///< half-edges whose first vertices have stars within the band
    std::vector<Candidate> across; ///< the cheap candidates whose stars reach beyond it
  };

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double length_weight = 1e-3; ///< of the squared length of the edge, times the area of the star
  static constexpr double least_cost = 1e-3 * length_weight; ///< so that flat regions do not collapse in any order
  static constexpr double aspect_scale2 = 25;                ///< an aspect ratio of 5 doubles the cost
  static constexpr double flip_penalty = 1e3;                ///< for a normal that turns by more than 78 degrees
  static constexpr int good_degree = 9;                      ///< each neighbour more doubles the cost
  static constexpr double share_of_candidates = 0.4;
  static constexpr int digits_of_costs = 10; ///< binary ones
  static constexpr int steps_of_a_task = 256;

  /// Bands are long, since what lies across their borders is collapsed one by one, but four or more, for as many
  /// threads.
  static int size_of_bands(int number_of_vertices)
  {
    constexpr int shortest = 4096, longest = 40000;
    int size = number_of_vertices / 4 + 1;
    while(size > longest)
      size = size / 2 + 1;
    return (std::max)(size, shortest);
  }

  /// Returns twice the area of the faces at v.
  double initialise_quadric(int v)
  {
    double twice_area = 0;
    if(mesh_.is_removed(v))
      return twice_area;
    mesh_.for_each_corner(v, [&](int c) {
      const vec3 n = normal(point_, {mesh_.vertex(c), mesh_.target(c), mesh_.apex(c)});
      const double length = std::sqrt(inner(n, n));
      if(length > 0)
        quadric_[v].add_plane(scale(1 / length, n), length / 2);
      twice_area += length;
    });
    return twice_area;
  }

  /// The cheapest collapse of u into a neighbour.
  Collapse best_collapse(int u) const
  {
    if(mesh_.degree(u) > maximum_degree_ || (keeps_vertices() && is_kept_[u]))
      return Collapse();
    struct Ring_face {
      int corner;
      vec3 a, b, normal; ///< the side opposite to u, and the normal
      double twice_area;
    };
    boost::container::small_vector<Ring_face, 24> ring(mesh_.degree(u), boost::container::default_init);
    double area = 0;
    auto at = ring.begin();
    mesh_.for_each_corner(u, [&](int c) {
      Ring_face& face = *at++;
      face.corner = c;
      face.a = point_[mesh_.target(c)];
      face.b = point_[mesh_.apex(c)];
      face.normal = outer(sub(face.a, point_[u]), sub(face.b, point_[u]));
      face.twice_area = std::sqrt(inner(face.normal, face.normal));
      area += face.twice_area / 2;
    });
    // Few are the cheapest by a lower bound of their cost: only these are computed exactly.
    struct Estimate {
      Collapse collapse;
      std::size_t number; ///< in the ring
      bool is_exact;
    };
    boost::container::small_vector<Estimate, 24> estimates;
    for(std::size_t i = 0; i < ring.size(); ++i)
      estimates.push_back({{cost(u, ring, i, area, false), ring[i].corner}, i, false});
    const auto is_cheaper = [](const Estimate& a, const Estimate& b) { return a.collapse.cost < b.collapse.cost; };
    while(!estimates.empty()) {
      const auto cheapest = std::min_element(estimates.begin(), estimates.end(), is_cheaper);
      if(!cheapest->is_exact) {
        cheapest->collapse.cost = cost(u, ring, cheapest->number, area, true);
        cheapest->is_exact = true;
      } else if(mesh_.is_collapsible(cheapest->collapse.half_edge) && is_allowed(cheapest->collapse.half_edge))
        return cheapest->collapse;
      else
        estimates.erase(cheapest);
    }
    return Collapse();
  }

  /// Whether the target of the half-edge sees the whole ring of its other end in the map, if there is one, and gets no
  /// kept vertex for a neighbour if it is one: an edge between two that do not move would be a wall to others.
  bool is_allowed(int half_edge) const
  {
    if(!map_ && !keeps_vertices())
      return true;
    const int u = mesh_.vertex(half_edge), v = mesh_.target(half_edge);
    const bool is_kept = keeps_vertices() && is_kept_[v];
    return !mesh_.any_corner(u, [&](int c) {
      const int j = mesh_.target(c), k = mesh_.apex(c);
      return j != v && ((is_kept && is_kept_[j]) ||
                        (map_ && k != v && !is_positively_oriented((*map_)[v], (*map_)[j], (*map_)[k])));
    });
  }

  /// Of moving u to the first point of ring[i]; a lower bound, unless it is to be exact. In units of the mesh, and
  /// rounded: costs that symmetry makes equal, and rounding errors not, are a tie then, which the order of the vertices
  /// decides. So a mesh that is turned is decimated alike.
  template <class Ring>
  double cost(int u, const Ring& ring, std::size_t i, double area, bool is_exact) const
  {
    const int v = mesh_.target(ring[i].corner);
    const vec3 p = ring[i].a, edge = sub(p, point_[u]);
    const int degree = mesh_.degree(u) + mesh_.degree(v) - 4;
    const double degree_factor = degree > good_degree ? std::ldexp(1, (std::min)(degree - good_degree, 200))
                                 : degree < 4         ? 0.5
                                                      : 1;
    const double distances = is_exact ? quadric_[u](edge) + quadric_[v].at_origin() : quadric_[u](edge);
    const double cost = ((distances + length_weight * area * inner(edge, edge)) / unit_ + least_cost) * degree_factor *
                        (is_exact ? shape_factor(ring, i) : 1);
    return cost < infinity ? rounded<digits_of_costs>(cost, cost) : infinity;
  }

  /// What badly shaped or turned triangles multiply the cost by when u moves to the first point of ring[i].
  template <class Ring>
  static double shape_factor(const Ring& ring, std::size_t i)
  {
    constexpr double equilateral = 0.8660254037844386, worst_aspect = 1e6, cosine = 0.2;
    const vec3 p = ring[i].a;
    const std::size_t before = (i + ring.size() - 1) % ring.size();
    double aspect = 1;
    bool is_turned = false;
    for(std::size_t k = 0; k < ring.size(); ++k) {
      if(k == i || k == before) // these vanish
        continue;
      const vec3 a = sub(ring[k].a, p), b = sub(ring[k].b, p), c = sub(b, a), normal = outer(a, b);
      const double length2 = (std::max)({inner(a, a), inner(b, b), inner(c, c)});
      const double twice_area = std::sqrt(inner(normal, normal));
      aspect = (std::max)(aspect, equilateral * length2 < worst_aspect * twice_area ? equilateral * length2 / twice_area
                                                                                    : worst_aspect);
      is_turned = is_turned || inner(ring[k].normal, normal) < cosine * ring[k].twice_area * twice_area;
    }
    return (1 + aspect * aspect / aspect_scale2) * (is_turned ? flip_penalty : 1);
  }

  /// On large meshes most costs stay outdated until their vertices may be taken: see select(). That costs a fifth of
  /// the time and now and then the order; where limbs find their places, the order counts.
  void update_costs()
  {
    constexpr int small_size = 20000;
    const bool is_small = mesh_.number_of_vertices() <= small_size;
    remaining_.erase(std::remove_if(remaining_.begin(), remaining_.end(), [&](int v) { return mesh_.is_removed(v); }),
                     remaining_.end());
    for_each_index<steps_of_a_task>(loop_, static_cast<int>(remaining_.size()), [&](int i) {
      const int v = remaining_[i];
      if(is_outdated_[v] && (is_small || best_[v].half_edge < 0))
        update(v);
    });
  }

  void update(int v)
  {
    best_[v] = best_collapse(v);
    is_outdated_[v] = false;
  }

  /// What the dearest candidate of this round may cost, from a sample of all collapses. Infinite if there is none.
  double cost_bound() const
  {
    constexpr std::size_t sample_size = 4096;
    const std::size_t stride = remaining_.size() / sample_size + 1;
    std::vector<double> sample;
    for(std::size_t i = 0; i < remaining_.size(); i += stride)
      if(best_[remaining_[i]].half_edge >= 0)
        sample.push_back(best_[remaining_[i]].cost);
    if(sample.empty())
      return infinity;
    const auto last = sample.begin() + static_cast<std::ptrdiff_t>(share_of_candidates * double(sample.size()));
    std::nth_element(sample.begin(), last, sample.end());
    return *last;
  }

  void release()
  {
    is_kept_.clear();
    is_outdated_.assign(is_outdated_.size(), true);
  }

  bool has_candidates() const
  {
    return std::any_of(remaining_.begin(), remaining_.end(), [&](int v) { return best_[v].half_edge >= 0; });
  }

  /// Selects among the vertices that cost no more than `bound`. Roles outside the band are neither read nor written.
  void select_within(int number, double bound, Band& band)
  {
    const int begin = number * band_size_, end = begin + band_size_;
    std::vector<Candidate> within;
    for(auto it = std::lower_bound(remaining_.begin(), remaining_.end(), begin); it != remaining_.end() && *it < end;
        ++it) {
      const Collapse& best = best_[*it];
      if(best.half_edge < 0 || best.cost > bound)
        continue;
      const bool is_across = mesh_.any_neighbour(*it, [&](int w) { return w < begin || w >= end; });
      (is_across ? band.across : within).emplace_back(best.cost, *it);
    }
    band.collapsed = select(std::move(within), bound);
  }

  /// Takes the collapses of independent candidates, the cheapest ones first. At least four vertices remain: each
  /// collapse has two vertices for itself, and two neighbours that are in none.
  ///
  /// The collapse of u touches no face of another one of this round and cannot break its link condition, nor the other
  /// way round: u and its target take no part in others, and its other neighbours are only neighbours.
  std::vector<int> select(std::vector<Candidate> candidates, double bound)
  {
    std::sort(candidates.begin(), candidates.end());
    std::vector<int> collapsed;
    for(const auto& [cost, u] : candidates) {
      if(!is_untouched(u))
        continue;
      const bool is_up_to_date = !is_outdated_[u];
      if(!is_up_to_date)
        update(u);
      const Collapse& best = best_[u];
      if(best.half_edge < 0 || best.cost > bound || role_[mesh_.target(best.half_edge)] != FREE)
        continue;
      if(!is_up_to_date || mesh_.is_collapsible(best.half_edge)) {
        occupy(u);
        collapsed.push_back(best.half_edge);
      } else // since an edge has come into being nearby
        is_outdated_[u] = true;
    }
    return collapsed;
  }

  /// Whether u takes no part in a collapse of this round, nor does a neighbour more than as one.
  bool is_untouched(int u) const
  {
    return role_[u] == FREE && !mesh_.any_neighbour(u, [&](int w) { return role_[w] == BUSY; });
  }

  void occupy(int u)
  {
    mesh_.for_each_corner(u, [&](int c) { role_[mesh_.target(c)] = RING; });
    role_[u] = BUSY;
    role_[mesh_.target(best_[u].half_edge)] = BUSY;
  }

  void apply(std::vector<int>& half_edges)
  {
    // in the order of the memory, now and when they are undone
    std::sort(half_edges.begin(), half_edges.end(), [&](int g, int h) { return mesh_.vertex(g) < mesh_.vertex(h); });
    for(int h : half_edges) {
      const int u = mesh_.vertex(h), v = mesh_.target(h);
      mesh_.for_each_corner(u, [&](int c) {
        const int w = mesh_.target(c);
        is_outdated_[w] = true;
        role_[w] = FREE;
      });
      role_[u] = FREE;
      best_[u] = Collapse();
      quadric_[v].add(quadric_[u], sub(point_[v], point_[u]));
      mesh_.collapse(h);
    }
  }

  const Watched_loop<Host_loop>& loop_;
  const Host_array<vec3>& point_;
  const Host_array<vec3>* const map_; ///< to be kept a bijection, or null
  Progressive_mesh& mesh_;
  Host_array<Quadric> quadric_;   ///< of every vertex, from there
  Host_array<Collapse> best_;     ///< of every vertex
  std::vector<Role> role_;        ///< of every vertex in the collapses chosen for this round
  Host_array<int> remaining_;     ///< vertices that were not removed before this round
  std::vector<char> is_outdated_; ///< whether the best collapse of a vertex may be another one by now
  std::vector<char> is_kept_;     ///< empty when none is any more
  int kept_until_;                ///< so many are left
  int band_size_;                 ///< number of vertices
  double unit_ = 1;               ///< of costs: the square of the mean area of a vertex
  int maximum_degree_ = 24;       ///< of vertices to be removed
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_DECIMATION_H
