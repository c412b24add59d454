// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_CONCAVE_CUTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_CONCAVE_CUTS_H

#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/algebra/pi.h>
#include <CGAL/Spherical_parameterization/internal/backend/Host_backend.h>
#include <CGAL/Spherical_parameterization/internal/multigrid/Multigrid.h>
#include <CGAL/Spherical_parameterization/internal/segmentation/Region_graph.h>
#include <CGAL/Spherical_parameterization/internal/segmentation/Segmentation_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The faces as vertices of a graph, two neighbours joined with weight (length of the edge) / (distance of the
/// centroids) times `diffusion`, and the areas as excess: M + diffusion * L of the dual mesh.
template <class Loop>
Weighted_graph dual_diffusion(const Loop& loop, const Segmentation_mesh& mesh, double diffusion)
{
  // A needle must not tie its neighbours together more than a good triangle would, by orders of magnitude.
  constexpr double largest_weight = 100;
  const int n = mesh.number_of_faces();
  Weighted_graph dual;
  for(int f = 0; f < n; ++f) {
    std::array<int, 3> order = {0, 1, 2};
    std::sort(order.begin(), order.end(), [&](int a, int b) { return mesh.across(f, a) < mesh.across(f, b); });
    for(int k : order) {
      const int g = mesh.across(f, k);
      const double length = mesh.side_length(f, k), distance = norm(sub(mesh.centroid(g), mesh.centroid(f)));
      dual.target.push_back(g);
      dual.weight.push_back(diffusion * (length < largest_weight * distance ? length / distance : largest_weight));
    }
    dual.offset.push_back(static_cast<int>(dual.target.size()));
    dual.excess.push_back((std::max)(mesh.face_area[f], 1e-12 / n));
  }
  dual.update_diagonal({}, loop);
  return dual;
}

/// The unit normals of the faces, averaged over neighbourhoods of root mean square radius r (the mesh has area 1): one
/// implicit step of the heat equation, (M + r^2/4 L) n' = M n. Does not depend on how finely the mesh is divided.
template <class Loop>
Host_array<vec3> smoothed_normals(const Loop& loop, const Segmentation_mesh& mesh, double radius)
{
  const Host_backend<Loop> backend(loop);
  const auto dual = std::make_shared<Weighted_graph>(dual_diffusion(loop, mesh, radius * radius / 4));
  Multigrid<Host_backend<Loop>> multigrid(backend, dual);
  Host_array<vec3> mass_times_normal(mesh.number_of_faces());
  for(int f = 0; f < mesh.number_of_faces(); ++f)
    mass_times_normal[f] = scale(0.5, mesh.area_vector(f));
  Host_array<vec3> normal = backend.vectors(mesh.number_of_faces());
  Monitor monitor(std::numeric_limits<double>::infinity(), {}, false);
  constexpr double accuracy = 1e-3; // of the normals, that is 1e-3 radians
  conjugate_gradients(backend, multigrid, 0, mass_times_normal, accuracy, monitor, 0, normal);
  for(vec3& n : normal)
    n = inner(n, n) > 0 ? unit(n) : make_vec3(0, 0, 0);
  return normal;
}

/// How much the normal turns inwards across each side along a way of length r: positive in concave places.
CGAL_SP_INLINE Side_costs inward_turn(const Segmentation_mesh& mesh, const Host_array<vec3>& normal, double radius)
{
  Side_costs turn(mesh.face.size());
  for(int f = 0; f < mesh.number_of_faces(); ++f)
    for(int k = 0; k < 3; ++k) {
      const int g = mesh.across(f, k);
      const vec3 d = sub(mesh.centroid(g), mesh.centroid(f)), dn = sub(normal[g], normal[f]);
      const double angle = std::atan2(norm(outer(normal[f], normal[g])), inner(normal[f], normal[g]));
      const double distance = norm(d), size = distance > 0 ? angle / distance * radius : 0;
      turn[f][k] = inner(d, dn) < 0 ? size : -size;
    }
  return turn;
}

