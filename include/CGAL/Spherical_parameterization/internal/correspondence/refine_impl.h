// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_REFINE_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_REFINE_IMPL_H

#include <CGAL/Spherical_parameterization/internal/backend/Host_backend.h>
#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/algebra/pi.h>
#include <CGAL/Spherical_parameterization/internal/surface/conformal_graph.h>
#include <CGAL/Spherical_parameterization/internal/surface/fans.h>
#include <CGAL/Spherical_parameterization/internal/multigrid/Multigrid.h>
#include <CGAL/Spherical_parameterization/internal/predicates/orientation.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/Carried_face.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/refine.h>
#include <CGAL/Spherical_parameterization/internal/locate/walk.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/Star.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

/// Where directions lie in the map of B: a walk from face to face, from where they were last.
class Face_walk {
public:
  explicit Face_walk(const Registered_surface& b) : b_(b) {}

  /// \param f  a face near q, and on return the one that contains it
  void walk(vec3 q, int& f) const { f = face_at(b_, b_.image, q, f); }

  /// Weights of the corners of f for which their mean has the direction q, and by the columns of `slope` their
  /// derivatives: weight k changes by inner(slope[k], dq).
  void weights(vec3 q, int f, std::array<double, 3>& weight, std::array<vec3, 3>& slope) const
  {
    const auto [i, j, k] = b_.face[f];
    const std::array<vec3, 3> v = {b_.image[i], b_.image[j], b_.image[k]};
    double sum = 0;
    for(int c = 0; c < 3; ++c) {
      const vec3 m = v[(c + 1) % 3], n = v[(c + 2) % 3];
      weight[c] = (std::max)(0., determinant(m, n, q));
      slope[c] = outer(m, sub(n, m));
      sum += weight[c];
    }
    const vec3 all = add(slope[0], add(slope[1], slope[2]));
    for(int c = 0; c < 3; ++c) {
      weight[c] /= sum;
      slope[c] = scale(1 / sum, add_scaled(slope[c], -weight[c], all));
    }
  }

private:
  const Registered_surface& b_;
};

/// The energy of the map x of the vertices of A, and its gradient.
class Registration_energy {
public:
  Registration_energy(const Host_loop& loop, const Registered_surface& a, const Registered_surface& b,
                      const Registration_features& features, const std::vector<Registration_landmark>& landmarks,
                      const Refinement& settings, const Host_array<vec3>& x)
    : loop_(loop), a_(a), b_(b), features_(features), landmarks_(landmarks),
      landmark_stiffness_(landmarks.empty() ? 0 : settings.landmark_weight / double(landmarks.size())),
      isometry_weight_(settings.isometry_weight), walk_(b), metric_(a.face.size()), corner_offset_(a.point.size() + 1),
      corner_(3 * a.face.size()), vertex_area_(a.point.size(), 0.), face_of_(a.point.size(), -1)
  {
    constexpr Metric_bounds as_it_is = {1e100, 0};
    const int faces = static_cast<int>(a.face.size());
    Host_array<double> twice_area(faces);
    for_each_index(loop, faces, [&](int f) {
      const auto [i, j, k] = a.face[f];
      metric_[f] = face_metric(sub(a.image[j], a.image[i]), sub(a.image[k], a.image[i]), as_it_is);
      twice_area[f] = metric_[f].twice_area;
      metric_[f].twice_area = determinant(a.image[i], a.image[j], a.image[k]); // what determinants are compared with
    });
    for(int f = 0; f < faces; ++f)
      for(int i : a.face[f]) {
        vertex_area_[i] += twice_area[f] / 6;
        area_ += twice_area[f] / 6;
      }
    corner_offset_.back() = 3 * faces;
    for_each_fan(loop, a.face, static_cast<int>(a.point.size()), [&](const Fan& fan) {
      corner_offset_[fan.vertex] = fan.first;
      std::copy(fan.begin(), fan.end(), corner_.begin() + fan.first);
    });
    find_faces(x);
  }

  double vertex_area(int i) const { return vertex_area_[i]; }
  double area() const { return area_; }
  double landmark_stiffness() const { return landmark_stiffness_; }

  /// The terms at the x of the last `value()`
  double distortion() const { return distortion_; }
  double mismatch() const { return mismatch_; }
  double stretching() const { return stretching_; }

