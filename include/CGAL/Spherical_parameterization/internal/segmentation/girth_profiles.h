// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_GIRTH_PROFILES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_GIRTH_PROFILES_H

#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/surface/persistence.h>
#include <CGAL/Spherical_parameterization/internal/segmentation/Segmentation_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Some tips of limbs that lie together on the sphere: a single one, or all of a hand.
struct Bundle {
  vec3 centre;
  std::size_t number_of_tips;
  double radius;           ///< chord from the centre to the farthest of its tips; 0 for a single one
  double distance_to_next; ///< chord from the centre to the nearest other tip; 2 if there is none
};

/// The nodes of the single-linkage tree of the tips, by their distances on the sphere, except for the root.
CGAL_SP_INLINE std::vector<Bundle> bundles_of_tips(const std::vector<vec3>& tips)
{
  const int n = static_cast<int>(tips.size());
  const auto distance = [](vec3 a, vec3 b) { return norm(sub(a, b)); };
  std::vector<std::vector<int>> clusters(n);
  std::vector<std::vector<double>> gap(n, std::vector<double>(n)); // between clusters
  for(int i = 0; i < n; ++i) {
    clusters[i] = {i};
    for(int j = 0; j < n; ++j)
      gap[i][j] = distance(tips[i], tips[j]);
  }

  std::vector<Bundle> bundles;
  const auto add_bundle = [&](const std::vector<int>& cluster) {
    vec3 centre = tips[cluster[0]];
    for(std::size_t k = 1; k < cluster.size(); ++k)
      centre = add(centre, tips[cluster[k]]);
    if(!(inner(centre, centre) > 0)) // tips that balance each other are no bundle
      return;
    Bundle b = {unit(centre), cluster.size(), 0, 2};
    for(int i = 0; i < n; ++i)
      if(std::find(cluster.begin(), cluster.end(), i) == cluster.end())
        b.distance_to_next = (std::min)(b.distance_to_next, distance(tips[i], b.centre));
      else if(cluster.size() > 1)
        b.radius = (std::max)(b.radius, distance(tips[i], b.centre));
    bundles.push_back(b);
  };
  if(n == 1)
    add_bundle(clusters[0]);
  for(int round = 1; round < n; ++round) {
    int a = -1, b = -1;
    for(int i = 0; i < n; ++i)
      for(int j = 0; j < i; ++j)
        if(!clusters[i].empty() && !clusters[j].empty() && (a < 0 || gap[i][j] < gap[a][b]))
          a = i, b = j;
    add_bundle(clusters[a]);
    add_bundle(clusters[b]);
    clusters[b].insert(clusters[b].end(), clusters[a].begin(), clusters[a].end());
    clusters[a].clear();
    for(int i = 0; i < n; ++i)
      gap[b][i] = gap[i][b] = (std::min)(gap[a][i], gap[b][i]);
  }
  return bundles;
}

/// rho = log(t / sqrt(1 - t^2 / 4)) of every vertex, t its chord to `centre`: log(2 tan(half the angle)). A conformal
/// map of a tube round the centre has rho as its length over its radius; a turn is isolines of rho.
CGAL_SP_INLINE std::vector<double> log_radius(const Segmentation_mesh& mesh, vec3 centre)
{
  std::vector<double> rho(mesh.image.size());
  for(std::size_t v = 0; v < rho.size(); ++v) {
    const double t2 = (std::max)(1e-34, squared_distance(mesh.image[v], centre));
    rho[v] = 0.5 * std::log(t2 / (std::max)(1e-6, 1 - t2 / 4));
  }
  return rho;
}

/// The isolines of rho as they lie on the source.
struct Girth_profile {
  double first, step;
  std::vector<double> girth; ///< length of the isoline first + i * step
  std::vector<double> area;  ///< share of the source inside

  double rho(std::size_t i) const { return first + static_cast<double>(i) * step; }
  /// How much of a part a cut makes: the smaller side's area over the square of the length of the cut.
  double significance(std::size_t i) const { return (std::min)(area[i], 1 - area[i]) / (girth[i] * girth[i]); }
};

