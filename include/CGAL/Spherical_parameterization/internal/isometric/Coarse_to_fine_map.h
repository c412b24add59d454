// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_COARSE_TO_FINE_MAP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_COARSE_TO_FINE_MAP_H

#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/text/text.h>
#include <CGAL/Spherical_parameterization/internal/problem/settle.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/Star.h>
#include <CGAL/Spherical_parameterization/internal/isometric/decimation.h>
#include <CGAL/Spherical_parameterization/internal/isometric/landmark_placement.h>
#include <CGAL/Spherical_parameterization/internal/problem/Method_solver.h>
#include <CGAL/Spherical_parameterization/values/methods.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// What densities ask for is another one than lengths do.
CGAL_SP_INLINE double area_exponent(const Isometric& method, const Problem& problem)
{
  return method.area_exponent.value_or(problem.density.empty() ? Isometric::default_area_exponent
                                                               : Isometric::area_exponent_of_densities);
}

/// Builds a bijective map to the sphere from a tetrahedron up, and keeps it bijective at every moment: a vertex is
/// inserted into the kernel of its star, and moves only to where all of its faces are positively oriented by the exact
/// predicate. E. Praun and H. Hoppe, "Spherical parametrization and remeshing", SIGGRAPH 2003; X. Hu, X.-M. Fu, L. Liu,
/// "Advanced hierarchical spherical parameterizations", TVCG 2018.
///
/// The rounds of the decimation are undone one by one, last first. The distortion of the map is relaxed after each one
/// on coarse meshes. On fine ones that is done only where the mesh has grown by `growth_of_fine_levels`, and by
/// Newton's method on the whole level: what is inserted then is distorted as its surroundings are, and these have been
/// at their optimum.
///
/// Fixed vertices are landmarks. The decimation keeps them while there are many more vertices than landmarks. On the
/// coarsest mesh that has all of them the map is rotated to fit their places, and they are moved there; where that mesh
/// is too coarse, on one of the next. From then on they do not move.
///
/// The problem is to be in canonical order, see canonical_order.h.
template <class...>
class Coarse_to_fine_map {
public:
  /// How landmarks are brought to their places.
  struct Attempt {
    int size;                                   ///< of the mesh, about, on which that is begun
    bool is_last;                               ///< whether it goes on to the finest mesh where they do not get there
    Landmark_budget* budget;                    ///< for all attempts
    const Host_array<vec3>* free_map = nullptr; ///< without landmarks, to begin with instead of a tetrahedron
    double least_exponent = 0;                  ///< of the area, below the whole mesh
    /// Of the area, below `tiny_size`: there a face of a small target could end as half of the sphere, since the energy
    /// takes the determinant of its corners for its area, and that is small, too. At 1 and below its long edges count.
    double largest_tiny_exponent = 1;
  };

  Coarse_to_fine_map(const Watched_loop<Host_loop>& loop, const Isometric& method, const Problem& problem,
                     const Effort& effort, const Attempt& attempt)
    : loop_(loop), attempt_(attempt), method_(method), density_(problem),
      last_exponent_(area_exponent(method, problem)), exponent_(coarse_exponent(attempt.largest_tiny_exponent)),
      distortion_(exponent_), problem_(problem), effort_(effort), source_area_(area_of_source()),
      mesh_(loop, problem.face, problem.size()),
      level_(loop, problem.size()), map_{Host_array<vec3>(problem.size(), vec3{0, 0, 0}),
                                         Host_array<int>(problem.size(), -1)},
      level_sizes_(sizes_of_levels(problem.size(), coarse_exponent(largest_coarse_exponent)))
  {
    if(!(source_area_ > 0)) // all points are one: then all faces count as equal
      source_area_ = 1;
    for(int v = 0; problem.has_fixed() && v < problem.size(); ++v)
      if(problem.is_fixed[v])
        landmarks_.push_back({v, problem.place_of_fixed(v)});
  }