  /// Infinite where a face is flipped.
  double value(const Host_array<vec3>& x)
  {
    const int n = static_cast<int>(x.size());
    distortion_ = sum_by_parts(loop_, static_cast<int>(a_.face.size()),
                               [&](int f) { return Star_face_at(*this, x, 3 * f).energy(); }) /
                  area_;
    if(!(distortion_ < std::numeric_limits<double>::infinity()))
      return distortion_;
    locate(x);
    mismatch_ = sum_by_parts(loop_, n, [&](int i) { return vertex_area_[i] * mismatch_at(i); }) / area_;
    double energy = distortion_ + mismatch_;
    if(isometry_weight_ > 0) {
      stretching_ =
        sum_by_parts(loop_, static_cast<int>(a_.face.size()), [&](int f) { return carried(3 * f).energy(); }) /
        surface_area;
      energy += isometry_weight_ * stretching_;
    }
    for(const Registration_landmark& l : landmarks_) {
      const vec3 d = sub(x[l.vertex], l.place);
      energy += landmark_stiffness_ * inner(d, d);
    }
    return energy;
  }

  /// The gradient, tangent to the sphere, at the x of the last `value()`.
  void gradient(const Host_array<vec3>& x, Host_array<vec3>& result) const
  {
    const int n = static_cast<int>(x.size());
    result.resize(n);
    for_each_index(loop_, n, [&](int i) {
      vec3 g = {0, 0, 0};
      for(int k = corner_offset_[i]; k < corner_offset_[i + 1]; ++k)
        g = add_scaled(g, 1 / area_, Star_face_at(*this, x, corner_[k]).gradient());
      const std::array<int, 3>& corner = b_.face[face_of_[i]];
      for(int k = 0; k < features_.number; ++k) {
        const double force = 2 * vertex_area_[i] / area_ * difference(k, i);
        for(int c = 0; c < 3; ++c)
          g = add_scaled(g, force * of_b(k, corner[c]), slope_[i][c]);
      }
      if(isometry_weight_ > 0) {
        vec3 force = {0, 0, 0};
        for(int k = corner_offset_[i]; k < corner_offset_[i + 1]; ++k)
          force = add_scaled(force, isometry_weight_ / surface_area, carried(corner_[k]).gradient());
        for(int c = 0; c < 3; ++c)
          g = add_scaled(g, inner(b_.point[corner[c]], force), slope_[i][c]);
      }
      result[i] = g;
    });
    for(const Registration_landmark& l : landmarks_)
      result[l.vertex] = add_scaled(result[l.vertex], 2 * landmark_stiffness_, sub(x[l.vertex], l.place));
    for_each_index(loop_, n, [&](int i) { result[i] = tangent(result[i], x[i]); });
  }

  /// The faces at vertex i
  Star star(int i, const Host_array<vec3>& x) const
  {
    Star result;
    for(int k = corner_offset_[i]; k < corner_offset_[i + 1]; ++k)
      result.push_back(Star_face_at(*this, x, corner_[k]).face);
    return result;
  }

private:
  /// A face at one of its corners; the symmetric Dirichlet energy as in `Star_face`.
  struct Star_face_at {
    vec3 x;
    Star_face face;

    Star_face_at(const Registration_energy& e, const Host_array<vec3>& at, int corner)
      : x(at[e.a_.origin(corner)]), face(at[e.a_.target(corner)], at[e.a_.apex(corner)], e.metric_at(corner), 1)
    {}
    double energy() const { return face.energy(Distortion(1), x); }
    vec3 gradient() const
    {
      const double det = face.determinant(x), ratio = face.twice_area / det;
      const vec3 pull = add_scaled(scale(-face.cot_j, sub(face.k, x)), -face.cot_k, sub(face.j, x));
      return add_scaled(scale(1 + ratio * ratio, pull), -2 * face.dirichlet(x) * ratio * ratio / det,
                        outer(face.j, face.k));
    }
  };

  Face_metric metric_at(int corner) const
  {
    const Face_metric& m = metric_[corner / 3];
    const int k = corner % 3;
    return {{m.cotangent[k], m.cotangent[(k + 1) % 3], m.cotangent[(k + 2) % 3]}, m.twice_area};
  }

