// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_REGION_GROWING_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_REGION_GROWING_H

#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/segmentation/Segmentation_mesh.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Seeds of Definition 2: the vertices where the stretch is a strict local minimum or maximum, those with the largest
/// stretch first.
CGAL_SP_INLINE std::vector<int> seeds(const Segmentation_mesh& mesh, const std::vector<double>& stretch)
{
  std::vector<int> result;
  for(int v = 0; v < mesh.number_of_vertices(); ++v) {
    bool is_minimum = true, is_maximum = true;
    mesh.for_each_neighbour(v, [&](int w) {
      is_minimum = is_minimum && stretch[w] > stretch[v];
      is_maximum = is_maximum && stretch[w] < stretch[v];
    });
    if(is_minimum || is_maximum)
      result.push_back(v);
  }
  std::stable_sort(result.begin(), result.end(), [&](int a, int b) { return stretch[a] > stretch[b]; });
  return result;
}

/// Section 5.1 of the paper: from every seed that no region has reached yet, a region grows over the faces whose
/// stretch differs from the seed's by at most `threshold`. Returns a label for every face; 0 is what no region has
/// reached.
CGAL_SP_INLINE std::vector<int> grown_labels(const Segmentation_mesh& mesh, const std::vector<double>& face_stretch,
                                             double threshold)
{
  // Without smoothing almost every second vertex would be a seed.
  const std::vector<double> stretch = smoothed(mesh, stretch_of_vertices(mesh, face_stretch));
  std::vector<int> some_face(stretch.size(), -1);
  for(int f = 0; f < mesh.number_of_faces(); ++f)
    for(int v : mesh.face[f])
      some_face[v] = f;

  std::vector<int> label(mesh.face.size(), 0);
  std::vector<char> is_reached(stretch.size(), 0);
  int count = 0;
  for(int seed : seeds(mesh, stretch)) {
    const int first = some_face[seed];
    if(is_reached[seed] || label[first] > 0)
      continue;
    ++count;
    const auto take = [&](int f) {
      label[f] = count;
      for(int v : mesh.face[f])
        is_reached[v] = 1;
    };
    take(first);
    flood(mesh, first, [&](int f) {
      const bool takes = label[f] == 0 && std::abs(mean_of_corners(mesh, stretch, f) - stretch[seed]) <= threshold;
      if(takes)
        take(f);
      return takes;
    });
  }
  return label;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_REGION_GROWING_H