CGAL_SP_INLINE Girth_profile girth_profile(const Segmentation_mesh& mesh, const std::vector<double>& rho, double first,
                                           double last)
{
  constexpr double resolution = 0.05;
  const int n = std::clamp(static_cast<int>((last - first) / resolution), 20, 2000);
  Girth_profile profile = {first, (last - first) / (n - 1), std::vector<double>(n, 0), std::vector<double>(n, 0)};
  for(int f = 0; f < mesh.number_of_faces(); ++f) {
    const std::array<int, 3>& corner = mesh.face[f];
    const double r[3] = {rho[corner[0]], rho[corner[1]], rho[corner[2]]};
    const double inside = (mean_of_corners(mesh, rho, f) - first) / profile.step;
    if(inside <= n - 1)
      profile.area[inside > 0 ? static_cast<int>(std::ceil(inside)) : 0] += mesh.face_area[f];
    const auto [least, largest] = std::minmax({r[0], r[1], r[2]});
    const double from = (least - first) / profile.step, to = (largest - first) / profile.step;
    if(!(to >= 0 && from <= n - 1))
      continue;
    const int i0 = from > 0 ? static_cast<int>(std::ceil(from)) : 0;
    const int i1 = to < n - 1 ? static_cast<int>(to) : n - 1;
    for(int i = i0; i <= i1; ++i) {
      vec3 end[3];
      int ends = 0;
      for(int k = 0; k < 3; ++k) {
        const double x = r[k], y = r[(k + 1) % 3], level = profile.rho(i);
        if((x < level) != (y < level))
          end[ends++] = add_scaled(mesh.point[corner[k]], (level - x) / (y - x), mesh.side(f, k));
      }
      if(ends == 2)
        profile.girth[i] += norm(sub(end[0], end[1]));
    }
  }
  for(int i = 1; i < n; ++i)
    profile.area[i] += profile.area[i - 1];
  return profile;
}

/// The minima of a profile that lie at least `prominence` below a maximum on both sides. If `open_end`, also one
/// between such a maximum and the end. Values that are infinite are left out.
CGAL_SP_INLINE std::vector<std::size_t> prominent_minima(const std::vector<double>& value, double prominence,
                                                         bool open_end)
{
  std::vector<std::size_t> minima;
  bool is_falling = false; // has fallen by the prominence since the last maximum
  double highest = -std::numeric_limits<double>::infinity();
  std::size_t lowest = 0;
  for(std::size_t i = 0; i < value.size(); ++i) {
    if(!std::isfinite(value[i]))
      continue;
    if(!is_falling) {
      highest = (std::max)(highest, value[i]);
      if(value[i] < highest - prominence) {
        is_falling = true;
        lowest = i;
      }
    } else if(value[i] < value[lowest])
      lowest = i;
    else if(value[i] > value[lowest] + prominence) {
      minima.push_back(lowest);
      is_falling = false;
      highest = value[i];
    }
  }
  if(open_end && is_falling)
    minima.push_back(lowest);
  return minima;
}

/// A cut along an isoline of rho.
struct Girth_cut {
  vec3 centre;
  double rho;
  std::size_t number_of_tips;
};