  /// Returns the positions of all vertices.
  Host_array<vec3> run(Solver_report& report)
  {
    decimate();
    take_exponent_of_level();
    if(attempt_.free_map)
      take_free_map();
    else
      embed_tetrahedron();
    for(; !rounds_.empty(); rounds_.pop_back()) {
      insert(std::move(rounds_.back()));
      take_exponent_of_level();
      const bool have_landmarks_come =
        rounds_.size() <= rounds_with_landmarks_ + 1 && !std::exchange(are_landmarks_present_, true);
      if(rounds_.size() > 1) {
        if(is_relaxed_now() || have_landmarks_come)
          relax_level();
        if(!has_second_start_ && mesh_.number_of_vertices() >= size_of_second_start && !are_landmarks_present_)
          start_again();
        loop_.advance(progress());
      }
    }
    finish(report);
    return std::move(map_.position);
  }

private:
  /// While there are vertices to come, needles count as better than they are: they would squeeze what is inserted.
  static constexpr Metric_bounds coarse_bounds = {100, 1e-4};
  static constexpr Metric_bounds final_bounds = {1e3, 1e-8};
  static constexpr double largest_coarse_exponent = 3;
  static constexpr double linear_tolerance = 0.1;              ///< of Newton's equations
  static constexpr double linear_tolerance_before_last = 0.03; ///< ... on fine levels below the whole mesh
  static constexpr double fine_linear_tolerance = 0.01;        ///< ... near a minimum
  static constexpr double converged_share = 0.02; ///< of the default accuracy: the map moves by about 1e-4 after that
  static constexpr int maximum_linear_iterations = 100; ///< ... on fine levels
  static constexpr int iterations_ahead = 20;           ///< ... of a step that is not taken
  static constexpr int sweeps_of_levels = 2;
  static constexpr int coarse_size = 20000; ///< the largest meshes of which many levels are relaxed
  static constexpr int large_size = 100000; ///< ... that get all Newton steps
  static constexpr int tiny_size = 500; ///< the largest ones of which most levels are relaxed: limbs find places there
  /// From one level that is relaxed to the next
  static constexpr double growth_of_tiny_levels = 1.3, growth_of_coarse_levels = 2, growth_of_fine_levels = 5;
  /// The mean distortion, 4 = isometric, from which on a shape has limbs, and long ones that get stuck.
  static constexpr double distortion_of_limbs = 8, distortion_of_long_limbs = 18;
  static constexpr int size_of_second_start = 50;
  /// Of the energy, for which a Newton step on a coarse level is worth while
  static constexpr double least_gain_without_limbs = 1e-3, least_gain_with_limbs = 1e-4;

  /// Below the whole mesh
  double coarse_exponent(double largest) const { return std::clamp(last_exponent_, attempt_.least_exponent, largest); }

  void take_exponent_of_level()
  {
    if(mesh_.number_of_vertices() >= tiny_size)
      take_exponent(coarse_exponent(largest_coarse_exponent));
  }

  void take_exponent(double exponent)
  {
    exponent_ = exponent;
    distortion_ = Distortion(exponent);
  }

  /// The smallest area that faces count with is a share of this. So it has needles as good as they will count: were the
  /// whole surface needles, and their true areas added up, then the share would be nothing to any of them.
  double area_of_source() const
  {
    return sum_by_parts(loop_, static_cast<int>(problem_.face.size()), [&](int f) {
      const auto [i, j, k] = problem_.face[f];
      const auto& p = problem_.point;
      return in_six_digits(face_metric(p[i], p[j], p[k], {coarse_bounds.aspect, 0})).twice_area / 2;
    });
  }

  void decimate()
  {
    Decimation<> decimation(loop_, problem_.point, mesh_, problem_.is_fixed, attempt_.size, attempt_.free_map);
    while(take_round(decimation)) {
      if(decimation.keeps_vertices())
        rounds_with_landmarks_ = rounds_.size();
      const double done =
        std::log(double(problem_.size()) / mesh_.number_of_vertices()) / std::log(problem_.size() / 4.);
      loop_.advance(share_of_decimation * done);
    }
  }

