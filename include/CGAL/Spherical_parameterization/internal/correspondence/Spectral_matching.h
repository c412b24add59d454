// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_SPECTRAL_MATCHING_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_SPECTRAL_MATCHING_H

#include <CGAL/Spherical_parameterization/internal/algebra/rotations.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/Spectral_refinement.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Which points of B are those of A: a map of the vertices of A to those of B, without anything but the shapes and
/// their maps to the sphere.
///
/// Eigenfunctions say precisely where a point belongs once it is known roughly (spectral upsampling), and see no
/// difference between a shape and its mirror image. The sphere knows that difference: a map that keeps orientation
/// there is none of a left hand to a right one. So candidates come from rotations of the sphere and from assignments of
/// the ends of limbs, and the limbs of those that are found are put onto each other anew with orientation kept, and
/// with left and right exchanged by the symmetry that B has itself. What decides is how much signatures and curvatures
/// differ, and how much of the surface keeps its orientation. The best candidates climb: they are made smooth on the
/// sphere and refined in turn as long as that makes them better. Answers that are nearly as good as the best one are
/// left to those who deform maps to them. See doc/registration.md.
template <class Loop>
class Spectral_matching : Spectral_refinement<Loop> {
  typedef Spectral_refinement<Loop> Base;
  using Base::a_, Base::are_guides_, Base::b_, Base::landmarks_, Base::loop_, Base::rough_distance;
  using Base::candidates, Base::distance, Base::first, Base::guided, Base::guiding_error, Base::is_apart,
    Base::is_better, Base::is_near, Base::judged, Base::nearest, Base::precise, Base::rows, Base::signature_difference,
    Base::upsample;
  typedef typename Base::Candidate Candidate;
  typedef typename Base::Cells Cells;
  typedef typename Base::Rows Rows;

public:
  static constexpr double share_of_work = 0.3; ///< for the callback, of a whole registration

  typedef typename Base::Shape Shape;
  typedef typename Base::Landmarks Landmarks;
  typedef typename Base::Map Map;

  struct Answer {
    Map map;                    ///< of all vertices
    double score = 0;           ///< the less the better
    double margin = 0;          ///< how much worse the best of all other answers is; infinite if there is none
    double difference = 0;      ///< of the signatures of points that correspond, from 0 to 1
    bool fits_landmarks = true; ///< all of them are near where they should be
  };

  using Base::Base;

  /// The best answer first, then those that are nearly as good.
  std::vector<Answer> run() const
  {
    constexpr double share_of_symmetries = share_of_work / 3, share_of_starts = 2 * share_of_work / 3;
    constexpr double clear = 0.4, much = 0.6, very_much = 1; // differences of scores
    constexpr double nearly = 0.1;
    constexpr int patience = 2, much_patience = 5, most_answers = 3;
    loop_.begin_stage(0, share_of_symmetries);
    const std::vector<Map> symmetries = Spectral_matching(loop_, b_, b_, {}, false).symmetries();
    loop_.begin_stage(share_of_symmetries, share_of_starts);
    const std::vector<Candidate> starts = first_candidates(symmetries);
    loop_.begin_stage(share_of_starts, share_of_work);

    std::vector<Climber> climbers;
    const auto go_on = [&](Climber& c, double farthest, int its_patience) {
      const std::vector<Candidate> all = bests(climbers);
      climb(c, best_of(all).score + farthest, its_patience);
    };
    const auto begin = [&](std::vector<Candidate> from, int most) {
      std::stable_sort(from.begin(), from.end(), is_better);
      std::vector<Map> known;
      for(const Climber& c : climbers)
        known.push_back(c.best.map);
      for(const Candidate& c : from)
        if(most > 0 && is_apart(c.map, known, different)) {
          climbers.push_back({c, c});
          go_on(climbers.back(), much, patience);
          known.push_back(c.map);
          known.push_back(climbers.back().best.map);
          --most;
        }
    };
    begin(starts, 4);
    begin(exchanged(best_of(bests(climbers)).map, symmetries), 2); // a duel of the best one with its mirror image
    if(const std::vector<Candidate> all = bests(climbers); margin(best_of(all), all, a_.some) < clear)
      for(Climber& c : climbers)
        go_on(c, very_much, much_patience);
    std::vector<Candidate> found = best_distinct(bests(climbers), 6, 0.1);
    found = candidates(found.size(), [&](int k) { return judged(found[k].map); });
    std::vector<Answer> result;
    for(const Candidate& c : best_distinct(found, most_answers, rough_distance))
      if(result.empty() || c.score <= result.front().score + nearly)
        result.push_back(answer(c, found));
    return result;
  }

private:
  static constexpr double orientation_weight = 0.3;
  static constexpr double different = 0.5; ///< from which on a candidate may climb beside another one

  /// Which samples a start is turned to: limbs, which are remote, or all of them.
  enum class Anchors { LIMBS, ALL };

