// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_REGISTERED_SURFACE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_REGISTERED_SURFACE_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/predicates/orientation.h>
#include <CGAL/Spherical_parameterization/internal/surface/Corner_table.h>

#include <array>

namespace CGAL::Spherical_parameterization::internal {

/// A closed surface and its map.
struct Registered_surface : Corner_table {
  Host_array<vec3> point; ///< of a surface of area 4 pi
  Host_array<vec3> image; ///< unit vectors, without flips
};

/// The mean of what the corners of a face have.
inline vec3 mean_of_corners(const std::array<int, 3>& corner, const std::array<double, 3>& weight,
                            const Host_array<vec3>& of_vertex)
{
  vec3 mean = {0, 0, 0};
  for(int c = 0; c < 3; ++c)
    mean = add_scaled(mean, weight[c], of_vertex[corner[c]]);
  return mean;
}

/// A vertex of A, and where it should go on the sphere.
struct Registration_landmark {
  int vertex;
  vec3 place;

  bool is_in_place(const Host_array<vec3>& x) const { return is_equal(x[vertex], place); }
};

/// What is compared. The features are scaled by the roots of their weights.
struct Registration_features {
  int number = 0;
  Host_array<double> a, b; ///< feature after feature
};

/// Weights and limits of `refine()`.
struct Refinement {
  double landmark_weight; ///< of the mean squared distance of the landmarks
  double isometry_weight; ///< of the mean stretching of surface A onto surface B
  int iterations;
  double accuracy; ///< the share of the energy above 4 that an iteration has to gain for another one to follow
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_REGISTERED_SURFACE_H
