// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_CONFORMAL_WEIGHTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_CONFORMAL_WEIGHTS_H

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationWeights
/// Cotangent weights of the intrinsic Delaunay triangulation of the surface; the default. Edges are flipped within the
/// surface until all these weights are nonnegative. So no angle has to be clamped, and the map is conformal up to
/// discretization. Faces may have any angles, and the area 0. A. Bobenko, B. Springborn, "A discrete Laplace-Beltrami
/// operator for simplicial surfaces", Discrete & Computational Geometry 38 (2007).
///
/// The map is a bijection of the intrinsic triangles. Some faces of the mesh that are much worse than these may be
/// flipped, or far from conformal (ratio of the principal stretches above 3.7; spring exponent 2). `Balanced` and
/// `Saddle_point` repair them: their vertices, and as few others as possible, are moved to the minimum of the conformal
/// energy MIPS, where no face is flipped. `Result::moved_vertices` counts them.
///
/// This is a tag, not a property map, since the intrinsic edges are not edges of the mesh. `parameterize()` and
/// `parameterize_triangle_soup()` accept it as `edge_weight_map`. Programs that choose weights at run time pass a
/// `std::variant<Conformal_weights, Map>`.
struct Conformal_weights {};

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_CONFORMAL_WEIGHTS_H
