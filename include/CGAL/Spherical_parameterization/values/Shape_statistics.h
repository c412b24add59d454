// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_VALUES_SHAPE_STATISTICS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_VALUES_SHAPE_STATISTICS_H

#include <CGAL/Spherical_parameterization/values/Rotation.h>

#include <array>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationStatistics
/// @{

/// The vertices of a shape.
typedef std::vector<std::array<double, 3>> Shape_points;

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

/// Mean and principal components of a set of shapes: a point distribution model (T. F. Cootes, C. J. Taylor,
/// D. H. Cooper, J. Graham, "Active shape models: their training and application", 1995). Shape i is the mean plus the
/// sum over k of scores[i][k] times modes[k].
template <class Shape>
struct Shape_statistics {
  Shape mean;                              ///< of the shapes
  std::vector<Shape> modes;                ///< principal components: orthonormal, root mean square 1
  std::vector<double> variances;           ///< by mode, largest first: of its scores, with n - 1 for n shapes
  std::vector<std::vector<double>> scores; ///< by shape, then by mode
  double total_variance = 0;               ///< of all modes, including those not requested
};

/// The quality of a set of shapes as a model, for each number of modes, from 0 on: root mean square distances and
/// variances (R. H. Davies, "Learning shape: optimal models for analysing natural variability", 2002; M. Styner et al.,
/// "Evaluation of 3D correspondence methods for model building", 2003).
struct Model_quality {
  std::vector<double> compactness;       ///< the variance of this number of modes; of all modes the total variance
  std::vector<double> generalization;    ///< leave-out errors: see `left_out_errors()`
  std::vector<double> specificity;       ///< mean distance of a random shape of the model from the nearest in the set
  std::vector<double> specificity_error; ///< standard error of that mean
};

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_VALUES_SHAPE_STATISTICS_H
