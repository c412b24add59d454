// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_CONFORMAL_WEIGHTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_CONFORMAL_WEIGHTS_H

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationWeights
/// Cotangent weights of the intrinsic Delaunay triangulation of the surface; the default. The edges of the mesh are
/// flipped inside the surface until all of these weights are nonnegative: nothing has to be clamped, and the map is as
/// conformal as the mesh is fine. Faces may have any angles, or no area. A. Bobenko, B. Springborn, "A discrete
/// Laplace-Beltrami operator for simplicial surfaces", Discrete & Computational Geometry 38 (2007).
///
/// The map is a bijection of the intrinsic triangles. Where the faces of the mesh are far worse than these, a few of
/// them may come out flipped, or not conformal at all (ratio of the principal stretches above 3.7; spring exponent 2).
/// Their vertices, and as few others as possible, are moved to the minimum of the conformal energy MIPS, where none is
/// flipped (`Balanced` and `Saddle_point`). `Result::moved_vertices` counts them.
///
/// No property map, since the springs are not the edges of the mesh: `parameterize()` takes it in the place of one, and
/// `parameterize_triangle_soup()`, too. The points are those of the call. Programs that choose at run time give a
/// `std::variant<Conformal_weights, Map>`.
struct Conformal_weights {};

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_CONFORMAL_WEIGHTS_H
