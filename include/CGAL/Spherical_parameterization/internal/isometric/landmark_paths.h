// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_LANDMARK_PATHS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_LANDMARK_PATHS_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/isometric/Map_level.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// A vertex that belongs at a certain place.
struct Landmark {
  int vertex; ///< of the whole mesh
  vec3 place;
  bool is_placed = false; ///< it is there, exactly, and stays
};
typedef std::vector<Landmark> Landmarks;

/// What may be spent on bringing landmarks home, by all attempts together: so many steps of Newton's method, times the
/// vertices that each of them moves.
class Landmark_budget {
public:
  explicit Landmark_budget(int number_of_vertices) : left_(least + per_vertex * number_of_vertices) {}

  void spend(double steps) { left_ -= steps; }
  bool is_spent() const { return left_ <= 0; }

private:
  static constexpr double least = 3e6, per_vertex = 60;
  double left_;
};

inline double distance(vec3 a, vec3 b) { return norm(sub(a, b)); }

/// A curve on the sphere, by points that are near each other.
typedef std::vector<vec3> Path;

/// Appends the geodesic from the last point of a path to another point.
inline void append_arc(Path& path, vec3 end)
{
  constexpr double spacing = 0.02;
  const vec3 begin = path.back(), d = sub(end, begin);
  const int steps = 1 + static_cast<int>(norm(d) / spacing);
  for(int s = 1; s < steps; ++s)
    path.push_back(unit(add_scaled(begin, double(s) / steps, d)));
  path.push_back(end);
}

/// Paths for the landmarks of a level from where they are to their places, no two of which meet, nor meet a landmark
/// that is placed. What moves along such paths drags what lies across them along, each path for itself; were they to
/// cross, what one has dragged would be dragged again by the next, and the distortion would multiply.
///
/// The paths go from vertex to vertex of the map, and have no vertex in common. Those to places nearby are laid first.
/// One that finds no way crosses others, as few as possible, and these are laid anew.
template <class...>
class Landmark_paths {
public:
  Landmark_paths(const Watched_loop<Host_loop>& loop, const Map_level<>& level, const Landmarks& landmarks,
                 Landmark_budget& budget)
    : loop_(loop), level_(level), landmarks_(landmarks), budget_(budget), owner_(level.size(), nobody),
      cost_(level.size(), 1.), goal_(landmarks.size(), nobody), route_(landmarks.size())
  {}

  /// The path of every landmark; just where it is, if it is placed. None at all if the level is too coarse, or too much
  /// work is needed.
  std::vector<Path> find()
  {
    constexpr double most_searches = 100; // as if each went through the whole level
    const int size = static_cast<int>(landmarks_.size());
    for(int l = 0; l < size; ++l)
      occupy(start(l), l);
    std::vector<int> order;
    for(int l = 0; l < size; ++l) {
      goal_[l] = landmarks_[l].is_placed ? start(l) : free_vertex_near(landmarks_[l].place);
      if(goal_[l] == nobody)
        return {};
      if(!landmarks_[l].is_placed) {
        occupy(goal_[l], l);
        order.push_back(l);
      }
    }
    const auto way = [&](int l) { return distance(level_.position()[start(l)], landmarks_[l].place); };
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return way(a) < way(b); });
    waiting_.assign(order.begin(), order.end());
    steps_left_ = most_searches * level_.size();
    for(attempts_ = 0; !waiting_.empty(); ++attempts_) {
      const int l = waiting_.front();
      waiting_.pop_front();
      if(steps_left_ < 0 || budget_.is_spent() || !lay(l))
        return {};
    }
    std::vector<Path> paths;
    for(int l = 0; l < size; ++l) {
      paths.push_back({level_.position()[start(l)]});
      for(std::size_t m = 1; m + 1 < route_[l].size(); ++m)
        append_arc(paths.back(), level_.position()[route_[l][m]]);
      if(!landmarks_[l].is_placed)
        append_arc(paths.back(), landmarks_[l].place);
    }
    return paths;
  }