  /// Returns whether there was one.
  bool take_round(Decimation<>& decimation)
  {
    std::vector<int> round = decimation.round();
    if(round.empty())
      return false;
    for(int h : round)
      density_.collapse(mesh_, h);
    rounds_.push_back(std::move(round));
    return true;
  }

  /// On the coarsest meshes limbs find their places, now and then wrong ones, of which no relaxation frees them. So a
  /// shape with long limbs gets a second map, from another tetrahedron: that of a decimation which knows no finer mesh
  /// than this one. The better map is kept.
  void start_again()
  {
    has_second_start_ = true;
    relax_level();
    if(mean_distortion_ < distortion_of_long_limbs)
      return;
    const Partial_map first = map_;
    const double first_distortion = std::exchange(mean_distortion_, 0);
    const std::vector<Level_size> level_sizes =
      std::exchange(level_sizes_, sizes_of_levels(mesh_.number_of_vertices(), exponent_));
    std::vector<std::vector<int>> rounds = std::exchange(rounds_, {});
    Decimation<> decimation(loop_, problem_.point, mesh_, {}, 0);
    while(take_round(decimation)) {
    }
    embed_tetrahedron();
    for(; !rounds_.empty(); rounds_.pop_back()) {
      insert(std::move(rounds_.back()));
      if(rounds_.size() == 1 || is_relaxed_now())
        relax_level();
    }
    rounds_ = std::move(rounds);
    level_sizes_ = level_sizes;
    if(!(mean_distortion_ < first_distortion)) {
      map_ = first;
      mean_distortion_ = first_distortion;
    }
  }

  /// The map without landmarks, restricted to the vertices that are left: all landmarks are among them.
  void take_free_map()
  {
    for(int v = 0; v < problem_.size(); ++v)
      if(!mesh_.is_removed(v)) {
        map_.position[v] = (*attempt_.free_map)[v];
        map_.colour[v] = free_colour(v);
      }
    are_landmarks_present_ = true;
    if(!rounds_.empty())
      relax_level();
  }

  /// The level is that of the tetrahedron, too: the first vertices to be inserted need its scale.
  void embed_tetrahedron()
  {
    static const double c = 1 / std::sqrt(3.);
    static const std::array<vec3, 4> regular = {vec3{c, c, c}, vec3{-c, -c, c}, vec3{-c, c, -c}, vec3{c, -c, -c}};
    int v = 0;
    while(mesh_.is_removed(v))
      ++v;
    const auto place = [&](int w, int k) {
      map_.position[w] = regular[k];
      map_.colour[w] = k;
    };
    place(v, 0);
    // seen from outside, the neighbours of (c, c, c) are regular[3], [2], [1], counterclockwise
    int k = 3;
    mesh_.for_each_corner(v, [&](int corner) { place(mesh_.target(corner), k--); });
    assign_level(coarse_bounds);
  }

  /// Undoes the collapses of a round. Those for whose vertex doubles have no position come last, after the others
  /// have been relaxed, with all faces pulled towards the same shape and size.
  void insert(std::vector<int> round)
  {
    constexpr int maximum_attempts = 20;
    for(int attempt = 0; attempt < maximum_attempts; ++attempt) {
      std::vector<int> failed = try_to_insert(round);
      if(failed.empty())
        return;
      round = std::move(failed);
      make_room();
      loop_.advance(progress());
    }
    throw Input_error(Error_code::NOT_BIJECTIVE, "no position in double precision was found for " +
                                                   counted(round.size(), "vertex", "vertices") + "; repair the mesh");
  }

  /// Pulls all faces towards the same shape, then also towards the same size: angles first, since areas are too stiff
  /// where a map is next to degenerate.
  void make_room()
  {
    constexpr int sweeps = 3;
    assign_level({1, 1});
    for(double exponent : {0., 1.}) {
      const Distortion distortion(exponent);
      for(int s = 0; s < sweeps; ++s)
        level_.relax(distortion);
      relax_globally(distortion);
    }
    level_.store(map_);
  }

