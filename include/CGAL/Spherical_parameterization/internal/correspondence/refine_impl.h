// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_REFINE_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_REFINE_IMPL_H

#include <CGAL/Spherical_parameterization/internal/backend/Host_backend.h>
#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/Registration_energy.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/refine.h>
#include <CGAL/Spherical_parameterization/internal/multigrid/Multigrid.h>
#include <CGAL/Spherical_parameterization/internal/surface/conformal_graph.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Fields of a surface by vertex, smoothed by the heat flow of the surface for a time: M f' + time L f' = M f.
template <class...>
class Heat_flow {
public:
  Heat_flow(const Host_loop& loop, const Registered_surface& surface)
    : backend_(loop), area_(vertex_areas(loop, surface))
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

/// To mean 0 and variance 1 over the surface; what is constant but for rounding becomes 0.
inline void standardize(const Host_array<double>& area, Host_array<double>& field)
{
  constexpr double rounding = 1e-12;
  const int n = static_cast<int>(area.size());
  double total = 0, mean = 0, variance = 0;
  for(int i = 0; i < n; ++i) {
    total += area[i];
    mean += area[i] * field[i];
  }
  mean /= total;
  for(int i = 0; i < n; ++i)
    variance += area[i] / total * (field[i] - mean) * (field[i] - mean);
  const double deviation = std::sqrt(variance), factor = deviation > rounding * std::abs(mean) ? 1 / deviation : 0;
  for(double& x : field)
    x = factor * (x - mean);
}

CGAL_SP_CORE std::vector<Host_array<double>> shape_features(const Host_loop& loop, const Registered_surface& surface,
                                                            std::vector<Host_array<double>> own,
                                                            double scale_of_details, Monitor& monitor)
{
  const int n = static_cast<int>(surface.point.size());
  const Heat_flow<> flow(loop, surface);
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
    constexpr double least = 1e-300, largest = 1e300;
    field[0][i] = std::log(std::clamp(area[i] / sphere_area[i], least, largest));
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
  for(Host_array<double>& its_own : own)
    standardize(area, its_own); // so that the unit does not decide how exactly it is smoothed
  flow.smooth(time, own, monitor);
  std::move(own.begin(), own.end(), std::back_inserter(field));
  for(std::size_t k = 0; k < field.size(); ++k) {
    if(k > 0)
      standardize(area, field[k]);
    for(double& x : field[k])
      x = bounded(x);
  }
  return field;
}

CGAL_SP_CORE Refinement_report refine(const Host_loop& loop, const Registered_surface& a, const Registered_surface& b,
                                      const Registration_features& features,
                                      const std::vector<Registration_landmark>& landmarks, const Refinement& settings,
                                      Monitor& monitor, Host_array<vec3>& x)
{
  constexpr double least_share = 0.2, armijo = 1e-4, stiffness = 8; // of the distortion at an isometry
  constexpr double isometric = 4, stiffness_of_held = 1e6;
  constexpr int maximum_halvings = 25, window = 10;
  const int n = static_cast<int>(x.size());
  Registration_energy<> energy(loop, a, b, features, landmarks, settings, x);
  Refinement_report report;
  double now = energy.value(x);
  report.energy_before = now;
  report.mismatch_before = energy.mismatch();
  const auto complete = [&] {
    report.energy = now;
    report.mismatch = energy.mismatch();
    report.distortion = energy.distortion();
    report.stretching = energy.stretching();
    return report;
  };
  if(!(now < std::numeric_limits<double>::infinity()))
    energy.compare(x); // faces that are lost already cannot be moved
  if(settings.iterations == 0 || !(now < std::numeric_limits<double>::infinity()))
    return complete();

  Spring_lengths lengths;
  Weighted_graph laplacian = conformal_graph(loop, a, a.image, lengths);
  for(double& w : laplacian.weight)
    w *= stiffness;
  laplacian.excess.resize(n);
  for_each_index(loop, n, [&](int i) { laplacian.excess[i] = stiffness * energy.vertex_area(i); });
  std::vector<int> held; // landmarks that are in place
  for(const Registration_landmark& l : landmarks)
    if(l.is_in_place(x)) {
      held.push_back(l.vertex);
      laplacian.excess[l.vertex] *= stiffness_of_held;
    } else
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
    for(int v : held)
      smooth[v] = {0, 0, 0};
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
    const double progress = double(report.iterations) / settings.iterations;
    for(int h = 0; h < maximum_halvings && !is_lower && (h == 0 || monitor.advance(progress)); ++h, t /= 2) {
      for_each_index(loop, n, [&](int i) { y[i] = unit(moved(i, t)); });
      for(int v : held)
        y[v] = x[v];
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
  now = energy.value(x);
  return complete();
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_REFINE_IMPL_H
