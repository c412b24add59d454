// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_SPECTRAL_MATCHING_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_SPECTRAL_MATCHING_H

#include <CGAL/Spherical_parameterization/internal/algebra/pi.h>
#include <CGAL/Spherical_parameterization/internal/algebra/rotations.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/Spectral_shape.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/Star.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Rotations that cover all of them evenly: M. Alexa, "Super-Fibonacci spirals", CVPR 2022.
inline Matrix_3 super_fibonacci_rotation(int i, int number)
{
  constexpr double psi = 1.533751168755204288118041;
  const double s = i + 0.5, r = std::sqrt(s / number), other = std::sqrt(1 - s / number);
  const double alpha = 2 * pi * s / std::sqrt(2.), beta = 2 * pi * s / psi;
  return rotation_of_quaternion(
    {other * std::cos(beta), r * std::sin(alpha), r * std::cos(alpha), other * std::sin(beta)});
}

/// Which points of B are those of A: a map of the vertices of A to those of B, without anything but the shapes and
/// their maps to the sphere.
///
/// Eigenfunctions say precisely where a point belongs once it is known roughly (spectral upsampling), and see no
/// difference between a shape and its mirror image. The sphere knows that difference: a map that keeps orientation
/// there is none of a left hand to a right one. So candidates come from rotations of the sphere and from assignments of
/// the ends of limbs, and the limbs of those that are found are put onto each other anew with orientation kept, and
/// with left and right exchanged by the symmetry that B has itself. What decides is how much signatures and curvatures
/// differ, and how much of the surface keeps its orientation. The best candidates climb: they are made smooth on the
/// sphere and refined in turn as long as that makes them better. See doc/registration.md.
template <class Loop>
class Spectral_matching {
public:
  static constexpr double share_of_work = 0.3; ///< for the callback, of a whole registration

  typedef Spectral_shape<Loop> Shape;
  typedef typename Shape::Rows Rows;
  typedef std::vector<int> Map; ///< of samples of A, in their order, or of all its vertices: vertices of B

  /// Vertices of A and of B that correspond.
  typedef std::vector<std::pair<int, int>> Landmarks;

  struct Match {
    Map map;               ///< of all vertices
    double margin = 0;     ///< how much worse the best of all other answers is; infinite if there is none
    double difference = 0; ///< of the signatures of points that correspond, from 0 to 1
  };

  Spectral_matching(const Watched_loop<Loop>& loop, const Shape& a, const Shape& b, const Landmarks& landmarks)
    : loop_(loop), a_(a), b_(b), most_functions_((std::min)(a.number_of_functions(), b.number_of_functions()))
  {
    for(const auto& [v, w] : landmarks)
      landmarks_.push_back({v, w, b.graph.distances(w)});
  }

