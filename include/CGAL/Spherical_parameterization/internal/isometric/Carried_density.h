// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_CARRIED_DENSITY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_CARRIED_DENSITY_H

#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/isometric/Progressive_mesh.h>
#include <CGAL/Spherical_parameterization/internal/surface/Corner_table.h>
#include <CGAL/Spherical_parameterization/internal/problem/Problem.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/Distortion.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The density of a progressive mesh: the area that a face is wanted to have on the sphere, per area in the source, in
/// units of its mean. To the solver a face of density d has the shape that it has, and d times its area.
///
/// The finest mesh has the densities of the problem. On coarser ones a vertex has the mean of the surface that it
/// stands for, by areas, and a face the mean of its corners. A uniform density is none.
class Carried_density {
public:
  explicit Carried_density(const Problem& problem)
  {
    const auto& given = problem.density;
    if(std::adjacent_find(given.begin(), given.end(), std::not_equal_to<>()) == given.end())
      return;
    const int number_of_faces = static_cast<int>(problem.face.size());
    Host_array<double> area(number_of_faces);
    double whole = 0;
    for(int f = 0; f < number_of_faces; ++f)
      whole += area[f] = norm(normal(problem.point, problem.face[f]));
    // so that every vertex has a mean: faces without area count, if only just
    const double least = whole > 0 ? negligible_share * whole / number_of_faces : 1;
    double wanted = 0;
    whole = 0;
    for(int f = 0; f < number_of_faces; ++f) {
      whole += area[f] = (std::max)(area[f], least);
      wanted += problem.density[f] * area[f];
    }
    const double mean = wanted / whole;
    of_face_.resize(number_of_faces);
    stands_for_.resize(problem.size(), {0, 0});
    before_.resize(problem.size());
    for(int f = 0; f < number_of_faces; ++f) {
      const double density = of_face_[f] = problem.density[f] / mean;
      for(int v : problem.face[f])
        stands_for_[v] = {stands_for_[v].area + area[f], stands_for_[v].wanted + density * area[f]};
    }
  }

  /// After the collapse of h.
  void collapse(const Progressive_mesh& mesh, int h)
  {
    if(!is_given())
      return;
    const int u = mesh.vertex(h), v = mesh.target(h);
    before_[u] = stands_for_[v];
    stands_for_[v] = {stands_for_[v].area + stands_for_[u].area, stands_for_[v].wanted + stands_for_[u].wanted};
  }

  /// After the collapse of h has been undone.
  void undo_collapse(const Progressive_mesh& mesh, int h)
  {
    if(is_given())
      stands_for_[mesh.target(h)] = before_[mesh.vertex(h)];
  }

  bool is_given() const { return !of_face_.empty(); }

  /// Gives the face at a corner the area that it is wanted to have, but no area below the least one that faces count
  /// with.
  void apply(const Progressive_mesh& mesh, int corner, double least_area, Face_metric& metric) const
  {
    if(is_given())
      metric.twice_area =
        (std::max)(at(mesh, corner) * metric.twice_area, (std::min)(metric.twice_area, 2 * least_area));
  }

private:
  struct Region {
    double area, wanted;
    double density() const { return wanted / area; }
  };

  static constexpr double negligible_share = 1e-12; ///< of the mean area of faces

  double at(const Progressive_mesh& mesh, int corner) const
  {
    if(mesh.number_of_vertices() == mesh.capacity())
      return of_face_[corner / 3];
    const auto of_vertex = [&](int v) { return stands_for_[v].density(); };
    return (of_vertex(mesh.vertex(corner)) + of_vertex(mesh.target(corner)) + of_vertex(mesh.apex(corner))) / 3;
  }

  Host_array<double> of_face_; ///< empty: no density is given
  std::vector<Region> stands_for_;
  std::vector<Region> before_; ///< of a vertex that was collapsed: what its target stood for
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_CARRIED_DENSITY_H