  std::vector<int> try_to_insert(const std::vector<int>& round)
  {
    const int n = static_cast<int>(round.size());
    std::vector<char> is_inserted(n);
    mesh_.undo_collapses(loop_, round);
    for(int h : round)
      density_.undo_collapse(mesh_, h);
    const int size = mesh_.number_of_vertices();
    const Metric_bounds bounds = {coarse_bounds.aspect, coarse_bounds.area * source_area_ / (2. * size - 4)};
    constexpr double sufficient_factor = 2; // times the mean
    const double sufficient_distortion = sufficient_factor * mean_distortion_;
    for_each_of_level(loop_, 0, n, [&](int r) {
      const int u = mesh_.vertex(round[r]), v = mesh_.target(round[r]);
      Star star;
      mesh_.for_each_corner(u, [&](int c) {
        const int j = mesh_.target(c), k = mesh_.apex(c);
        const auto& p = problem_.point;
        Face_metric metric = in_six_digits(face_metric(p[u], p[j], p[k], bounds));
        density_.apply(mesh_, c, bounds.area, metric);
        star.emplace_back(map_.position[j], map_.position[k], metric, level_.area_scale());
      });
      is_inserted[r] = insert_vertex(distortion_, star, map_.position[v], sufficient_distortion, map_.position[u]);
      map_.colour[u] = free_colour(u); // its neighbours are not of this round
    });
    std::vector<int> failed;
    for(int r = n - 1; r >= 0; --r)
      if(!is_inserted[r]) {
        mesh_.collapse(round[r]);
        density_.collapse(mesh_, round[r]);
        failed.push_back(round[r]);
      }
    mesh_.count_collapses(static_cast<int>(failed.size()));
    return failed;
  }

  /// The smallest colour that no neighbour of u has.
  int free_colour(int u) const
  {
    int colour = 0;
    while(mesh_.any_neighbour(u, [&](int w) { return map_.colour[w] == colour; }))
      ++colour;
    return colour;
  }

  void assign_level(const Metric_bounds& bounds)
  {
    level_.assign(mesh_, problem_.point, density_, source_area_, bounds, map_);
    if(!are_landmarks_present_ || landmarks_.empty())
      return;
    if(!std::exchange(are_landmarks_aligned_, true))
      rotate_to_landmarks(landmarks_, level_);
    if(are_landmarks_soft())
      for(const Landmark& l : landmarks_)
        level_.hold(level_.index(l.vertex),
                    {l.place, 2 * method_.landmark_weight * level_.area() / double(landmarks_.size())});
    else
      pin_placed(landmarks_, level_);
  }

  bool are_landmarks_soft() const { return std::isfinite(method_.landmark_weight); }

  /// Whether all are where they have to be.
  bool are_landmarks_placed() const
  {
    const auto is_placed = [](const Landmark& l) { return l.is_placed; };
    return are_landmarks_soft() || std::all_of(landmarks_.begin(), landmarks_.end(), is_placed);
  }

  /// Moves the landmarks to their places as far as the level allows it. Tried only so often, since a little finer mesh
  /// bends little more. Throws the Error after the last level, or where another attempt promises more.
  void place_landmarks(bool is_last_level)
  {
    constexpr double growth = 1.5;
    constexpr int levels_of_attempt = 4; // up to so many times the size on which the landmarks are brought in
    if(!are_landmarks_present_ || are_landmarks_placed())
      return;
    if(!is_last_level && level_.size() < growth * last_placement_)
      return;
    last_placement_ = level_.size();
    if(Landmark_placement<>(loop_, distortion_, level_, landmarks_, *attempt_.budget).run())
      return;
    if(is_last_level || attempt_.budget->is_spent() ||
       (!attempt_.is_last && level_.size() > levels_of_attempt * attempt_.size))
      refuse_landmarks();
  }

