// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_CONCAVE_CUTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_CONCAVE_CUTS_H

#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/backend/Host_backend.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/multigrid/Multigrid.h>
#include <CGAL/Spherical_parameterization/internal/segmentation/Region_graph.h>
#include <CGAL/Spherical_parameterization/internal/surface/breadth_first.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// An order of the faces in which neighbours are close together, as the multigrid needs it: that of the mesh, unless a
/// quarter of the neighbours are far from each other in it. Then the faces are sorted by their first vertices, which
/// are numbered breadth-first.
CGAL_SP_INLINE Host_array<int> local_order(const Segmentation_mesh& mesh)
{
  constexpr int far_away = 16384; // the multigrid cuts between blocks of so many
  const auto is_far = [&](int h) { return std::abs(mesh.twin[h] / 3 - h / 3) > far_away; };
  int far_sides = 0;
  for(int h = 0; h < mesh.number_of_halfedges(); ++h)
    far_sides += is_far(h);
  const bool is_local = far_sides <= mesh.number_of_halfedges() / 4;
  std::vector<int> begin; // of no use
  return sorted_by_key(mesh.number_of_faces(), mesh.number_of_vertices(), begin, [&](int f) {
    return is_local ? 0 : *std::min_element(mesh.face[f].begin(), mesh.face[f].end());
  });
}

