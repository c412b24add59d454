// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_VALUES_HARMONICS_METHODS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_VALUES_HARMONICS_METHODS_H

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationHarmonics
/// @{

/// How much each vertex counts in a fit by least squares.
enum class Vertex_weights {
  SPHERE_AREA,  ///< a third of the areas of its faces on the sphere: close to the mean over the sphere; fewest
                ///< iterations
  SURFACE_AREA, ///< the same of its faces in space: close to the mean over the surface
  EQUAL         ///< all alike: least root mean square over the vertices
};

/// Analysis by weighted least squares: the coefficients for which the weighted sum of the squares of the errors at the
/// vertices is least. Where the data are harmonics of this degree it finds them, whatever the triangles.
///
/// Conjugate gradients on the normal equations. Their matrix and right-hand side are taken from the vertices once, with
/// a relative error of 1e-13, and applied by fast transforms: O(n) for n vertices, and O(L^3) per iteration for degree
/// L. The number of iterations depends on how evenly the weights cover the sphere, and on how many more vertices there
/// are than coefficients: 5 to 15 with sphere areas and ten times as many, hundreds with twice as many.
///
/// A. Bjorck, "Numerical Methods for Least Squares Problems", 1996, 7.4; H. Feichtinger, K. Groechenig, T. Strohmer,
/// "Efficient numerical methods in non-uniform sampling theory", Numer. Math. 69, 1995.
struct Least_squares {
  Vertex_weights weights = Vertex_weights::SPHERE_AREA; ///< how much each vertex counts
  double accuracy = 1e-10;                              ///< stops where the gradient is this part of that at 0
  int iterations = 500; ///< at most; `Harmonic_analysis::has_converged` says whether they were enough
};

/// Analysis by integrals: c(l, m) is the integral over the sphere of Y(l, m) times the field that is linear on every
/// face, as `interpolate()` has it: at the direction of the point a u + b v + c w of the triangle of the images u, v, w
/// it is the same mean of the values at the vertices. For orthonormal functions that is the best approximation of this
/// field in the mean over the sphere.
///
/// Gauss rules on every face, with so many points (faces that are too large are cut into four) that the error of each
/// coefficient is below `accuracy` times the field's mean absolute value. Lumping the areas of faces at vertices
/// instead is no quadrature: its error grows from degree sqrt(n) / 4 on.
struct Integration {
  double accuracy = 1e-11; ///< of the quadrature
};

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_VALUES_HARMONICS_METHODS_H