  Carried_face carried(int corner) const
  {
    const int i = a_.origin(corner), j = a_.target(corner), k = a_.apex(corner);
    return {a_.point[i], a_.point[j], a_.point[k], place_[i], place_[j], place_[k]};
  }

  double of_b(int k, int vertex) const { return features_.b[k * b_.point.size() + vertex]; }
  double difference(int k, int i) const
  {
    const std::array<int, 3>& corner = b_.face[face_of_[i]];
    double value = -features_.a[k * a_.point.size() + i];
    for(int c = 0; c < 3; ++c)
      value += weight_[i][c] * of_b(k, corner[c]);
    return value;
  }
  double mismatch_at(int i) const
  {
    double sum = 0;
    for(int k = 0; k < features_.number; ++k)
      sum += difference(k, i) * difference(k, i);
    return sum;
  }

  /// The first time: every vertex from where a neighbour is.
  void find_faces(const Host_array<vec3>& x)
  {
    std::vector<int> queue = {0};
    face_of_[0] = 0;
    for(std::size_t next = 0; next < queue.size(); ++next) {
      const int i = queue[next];
      walk_.walk(x[i], face_of_[i]);
      for(int k = corner_offset_[i]; k < corner_offset_[i + 1]; ++k)
        if(const int j = a_.target(corner_[k]); face_of_[j] < 0) {
          face_of_[j] = face_of_[i];
          queue.push_back(j);
        }
    }
  }

  void locate(const Host_array<vec3>& x)
  {
    const int n = static_cast<int>(x.size());
    weight_.resize(n);
    slope_.resize(n);
    place_.resize(n);
    for_each_index(loop_, n, [&](int i) {
      walk_.walk(x[i], face_of_[i]);
      walk_.weights(x[i], face_of_[i], weight_[i], slope_[i]);
      const std::array<int, 3>& corner = b_.face[face_of_[i]];
      place_[i] = {0, 0, 0};
      for(int c = 0; c < 3; ++c)
        place_[i] = add_scaled(place_[i], weight_[i][c], b_.point[corner[c]]);
    });
  }

  const Host_loop& loop_;
  const Registered_surface& a_;
  const Registered_surface& b_;
  const Registration_features& features_;
  const std::vector<Registration_landmark>& landmarks_;
  static constexpr double surface_area = 4 * pi; ///< of A and of B
  double landmark_stiffness_, isometry_weight_;
  Face_walk walk_;
  Host_array<Face_metric> metric_;         ///< of the map that A came with
  Host_array<int> corner_offset_, corner_; ///< of every vertex
  Host_array<double> vertex_area_;         ///< on the sphere
  double area_ = 0, distortion_ = 0, mismatch_ = 0, stretching_ = 0;
  Host_array<int> face_of_; ///< of B, by vertex of A
  Host_array<std::array<double, 3>> weight_;
  Host_array<std::array<vec3, 3>> slope_;
  Host_array<vec3> place_; ///< on the surface of B
};

/// Fields of a surface by vertex, smoothed by the heat flow of the surface for a time: M f' + time L f' = M f.
class Heat_flow {
public:
  Heat_flow(const Host_loop& loop, const Registered_surface& surface) : backend_(loop), area_(vertex_areas(surface))
  {
    Spring_lengths lengths;
    laplacian_ = conformal_graph(loop, surface, surface.point, lengths);
  }

  const Host_array<double>& area() const { return area_; }
  const Weighted_graph& laplacian() const { return laplacian_; }

  /// Smooths three fields at a time.
  void smooth(double time, std::vector<Host_array<double>>& fields, Monitor& monitor) const
  {
    constexpr double accuracy = 1e-3, share_of_work = 0; // that of `refine()` counts
    if(!(time > 0))
      return;
    const int n = static_cast<int>(area_.size());
    auto graph = std::make_shared<Weighted_graph>(laplacian_);
    graph->excess = area_;
    for(double& w : graph->weight)
      w *= time;
    graph->update_diagonal({}, backend_.host_loop());
    Multigrid<Host_backend<Host_loop>> multigrid(backend_, graph);
    for(std::size_t k = 0; k < fields.size(); k += 3) {
      const auto value = [&](std::size_t j, int i) { return k + j < fields.size() ? fields[k + j][i] : 0.; };
      Host_array<vec3> b(n), x(n, make_vec3(0, 0, 0));
      for(int i = 0; i < n; ++i)
        b[i] = scale(area_[i], make_vec3(value(0, i), value(1, i), value(2, i)));
      conjugate_gradients(backend_, multigrid, 0, std::move(b), accuracy, monitor, share_of_work, x);
      for(int i = 0; i < n; ++i) {
        const double smooth_value[3] = {x[i].x, x[i].y, x[i].z};
        for(std::size_t j = 0; j < 3 && k + j < fields.size(); ++j)
          fields[k + j][i] = smooth_value[j];
      }
    }
  }

private:
  Host_backend<Host_loop> backend_;
  Host_array<double> area_;
  Weighted_graph laplacian_;
};

