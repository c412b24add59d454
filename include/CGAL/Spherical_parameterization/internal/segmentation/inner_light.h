// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_INNER_LIGHT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_INNER_LIGHT_H

#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/locate/Ray_tree.h>
#include <CGAL/Spherical_parameterization/internal/segmentation/Region_graph.h>
#include <CGAL/Spherical_parameterization/internal/surface/even_samples.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// A way of light inside the body, from one face to another one.
struct Flight {
  int from, to;
};

/// Ways of light that leaves every place of the surface inwards with the same density, and in every direction with the
/// cosine of its angle to the normal, as a matt surface reflects it. What ends nowhere is left out.
template <class Loop>
std::vector<Flight> flights_inside(const Loop& loop, const Segmentation_mesh& mesh, int count)
{
  constexpr double step[] = {0.8566748838545029, 0.733891856627126, 0.6287067210378087, 0.5385972572236101};
  const std::vector<int> faces = faces_at_even_areas(mesh.face_area, 1, count);
  std::vector<Flight> flights(count);
  const Ray_tree tree(mesh.point, mesh.face);
  // Where faces are needles, a ray takes long: only small parts end soon after the time limit.
  constexpr int rays_at_once = 64;
  for_each_index<rays_at_once>(loop, count, [&](int i) {
    const int f = faces[i];
    flights[i] = {f, -1};
    int k = 0; // the longest side: as far as sides differ, directions do not depend on which corner is the first one
    for(int other : {1, 2})
      if(mesh.side_length(f, other) > mesh.side_length(f, k))
        k = other;
    const double s = std::sqrt(quasirandom(i, step[0])), t = quasirandom(i, step[1]);
    const double square = quasirandom(i, step[2]), turn = 2 * pi * quasirandom(i, step[3]);
    const vec3 along = mesh.side(f, k), inwards = scale(-1, normal(mesh.point, mesh.face[f]));
    const double length = norm(along), twice_area = norm(inwards);
    if(!(length > 0 && twice_area > 0))
      return;
    const vec3 z = scale(1 / twice_area, inwards), x = scale(1 / length, along), y = outer(z, x);
    const vec3 level = add_scaled(scale(std::cos(turn), x), std::sin(turn), y);
    const vec3 direction = add_scaled(scale(std::sqrt(1 - square), z), std::sqrt(square), level);
    const vec3 side = mesh.side(f, (k + 1) % 3);
    const vec3 origin = add_scaled(add_scaled(mesh.point[mesh.face[f][k]], s, along), s * t, side);
    flights[i].to = tree.first_hit({origin, direction}, f);
  });
  flights.erase(std::remove_if(flights.begin(), flights.end(), [](const Flight& flight) { return flight.to < 0; }),
                flights.end());
  return flights;
}

/// How much light goes from one region to another one, half of it directly, and half reflected once on the way: so
/// those see each other, too, that lie side by side on a wall, by what is opposite.
class Exchange_of_light {
public:
  Exchange_of_light(const std::vector<int>& region, int count, const std::vector<double>& face_area,
                    const std::vector<Flight>& flights)
    : count_(count), area_(count, 0), light_(static_cast<std::size_t>(count) * count, 0)
  {
    for(std::size_t f = 0; f < region.size(); ++f)
      area_[region[f]] += face_area[f];
    std::vector<double> direct(light_.size(), 0), sum(count, 0);
    for(const Flight& flight : flights) { // light may go either way
      const int a = region[flight.from], b = region[flight.to];
      ++direct[at(a, b)];
      ++direct[at(b, a)];
      ++sum[a];
      ++sum[b];
    }
    for(int a = 0; a < count; ++a)
      for(int c = 0; c < count; ++c)
        if(const double arrives = direct[at(a, c)]; arrives > 0) {
          light_[at(a, c)] += arrives;
          for(int b = 0; b < count; ++b)
            light_[at(a, b)] += arrives / sum[c] * direct[at(c, b)];
        }
  }

  /// Of the light that starts in one region and stays in the two, the share that ends in the other one: for that region
  /// which sends less to itself, and over the share of the larger region in their area. 1 in a ball, less if the way
  /// between them is narrow or bent, and more if they are all that they see.
  double share(int a, int b) const
  {
    const double over = light_[at(a, b)];
    const double all = over + (std::min)(light_[at(a, a)], light_[at(b, b)]);
    return all > 0 ? over / all * (area_[a] + area_[b]) / (std::max)(area_[a], area_[b]) : 0;
  }

  /// To be called when regions a and b have become one, with the number c of either.
  void merge(int a, int b, int c)
  {
    const int gone = c == a ? b : a;
    area_[c] += area_[gone];
    for(int other = 0; other < count_; ++other)
      light_[at(c, other)] += light_[at(gone, other)];
    for(int other = 0; other < count_; ++other)
      light_[at(other, c)] += light_[at(other, gone)];
  }

private:
  std::size_t at(int a, int b) const { return static_cast<std::size_t>(a) * count_ + b; }

  int count_;
  std::vector<double> area_;
  std::vector<double> light_; ///< a symmetric matrix
};

/// The parts of the body within which light spreads: a limb gets little light of the body it is on, and a bent limb
/// little from beyond the bend; the inside and the outside of a cup see each other through the wall. A single part if
/// most light ends nowhere, as where the faces are turned inside out.
/// \param patches  labels of the faces from 0 on without gaps: what is not cut
CGAL_SP_INLINE std::vector<int> segments_of_light(const Watched_loop<Host_loop>& loop, const Segmentation_mesh& mesh,
                                                  const std::vector<int>& patches)
{
  constexpr int count = 1 << 16; // about 330 for each of 200 patches
  constexpr double least_share = 0.4;
  const std::vector<Flight> flights = flights_inside(loop, mesh, count);
  if(flights.size() < count / 2)
    return std::vector<int>(patches.size(), 0);
  Region_graph regions(loop, mesh, patches, side_lengths(mesh));
  Exchange_of_light light(patches, regions.capacity(), mesh.face_area, flights);
  const auto darkness = [&](int a, const Region_graph::Border& border) { return -light.share(a, border.region); };
  merge_in_order(
    regions, darkness, [&](double key) { return -key > least_share; },
    [&](int a, int b, int c) { light.merge(a, b, c); });
  return regions.labels();
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_INNER_LIGHT_H