  Match run() const
  {
    constexpr double share_of_symmetries = share_of_work / 3, share_of_starts = 2 * share_of_work / 3;
    loop_.begin_stage(0, share_of_symmetries);
    const std::vector<Map> symmetries = Spectral_matching(loop_, b_, b_, {}).symmetries();

    loop_.begin_stage(share_of_symmetries, share_of_starts);
    const std::vector<Map> roughly = distinct(coarse_maps(), 5, a_.some, rough_distance);
    std::vector<Map> starts;
    for(std::size_t k = 0; k < roughly.size() && k < 3; ++k)
      for(double width : {0.3, 0.5}) {
        starts.push_back(vertices_near(turned(roughly[k], width, Anchors::LIMBS)));
        for(const Map& symmetry : symmetries)
          starts.push_back(vertices_near(turned(composed(roughly[k], symmetry), width, Anchors::LIMBS)));
      }
    for(double width : {0.3, 0.5, 0.7})
      if(landmarks_.size() >= 3)
        starts.push_back(turned_to_landmarks(width));
    for(Map& start : turned_to_tips())
      starts.push_back(std::move(start));
    std::vector<Map> pool;
    for(Candidate& c : upsampled(starts, {14, 17, 20, 25, 30}))
      pool.push_back(std::move(c.map));
    for(Candidate& c : upsampled(roughly, {20, 25, 30}))
      pool.push_back(std::move(c.map));
    loop_.begin_stage(share_of_starts, share_of_work);
    std::vector<Candidate> found;
    climb(guided(pool, {30, 40}), 4, found);

    // A duel of the best one with itself where left and right are exchanged
    const Map best_map = std::min_element(found.begin(), found.end(), is_better)->map;
    starts.clear();
    for(const Map& symmetry : symmetries)
      for(double width : {0.2, 0.3, 0.4, 0.5, 0.7})
        for(Anchors anchors : {Anchors::LIMBS, Anchors::ALL})
          starts.push_back(vertices_near(turned(composed(best_map, symmetry), width, anchors)));
    climb(guided(starts, climbing_numbers_), 2, found);
    found = judged(best_distinct(std::move(found), 6, 0.1));
    std::stable_sort(found.begin(), found.end(), is_better);

    Match result;
    const Candidate& best = found.front();
    result.margin = std::numeric_limits<double>::infinity();
    for(const Candidate& other : found)
      if(distance(best.map, other.map, a_.all) > rough_distance)
        result.margin = (std::min)(result.margin, other.score - best.score);
    result.map = on_all_vertices(upsample(best.map, a_.all, all_vertices(), {80, 100, 120}));
    for(int i = 0; i < a_.size(); ++i)
      result.difference += a_.area[i] * signature_difference(a_, i, b_, result.map[i]);
    return result;
  }

private:
  static constexpr double rough_distance = 0.35; ///< from which on two maps are different answers
  static constexpr double orientation_weight = 0.3;

  typedef std::vector<vec3> Places; ///< on the sphere of B

  /// Which samples a start is turned to: limbs, which are remote, or all of them.
  enum class Anchors { LIMBS, ALL };

  struct Candidate {
    Map map;         ///< of the first samples
    Rows functional; ///< C = Phi_A^T M_A Phi_B[map]
    double residual = 0;
    double orientation = 0; ///< the share of the area that keeps its orientation less that which does not
    double score = 0;       ///< the less the better
  };

  struct Landmark {
    int of_a, of_b;
    std::vector<double> distance; ///< on B
  };

  static bool is_better(const Candidate& x, const Candidate& y) { return x.score < y.score; }

  static std::vector<int> first(const std::vector<int>& samples, const typename Shape::Cells& cells)
  {
    return {samples.begin(), samples.begin() + cells.size()};
  }

  Map on_all_samples(const Map& map) const
  {
    Map result;
    for(int v : a_.sample)
      result.push_back(map[a_.some.of_vertex[v]]);
    return result;
  }

  Map all_vertices() const
  {
    Map result(b_.size());
    std::iota(result.begin(), result.end(), 0);
    return result;
  }

  Map vertices_near(const Places& places) const
  {
    Map result;
    for(const vec3& p : places)
      result.push_back(b_.vertex_near(p));
    return result;
  }

  static Map composed(Map map, const Map& of_b)
  {
    for(int& t : map)
      t = of_b[t];
    return map;
  }

  static Rows rows(const Rows& all, const std::vector<int>& which, int columns)
  {
    Rows result(which.size(), columns);
    for(std::size_t r = 0; r < which.size(); ++r)
      result.row(r) = all.row(which[r]).head(columns);
    return result;
  }

  /// Calls f(r, s, square) with the nearest row s of `to`, and its squared distance, for every row r of `from`.
  template <class F>
  static void for_each_nearest(const Rows& from, const Rows& to, F f)
  {
    constexpr int block = 64;
    const auto half = (to.rowwise().squaredNorm() / 2).eval();
    const Rows transposed = to.transpose();
    Rows product;
    for(int begin = 0; begin < from.rows(); begin += block) {
      const int size = (std::min)(block, static_cast<int>(from.rows()) - begin);
      product.noalias() = from.middleRows(begin, size) * transposed;
      for(int r = 0; r < size; ++r) {
        const float* p = product.row(r).data();
        int nearest = 0;
        for(int s = 1; s < to.rows(); ++s)
          if(p[s] - half[s] > p[nearest] - half[nearest])
            nearest = s;
        const float square = from.row(begin + r).squaredNorm() - 2 * (p[nearest] - half[nearest]);
        f(begin + r, nearest, (std::max)(0.f, square));
      }
    }
  }