/// 2 tanh(x / 2): what is far out does not outweigh all else.
inline double bounded(double x) { return 2 * std::tanh(x / 2); }

CGAL_SP_CORE std::vector<Host_array<double>> shape_features(const Host_loop& loop, const Registered_surface& surface,
                                                            double scale_of_details, Monitor& monitor)
{
  const int n = static_cast<int>(surface.point.size());
  const Heat_flow flow(loop, surface);
  const Host_array<double>& area = flow.area();
  Host_array<double> sphere_area(n, 0.);
  Host_array<vec3> normals(n, make_vec3(0, 0, 0));
  for(const std::array<int, 3>& f : surface.face) {
    const vec3 up = normal(surface.point, f), on_sphere = normal(surface.image, f);
    for(int i : f) {
      sphere_area[i] += norm(on_sphere) / 6;
      normals[i] = add(normals[i], up);
    }
  }
  // The stretch, and the mean curvature by the Laplacian (M. Meyer, M. Desbrun, P. Schroeder, A. Barr, "Discrete
  // differential-geometry operators for triangulated 2-manifolds", 2003)
  std::vector<Host_array<double>> field(2, Host_array<double>(n, 0.));
  const Weighted_graph& graph = flow.laplacian();
  for_each_index(loop, n, [&](int i) {
    if(!(area[i] > 0) || !(inner(normals[i], normals[i]) > 0))
      return;
    constexpr double least = 1e-300;
    field[0][i] = std::log((std::max)(least, area[i] / sphere_area[i]));
    vec3 force = {0, 0, 0};
    for(int k = graph.offset[i]; k < graph.offset[i + 1]; ++k)
      force = add_scaled(force, graph.weight[k], sub(surface.point[i], surface.point[graph.target[k]]));
    field[1][i] = inner(force, unit(normals[i])) / (2 * area[i]);
  });
  const double time = scale_of_details * scale_of_details;
  std::vector<Host_array<double>> fine = {field[1]};
  flow.smooth(time / 4, fine, monitor);
  flow.smooth(time, field, monitor);
  field.push_back(std::move(fine[0]));
  for(double& x : field[0])
    x = bounded(x);
  for(std::size_t k = 1; k < field.size(); ++k) { // to mean 0 and variance 1
    double total = 0, mean = 0, variance = 0;
    for(int i = 0; i < n; ++i) {
      total += area[i];
      mean += area[i] * field[k][i];
    }
    mean /= total;
    for(int i = 0; i < n; ++i)
      variance += area[i] / total * (field[k][i] - mean) * (field[k][i] - mean);
    const double factor = variance > 0 ? 1 / std::sqrt(variance) : 0;
    for(double& x : field[k])
      x = bounded(factor * (x - mean));
  }
  return field;
}

