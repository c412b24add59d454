// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_MAJORITY_VOTE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_MAJORITY_VOTE_H

#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/segmentation/Region_graph.h>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// A segmentation with a say in the common one.
struct Voter {
  std::vector<int> label; ///< of the faces
  double weight;
};

/// How much of every region has which label, for every voter; for two regions this gives the share of votes for
/// keeping a pair of points together, one from each, drawn by area.
template <class...>
class Ballots {
public:
  Ballots(const Segmentation_mesh& mesh, const std::vector<int>& region, int count, const std::vector<Voter>& voters)
    : tallies_(count), area_(count, 0)
  {
    double total = 0;
    for(const Voter& voter : voters)
      total += voter.weight;
    for(const Voter& voter : voters)
      weight_.push_back(voter.weight / total);
    const double tiny = 1e-9 / mesh.number_of_faces(); // so that regions without area have a share, too
    for(int f = 0; f < mesh.number_of_faces(); ++f) {
      area_[region[f]] += mesh.face_area[f] + tiny;
      for(std::size_t e = 0; e < voters.size(); ++e)
        tallies_[region[f]][{e, voters[e].label[f]}] += mesh.face_area[f] + tiny;
    }
  }

  double votes_for_union(int a, int b) const
  {
    if(tallies_[a].size() > tallies_[b].size())
      std::swap(a, b);
    double sum = 0;
    for(const auto& [key, area] : tallies_[a])
      if(const auto other = tallies_[b].find(key); other != tallies_[b].end())
        sum += weight_[key.first] * area * other->second;
    return sum / (area_[a] * area_[b]);
  }

  /// To be called when regions a and b have become one, with the number c of either.
  void merge(int a, int b, int c)
  {
    const int gone = c == a ? b : a;
    area_[c] += area_[gone];
    for(const auto& [key, area] : tallies_[gone])
      tallies_[c][key] += area;
    tallies_[gone].clear();
  }

private:
  std::vector<std::map<std::pair<std::size_t, int>, double>> tallies_; // by region: (voter, label) -> area
  std::vector<double> area_, weight_;
};

/// The segmentation that disagrees little with the voters, counted in pairs of points like the Rand index does: from
/// the common refinement on, those neighbours are merged that have most votes for it, while they have more than half
/// of them. If the limits have a number of segments, until there are that many.
CGAL_SP_INLINE std::vector<int> majority_segments(const Watched_loop<Host_loop>& loop, const Segmentation_mesh& mesh,
                                                  const std::vector<Voter>& voters, const Segment_limits& limits)
{
  std::map<std::vector<int>, int> number_of;
  std::vector<int> label(mesh.face.size()), key(voters.size());
  for(std::size_t f = 0; f < label.size(); ++f) {
    for(std::size_t e = 0; e < voters.size(); ++e)
      key[e] = voters[e].label[f];
    label[f] = number_of.emplace(key, static_cast<int>(number_of.size())).first->second;
  }
  const std::vector<int> region = connected_components(mesh, label);
  Region_graph regions(loop, mesh, region, side_lengths(mesh));
  Ballots<> ballots(mesh, region, regions.capacity(), voters);
  const auto votes_against = [&](int a, const Region_graph::Border& border) {
    return 1 - ballots.votes_for_union(a, border.region);
  };
  const auto count = [&](int a, int b, int c) { ballots.merge(a, b, c); };
  absorb_small_regions(regions, limits.minimum_area, votes_against, count);
  constexpr double half = 0.5 - 1e-9; // a tie is no majority
  const auto goes_on = [&](double against) {
    return limits.number_of_segments > 0 ? regions.number_of_regions() > limits.number_of_segments : against < half;
  };
  merge_in_order(regions, votes_against, goes_on, count);
  return regions.labels();
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_MAJORITY_VOTE_H
