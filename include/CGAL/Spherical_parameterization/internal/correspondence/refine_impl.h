// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_REFINE_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_REFINE_IMPL_H

#include <CGAL/Spherical_parameterization/internal/backend/Host_backend.h>
#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/Registration_newton.h>
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

namespace CGAL::Spherical_parameterization::internal {

/// Fields of a surface by vertex, smoothed by the heat flow of the surface for a time: M f' + time L f' = M f.
template <class...>
class Heat_flow {
public:
  Heat_flow(const Host_loop& loop, const Registered_surface& surface)
    : backend_(loop), area_(vertex_areas(loop, surface.face, surface.point))
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
  const Host_array<double> sphere_area = vertex_areas(loop, surface.face, surface.image);
  Host_array<vec3> normals(n, make_vec3(0, 0, 0));
  for(const std::array<int, 3>& f : surface.face) {
    const vec3 up = normal(surface.point, f);
    for(int i : f)
      normals[i] = add(normals[i], up);
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
      x = 2 * std::tanh(x / 2); // bounded: what is far out does not outweigh all else
  }
  return field;
}

/// The longest step up to 1 along d with which no face shrinks to less than a twentieth at once.
inline double longest_step(const Host_loop& loop, const Registered_surface& a, const Host_array<vec3>& x,
                           const Host_array<vec3>& d)
{
  constexpr double least_share = 0.05, shrink = 0.7, shortest = 1e-9;
  const auto of_part = results_of_parts(loop, static_cast<int>(a.face.size()), [&](int begin, int end) {
    double t = 1;
    for(int f = begin; f < end; ++f) {
      const auto [i, j, k] = a.face[f];
      const auto moved = [&](int v) { return add_scaled(x[v], t, d[v]); };
      const double least = least_share * determinant(x[i], x[j], x[k]);
      while(t > shortest && !(determinant(moved(i), moved(j), moved(k)) > least))
        t *= shrink;
    }
    return t;
  });
  return *std::min_element(of_part.begin(), of_part.end());
}

CGAL_SP_CORE Refinement_report refine(const Host_loop& loop, const Registered_surface& a, const Registered_surface& b,
                                      const Registration_features& features,
                                      const std::vector<Registration_landmark>& landmarks, const Refinement& settings,
                                      Monitor& monitor, Host_array<vec3>& x)
{
  constexpr double armijo = 1e-4, isometric = 4, least_at_stake = 1e-3;
  constexpr int maximum_halvings = 25;
  const int n = static_cast<int>(x.size());
  Registration_energy<> energy(loop, a, b, features, landmarks, settings, x);
  Refinement_report report;
  double now = energy.value(x);
  report.energy_before = now;
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

  std::vector<char> is_held(n, 0); // landmarks that are in place
  for(const Registration_landmark& l : landmarks)
    is_held[l.vertex] = is_held[l.vertex] || l.is_in_place(x);
  Registration_newton<> newton(loop, energy, is_held, monitor);
  Host_array<vec3> g, y(n);
  while(report.iterations < settings.iterations && !report.has_converged) {
    const double progress = double(report.iterations) / settings.iterations;
    if(!monitor.advance(progress))
      break;
    energy.gradient(x, g);
    const Host_array<vec3> d = newton.direction(x, g, progress);
    const double slope = sum_by_parts(loop, n, [&](int i) { return inner(g[i], d[i]); });
    if(!(slope < 0))
      break;
    double t = longest_step(loop, a, x, d), next = now;
    bool is_lower = false;
    for(int h = 0; h < maximum_halvings && !is_lower && (h == 0 || monitor.advance(progress)); ++h, t /= 2) {
      for_each_index(loop, n, [&](int i) { y[i] = is_held[i] ? x[i] : unit(add_scaled(x[i], t, d[i])); });
      next = energy.value(y);
      is_lower = next <= now + armijo * t * slope;
    }
    if(!is_lower) {
      now = energy.value(x); // its places are those of x again
      break;
    }
    report.has_converged = now - next < settings.accuracy * (std::max)(least_at_stake, now - isometric);
    std::swap(x, y);
    now = next;
    ++report.iterations;
  }
  return complete();
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_REFINE_IMPL_H
