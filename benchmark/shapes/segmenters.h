// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef BENCHMARK_SEGMENTERS_H
#define BENCHMARK_SEGMENTERS_H

#include "meshes/mesh.h"
#include "shapes/segmentation_scores.h"

#include <string>
#include <vector>

namespace benchmark {

struct Timed_labels {
  Labels labels;
  double seconds = 0; ///< without the map
};

struct Segmenter_result {
  std::string name;
  Timed_labels result;
};

/// All methods on one mesh, always the same ones in the same order: ours, the published one, stretch and SDF values in
/// CGAL's graph cut, and the trivial ones. `number_of_cells` is the number of random Voronoi cells.
std::vector<Segmenter_result> segment_by_all(Mesh& mesh, Sphere_map sphere, std::size_t number_of_cells, bool with_sdf);

} // namespace benchmark

#endif // BENCHMARK_SEGMENTERS_H
