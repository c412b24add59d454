// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_VALUES_PROCRUSTES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_VALUES_PROCRUSTES_H

#include <CGAL/Spherical_parameterization/values/Rotation.h>

#include <array>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationStatistics
/// @{

/// What is removed before statistics of shapes: translations always, rotations and sizes as chosen.
struct Procrustes {
  bool rotate = true;      ///< rotate all shapes except the first one so that they are closest to their mean
  bool scale = false;      ///< scale all shapes to the root mean square of their sizes
  double accuracy = 1e-10; ///< stops where no rotation changes by more, in radians
  int iterations = 1000;   ///< at most
};

/// The motion of a shape: x becomes scale * rotation x + translation.
struct Similarity {
  double scale = 1;                                        ///< positive
  Rotation rotation = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; ///< of the scaled shape
  std::array<double, 3> translation = {0, 0, 0};           ///< comes last
};

/// The result of `align_shapes()`.
struct Procrustes_alignment {
  std::vector<Similarity> motions; ///< by shape
  double deviation = 0;            ///< root mean square distance from the mean, over vertices and shapes
  bool has_converged = true;       ///< whether the accuracy was reached
  int iterations = 0;              ///< of alternating mean and rotations
};

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_VALUES_PROCRUSTES_H
