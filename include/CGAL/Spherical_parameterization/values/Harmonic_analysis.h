// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_VALUES_HARMONIC_ANALYSIS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_VALUES_HARMONIC_ANALYSIS_H

#include <CGAL/Spherical_parameterization/values/Harmonic_coefficients.h>
#include <CGAL/Spherical_parameterization/values/Rotation.h>

#include <array>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationHarmonics
/// @{

/// The weights of vertices in a fit by least squares.
enum class Vertex_weights {
  SPHERE_AREA,  ///< a third of the areas of its faces on the sphere: close to the mean over the sphere; fewest
                ///< iterations
  SURFACE_AREA, ///< the same of its faces in space: close to the mean over the surface
  EQUAL         ///< equal weights: least root mean square over the vertices
};

/// Analysis by weighted least squares: the coefficients minimize the weighted sum of the squared errors at the
/// vertices. If the data are harmonics of this degree, their coefficients are found, whatever the triangles are.
///
/// Uses conjugate gradients on the normal equations. Matrix and right-hand side are computed from the vertices once,
/// with a relative error of 1e-13, and applied by fast transforms: O(n) for n vertices, and O(L^3) per iteration for
/// degree L. The number of iterations depends on how uniformly the weights cover the sphere, and on the ratio of
/// vertices to coefficients: 5 to 15 iterations with sphere areas and a ratio of ten, hundreds with a ratio of two.
///
/// A. Bjorck, "Numerical Methods for Least Squares Problems", 1996, 7.4; H. Feichtinger, K. Groechenig, T. Strohmer,
/// "Efficient numerical methods in non-uniform sampling theory", Numer. Math. 69, 1995.
struct Least_squares {
  Vertex_weights weights = Vertex_weights::SPHERE_AREA; ///< how much each vertex counts
  double accuracy = 1e-10;                              ///< stops when the gradient has fallen by this factor
  int iterations = 500; ///< at most; `Harmonic_analysis::has_converged` says whether they were enough
};

/// Analysis by integrals: c(l, m) is the integral over the sphere of Y(l, m) times a field that is linear on every
/// face, that of `interpolate()`: in the direction of the point a u + b v + c w of the triangle of the images u, v, w
/// it is the same mean of the values at the vertices. This is the best least-squares approximation of the field over
/// the sphere.
///
/// Uses Gauss rules on every face. The number of points (and the division of large faces into four) is such that the
/// error of each coefficient is below `accuracy` times the mean absolute value of the field. Sums over the vertices,
/// weighted by areas, are no accurate quadrature: their error grows from degree sqrt(n) / 4 on.
struct Integration {
  double accuracy = 1e-11; ///< of the quadrature; at least 1e-15 is used, since rounding errors are larger
};

/// The result of `harmonic_analysis()`.
struct Harmonic_analysis {
  Harmonic_coefficients coefficients; ///< of the data
  bool has_converged = true; ///< whether the gradient of least squares, at these coefficients, is within the accuracy
  int iterations = 0;        ///< of least squares
};

/// The shape up to degree 1, an ellipsoid: the points centre + axes^T diag(radii) sphere_axes x for unit vectors
/// x.
struct First_order_ellipsoid {
  std::array<double, 3> centre; ///< mean over the sphere
  std::array<double, 3> radii;  ///< largest first; the last one is negative if the map mirrors the shape
  Rotation axes;                ///< rows: the directions of the half axes in space
  Rotation sphere_axes;         ///< rows: the directions on the sphere that are mapped there
};

/// The alignment of a shape g with another one, f: space g(sphere^-1 x) is most similar to f(x).
struct Shape_alignment {
  Rotation space;     ///< rotates the shape
  Rotation sphere;    ///< rotates its map
  double correlation; ///< of f and the moved g, from -1 to 1, with both centres (degree 0) at the origin
};

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_VALUES_HARMONIC_ANALYSIS_H