  /// The Error if the levels were too coarse.
  [[noreturn]] void refuse_landmarks() const
  {
    constexpr int most = 5;
    std::vector<char> is_landmark(problem_.size(), false);
    for(const Landmark& l : landmarks_)
      is_landmark[l.vertex] = true;
    const auto name = [&](int v) { return std::to_string(problem_.position[v]); };
    std::string pairs;
    int count = 0;
    for(const Landmark& l : landmarks_)
      if(!l.is_placed && ++count <= most)
        pairs += (count > 1 ? ", " : "") + name(l.vertex) + " and " + name(nearest_landmark(l.vertex, is_landmark));
    throw Input_error(Error_code::BAD_CONSTRAINTS,
                      (attempt_.budget->is_spent() ? std::string("no map was found with reasonable effort")
                                                   : std::string("the mesh is too coarse")) +
                        " for the positions of the fixed vertices " + pairs +
                        (count > most ? ", and near " + counted(count - most, "other", "others") : "") +
                        "; refine the mesh there, or free some of them");
  }

  /// In edges; v is one.
  int nearest_landmark(int v, const std::vector<char>& is_landmark) const
  {
    std::vector<char> is_seen(problem_.size(), false);
    std::vector<int> front = {v};
    is_seen[v] = true;
    for(std::size_t k = 0; k < front.size(); ++k) {
      if(front[k] != v && is_landmark[front[k]])
        return front[k];
      mesh_.for_each_corner(front[k], [&](int c) {
        if(!std::exchange(is_seen[mesh_.target(c)], true))
          front.push_back(mesh_.target(c));
      });
    }
    return v;
  }

  /// Of a level below that of the whole mesh.
  struct Level_size {
    double size;
    double least_distortion; ///< it is relaxed only if the map has as much in the mean
  };

  /// In descending order. Limbs get stuck between levels that are far apart, so that every other coarse level is for
  /// them alone. They do so more easily where areas count more than lengths: then all coarse levels are as close as
  /// tiny ones, and relaxed.
  static std::vector<Level_size> sizes_of_levels(int number_of_vertices, double exponent)
  {
    const int close_size = exponent > 1 ? coarse_size : tiny_size;
    std::vector<Level_size> sizes;
    bool is_for_limbs = false;
    for(double size = number_of_vertices; size > 4;) {
      is_for_limbs = !is_for_limbs && size <= coarse_size && exponent <= 1;
      size /= size > coarse_size  ? growth_of_fine_levels
              : size > close_size ? std::sqrt(growth_of_coarse_levels)
                                  : growth_of_tiny_levels;
      sizes.push_back({size, !is_for_limbs ? 0 : size > tiny_size ? distortion_of_long_limbs : distortion_of_limbs});
    }
    return sizes;
  }

  /// Whether the mesh has got to the next level that is to be relaxed.
  bool is_relaxed_now()
  {
    bool result = false;
    for(; !level_sizes_.empty() && level_sizes_.back().size <= mesh_.number_of_vertices(); level_sizes_.pop_back())
      result = result || mean_distortion_ >= level_sizes_.back().least_distortion;
    return result;
  }

  bool is_level_coarse() const { return level_.size() <= coarse_size; }

  void relax_level()
  {
    assign_level(coarse_bounds);
    for(int s = 0; s < sweeps_of_levels; ++s)
      level_.relax(distortion_);
    place_landmarks(false);
    relax_globally(distortion_);
    mean_distortion_ = level_.energy(distortion_);
    level_.relax_distorted(distortion_, mean_distortion_);
    if(!is_level_coarse()) {
      Solver_report report;
      Newton_relaxation<> newton(loop_, distortion_, level_);
      descend(newton, number_of_steps(), report);
      loop_.check();
    }
    level_.store(map_);
  }

  /// Newton's method on coarse meshes, where limbs find their places for little: the number of steps falls with the
  /// size.
  void relax_globally(const Distortion& distortion)
  {
    constexpr int maximum_steps = 100, maximum_work = 200000, maximum_iterations = 50;
    if(!is_level_coarse())
      return;
    Newton_relaxation<> newton(loop_, distortion, level_);
    const int steps = (std::min)(maximum_steps, maximum_work / level_.size());
    const double least_gain =
      level_.energy(distortion) < distortion_of_limbs ? least_gain_without_limbs : least_gain_with_limbs;
    for(int s = 0; s < steps && newton.step(maximum_iterations, linear_tolerance) > least_gain; ++s) {
      level_.relax(distortion);
      loop_.advance(progress());
    }
  }