  /// Every vertex goes downhill in the embedding by eigenfunctions, from where its sample has been mapped to.
  Map on_all_vertices(const Candidate& of_samples) const
  {
    const Rows &c = of_samples.functional, to = b_.function.leftCols(c.cols()) * c.transpose();
    Map result(a_.size());
    loop_.for_each(a_.size(), [&](int i) {
      const auto square = [&](int w) { return (a_.function.row(i).head(c.rows()) - to.row(w)).squaredNorm(); };
      int at = of_samples.map[a_.all.of_vertex[i]];
      float least = square(at);
      for(int before = -1; before != at;) {
        before = at;
        b_.graph.for_each_way(before, [&](int w, double) {
          if(const float s = square(w); s < least) {
            least = s;
            at = w;
          }
        });
      }
      result[i] = at;
    });
    return result;
  }

  /// With more and more eigenfunctions: S. Melzi, J. Ren, E. Rodola, A. Sharma, P. Wonka, M. Ovsjanikov, "ZoomOut",
  /// ACM TOG 38 (2019).
  /// \param beside_a, beside_b  what else is compared: a row for each sample, and for each target
  Candidate upsample(Map map, const typename Shape::Cells& cells, const std::vector<int>& targets,
                     const std::vector<int>& numbers, const Rows& beside_a = Rows(),
                     const Rows& beside_b = Rows()) const
  {
    const std::vector<int> samples = first(a_.sample, cells);
    const int others = static_cast<int>(beside_a.cols());
    Candidate c;
    for(int number : numbers) {
      const int k = (std::min)(number, most_functions_);
      Rows from(samples.size(), k + others), to(targets.size(), k + others);
      from.leftCols(k) = rows(a_.function, samples, k);
      Rows weighted = from.leftCols(k);
      for(int r = 0; r < cells.size(); ++r)
        weighted.row(r) *= static_cast<float>(cells.area[r]);
      c.functional.noalias() = weighted.transpose() * rows(b_.function, map, k);
      to.leftCols(k) = rows(b_.function, targets, k) * c.functional.transpose();
      if(others > 0) {
        from.rightCols(others) = beside_a;
        to.rightCols(others) = beside_b;
      }
      double sum = 0;
      for_each_nearest(from, to, [&](int r, int s, float square) {
        map[r] = targets[s];
        sum += cells.area[r] * (others == 0 ? square : (from.row(r) - to.row(s)).head(k).squaredNorm());
      });
      c.residual = std::sqrt(sum / k);
    }
    c.map = std::move(map);
    c.orientation = orientation(c.functional);
    return c;
  }

  /// Of the smooth map to the sphere that C stands for.
  double orientation(const Rows& functional) const
  {
    const int k = static_cast<int>(functional.rows());
    const Rows carried = functional * b_.sphere.topRows(functional.cols());
    double sum = 0;
    for(const std::array<int, 3>& f : a_.some_face) {
      std::array<vec3, 3> at;
      for(int c = 0; c < 3; ++c) {
        const auto p = (a_.function.row(f[c]).head(k) * carried).eval();
        at[c] = {p(0), p(1), p(2)};
      }
      const double d = determinant(at[0], at[1], at[2]);
      sum += d > 0 ? 1 : d < 0 ? -1 : 0;
    }
    return sum / static_cast<double>(a_.some_face.size());
  }

  /// The mean distance on B from where landmarks should be, so weighted that nothing outweighs it.
  double landmark_error(const Map& map, const typename Shape::Cells& cells) const
  {
    constexpr double weight = 10;
    double sum = 0;
    for(const Landmark& l : landmarks_)
      sum += weight * l.distance[map[cells.of_vertex[l.of_a]]] / static_cast<double>(landmarks_.size());
    return sum;
  }

