// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef BENCHMARK_SEGMENTATIONS_H
#define BENCHMARK_SEGMENTATIONS_H

#include "meshes/mesh.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace benchmark {

/// One number for every face, in the order of the faces.
typedef std::vector<int> Labels;

/// How much two segmentations of a mesh differ, after X. Chen, A. Golovinskiy, T. Funkhouser, "A benchmark for 3D mesh
/// segmentation", SIGGRAPH 2009; 0 for equal ones:
/// 0. Rand index error: share of the pairs of faces that one keeps together and the other does not
/// 1. cut discrepancy: mean distance from each one's cuts to the other's, both ways added, over the mean distance of
///    the surface from its centroid; NaN if one of them has no cut
/// 2. Hamming distance: mean of missing rate and false alarm rate
/// 3. global consistency error: 0 if one refines the other
/// 4. local consistency error: 0 if everywhere one or the other is the refinement
typedef Eigen::Array<double, 5, 1> Segmentation_scores;

/// The faces count equally in the Rand index, by their areas in the Hamming distance and the consistency errors.
/// Distances between cuts are measured along edges.
class Segmentation_judge {
public:
  explicit Segmentation_judge(const Mesh& mesh);
  Segmentation_scores compare(const Labels& a, const Labels& b) const;

private:
  double cut_distance(const Labels& from, const Labels& to) const;

  const Mesh& mesh_;
  Eigen::ArrayXd area_; ///< of the faces
  double mean_radius_ = 0;
};

struct Segmenter_result {
  std::string name;
  Labels labels;
  double seconds = 0; ///< without the map
};

/// All methods on one mesh, always the same ones in the same order: ours, the published one, stretch and SDF values in
/// CGAL's graph cut, and the trivial ones. `number_of_cells` is the number of random Voronoi cells.
std::vector<Segmenter_result> segment_by_all(Mesh& mesh, Sphere_map sphere, std::size_t number_of_cells, bool with_sdf);

} // namespace benchmark

#endif // BENCHMARK_SEGMENTATIONS_H
