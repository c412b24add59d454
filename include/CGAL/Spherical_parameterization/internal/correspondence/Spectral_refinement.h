// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_SPECTRAL_REFINEMENT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_SPECTRAL_REFINEMENT_H

#include <CGAL/Spherical_parameterization/internal/algebra/Nearest_rows.h>
#include <CGAL/Spherical_parameterization/internal/algebra/dense_matrices.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/Spectral_shape.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/places_on_sphere.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/Star.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Maps of samples of a shape A to vertices of a shape B: how they are refined by eigenfunctions, and what is compared
/// to choose one.
template <class Loop>
class Spectral_refinement {
public:
  typedef Spectral_shape<Loop> Shape;
  typedef typename Shape::Rows Rows;
  typedef typename Shape::Cells Cells;
  typedef std::vector<int> Map; ///< of samples of A, in their order, or of all its vertices: vertices of B

  /// Vertices of A and of B that correspond.
  typedef std::vector<std::pair<int, int>> Landmarks;

  static constexpr double rough_distance = 0.35; ///< from which on two maps are different answers

  struct Candidate {
    Map map;         ///< of the first samples, or of all of them
    Rows functional; ///< C = Phi_A^T M_A Phi_B[map]
    double residual = 0;
    double orientation = 0; ///< the share of the area that keeps its orientation less that which does not
    double score = 0;       ///< the less the better
  };

  /// \param are_guides  whether landmarks count from the beginning, and not only in `judged()`
  Spectral_refinement(const Watched_loop<Loop>& loop, const Shape& a, const Shape& b, const Landmarks& landmarks,
                      bool are_guides)
    : loop_(loop), a_(a), b_(b), are_guides_(are_guides),
      most_functions_((std::min)(a.number_of_functions(), b.number_of_functions()))
  {
    for(const auto& [v, w] : landmarks) {
      loop_.check();
      landmarks_.push_back({v, w, b.graph.distances(w)});
    }
  }

  static bool is_better(const Candidate& x, const Candidate& y) { return x.score < y.score; }

  /// Candidates made side by side: f(k) for k = 0 ... number-1.
  template <class F>
  std::vector<Candidate> candidates(std::size_t number, F f) const
  {
    std::vector<Candidate> result(number);
    loop_.for_each(static_cast<int>(number), [&](int k) { result[k] = f(k); });
    return result;
  }

  static std::vector<int> first(const std::vector<int>& samples, const Cells& cells)
  {
    return {samples.begin(), samples.begin() + cells.size()};
  }