  /// Root mean square distance of two maps in the embedding by eigenfunctions.
  double distance(const Map& x, const Map& y, const typename Shape::Cells& cells) const
  {
    const int k = (std::min)(20, most_functions_ - 1);
    double sum = 0;
    for(int r = 0; r < cells.size(); ++r)
      sum += cells.area[r] * (b_.function.row(x[r]).segment(1, k) - b_.function.row(y[r]).segment(1, k)).squaredNorm();
    return std::sqrt(sum / k);
  }

  /// The first few maps that are farther from each other than `limit`, and from one that is known.
  std::vector<Map> distinct(const std::vector<Map>& maps, std::size_t number, const typename Shape::Cells& cells,
                            double limit, const Map& known = {}) const
  {
    std::vector<Map> result;
    for(const Map& m : maps)
      if(result.size() < number && (known.empty() || distance(m, known, cells) > limit) &&
         std::all_of(result.begin(), result.end(), [&](const Map& o) { return distance(m, o, cells) > limit; }))
        result.push_back(m);
    return result;
  }

  std::vector<Candidate> best_distinct(std::vector<Candidate> pool, std::size_t number, double limit) const
  {
    std::stable_sort(pool.begin(), pool.end(), is_better);
    std::vector<Candidate> result;
    for(Candidate& c : pool)
      if(result.size() < number && std::all_of(result.begin(), result.end(), [&](const Candidate& o) {
           return distance(c.map, o.map, a_.some) > limit;
         }))
        result.push_back(std::move(c));
    return result;
  }

  std::vector<Candidate> upsampled(const std::vector<Map>& starts, const std::vector<int>& numbers) const
  {
    std::vector<Candidate> result(starts.size());
    loop_.for_each(static_cast<int>(starts.size()),
                   [&](int k) { result[k] = upsample(starts[k], a_.some, b_.sample, numbers); });
    return result;
  }

