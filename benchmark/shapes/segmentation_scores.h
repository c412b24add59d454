// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef BENCHMARK_SEGMENTATION_SCORES_H
#define BENCHMARK_SEGMENTATION_SCORES_H

#include "meshes/mesh.h"

#include <array>
#include <vector>

namespace benchmark {

/// One number for every face, in the order of the faces.
typedef std::vector<int> Labels;

/// How much two segmentations of a mesh differ, after X. Chen, A. Golovinskiy, T. Funkhouser, "A benchmark for 3D mesh
/// segmentation", SIGGRAPH 2009; 0 for equal ones.
struct Segmentation_scores {
  double rand_index_error = 0;   ///< share of the pairs of faces that one keeps together and the other does not
  double cut_discrepancy = 0;    ///< mean distance from each one's cuts to the other's, both ways added, over the mean
                                 ///< distance of the surface from its centroid; NaN if one of them has no cut
  double hamming_distance = 0;   ///< mean of missing rate and false alarm rate
  double global_consistency = 0; ///< error; 0 if one refines the other
  double local_consistency = 0;  ///< error; 0 if everywhere one or the other is the refinement
};
constexpr std::array<double Segmentation_scores::*, 5> all_scores = {
  &Segmentation_scores::rand_index_error, &Segmentation_scores::cut_discrepancy, &Segmentation_scores::hamming_distance,
  &Segmentation_scores::global_consistency, &Segmentation_scores::local_consistency};

/// The faces count equally in the Rand index, by their areas in the Hamming distance and the consistency errors.
/// Distances between cuts are measured along edges.
class Segmentation_judge {
public:
  explicit Segmentation_judge(const Mesh& mesh);
  Segmentation_scores compare(const Labels& a, const Labels& b) const;

private:
  double cut_distance(const Labels& from, const Labels& to) const;

  const Mesh& mesh_;
  std::vector<double> area_; ///< of the faces
  double mean_radius_ = 0;
};

} // namespace benchmark

#endif // BENCHMARK_SEGMENTATION_SCORES_H