/// The faces as vertices of a graph, numbered in this `order`, two neighbours joined with weight (length of the edge) /
/// (distance of the centroids) times `diffusion`, and the areas as excess: M + diffusion * L of the dual mesh.
CGAL_SP_INLINE Weighted_graph dual_diffusion(const Host_loop& loop, const Segmentation_mesh& mesh,
                                             const Host_array<int>& order, double diffusion)
{
  // A needle must not tie its neighbours together more than a good triangle would, by orders of magnitude.
  constexpr double largest_weight = 100;
  const int n = mesh.number_of_faces();
  const Host_array<int> number = inverse_permutation(loop, order);
  Weighted_graph dual;
  for(int f : order) {
    std::array<int, 3> sides = {0, 1, 2};
    std::sort(sides.begin(), sides.end(),
              [&](int a, int b) { return number[mesh.across(f, a)] < number[mesh.across(f, b)]; });
    for(int k : sides) {
      const int g = mesh.across(f, k);
      const double length = mesh.side_length(f, k), distance = norm(sub(mesh.centroid(g), mesh.centroid(f)));
      dual.target.push_back(number[g]);
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
CGAL_SP_INLINE Host_array<vec3> smoothed_normals(const Watched_loop<Host_loop>& loop, const Segmentation_mesh& mesh,
                                                 double radius)
{
  loop.check();
  const int n = mesh.number_of_faces();
  const Host_backend<Host_loop> backend(loop.bare());
  const Host_array<int> order = local_order(mesh);
  const auto dual = std::make_shared<Weighted_graph>(dual_diffusion(loop.bare(), mesh, order, radius * radius / 4));
  Multigrid<Host_backend<Host_loop>> multigrid(backend, dual, &loop.monitor());
  Host_array<vec3> mass_times_normal(n);
  for(int i = 0; i < n; ++i)
    mass_times_normal[i] = scale(0.5, normal(mesh.point, mesh.face[order[i]]));
  Host_array<vec3> smooth = backend.vectors(n);
  constexpr double accuracy = 1e-3; // of the normals, that is 1e-3 radians
  conjugate_gradients(backend, multigrid, 0, mass_times_normal, accuracy, loop.monitor(), 0, smooth);
  Host_array<vec3> normal(n);
  for(int i = 0; i < n; ++i)
    normal[order[i]] = inner(smooth[i], smooth[i]) > 0 ? unit(smooth[i]) : make_vec3(0, 0, 0);
  return normal;
}

/// How much the normal turns inwards across side k of face f along a way of length r: positive in concave places.
CGAL_SP_INLINE double inward_turn(const Segmentation_mesh& mesh, const Host_array<vec3>& normal, double radius, int f,
                                  int k)
{
  const int g = mesh.across(f, k);
  const vec3 d = sub(mesh.centroid(g), mesh.centroid(f)), dn = sub(normal[g], normal[f]);
  const double angle = std::atan2(norm(outer(normal[f], normal[g])), inner(normal[f], normal[g]));
  const double distance = norm(d), size = distance > 0 ? angle / distance * radius : 0;
  return inner(d, dn) < 0 ? size : -size;
}

/// The concave creases of a mesh, at four scales.
class Creases {
public:
  static constexpr int scales = 4;

  CGAL_SP_INLINE Creases(const Watched_loop<Host_loop>& loop, const Segmentation_mesh& mesh) : mesh_(mesh)
  {
    for(int scale = 0; scale < scales + wider; ++scale)
      normals_.push_back(smoothed_normals(loop, mesh, radius(scale)));
  }

  /// What it costs to cut along side k of face f: its length, less in a crease of the width of that scale. A crease is
  /// where the surface turns inwards more than it does at a wider scale, so that the inside of a bowl, which is concave
  /// everywhere, is none.
  double cost(int scale, int f, int k) const
  {
    constexpr double sharpness = 60; // a turn by 0.2 radians makes a cut 50 times cheaper
    constexpr double least = 0.02;   // of the length: the shorter of two perfect creases is the better cut
    const double fine = inward_turn(mesh_, normals_[scale], radius(scale), f, k);
    const double wide = inward_turn(mesh_, normals_[scale + wider], radius(scale), f, k);
    const double crease = fine - 0.5 * (std::max)(0., wide);
    const double share = crease > 0 ? std::pow((std::max)(0., 1 - crease / pi), sharpness) : 1;
    return (std::max)(share, least) * mesh_.side_length(f, k);
  }

  /// The costs of all sides. On a rugged surface, like curly hair, creases are everywhere, and say little: all costs
  /// rise as their mean falls.
  Side_costs costs(int scale) const
  {
    constexpr double ruggedness = 6; // the mean cost is 0.9 of the length on limbs, and 0.7 on curly hair
    Side_costs costs(mesh_.face.size());
    double total_cost = 0, total_length = 0;
    for(int f = 0; f < mesh_.number_of_faces(); ++f)
      for(int k = 0; k < 3; ++k) {
        costs[f][k] = cost(scale, f, k);
        total_cost += costs[f][k];
        total_length += mesh_.side_length(f, k);
      }
    const double factor = std::pow(total_length / total_cost, ruggedness);
    for(std::array<double, 3>& of_face : costs)
      for(double& c : of_face)
        c *= factor;
    return costs;
  }

private:
  static constexpr int wider = 2; // so many scales on is the one that creases are compared with

  /// of the width of creases, in square roots of the area; meshes of 10,000 faces have edges of 0.015
  static double radius(int scale) { return 0.02 * std::pow(1.5, scale); }

  const Segmentation_mesh& mesh_;
  std::vector<Host_array<vec3>> normals_;
};

/// Bottom-up normalized cuts (after Golovinskiy and Funkhouser, "Randomized cuts for 3D mesh analysis", SIGGRAPH Asia
/// 2008): the two neighbours are merged that lower the sum over all segments of (cost of the perimeter) / area most,
/// while `goes_on(by how much)`. Areas are shares of the whole, and costs lengths relative to its square root.
template <class Goes_on>
void merge_by_normalized_cuts(Region_graph& regions, Goes_on goes_on)
{
  constexpr double tiny = 1e-15; // faces without area merge first
  const auto change_of_sum = [&](int a, const Region_graph::Border& border) {
    const int b = border.region;
    const double area_a = regions.area(a) + tiny, area_b = regions.area(b) + tiny;
    const double perimeter_a = regions.perimeter(a), perimeter_b = regions.perimeter(b);
    return (perimeter_a + perimeter_b - 2 * border.cost) / (area_a + area_b) - perimeter_a / area_a -
           perimeter_b / area_b;
  };
  merge_in_order(regions, change_of_sum, [&](double change) { return goes_on(-change); });
}

/// Segmentations along concave creases.
struct Crease_segments {
  std::array<std::vector<int>, Creases::scales> at_scale;
  std::vector<int> patches; ///< at most 200: those of one scale before most mergers
};

/// Each scale on a thread.
CGAL_SP_INLINE Crease_segments crease_segments(const Watched_loop<Host_loop>& loop, const Segmentation_mesh& mesh,
                                               const Creases& creases)
{
  constexpr double stop = 6; // what a part of area a and perimeter p has to save, p / a, to be one
  constexpr int scale_of_patches = 1;
  constexpr std::size_t number_of_patches = 200;
  Crease_segments segments;
  loop.for_each(Creases::scales, [&](int scale) {
    std::vector<int> single(mesh.face.size());
    std::iota(single.begin(), single.end(), 0);
    Region_graph regions(loop, mesh, std::move(single), creases.costs(scale));
    if(scale == scale_of_patches) {
      merge_by_normalized_cuts(regions, [&](double) { return regions.number_of_regions() > number_of_patches; });
      segments.patches = regions.labels();
    }
    merge_by_normalized_cuts(regions, [&](double saving) { return saving >= stop; });
    segments.at_scale[scale] = regions.labels();
  });
  return segments;
}

/// Unites segments whose border is no crease, those first whose border costs most above the limit: a long tube is one
/// part, however much it would save to cut it.
CGAL_SP_INLINE std::vector<int> without_flat_borders(const Watched_loop<Host_loop>& loop, const Segmentation_mesh& mesh,
                                                     const Creases& creases, const std::vector<int>& label)
{
  constexpr double flat = 0.85; // of the length: the mean cost along the border, and over the scales
  Side_costs excess(mesh.face.size(), {0, 0, 0});
  for(int f = 0; f < mesh.number_of_faces(); ++f)
    for(int k = 0; k < 3; ++k)
      if(label[f] != label[mesh.across(f, k)]) {
        for(int scale = 0; scale < Creases::scales; ++scale)
          excess[f][k] += creases.cost(scale, f, k) / Creases::scales;
        excess[f][k] -= flat * mesh.side_length(f, k);
      }
  Region_graph regions(loop, mesh, label, excess);
  merge_in_order(
    regions, [](int, const Region_graph::Border& border) { return -border.cost; }, [](double key) { return key < 0; });
  return regions.labels();
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_CONCAVE_CUTS_H