  static const Candidate& best_of(const std::vector<Candidate>& found)
  {
    return *std::min_element(found.begin(), found.end(), is_better);
  }

  /// From rotations of the sphere, with limbs put onto each other, from the ends of limbs, and from landmarks.
  std::vector<Candidate> first_candidates(const std::vector<Map>& symmetries) const
  {
    const std::vector<Map> roughly = distinct(coarse_maps(), 5);
    std::vector<Map> starts = turned_to_tips();
    for(std::size_t k = 0; k < roughly.size() && k < 3; ++k)
      for(double width : {0.3, 0.5}) {
        starts.push_back(vertices_near(smoothed(roughly[k], width, Anchors::LIMBS)));
        for(const Map& symmetry : symmetries)
          starts.push_back(vertices_near(smoothed(composed(roughly[k], symmetry), width, Anchors::LIMBS)));
      }
    Map of_a, of_b;
    for(const auto& l : landmarks_) {
      of_a.push_back(l.of_a);
      of_b.push_back(l.of_b);
    }
    for(double width : {0.3, 0.5, 0.7})
      if(are_guides_ && landmarks_.size() >= 3)
        starts.push_back(turned_to(of_a, of_b, width));
    const int number_of_turned = static_cast<int>(starts.size());
    starts.insert(starts.end(), roughly.begin(), roughly.end());
    return candidates(starts.size(), [&](int k) {
      const std::vector<int> numbers =
        k < number_of_turned ? std::vector<int>{14, 17, 20, 25, 30} : std::vector<int>{20, 25, 30};
      return guided(upsample(starts[k], a_.some, b_.sample, numbers).map, {30, 40});
    });
  }

  /// A map with left and right exchanged.
  std::vector<Candidate> exchanged(const Map& map, const std::vector<Map>& symmetries) const
  {
    std::vector<Map> starts;
    for(const Map& symmetry : symmetries)
      for(double width : {0.2, 0.3, 0.4, 0.5, 0.7})
        for(Anchors anchors : {Anchors::LIMBS, Anchors::ALL})
          starts.push_back(vertices_near(smoothed(composed(map, symmetry), width, anchors)));
    return candidates(starts.size(), [&](int k) { return guided(starts[k], {20, 30, 40}); });
  }

