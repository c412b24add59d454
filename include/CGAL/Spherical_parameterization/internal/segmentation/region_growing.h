// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_REGION_GROWING_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_REGION_GROWING_H

#include <CGAL/Spherical_parameterization/internal/segmentation/Segmentation_mesh.h>
#include <CGAL/Spherical_parameterization/internal/segmentation/stretch_minima.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Seeds of Definition 2: the vertices where the stretch is a strict local minimum or maximum, those with the largest
/// stretch first.
inline std::vector<int> seeds(const Segmentation_mesh& mesh, const std::vector<double>& stretch)
{
  std::vector<int> result;
  for(int v = 0; v < mesh.number_of_vertices(); ++v) {
    bool is_minimum = true, is_maximum = true;
    for(int k = mesh.graph->offset[v]; k < mesh.graph->offset[v + 1]; ++k) {
      is_minimum = is_minimum && stretch[mesh.graph->target[k]] > stretch[v];
      is_maximum = is_maximum && stretch[mesh.graph->target[k]] < stretch[v];
    }
    if(is_minimum || is_maximum)
      result.push_back(v);
  }
  std::stable_sort(result.begin(), result.end(), [&](int a, int b) { return stretch[a] > stretch[b]; });
  return result;
}

/// Section 5.1 of the paper: from every seed that no region has reached yet, a region grows over the faces whose
/// stretch differs from the seed's by at most `threshold`. Returns a label for every face; 0 is what no region has
/// reached.
inline std::vector<int> grown_labels(const Segmentation_mesh& mesh, const std::vector<double>& face_stretch,
                                     double threshold)
{
  constexpr int smoothing = 5; // of the stretch, or almost every second vertex would be a seed
  const std::vector<double> stretch = smoothed(mesh, stretch_of_vertices(mesh, face_stretch), smoothing);
  std::vector<int> some_face(stretch.size(), -1);
  for(int f = 0; f < mesh.number_of_faces(); ++f)
    for(int v : mesh.face[f])
      some_face[v] = f;
  const auto value = [&](int f) {
    return (stretch[mesh.face[f][0]] + stretch[mesh.face[f][1]] + stretch[mesh.face[f][2]]) / 3;
  };

  std::vector<int> label(mesh.face.size(), 0), front;
  std::vector<char> is_reached(stretch.size(), 0);
  int count = 0;
  for(int seed : seeds(mesh, stretch)) {
    const int first = some_face[seed];
    if(is_reached[seed] || label[first] > 0)
      continue;
    label[first] = ++count;
    front.push_back(first);
    while(!front.empty()) {
      const int f = front.back();
      front.pop_back();
      for(int v : mesh.face[f])
        is_reached[v] = 1;
      for(int k = 0; k < 3; ++k) {
        const int g = mesh.across(f, k);
        if(label[g] == 0 && std::abs(value(g) - stretch[seed]) <= threshold) {
          label[g] = count;
          front.push_back(g);
        }
      }
    }
  }
  return label;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_REGION_GROWING_H