  /// The whole mesh, with its own shape. Exponents that are too stiff for an arbitrary start are approached from below.
  /// If that is interrupted, the map is handed over as it is: it is a bijection at every moment.
  void finish(Solver_report& report)
  {
    are_landmarks_present_ = true;
    bool is_level_assigned = false;
    try {
      assign_level(final_bounds);
      is_level_assigned = true;
      place_whole_mesh();
      Newton_relaxation<> newton(loop_, distortion_, level_);
      relax_whole_mesh(newton, report);
      measure(newton, report);
      reach_accuracy(newton, report);
    } catch(const Input_error&) {
      if(!loop_.monitor().is_interrupted() || !are_landmarks_placed())
        throw;
      report.energy = report.residual = std::numeric_limits<double>::quiet_NaN(); // there is no time to know
    }
    if(is_level_assigned)
      level_.store(map_);
  }

  void place_whole_mesh()
  {
    for(int s = 0; s < sweeps_of_levels; ++s) {
      loop_.advance(progress());
      level_.relax(distortion_);
    }
    place_landmarks(true);
  }

  void relax_whole_mesh(Newton_relaxation<>& newton, Solver_report& report)
  {
    constexpr std::size_t steps_per_exponent = 6;
    constexpr double growth_of_exponent = 1.5;
    take_exponent((std::min)(exponent_, last_exponent_));
    descend(newton, number_of_steps(), report);
    while(exponent_ < last_exponent_) {
      take_exponent((std::min)(last_exponent_, growth_of_exponent * exponent_));
      descend(newton,
              exponent_ < last_exponent_ ? (std::min)(steps_per_exponent, number_of_steps()) : number_of_steps(),
              report);
    }
  }

  /// What a step promises falls below the accuracy a little before the residual of the map that it leads to does.
  void reach_accuracy(Newton_relaxation<>& newton, Solver_report& report)
  {
    constexpr int patience = 5;
    double least = report.residual;
    for(int in_vain = 0; !report.has_converged && !report.has_stalled && report.iterations < number_of_steps();) {
      descend(newton, 1, report);
      measure(newton, report);
      in_vain = report.residual < least ? 0 : in_vain + 1;
      least = (std::min)(least, report.residual);
      report.has_stalled = report.has_stalled || in_vain == patience;
    }
  }

  /// Energy and residual of the map as it will be stored. Who asks for no more than the defaults gets what these reach,
  /// and on large meshes, where a new matrix would be a tenth of the time, the residual by that of the last step. That
  /// is near to the one by a new matrix, but not with landmarks, round which the map is stiff.
  void measure(Newton_relaxation<>& newton, Solver_report& report)
  {
    if(exponent_ > 1) // large ones are for the areas, of which the scale is a part
      level_.fit_scale();
    make_storable(loop_.bare(), problem_, level_.position());
    const double accuracy = effort_.accuracy.value_or(Isometric::default_accuracy);
    const bool are_defaults = accuracy >= Isometric::default_accuracy &&
                              effort_.number_of_iterations.value_or(Isometric::default_number_of_iterations) >=
                                Isometric::default_number_of_iterations;
    report.residual =
      are_defaults && level_.size() > large_size && exponent_ <= 1 && landmarks_.empty()
        ? newton.gain_ahead_by_last_matrix(iterations_ahead, linear_tolerance)
        : newton.gain_ahead(are_defaults ? iterations_ahead : maximum_linear_iterations, linear_tolerance);
    report.has_converged = are_defaults || report.residual <= accuracy;
    level_.fit_scale(); // which the steps of small exponents have left as it was
    report.energy = level_.energy(distortion_);
  }

  /// Whether the level is the whole mesh, of a shape without limbs, and small enough for that to be cheap. Then there
  /// is one minimum, as far as was seen, and a few exact Newton steps reach it, in the directions, too, in which the
  /// energy is flat. So two maps of one shape agree.
  bool is_minimum_near() const
  {
    return level_.size() == problem_.size() && is_level_coarse() && exponent_ <= 1 &&
           level_.energy(distortion_) < distortion_of_limbs;
  }