  /// Eigenfunctions of shapes that differ lead astray: features guide them and, if there are any, places that keep
  /// orientation. With the score that decides.
  Candidate guided(Map map, const std::vector<int>& numbers, const Places& places = {}) const
  {
    constexpr float weight_of_places = 4;
    constexpr int number = Shape::number_of_features;
    const int columns = number + (places.empty() ? 0 : 3);
    const std::vector<int> targets = first(b_.sample, b_.some);
    Rows beside_a(map.size(), columns), beside_b(targets.size(), columns);
    beside_a.leftCols(number) = rows(a_.feature, first(a_.sample, a_.some), number);
    beside_b.leftCols(number) = rows(b_.feature, targets, number);
    const auto place = [&](Rows& of, std::size_t r, vec3 p) {
      of.row(r).tail(3) << static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z);
      of.row(r).tail(3) *= weight_of_places;
    };
    if(!places.empty()) {
      for(std::size_t r = 0; r < places.size(); ++r)
        place(beside_a, r, places[r]);
      for(std::size_t r = 0; r < targets.size(); ++r)
        place(beside_b, r, b_.image[targets[r]]);
    }
    return with_score(upsample(std::move(map), a_.some, targets, numbers, beside_a, beside_b), a_.some);
  }

  std::vector<Candidate> guided(const std::vector<Map>& starts, const std::vector<int>& numbers) const
  {
    std::vector<Candidate> result(starts.size());
    loop_.for_each(static_cast<int>(starts.size()), [&](int k) { result[k] = guided(starts[k], numbers); });
    return result;
  }

  /// Adds up to `most` of the candidates, the best first, that are not like each other or those that have been found.
  void climb(std::vector<Candidate> candidates, int most, std::vector<Candidate>& found) const
  {
    constexpr double different = 0.5;
    std::stable_sort(candidates.begin(), candidates.end(), is_better);
    std::vector<Map> known;
    for(const Candidate& c : found)
      known.push_back(c.map);
    for(const Candidate& c : candidates)
      if(most > 0 && std::all_of(known.begin(), known.end(),
                                 [&](const Map& o) { return distance(c.map, o, a_.some) > different; })) {
        found.push_back(climbed(c));
        known.push_back(c.map);
        known.push_back(found.back().map);
        --most;
      }
  }

  /// By steps to the best one of a few neighbours, each smooth on the sphere and refined. Where that does not help
  /// much, limbs are made longer or shorter: shapes differ by that.
  Candidate climbed(Candidate c) const
  {
    constexpr int most_steps = 10;
    constexpr double little = 0.02, least = 1e-3, change_of_limbs = 0.2;
    const auto step = [&](const std::vector<Places>& ways) {
      std::vector<Candidate> next(ways.size());
      loop_.for_each(static_cast<int>(ways.size()),
                     [&](int k) { next[k] = guided(vertices_near(ways[k]), climbing_numbers_, ways[k]); });
      for(Candidate& other : next)
        if(is_better(other, c))
          c = std::move(other);
    };
    for(int k = 0; k < most_steps; ++k) {
      const Map before = c.map;
      const double score = c.score;
      step({turned(before, 0.15, Anchors::ALL), turned(before, 0.3, Anchors::ALL)});
      if(score - c.score <= little) {
        const Places smooth = turned(before, 0.2, Anchors::ALL);
        std::vector<Places> ways;
        for(int tip : a_.tip)
          for(double change : {-change_of_limbs, change_of_limbs})
            ways.push_back(moved_from(smooth[a_.some.of_vertex[tip]], change, smooth));
        step(ways);
      }
      if(score - c.score <= least)
        break;
    }
    return c;
  }

  /// Moves places away from a centre, the more so the farther off they are, within reach.
  static Places moved_from(vec3 centre, double change, Places places)
  {
    constexpr double reach = 0.6;
    for(vec3& p : places) {
      const vec3 d = sub(p, centre);
      p = unit(add_scaled(p, change * std::exp(-inner(d, d) / (2 * reach * reach)), d));
    }
    return places;
  }

  /// Maps of the first samples by rotations and reflections of the sphere, best first. What is compared is what bending
  /// does not change much.
  std::vector<Map> coarse_maps(double weight_of_orientation = orientation_weight) const
  {
    constexpr int number = 600, most = 50, features = 3;
    constexpr double most_stretch = 2;
    const std::vector<int> samples = first(a_.sample, a_.few);
    const auto by_scale = b_.signature.array().square().colwise().mean().sqrt().inverse().eval();
    const Rows signature_a = rows(a_.signature, samples, Shape::number_of_energies).array().rowwise() * by_scale;
    const Rows signature_b = b_.signature.array().rowwise() * by_scale;
    std::vector<Map> map(2 * number, Map(samples.size()));
    std::vector<std::array<double, features>> difference(map.size());
    loop_.for_each(static_cast<int>(map.size()), [&](int r) {
      const Matrix_3 rotation = super_fibonacci_rotation(r % number, number);
      difference[r] = {};
      for(std::size_t i = 0; i < samples.size(); ++i) {
        const int v = samples[i];
        const vec3 p = a_.image[v];
        const int t = map[r][i] = b_.vertex_near(rotated(rotation, {p.x, p.y, r < number ? p.z : -p.z}));
        const double area = a_.few.area[i];
        difference[r][0] += area * std::abs(a_.remoteness[v] - b_.remoteness[t]);
        difference[r][1] += area * (signature_a.row(i) - signature_b.row(t)).cwiseAbs().mean();
        difference[r][2] += area * (std::min)(most_stretch, std::abs(a_.stretch[v] - b_.stretch[t]));
      }
    });
    std::vector<double> sum(map.size(), 0.);
    for(int k = 0; k < features; ++k) {
      std::vector<double> all;
      for(const auto& d : difference)
        all.push_back(d[k]);
      std::nth_element(all.begin(), all.begin() + number, all.end());
      for(std::size_t r = 0; r < map.size(); ++r)
        sum[r] += difference[r][k] / (std::max)(all[number], 1e-300);
    }
    std::vector<Map> starts;
    for(int first : {0, number}) {
      std::vector<int> order(number);
      std::iota(order.begin(), order.end(), first);
      std::stable_sort(order.begin(), order.end(), [&](int x, int y) { return sum[x] < sum[y]; });
      for(int k = 0; k < most; ++k) {
        Map start;
        for(int i = 0; i < a_.some.size(); ++i)
          start.push_back(map[order[k]][a_.few.of_vertex[a_.sample[i]]]);
        starts.push_back(std::move(start));
      }
    }
    std::vector<Candidate> candidates = upsampled(starts, {6, 10, 14, 20});
    for(Candidate& c : candidates)
      c.score = c.residual - weight_of_orientation * c.orientation + landmark_error(c.map, a_.some);
    std::stable_sort(candidates.begin(), candidates.end(), is_better);
    std::vector<Map> result;
    for(Candidate& c : candidates)
      result.push_back(std::move(c.map));
    return result;
  }

  /// Of a shape to itself: up to two isometries other than the identity, of every vertex. They exchange left and right,
  /// and turn the surface over.
  std::vector<Map> symmetries() const
  {
    std::vector<Candidate> found;
    for(const Map& start :
        distinct(coarse_maps(-orientation_weight), 5, a_.some, rough_distance, first(a_.sample, a_.some))) {
      Candidate c;
      c.map = start;
      c = judged({std::move(c)}).front();
      c.score += 2 * c.orientation;
      if(distance(c.map, a_.sample, a_.all) > rough_distance)
        found.push_back(std::move(c));
    }
    std::vector<Map> result;
    for(const Candidate& c : best_distinct(std::move(found), 2, rough_distance)) {
      Map map(a_.size());
      const Rows from = a_.function.leftCols(c.functional.rows());
      const Rows to = rows(a_.function, a_.target, static_cast<int>(c.functional.cols())) * c.functional.transpose();
      for_each_nearest(from, to, [&](int r, int s, float) { map[r] = a_.target[s]; });
      result.push_back(std::move(map));
    }
    return result;
  }

  /// Places that keep orientation: the samples are rotated on the sphere as anchors want it, and moved smoothly towards
  /// where these belong. \param weight  of the anchors
  Places turned(const std::vector<int>& anchor, const std::vector<vec3>& place, const std::vector<double>& weight,
                double width) const
  {
    Matrix_3 products = {};
    std::vector<vec3> from;
    for(std::size_t k = 0; k < anchor.size(); ++k) {
      const vec3 p = a_.image[anchor[k]];
      const std::array<double, 3> f = {p.x, p.y, p.z}, t = {place[k].x, place[k].y, place[k].z};
      for(int i = 0; i < 3; ++i)
        for(int j = 0; j < 3; ++j)
          products[i][j] += weight[k] * f[i] * t[j];
    }
    const Matrix_3 rotation = rotation_of_products(products);
    for(int v : anchor)
      from.push_back(rotated(rotation, a_.image[v]));
    Places result;
    for(int i = 0; i < a_.some.size(); ++i) {
      const vec3 p = rotated(rotation, a_.image[a_.sample[i]]);
      vec3 d = {0, 0, 0};
      double sum = 0;
      for(std::size_t k = 0; k < anchor.size(); ++k) {
        const double w = std::exp((inner(p, from[k]) - 1) / (width * width)) * weight[k];
        d = add_scaled(d, w, sub(place[k], from[k]));
        sum += w;
      }
      result.push_back(unit(add_scaled(p, sum > 0 ? 1 / sum : 0, d)));
    }
    return result;
  }

  /// Starts by the ends of limbs: by those assignments of them that differ least in remoteness, signature, and geodesic
  /// distance from each other.
  std::vector<Map> turned_to_tips() const
  {
    constexpr std::size_t most = 12, least_tips = 3;
    const bool has_a_fewer = a_.tip.size() <= b_.tip.size();
    const Shape &fewer = has_a_fewer ? a_ : b_, &more = has_a_fewer ? b_ : a_;
    const std::size_t n = fewer.tip.size();
    if(n < least_tips)
      return {};
    typedef std::pair<double, std::vector<int>> Assignment; // difference, and the other tip of every tip
    std::vector<Assignment> found;
    std::vector<int> order(more.tip.size());
    std::iota(order.begin(), order.end(), 0);
    do {
      if(!std::is_sorted(order.begin() + static_cast<std::ptrdiff_t>(n), order.end()))
        continue; // the same but for those that are left over
      double difference = 0;
      for(std::size_t i = 0; i < n; ++i) {
        const int v = fewer.tip[i], w = more.tip[order[i]];
        difference += std::abs(fewer.remoteness[v] - more.remoteness[w]) + signature_difference(fewer, v, more, w);
        for(std::size_t j = 0; j < i; ++j)
          difference += std::abs(fewer.tip_distance[i][j] - more.tip_distance[order[i]][order[j]]);
      }
      found.emplace_back(difference, order);
    } while(std::next_permutation(order.begin(), order.end()));
    std::stable_sort(found.begin(), found.end());
    std::vector<Map> result;
    for(std::size_t k = 0; k < (std::min)(most, found.size()); ++k) {
      std::vector<int> anchor;
      std::vector<vec3> place;
      for(std::size_t i = 0; i < n; ++i) {
        const int own = fewer.tip[i], other = more.tip[found[k].second[i]];
        anchor.push_back(has_a_fewer ? own : other);
        place.push_back(b_.image[has_a_fewer ? other : own]);
      }
      for(double width : {0.4, 0.7})
        result.push_back(vertices_near(turned(anchor, place, std::vector<double>(n, 1.), width)));
    }
    return result;
  }

  /// From 0 to 1.
  static double signature_difference(const Shape& a, int v, const Shape& b, int w)
  {
    const auto x = a.signature.row(v), y = b.signature.row(w);
    return (x - y).cwiseAbs().sum() / (x + y).cwiseAbs().sum();
  }

  /// Anchors stay where a map has them.
  Places turned(const Map& map, double width, Anchors anchors) const
  {
    const std::vector<int> anchor = first(a_.sample, a_.some);
    Places place;
    std::vector<double> weight;
    for(int i = 0; i < a_.some.size(); ++i) {
      place.push_back(b_.image[map[i]]);
      const double remoteness = anchors == Anchors::LIMBS ? a_.remoteness[anchor[i]] : 1;
      weight.push_back(a_.some.area[i] * remoteness * remoteness * remoteness);
    }
    return turned(anchor, place, weight, width);
  }

  Map turned_to_landmarks(double width) const
  {
    std::vector<int> anchor;
    std::vector<vec3> place;
    for(const Landmark& l : landmarks_) {
      anchor.push_back(l.of_a);
      place.push_back(b_.image[l.of_b]);
    }
    return vertices_near(turned(anchor, place, std::vector<double>(anchor.size(), 1.), width));
  }

  /// With the score that decides.
  Candidate with_score(Candidate c, const typename Shape::Cells& cells) const
  {
    constexpr double least = 1e-9;
    double signatures = 0;
    std::array<double, 2> curvatures = {};
    for(int i = 0; i < cells.size(); ++i) {
      const int v = a_.sample[i], t = c.map[i];
      signatures += cells.area[i] * signature_difference(a_, v, b_, t);
      for(std::size_t s = 0; s < curvatures.size(); ++s)
        curvatures[s] += cells.area[i] * std::abs(a_.curvature[s][v] - b_.curvature[s][t]);
    }
    c.score = std::log((std::max)(signatures, least)) - c.orientation + landmark_error(c.map, cells);
    for(double difference : {curvatures[0], curvatures[1], c.residual})
      c.score += std::log((std::max)(difference, least)) / 2;
    return c;
  }

  /// With many eigenfunctions, and the score that decides.
  std::vector<Candidate> judged(const std::vector<Candidate>& candidates) const
  {
    std::vector<Candidate> result(candidates.size());
    loop_.for_each(static_cast<int>(candidates.size()), [&](int n) {
      result[n] = with_score(upsample(on_all_samples(candidates[n].map), a_.all, b_.target, {30, 40, 50, 60}), a_.all);
    });
    return result;
  }

  const Watched_loop<Loop>& loop_;
  const Shape& a_;
  const Shape& b_;
  int most_functions_;
  const std::vector<int> climbing_numbers_ = {20, 25, 30, 40}; ///< of eigenfunctions
  std::vector<Landmark> landmarks_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_SPECTRAL_MATCHING_H