  /// With more and more eigenfunctions: S. Melzi, J. Ren, E. Rodola, A. Sharma, P. Wonka, M. Ovsjanikov, "ZoomOut",
  /// ACM TOG 38 (2019).
  /// \param beside_a, beside_b  what else is compared: a row for each sample, and for each target
  Candidate upsample(Map map, const Cells& cells, const std::vector<int>& targets, const std::vector<int>& numbers,
                     const Rows& beside_a = Rows(), const Rows& beside_b = Rows()) const
  {
    const std::vector<int> samples = first(a_.sample, cells);
    const int others = static_cast<int>(beside_a.cols());
    Candidate c;
    for(int number : numbers) {
      const int k = (std::min)(number, most_functions_);
      Rows from(samples.size(), k + others), to(targets.size(), k + others);
      from.leftCols(k) = rows(a_.function, samples, k);
      c.functional = functional(from.leftCols(k), cells.area, rows(b_.function, map, k));
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

  /// By eigenfunctions beside features, since those of shapes that differ lead astray, and beside places on the sphere
  /// that keep orientation, if there are any. With the score that decides.
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
    Candidate c = with_score(upsample(std::move(map), a_.some, targets, numbers, beside_a, beside_b), a_.some, {1, 1});
    c.score += guiding_error(c.map);
    return c;
  }

  /// All vertices, from a map of all samples, by many eigenfunctions. The matrices of a map and of the one back are
  /// transposed to each other where both keep areas (R. Huang, M. Ovsjanikov, "Adjoint map representation for shape
  /// analysis and matching", SGP 2017): the mean of the two is less wrong than either.
  Map precise(Map map) const
  {
    const std::vector<int> of_a = first(a_.sample, a_.all), of_b = first(b_.sample, b_.all);
    Rows mean;
    for(int number : {80, 120}) {
      const int k = (std::min)(number, most_functions_);
      const Rows from_a = rows(a_.function, of_a, k), from_b = rows(b_.function, of_b, k);
      const Rows there = functional(from_a, a_.all.area, rows(b_.function, map, k));
      Map back(of_b.size());
      for_each_nearest(from_b, a_.function.leftCols(k) * there, [&](int r, int s, float) { back[r] = s; });
      mean = (there + functional(from_b, b_.all.area, rows(a_.function, back, k)).transpose()) / 2;
      for_each_nearest(from_a, b_.function.leftCols(k) * mean.transpose(), [&](int r, int s, float) { map[r] = s; });
    }
    const int k = static_cast<int>(mean.rows());
    std::vector<int> every(a_.size());
    std::iota(every.begin(), every.end(), 0);
    const Map all = nearest(every, mean);
    return downhill(every, functional(a_.function.leftCols(k), a_.area, rows(b_.function, all, k)), all);
  }

  /// The nearest vertices of B in the embedding by eigenfunctions: the nearest targets by the first ones, and downhill
  /// from there.
  Map nearest(const std::vector<int>& vertices, const Rows& functional) const
  {
    constexpr int first_ones = 60;
    const int columns = (std::min)(first_ones, static_cast<int>(functional.rows()));
    const Rows to =
      rows(b_.function, b_.target, static_cast<int>(functional.cols())) * functional.topRows(columns).transpose();
    const Rows from = rows(a_.function, vertices, columns);
    Map result(vertices.size());
    const Nearest_rows targets(to.data(), static_cast<int>(to.rows()), columns);
    for_each_block(result.size(), [&](int begin, int size) {
      targets.for_each_row_of(from.row(begin).data(), size,
                              [&](int r, int s, float) { result[begin + r] = b_.target[s]; });
    });
    return downhill(vertices, functional, std::move(result));
  }

  /// With all samples and many eigenfunctions, and the score that decides.
  Candidate judged(const Map& of_some) const
  {
    constexpr Weights weights = {0.65, 0.5}; // many eigenfunctions say more
    Map map;
    for(int v : a_.sample)
      map.push_back(of_some[a_.some.of_vertex[v]]);
    Candidate c = with_score(upsample(std::move(map), a_.all, b_.target, {30, 40, 50, 60}), a_.all, weights);
    c.score += landmark_error(c.map, a_.all);
    return c;
  }

  /// Of a map of the first samples, while candidates are sought.
  double guiding_error(const Map& of_some) const { return are_guides_ ? landmark_error(of_some, a_.some) : 0; }

  /// Whether a point of B is where a landmark should be. If it is only near it, it is moved there in the end.
  static bool is_near(const std::vector<double>& distance_from_landmark, int v)
  {
    constexpr double near = 0.25;
    return distance_from_landmark[v] <= near;
  }

  /// Root mean square distance of two maps in the embedding by eigenfunctions.
  double distance(const Map& x, const Map& y, const Cells& cells) const
  {
    const int k = (std::min)(20, most_functions_ - 1);
    double sum = 0;
    for(int r = 0; r < cells.size(); ++r)
      sum += cells.area[r] * (b_.function.row(x[r]).segment(1, k) - b_.function.row(y[r]).segment(1, k)).squaredNorm();
    return std::sqrt(sum / k);
  }

  /// Whether a map is farther from all others than `limit`.
  bool is_apart(const Map& map, const std::vector<Map>& others, double limit) const
  {
    return std::all_of(others.begin(), others.end(), [&](const Map& o) { return distance(map, o, a_.some) > limit; });
  }

  /// From 0 to 1.
  static double signature_difference(const Shape& a, int v, const Shape& b, int w)
  {
    const auto x = a.signature.row(v), y = b.signature.row(w);
    return (x - y).cwiseAbs().sum() / (x + y).cwiseAbs().sum();
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
    Nearest_rows(to.data(), static_cast<int>(to.rows()), static_cast<int>(to.cols()))
      .for_each_row_of(from.data(), static_cast<int>(from.rows()), f);
  }

protected:
  const Watched_loop<Loop>& loop_;
  const Shape& a_;
  const Shape& b_;

  struct Landmark {
    int of_a, of_b;
    std::vector<double> distance; ///< on B
  };
  std::vector<Landmark> landmarks_;
  bool are_guides_;

private:
  /// The mean distance on B from where landmarks should be, so weighted that nothing outweighs it.
  double landmark_error(const Map& map, const Cells& cells) const
  {
    constexpr double weight = 10;
    double sum = 0;
    for(const Landmark& l : landmarks_)
      if(const int v = map[cells.of_vertex[l.of_a]]; !is_near(l.distance, v))
        sum += weight * l.distance[v] / static_cast<double>(landmarks_.size());
    return sum;
  }

  /// Calls f(begin, size) for blocks of 0 ... number-1.
  template <class F>
  void for_each_block(std::size_t number, F f) const
  {
    constexpr int block = 512;
    const int n = static_cast<int>(number);
    loop_.for_each((n + block - 1) / block, [&](int k) { f(k * block, (std::min)(block, n - k * block)); });
  }

  /// Every vertex where it is nearer in the embedding than at all neighbours.
  Map downhill(const std::vector<int>& vertices, const Rows& functional, Map map) const
  {
    const int columns = static_cast<int>(functional.rows());
    const Rows to = b_.function.leftCols(functional.cols()) * functional.transpose();
    for_each_block(map.size(), [&](int begin, int size) {
      for(int r = begin; r < begin + size; ++r) {
        const auto from = a_.function.row(vertices[r]).head(columns);
        const auto square = [&](int w) { return (from - to.row(w)).squaredNorm(); };
        float least = square(map[r]);
        for(int before = -1; before != map[r];) {
          before = map[r];
          b_.graph.for_each_way(before, [&](int w, double) {
            if(const float there = square(w); there < least) {
              least = there;
              map[r] = w;
            }
          });
        }
      }
    });
    return map;
  }

  /// Phi_A^T M_A Phi_B of points that correspond.
  static Rows functional(Rows of_a, const std::vector<double>& area, const Rows& of_b)
  {
    for(int r = 0; r < of_a.rows(); ++r)
      of_a.row(r) *= static_cast<float>(area[r]);
    Rows result = Rows::Zero(of_a.cols(), of_b.cols());
    add_product(of_a.transpose(), of_b, result);
    return result;
  }

  /// Of the smooth map to the sphere that C stands for.
  double orientation(const Rows& functional) const
  {
    const int k = static_cast<int>(functional.rows());
    const Rows corner = a_.corner.leftCols(k) * (functional * b_.sphere.topRows(functional.cols()));
    double sum = 0;
    for(int r = 0; r < corner.rows(); r += 3) {
      const double d = determinant(vec3{corner(r, 0), corner(r, 1), corner(r, 2)},
                                   vec3{corner(r + 1, 0), corner(r + 1, 1), corner(r + 1, 2)},
                                   vec3{corner(r + 2, 0), corner(r + 2, 1), corner(r + 2, 2)});
      sum += d > 0 ? 1 : d < 0 ? -1 : 0;
    }
    return 3 * sum / static_cast<double>(corner.rows());
  }

  /// Of terms of the score; those of curvatures and residuals have 0.5.
  struct Weights {
    double orientation, signatures;
  };

  /// With the score that decides.
  Candidate with_score(Candidate c, const Cells& cells, const Weights& weights) const
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
    c.score = -weights.orientation * c.orientation;
    const auto add = [&](double difference, double weight) {
      c.score += weight * std::log((std::max)(difference, least));
    };
    add(signatures, weights.signatures);
    for(double difference : {curvatures[0], curvatures[1], c.residual})
      add(difference, 0.5);
    return c;
  }

  int most_functions_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_SPECTRAL_REFINEMENT_H