/// Where the limbs that end in `bundle` are cut off. On a tube d log(girth) / d rho is 0, on a cone the sine of its
/// slope, on a flat body 1: a limb ends where the girth starts to grow like that of a body, at the minimum of log
/// girth - slope * rho.
CGAL_SP_INLINE void add_girth_cuts(const Segmentation_mesh& mesh, const Bundle& bundle, std::vector<Girth_cut>& cuts)
{
  constexpr double slope = 0.3;               // between that of a tube and that of a body
  constexpr double prominence = 0.05;         // of a change of slope; 5 % of the girth
  constexpr double neck_prominence = 0.2;     // of a minimum of the girth itself
  constexpr double gap = 0.3;                 // to the nearest tips, so that isolines do not wind round them
  constexpr double least_area = 0.005;        // inside an isoline: less is noise
  constexpr double end_significance = 0.4;    // of the narrowest place of a profile that is still narrowing at its end
  constexpr double least_significance = 0.16; // that of the great circle of a ball, 1 / (2 pi)
  constexpr double same_cut = 0.2;            // a neck and a cut that differ by less than this share of the area
  constexpr double deepest = -36;             // log radius beyond which positions do not resolve anything
  const bool is_single = bundle.number_of_tips == 1;

  const double first = is_single ? deepest : std::log((std::max)(bundle.radius, 1e-16)) + gap;
  const double last = std::log((std::max)(bundle.distance_to_next, 1e-16)) - gap;
  if(last - first < 0.2)
    return;
  const Girth_profile profile = girth_profile(mesh, log_radius(mesh, bundle.centre), first, last);
  const std::size_t n = profile.girth.size();
  std::vector<double> girth(n, std::numeric_limits<double>::infinity()), sloped = girth;
  for(std::size_t i = 0; i < n; ++i)
    if(profile.girth[i] > 0 && profile.area[i] >= least_area) {
      girth[i] = std::log(profile.girth[i]);
      sloped[i] = girth[i] - slope * profile.rho(i);
    }
  for(int pass = 0; pass < 3; ++pass) { // a binomial filter
    const std::vector<double> before = sloped;
    for(std::size_t i = 1; i + 1 < n; ++i)
      if(std::isfinite(before[i - 1]) && std::isfinite(before[i + 1]))
        sloped[i] = before[i - 1] / 4 + before[i] / 2 + before[i + 1] / 4;
  }

  std::vector<std::size_t> chosen = prominent_minima(sloped, prominence, false);
  if(is_single) {
    const std::vector<std::size_t> with_end = prominent_minima(sloped, prominence, true);
    if(with_end.size() > chosen.size() && profile.significance(with_end.back()) > end_significance)
      chosen = with_end;
  }
  const std::size_t number_of_slope_cuts = chosen.size();
  for(std::size_t neck : prominent_minima(girth, neck_prominence, false)) {
    const bool is_new = std::none_of(chosen.begin(), chosen.begin() + number_of_slope_cuts, [&](std::size_t i) {
      return std::abs(profile.area[neck] - profile.area[i]) <
             same_cut * (std::min)(profile.area[neck], profile.area[i]);
    });
    if(is_new)
      chosen.push_back(neck);
  }
  for(std::size_t i : chosen)
    if(profile.significance(i) >= least_significance)
      cuts.push_back({bundle.centre, profile.rho(i), bundle.number_of_tips});
}

/// A label for every face by girth profiles round the minima of the map's scale; equal labels need not be connected.
/// The profiles of different bundles are measured on different threads.
CGAL_SP_INLINE std::vector<int> girth_labels(const Watched_loop<Host_loop>& loop, const Segmentation_mesh& mesh,
                                             const std::vector<double>& face_stretch)
{
  constexpr double persistence = 3;                  // about twice the length of a limb over its radius
  constexpr std::size_t largest_number_of_tips = 40; // more, and they are noise
  std::vector<double> scale_of_map = stretch_of_vertices(mesh, face_stretch);
  for(double& x : scale_of_map)
    x = -x;
  scale_of_map = smoothed(mesh, std::move(scale_of_map));
  const auto neighbours = [&](int v, const auto& visit) { mesh.for_each_neighbour(v, visit); };
  std::vector<vec3> tips;
  for(const Basin& basin : basins(scale_of_map, std::vector<double>(scale_of_map.size(), 1), neighbours))
    if(tips.empty() || (basin.persistence >= persistence && tips.size() < largest_number_of_tips))
      tips.push_back(mesh.image[basin.minimum]);

  const std::vector<Bundle> bundles = bundles_of_tips(tips);
  std::vector<std::vector<Girth_cut>> cuts_of_bundle(bundles.size());
  loop.for_each(static_cast<int>(bundles.size()), [&](int i) { add_girth_cuts(mesh, bundles[i], cuts_of_bundle[i]); });
  std::vector<Girth_cut> cuts;
  for(const std::vector<Girth_cut>& some : cuts_of_bundle)
    cuts.insert(cuts.end(), some.begin(), some.end());
  // outer cuts first, so that inner ones lie on top of them
  std::stable_sort(cuts.begin(), cuts.end(), [](const Girth_cut& a, const Girth_cut& b) {
    return a.number_of_tips != b.number_of_tips ? a.number_of_tips > b.number_of_tips : a.rho > b.rho;
  });
  std::vector<int> label(mesh.face.size(), 0);
  int count = 0;
  for(const Girth_cut& cut : cuts) {
    loop.check();
    const std::vector<double> rho = log_radius(mesh, cut.centre);
    ++count;
    for(int f = 0; f < mesh.number_of_faces(); ++f)
      if(mean_of_corners(mesh, rho, f) < cut.rho)
        label[f] = count;
  }
  return label;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_GIRTH_PROFILES_H