  /// Newton's method until a step promises to gain little. On fine levels steps are dear: one that could be taken in
  /// full has left about a quarter of what it promised, measured, so that the next one need not be computed to know.
  void descend(Newton_relaxation<>& newton, std::size_t maximum_steps, Solver_report& report)
  {
    constexpr double share_left = 0.25;
    constexpr double work_left = 0.8; // of the last level after a step, as nobody knows how many there will be
    constexpr double small_size = 2000, least_part = 0.05; // steps are cheap on small meshes
    const bool is_to_converge = is_minimum_near();
    const double asked = effort_.accuracy.value_or(Isometric::default_accuracy);
    const double accuracy = is_to_converge
                              ? (std::min)(asked, converged_share * (std::max)(asked, Isometric::default_accuracy))
                              : asked * std::clamp(level_.size() / small_size, least_part, 1.);
    const double tolerance = rounds_.empty() ? linear_tolerance : linear_tolerance_before_last;
    constexpr double rounding = 1e-15;
    constexpr int patience = 5;
    int steps_in_vain = 0;
    for(std::size_t s = 0; s < maximum_steps; ++s) {
      loop_.advance(progress());
      if(rounds_.empty())
        work_of_last_level_ *= work_left;
      if(rounds_.empty() && exponent_ > 1)
        level_.fit_scale();
      const double gain = is_to_converge ? newton.step_near_minimum(maximum_linear_iterations, fine_linear_tolerance)
                                         : newton.step(maximum_linear_iterations, tolerance);
      report.residual = newton.promised_gain();
      ++report.iterations;
      level_.relax(distortion_);
      steps_in_vain = gain > rounding ? 0 : steps_in_vain + 1;
      report.has_stalled = steps_in_vain == patience;
      if(report.has_stalled)
        return;
      const bool is_quartered = !is_to_converge && !is_level_coarse() && newton.step_length() >= 1;
      if((is_quartered ? share_left : 1) * report.residual < accuracy)
        return;
    }
  }

  /// The most Newton steps for a level: on large ones a share of what the user allows, since they are dear and the
  /// levels before have done the most of it.
  std::size_t number_of_steps() const
  {
    constexpr double least_share = 0.25;
    const auto steps = effort_.number_of_iterations.value_or(Isometric::default_number_of_iterations);
    const double share = (std::max)(large_size / double(level_.size()), least_share);
    return share < 1 ? static_cast<std::size_t>(std::ceil(double(steps) * share)) : steps; // however many
  }

  /// How far the work has come, in [0,1].
  double progress() const
  {
    constexpr double share_of_last_level = 0.4;
    const double done = double(mesh_.number_of_vertices()) / problem_.size();
    return share_of_decimation + (1 - share_of_decimation - share_of_last_level) * done +
           share_of_last_level * (1 - work_of_last_level_);
  }

  static constexpr double share_of_decimation = 0.15;

  const Watched_loop<Host_loop>& loop_;
  Attempt attempt_;
  Isometric method_;
  Carried_density density_;
  double last_exponent_; ///< of the area
  double exponent_;      ///< of the area, at the moment
  Distortion distortion_;
  const Problem& problem_;
  Effort effort_;
  double source_area_;
  Progressive_mesh mesh_;
  Map_level<> level_;
  Partial_map map_;
  std::vector<std::vector<int>> rounds_; ///< the collapsed half-edges of every round
  std::vector<Level_size> level_sizes_;  ///< of which levels are relaxed, those to come
  double work_of_last_level_ = 1;        ///< that is left, for the progress
  double mean_distortion_ = 0;           ///< of the level that was relaxed last; 0: there was none
  bool has_second_start_ = false;
  double last_placement_ = 0; ///< size of the level
  Landmarks landmarks_;
  std::size_t rounds_with_landmarks_ = 0; ///< the first rounds of the decimation, which keep all of them
  bool are_landmarks_present_ = false;    ///< in the current mesh
  bool are_landmarks_aligned_ = false;    ///< by the best rotation
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_COARSE_TO_FINE_MAP_H