CGAL_SP_CORE Refinement_report refine(const Host_loop& loop, const Registered_surface& a, const Registered_surface& b,
                                      const Registration_features& features,
                                      const std::vector<Registration_landmark>& landmarks, const Refinement& settings,
                                      Monitor& monitor, Host_array<vec3>& x)
{
  constexpr double least_share = 0.2, armijo = 1e-4, stiffness = 8; // of the distortion at an isometry
  constexpr double isometric = 4;
  constexpr int maximum_halvings = 25, window = 10;
  const int n = static_cast<int>(x.size());
  Registration_energy energy(loop, a, b, features, landmarks, settings, x);
  Refinement_report report;
  double now = energy.value(x);
  report.energy_before = now;
  report.mismatch_before = energy.mismatch();
  const auto complete = [&] {
    report.energy = energy.value(x);
    report.mismatch = energy.mismatch();
    report.distortion = energy.distortion();
    report.stretching = energy.stretching();
    return report;
  };
  if(settings.iterations == 0)
    return complete();

  Spring_lengths lengths;
  Weighted_graph laplacian = conformal_graph(loop, a, a.image, lengths);
  for(double& w : laplacian.weight)
    w *= stiffness;
  laplacian.excess.resize(n);
  for_each_index(loop, n, [&](int i) { laplacian.excess[i] = stiffness * energy.vertex_area(i); });
  for(const Registration_landmark& l : landmarks)
    laplacian.excess[l.vertex] += 2 * energy.landmark_stiffness() * energy.area();
  laplacian.update_diagonal({}, loop);
  const Host_backend<Host_loop> backend{loop};
  Multigrid<Host_backend<Host_loop>> multigrid(backend, std::make_shared<const Weighted_graph>(std::move(laplacian)));

  Host_array<vec3> g, d(n, make_vec3(0, 0, 0)), smooth(n), previous, y(n);
  double previous_product = 0, milestone = now;
  while(report.iterations < settings.iterations && monitor.advance(double(report.iterations) / settings.iterations)) {
    energy.gradient(x, g);
    for_each_index(loop, n, [&](int i) { g[i] = scale(energy.area(), g[i]); });
    multigrid.apply(0, g, smooth);
    for_each_index(loop, n, [&](int i) { smooth[i] = tangent(smooth[i], x[i]); });
    const double product = backend.dot(g, smooth);
    double beta = 0; // Polak and Ribiere
    if(!previous.empty() && previous_product > 0)
      beta = (std::max)(0., (product - backend.dot(previous, smooth)) / previous_product);
    const auto choose_direction = [&] {
      for_each_index(loop, n, [&](int i) { d[i] = tangent(add_scaled(scale(-1, smooth[i]), beta, d[i]), x[i]); });
      return backend.dot(g, d) / energy.area();
    };
    double slope = choose_direction();
    if(!(slope < 0) && beta > 0) {
      beta = 0;
      slope = choose_direction();
    }
    if(!(slope < 0))
      break;
    previous = g;
    previous_product = product;

    // the longest step up to 1 with which no face shrinks too much at once
    const auto moved = [&](int i, double t) { return add_scaled(x[i], t, d[i]); };
    double t = 1;
    for(double part : results_of_parts(loop, static_cast<int>(a.face.size()), [&](int begin, int end) {
          constexpr double shrink = 0.7, shortest = 1e-9;
          double longest = 1;
          for(int f = begin; f < end; ++f) {
            const auto [i, j, k] = a.face[f];
            const double least = least_share * determinant(x[i], x[j], x[k]);
            while(longest > shortest && !(determinant(moved(i, longest), moved(j, longest), moved(k, longest)) > least))
              longest *= shrink;
          }
          return longest;
        }))
      t = (std::min)(t, part);
    bool is_lower = false;
    double next = now;
    for(int h = 0; h < maximum_halvings && !is_lower; ++h, t /= 2) {
      for_each_index(loop, n, [&](int i) { y[i] = unit(moved(i, t)); });
      next = energy.value(y);
      is_lower = next <= now + armijo * t * slope;
    }
    if(!is_lower) {
      energy.value(x); // its places are those of x again
      if(beta == 0)
        break;
      previous.clear();
      continue;
    }
    std::swap(x, y);
    now = next;
    ++report.iterations;
    if(report.iterations % window == 0) {
      const double at_stake = (std::max)(1e-3, milestone - isometric);
      report.has_converged = milestone - now < settings.accuracy * at_stake;
      if(report.has_converged)
        break;
      milestone = now;
    }
  }
  return complete();
}

CGAL_SP_CORE void place_landmarks(const Host_loop& loop, const Registered_surface& a,
                                  const std::vector<Registration_landmark>& landmarks, Host_array<vec3>& x)
{
  const Registration_features none;
  const Registration_energy energy(loop, a, a, none, landmarks, {}, a.image);
  for(const Registration_landmark& l : landmarks)
    if(is_valid_centre(energy.star(l.vertex, x), l.place))
      x[l.vertex] = l.place;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_REFINE_IMPL_H
