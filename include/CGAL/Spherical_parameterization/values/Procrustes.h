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

/// What is not shape, and is taken away before statistics: place always, the rest by choice.
struct Procrustes {
  bool rotate = true;      ///< turn the shapes, the first one excepted, to where they are closest to their mean
  bool scale = false;      ///< give all of them the same size, the root mean square of their sizes
  double accuracy = 1e-10; ///< stops where no rotation changes by more, in radians
  int iterations = 1000;   ///< at most
};

/// The motion of a shape: x becomes scale * rotation x + translation.
struct Similarity {
  double scale = 1;                                        ///< positive
  Rotation rotation = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; ///< of the scaled shape
  std::array<double, 3> translation = {0, 0, 0};           ///< comes last
};

/// What `align_shapes()` has done.
struct Procrustes_alignment {
  std::vector<Similarity> motions; ///< by shape
  double deviation = 0;            ///< root mean square distance from the mean, over vertices and shapes
  bool has_converged = true;       ///< whether the accuracy was reached in the iterations there were
  int iterations = 0;              ///< of rotations and mean by turns
};

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_VALUES_PROCRUSTES_H
