// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_PREPARATION_SURFACE_DISTANCE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_PREPARATION_SURFACE_DISTANCE_H

#include <CGAL/Spherical_parameterization/Indexed_triangle_mesh.h>
#include <CGAL/Spherical_parameterization/preparation/glued_surface.h>

#include <functional>
#include <vector>

namespace CGAL::Spherical_parameterization::preparation {

/// \cond SKIP_IN_MANUAL
typedef Indexed_triangle_mesh Mesh;
typedef Mesh::Point Point;

/// Bounds of a number.
struct Bounds {
  double low = 0, high = 0;
};

/// The Hausdorff distances of a mesh as it was read and the repaired mesh.
struct Hausdorff_distance {
  Bounds from_new; ///< from points of the repaired mesh
  Bounds from_old; ///< from points of the mesh as it was read
};

/// Triangles are halved until bounds are `tolerance` apart, or 5 % of the distance where that is more: the distance
/// from a surface grows by no more than the way, and that from a face is largest at a corner (M. Tang, M. Lee, Y. J.
/// Kim, "Interactive Hausdorff distance computation for general polygonal models", 2009). The upper bound holds in any
/// case; where surfaces run along each other closer than `tolerance`, or thousands of faces lie across each other, the
/// work ends before the bounds are so close. Faces that are the same in both are at distance 0, and are not looked at.
/// `go_on` is called now and then, and may throw.
Hausdorff_distance hausdorff_distance(const Triangle_soup& old, const std::vector<Glued_surface>& parts,
                                      double tolerance, const std::function<void()>& go_on);

/// For each face of the mesh as it was read its face in `surface`. For removed faces the face nearest to the centre (or
/// one that is near, where thousands of faces lie across each other).
/// Faces without finite coordinates get face 0.
std::vector<int> nearest_faces(const Triangle_soup& old, const Glued_surface& surface);

/// For each point the nearest of those faces of `surface` that the mesh as it was read has, too (or one that is near,
/// as above). \pre there is one
std::vector<int> nearest_old_faces(const std::vector<Point>& points, const Glued_surface& surface);

/// The Hausdorff distance of two surfaces with the same faces, sampled at the vertices: the largest distance of a
/// vertex of one from the other surface. `points` and `others` are finite.
double hausdorff_distance_at_vertices(const Mesh& mesh, const std::vector<Point>& points,
                                      const std::vector<Point>& others);

/// The loss of a shape in a mesh that was sampled from it.
struct Sampling_loss {
  double bounding_box = 0; ///< relative loss of the side of the box that has lost most, in [0, 1]
  double distance = 0;     ///< from the shape to the samples, that 99 % of the area keep; of the diagonal of the box
};

/// Compares `mesh` with the same shape sampled at the vertices of `sampled`.
/// \param points  by vertex of `sampled`
Sampling_loss sampling_loss(const Mesh& mesh, const Mesh& sampled, const std::vector<Point>& points);
/// \endcond

} // namespace CGAL::Spherical_parameterization::preparation

#endif // CGAL_SPHERICAL_PARAMETERIZATION_PREPARATION_SURFACE_DISTANCE_H
