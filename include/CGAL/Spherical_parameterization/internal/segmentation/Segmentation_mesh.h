// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_SEGMENTATION_MESH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_SEGMENTATION_MESH_H

#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/surface/Mapped_surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/neighbours.h>
#include <CGAL/Spherical_parameterization/internal/algebra/point_coordinates.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// What segmentation looks at: a mesh and its sphere as arrays, the mesh scaled to area 1 so that all lengths and areas
/// are dimensionless. Images are unit vectors.
struct Segmentation_mesh : Corner_table {
  Host_array<vec3> point, image;
  std::vector<double> face_area; ///< they sum up to 1
  Weighted_graph graph;          ///< the neighbours of the vertices, without weights

  /// \param source  read breadth-first
  /// Throws Error for a mesh without area, and for images that are not directions.
  Segmentation_mesh(Mapped_surface source, const Host_loop& loop)
    : face_area(source.face_area(loop).begin(), source.face_area(loop).end()), graph(neighbours(loop, source))
  {
    twin = source.twin(loop);
    face = std::move(source.face);
    point = std::move(source.point);
    image = std::move(source.image);
    for(std::size_t i = 0; i < image.size(); ++i) {
      const vec3 direction = scaled_to_unit_box(image[i]);
      const double length2 = inner(direction, direction);
      const auto fail = [&](Error_code code, const char* what) {
        throw Input_error(code, "the image of vertex " + std::to_string(source.position[i]) + what);
      };
      if(!std::isfinite(length2))
        fail(Error_code::NON_FINITE_COORDINATE, " on the sphere");
      if(!(length2 > 0))
        fail(Error_code::NOT_BIJECTIVE, " is the centre of the sphere; compute the map first");
      image[i] = unit(direction);
    }
    const double total = std::accumulate(face_area.begin(), face_area.end(), 0.);
    if(!(total > 0))
      throw Input_error(Error_code::DEGENERATE_FACE, "the mesh has no area");
    for(double& a : face_area)
      a /= total;
    for(vec3& p : point)
      p = scale(1 / std::sqrt(total), p);
  }

  int number_of_faces() const { return static_cast<int>(face.size()); }
  int number_of_vertices() const { return static_cast<int>(point.size()); }
  /// the face beyond the side (corner k, corner k+1)
  int across(int f, int k) const { return twin[3 * f + k] / 3; }
  vec3 side(int f, int k) const { return sub(point[face[f][(k + 1) % 3]], point[face[f][k]]); }
  double side_length(int f, int k) const { return norm(side(f, k)); }
  vec3 centroid(int f) const
  {
    return scale(1. / 3, add(add(point[face[f][0]], point[face[f][1]]), point[face[f][2]]));
  }
  template <class Visit>
  void for_each_neighbour(int v, const Visit& visit) const
  {
    for(int k = graph.offset[v]; k < graph.offset[v + 1]; ++k)
      visit(graph.target[k]);
  }
};

/// Spreads from face `first` to the faces beyond its sides that `takes(face)` takes, and on from these. Faces are asked
/// each time they are met: it is `takes` that has to remember which ones it has taken.
template <class Takes>
void flood(const Segmentation_mesh& mesh, int first, Takes takes)
{
  std::vector<int> front = {first};
  while(!front.empty()) {
    const int f = front.back();
    front.pop_back();
    for(int k = 0; k < 3; ++k)
      if(const int g = mesh.across(f, k); takes(g))
        front.push_back(g);
  }
}

/// The mean of the values at the corners of a face.
CGAL_SP_INLINE double mean_of_corners(const Segmentation_mesh& mesh, const std::vector<double>& value, int f)
{
  const auto [a, b, c] = mesh.face[f];
  return (value[a] + value[b] + value[c]) / 3;
}

/// The logarithmic area stretch of the vertices from that of the faces, log(source area / spherical area) of the star:
/// a mean of the reciprocal stretches, weighted with the source areas, so that a face that is much too small on the
/// sphere, or flipped, does not count.
CGAL_SP_INLINE std::vector<double> stretch_of_vertices(const Segmentation_mesh& mesh,
                                                       const std::vector<double>& face_stretch)
{
  const int n = mesh.number_of_vertices();
  std::vector<double> least(n, 1e300), sum(n, 0), area(n, 0);
  for(int f = 0; f < mesh.number_of_faces(); ++f)
    for(int v : mesh.face[f])
      least[v] = (std::min)(least[v], face_stretch[f]);
  for(int f = 0; f < mesh.number_of_faces(); ++f)
    for(int v : mesh.face[f]) {
      sum[v] += mesh.face_area[f] * std::exp(least[v] - face_stretch[f]);
      area[v] += mesh.face_area[f];
    }
  std::vector<double> stretch(n);
  for(int v = 0; v < n; ++v)
    stretch[v] = sum[v] > 0 ? least[v] - std::log(sum[v] / area[v]) : least[v];
  return stretch;
}

/// Damped Jacobi sweeps of a Laplacian with weights 1 / length: takes the noise of single triangles away.
CGAL_SP_INLINE std::vector<double> smoothed(const Segmentation_mesh& mesh, std::vector<double> value)
{
  constexpr int sweeps = 5;
  std::vector<double> next(value.size());
  for(int sweep = 0; sweep < sweeps; ++sweep) {
    for(int v = 0; v < mesh.number_of_vertices(); ++v) {
      double sum = 0, total = 0;
      mesh.for_each_neighbour(v, [&](int w) {
        const double weight = 1 / (std::max)(1e-9, norm(sub(mesh.point[v], mesh.point[w])));
        sum += weight * value[w];
        total += weight;
      });
      next[v] = value[v] / 2 + sum / (2 * total);
    }
    value.swap(next);
  }
  return value;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_SEGMENTATION_MESH_H