private:
  static constexpr int nobody = -1;

  int start(int l) const { return level_.index(landmarks_[l].vertex); }

  int free_vertex_near(vec3 place) const
  {
    loop_.check();
    int best = nobody;
    double nearest = std::numeric_limits<double>::infinity();
    for(int i = 0; i < level_.size(); ++i) {
      const double d = distance(level_.position()[i], place);
      if(owner_[i] == nobody && d < nearest) {
        nearest = d;
        best = i;
      }
    }
    return best;
  }

  bool is_end(int i) const { return owner_[i] != nobody && (i == start(owner_[i]) || i == goal_[owner_[i]]); }

  void occupy(int i, int l)
  {
    owner_[i] = l;
    add_to_costs(i, 1);
  }
  void leave(int i)
  {
    owner_[i] = nobody;
    add_to_costs(i, -1);
  }

  /// What is next to a path is dear, so that paths keep apart.
  void add_to_costs(int i, double sign)
  {
    constexpr double first_ring = 3, second_ring = 0.5;
    for(int c = level_.offset(i); c < level_.offset(i + 1); ++c) {
      const int j = level_.corner(c).j;
      cost_[j] += sign * first_ring;
      for(int d = level_.offset(j); d < level_.offset(j + 1); ++d)
        cost_[level_.corner(d).j] += sign * second_ring;
    }
  }

  /// Lays the path of landmark l, and takes up those that it crosses.
  bool lay(int l)
  {
    loop_.check();
    route_[l] = cheapest_route(l);
    for(int i : route_[l]) {
      const int other = owner_[i];
      if(other == nobody || other == l)
        continue;
      for(int v : route_[other])
        if(!is_end(v))
          leave(v);
      route_[other].clear();
      waiting_.push_back(other);
    }
    for(int i : route_[l])
      if(owner_[i] == nobody)
        occupy(i, l);
    return !route_[l].empty();
  }

  /// By Dijkstra's algorithm, from the start to the goal, not through the ends of other paths. Empty if there is none.
  std::vector<int> cheapest_route(int l)
  {
    constexpr double share_of_newton_step = 0.125; // of the time that it takes for a vertex
    constexpr double crossing = 50, growth = 0.01; // of the cost; it grows, lest two paths take up each other for ever
    typedef std::pair<double, int> Item;
    std::priority_queue<Item, std::vector<Item>, std::greater<Item>> queue;
    std::vector<double> cost(level_.size(), std::numeric_limits<double>::infinity());
    std::vector<int> before(level_.size(), nobody);
    cost[start(l)] = 0;
    queue.push({0, start(l)});
    int steps = 0;
    for(; !queue.empty() && queue.top().second != goal_[l]; ++steps) {
      const auto [cost_of_i, i] = queue.top();
      queue.pop();
      for(int c = level_.offset(i); cost_of_i <= cost[i] && c < level_.offset(i + 1); ++c) {
        const int j = level_.corner(c).j;
        const bool is_crossing = owner_[j] != nobody && owner_[j] != l;
        if(is_crossing && is_end(j))
          continue;
        const double per_length = cost_[j] + (is_crossing ? crossing * (1 + growth * attempts_) : 0);
        const double cost_of_j = cost_of_i + per_length * distance(level_.position()[i], level_.position()[j]);
        if(cost_of_j < cost[j]) {
          cost[j] = cost_of_j;
          before[j] = i;
          queue.push({cost_of_j, j});
        }
      }
    }
    steps_left_ -= steps;
    budget_.spend(share_of_newton_step * steps);
    std::vector<int> route;
    if(!queue.empty())
      for(int i = goal_[l]; i != nobody; i = before[i])
        route.push_back(i);
    std::reverse(route.begin(), route.end());
    return route;
  }

  const Watched_loop<Host_loop>& loop_; ///< which is asked whether to go on
  const Map_level<>& level_;
  const Landmarks& landmarks_;
  Landmark_budget& budget_;
  std::vector<int> owner_;   ///< of a vertex: the landmark whose path goes through it
  std::vector<double> cost_; ///< of a vertex: what the way to it costs, per length
  std::vector<int> goal_;    ///< of a landmark: the last vertex of its path
  std::vector<std::vector<int>> route_;
  std::deque<int> waiting_; ///< landmarks without a path
  int attempts_ = 0;
  double steps_left_ = 0; ///< of searches
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_LANDMARK_PATHS_H