  static Places images(const Shape& shape, const Map& vertices)
  {
    Places result;
    for(int v : vertices)
      result.push_back(shape.image[v]);
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

  /// The first few maps that differ roughly from each other, and from one that is known.
  std::vector<Map> distinct(const std::vector<Map>& maps, std::size_t number, const Map& known = {}) const
  {
    std::vector<Map> result;
    for(const Map& m : maps)
      if(result.size() < number && is_apart(m, result, rough_distance) &&
         (known.empty() || is_apart(m, {known}, rough_distance)))
        result.push_back(m);
    return result;
  }

  /// The best few, farther from each other than `limit`.
  std::vector<Candidate> best_distinct(std::vector<Candidate> pool, std::size_t number, double limit) const
  {
    std::stable_sort(pool.begin(), pool.end(), is_better);
    std::vector<Candidate> result;
    std::vector<Map> maps;
    for(Candidate& c : pool)
      if(result.size() < number && is_apart(c.map, maps, limit)) {
        maps.push_back(c.map);
        result.push_back(std::move(c));
      }
    return result;
  }

  /// How much worse the best of all other answers is than one, infinite if there is none.
  double margin(const Candidate& one, const std::vector<Candidate>& found, const Cells& cells) const
  {
    double result = std::numeric_limits<double>::infinity();
    for(const Candidate& other : found)
      if(distance(one.map, other.map, cells) > rough_distance)
        result = (std::min)(result, other.score - one.score);
    return result;
  }

  Answer answer(const Candidate& c, const std::vector<Candidate>& found) const
  {
    Answer result = {precise(c.map), c.score, margin(c, found, a_.all)};
    for(int i = 0; i < a_.size(); ++i)
      result.difference += a_.area[i] * signature_difference(a_, i, b_, result.map[i]);
    for(const auto& l : landmarks_)
      result.fits_landmarks = result.fits_landmarks && is_near(l.distance, result.map[l.of_a]);
    return result;
  }

  /// Where a candidate has come to.
  struct Climber {
    Candidate at, best;
    int in_vain = 0; ///< steps since the best
  };

  static std::vector<Candidate> bests(const std::vector<Climber>& climbers)
  {
    std::vector<Candidate> result;
    for(const Climber& c : climbers)
      result.push_back(c.best);
    return result;
  }

  /// By steps to the best one of a few neighbours, each smooth on the sphere and refined. Where that does not help
  /// much, limbs are made longer or shorter: shapes differ by that. Local optima are many, so a few steps may be in
  /// vain. \param limit  a score: no such patience if its best is worse
  void climb(Climber& c, double limit, int patience) const
  {
    constexpr int most_steps = 20;
    constexpr double little = 0.02, least = 1e-3, change_of_limbs = 0.2;
    for(int k = 0; k < most_steps && c.in_vain <= patience; ++k) {
      const double score = c.best.score;
      Candidate next = best_refined({smoothed(c.at.map, 0.15, Anchors::ALL), smoothed(c.at.map, 0.3, Anchors::ALL)});
      if(score - next.score <= little) {
        const Places smooth = smoothed(c.at.map, 0.2, Anchors::ALL);
        std::vector<Places> ways;
        for(int tip : a_.tip)
          for(double change : {-change_of_limbs, change_of_limbs})
            ways.push_back(moved_from(smooth[a_.some.of_vertex[tip]], change, smooth));
        if(Candidate other = best_refined(ways); is_better(other, next))
          next = std::move(other);
      }
      c.at = std::move(next);
      if(is_better(c.at, c.best))
        c.best = c.at;
      c.in_vain = score - c.best.score > least ? 0 : c.in_vain + 1;
      if(c.in_vain > 0 && c.best.score > limit)
        return;
    }
  }

  /// The best of them when refined by a few eigenfunctions; those that lead then, by more.
  Candidate best_refined(const std::vector<Places>& ways) const
  {
    constexpr std::size_t most = 2;
    const std::vector<Candidate> found =
      candidates(ways.size(), [&](int k) { return guided(vertices_near(ways[k]), {20}, ways[k]); });
    std::vector<std::size_t> order(ways.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t k, std::size_t l) { return is_better(found[k], found[l]); });
    order.resize((std::min)(order.size(), most));
    const std::vector<Candidate> last = candidates(order.size(), [&](int k) {
      return guided(found[order[k]].map, {30, 40}, ways[order[k]]);
    });
    return *std::min_element(last.begin(), last.end(), is_better);
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
    for(int begin : {0, number}) {
      std::vector<int> order(number);
      std::iota(order.begin(), order.end(), begin);
      std::stable_sort(order.begin(), order.end(), [&](int x, int y) { return sum[x] < sum[y]; });
      for(int k = 0; k < most; ++k) {
        Map start;
        for(int i = 0; i < a_.some.size(); ++i)
          start.push_back(map[order[k]][a_.few.of_vertex[a_.sample[i]]]);
        starts.push_back(std::move(start));
      }
    }
    std::vector<Candidate> found = candidates(starts.size(), [&](int k) {
      return upsample(starts[k], a_.some, b_.sample, {6, 10, 14, 20});
    });
    for(Candidate& c : found)
      c.score = c.residual - weight_of_orientation * c.orientation + guiding_error(c.map);
    std::stable_sort(found.begin(), found.end(), is_better);
    std::vector<Map> result;
    for(Candidate& c : found)
      result.push_back(std::move(c.map));
    return result;
  }

  /// Of a shape to itself: up to two isometries other than the identity, of the samples: other vertices go where
  /// the nearest sample goes. They exchange left and right, and turn the surface over.
  std::vector<Map> symmetries() const
  {
    const std::vector<Map> starts = distinct(coarse_maps(-orientation_weight), 5, first(a_.sample, a_.some));
    std::vector<Candidate> found;
    for(Candidate& c : candidates(starts.size(), [&](int k) { return judged(starts[k]); })) {
      c.score += 2 * c.orientation; // less orientation is better here
      if(distance(c.map, a_.sample, a_.all) > rough_distance)
        found.push_back(std::move(c));
    }
    std::vector<Map> result;
    for(const Candidate& c : best_distinct(std::move(found), 2, rough_distance))
      result.push_back(composed(a_.all.of_vertex, nearest(a_.sample, c.functional)));
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
      const Map &own = fewer.tip, other = composed({found[k].second.begin(), found[k].second.begin() + n}, more.tip);
      for(double width : {0.4, 0.7})
        result.push_back(has_a_fewer ? turned_to(own, other, width) : turned_to(other, own, width));
    }
    return result;
  }

  /// Places of the first samples that keep orientation; anchors stay near where a map has them.
  Places smoothed(const Map& map, double width, Anchors anchors) const
  {
    const Places anchor = images(a_, first(a_.sample, a_.some));
    std::vector<double> weight;
    for(int i = 0; i < a_.some.size(); ++i) {
      const double remoteness = anchors == Anchors::LIMBS ? a_.remoteness[a_.sample[i]] : 1;
      weight.push_back(a_.some.area[i] * remoteness * remoteness * remoteness);
    }
    return turned(anchor, anchor, images(b_, map), weight, width);
  }

  /// All samples, smoothly with a few vertices that go to those of B.
  Map turned_to(const Map& anchor, const Map& of_b, double width) const
  {
    return vertices_near(turned(images(a_, first(a_.sample, a_.some)), images(a_, anchor), images(b_, of_b),
                                std::vector<double>(anchor.size(), 1.), width));
  }
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_SPECTRAL_MATCHING_H