/// What it costs to cut along each edge: its length, less in valleys of width r. A valley is where the surface turns
/// inwards more than it does at a wider scale, so that the inside of a bowl, which is concave everywhere, is none.
/// `fine` and `wide` are inward_turn() of normals smoothed at radius r and at that scale. On a rugged surface, like
/// curly hair, valleys are everywhere, and say little: the costs of all edges rise as their mean falls.
CGAL_SP_INLINE Side_costs cutting_costs(const Segmentation_mesh& mesh, const Side_costs& fine, const Side_costs& wide)
{
  constexpr double sharpness = 60; // a turn by 0.2 radians makes a cut 50 times cheaper
  constexpr double least = 0.02;   // of the length: the shorter of two perfect valleys is the better cut
  constexpr double ruggedness = 6; // the mean cost is 0.9 of the length on limbs, and 0.7 on curly hair
  Side_costs cost(mesh.face.size());
  double total_cost = 0, total_length = 0;
  for(int f = 0; f < mesh.number_of_faces(); ++f)
    for(int k = 0; k < 3; ++k) {
      const double valley = fine[f][k] - 0.5 * (std::max)(0., wide[f][k]);
      const double share = valley > 0 ? std::pow((std::max)(0., 1 - valley / pi), sharpness) : 1;
      const double length = mesh.side_length(f, k);
      cost[f][k] = (std::max)(share, least) * length;
      total_cost += cost[f][k];
      total_length += length;
    }
  const double factor = std::pow(total_length / total_cost, ruggedness);
  for(std::array<double, 3>& of_face : cost)
    for(double& c : of_face)
      c *= factor;
  return cost;
}

/// Bottom-up normalized cuts (after Golovinskiy and Funkhouser, "Randomized cuts for 3D mesh analysis", SIGGRAPH Asia
/// 2008): from single faces on, the two neighbours are merged that lower the sum over all segments of (cost of the
/// perimeter) / area most, until the best merger lowers it by less than `stop`. Areas are shares of the whole, and
/// costs lengths relative to its square root.
CGAL_SP_INLINE std::vector<int> normalized_cuts(const Segmentation_mesh& mesh, const Side_costs& costs, double stop)
{
  std::vector<int> single(mesh.face.size());
  std::iota(single.begin(), single.end(), 0);
  Region_graph regions(mesh, std::move(single), costs);
  const double tiny = 1e-9 / mesh.number_of_faces(); // faces without area merge first
  const auto change_of_sum = [&](int a, const Region_graph::Border& border) {
    const int b = border.region;
    const double area_a = regions.area(a) + tiny, area_b = regions.area(b) + tiny;
    const double perimeter_a = regions.perimeter(a), perimeter_b = regions.perimeter(b);
    return (perimeter_a + perimeter_b - 2 * border.cost) / (area_a + area_b) - perimeter_a / area_a -
           perimeter_b / area_b;
  };
  merge_in_order(regions, change_of_sum, [&](double change) { return -change >= stop; });
  return regions.labels();
}

/// Segmentations along concave creases at four scales, each on a thread.
template <class Loop>
std::vector<std::vector<int>> concavity_segments(const Loop& loop, const Segmentation_mesh& mesh)
{
  constexpr int scales = 4;
  constexpr double finest = 0.02; // of the square root of the area; meshes of 10,000 faces have edges of 0.015
  constexpr double ratio = 1.5;   // of one scale to the next; valleys are compared with the scale after that
  constexpr double stop = 6;      // what a part of area a and perimeter p has to save, p / a, to be one
  const auto radius = [&](int scale) { return finest * std::pow(ratio, scale); };
  std::vector<Host_array<vec3>> normals;
  for(int i = 0; i < scales + 2; ++i)
    normals.push_back(smoothed_normals(loop, mesh, radius(i)));
  std::vector<std::vector<int>> segments(scales);
  loop.for_each(scales, [&](int i) {
    const Side_costs fine = inward_turn(mesh, normals[i], radius(i));
    const Side_costs wide = inward_turn(mesh, normals[i + 2], radius(i));
    segments[i] = normalized_cuts(mesh, cutting_costs(mesh, fine, wide), stop);
  });
  return segments;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_CONCAVE_CUTS_H
