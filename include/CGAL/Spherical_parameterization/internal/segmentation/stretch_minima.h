// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_STRETCH_MINIMA_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_STRETCH_MINIMA_H

#include <CGAL/Spherical_parameterization/internal/segmentation/Segmentation_mesh.h>
#include <CGAL/Spherical_parameterization/internal/base/persistence.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The logarithmic area stretch of the vertices from that of the faces, log(source area / spherical area) of the star:
/// a mean of the reciprocal stretches, weighted with the source areas, so that a face that is much too small on the
/// sphere, or flipped, does not count.
inline std::vector<double> stretch_of_vertices(const Segmentation_mesh& mesh, const std::vector<double>& face_stretch)
{
  const int n = mesh.number_of_vertices();
  std::vector<double> least(n, 1e300), sum(n, 0), area(n, 0);
  for(int f = 0; f < mesh.number_of_faces(); ++f)
    for(int v : mesh.face[f])
      least[v] = (std::min)(least[v], face_stretch[f]);
  for(int f = 0; f < mesh.number_of_faces(); ++f)
    for(int v : mesh.face[f]) {
      sum[v] += mesh.area[f] * std::exp(least[v] - face_stretch[f]);
      area[v] += mesh.area[f];
    }
  std::vector<double> stretch(n);
  for(int v = 0; v < n; ++v)
    stretch[v] = sum[v] > 0 ? least[v] - std::log(sum[v] / area[v]) : least[v];
  return stretch;
}

/// Damped Jacobi sweeps of a Laplacian with weights 1 / length: takes the noise of single triangles away.
inline std::vector<double> smoothed(const Segmentation_mesh& mesh, std::vector<double> value, int sweeps)
{
  std::vector<double> next(value.size());
  for(int sweep = 0; sweep < sweeps; ++sweep) {
    for(int v = 0; v < mesh.number_of_vertices(); ++v) {
      double sum = 0, total = 0;
      for(int k = mesh.graph->offset[v]; k < mesh.graph->offset[v + 1]; ++k) {
        const int w = mesh.graph->target[k];
        const vec3 e = sub(mesh.point[v], mesh.point[w]);
        const double weight = 1 / (std::max)(1e-9, std::sqrt(inner(e, e)));
        sum += weight * value[w];
        total += weight;
      }
      next[v] = value[v] / 2 + sum / (2 * total);
    }
    value.swap(next);
  }
  return value;
}

/// The vertices that are minima of `value` with a persistence of at least `persistence`: the value has to rise that far
/// before one comes from them to a lower one. The lowest vertex is always one. In the order of their persistence.
inline std::vector<int> persistent_minima(const Segmentation_mesh& mesh, const std::vector<double>& value,
                                          double persistence)
{
  const auto for_each_neighbour = [&](int v, const auto& visit) {
    for(int k = mesh.graph->offset[v]; k < mesh.graph->offset[v + 1]; ++k)
      visit(mesh.graph->target[k]);
  };
  std::vector<int> vertices;
  for(const Basin& basin : basins(value, std::vector<double>(value.size(), 1), for_each_neighbour))
    if(vertices.empty() || basin.persistence >= persistence)
      vertices.push_back(basin.minimum);
  return vertices;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_STRETCH_MINIMA_H
