// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SHAPE_FORM_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SHAPE_FORM_H

#include <CGAL/Spherical_parameterization/internal/api/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/signature/diffusion.h>
#include <CGAL/Spherical_parameterization/internal/signature/form_values.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>
#include <CGAL/Spherical_parameterization/shape_signature.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationSearch
/// @{

/// The form of a shape in the pose that it has: 112 numbers, compared by the L1 distance. It is independent of
/// position, size and orientation (including reflections). See `shape_form()`.
///
/// The numbers are nonnegative, and scaled such that dissimilar shapes differ by about 1 in each part:
/// -  0 ... 63: pairs of points, by 16 distances and 4 cosines of the angle of their normals
/// - 64 ... 111: points, by 12 distances from the centre and 4 cosines of the angle between normal and radius
struct Shape_form {
  static constexpr std::size_t size = internal::Form_sizes::all; ///< 112

  std::array<float, size> values{}; ///< the coordinates
};

/// The L1 distance of two forms. It is typically 2 between different shapes.
/// \param a  a form
/// \param b  another one
/// \return the sum of the absolute differences
inline double distance(const Shape_form& a, const Shape_form& b)
{
  double sum = 0;
  for(std::size_t i = 0; i < Shape_form::size; ++i)
    sum += std::abs(static_cast<double>(a.values[i]) - b.values[i]);
  return sum;
}

/// A shape descriptor for things that have one pose, such as furniture, tools and vessels, which differ less in girths
/// and limbs than in form. Two histograms of 1024 points that are spread evenly over the surface: of the distances of
/// pairs (R. Osada, T. Funkhouser, B. Chazelle, D. Dobkin, "Shape distributions", 2002) and the angles of their
/// normals, and of radii and the angles there.
///
/// The points follow the order of the faces, so that another order or triangulation changes the form by about 0.1.
///
/// \param mesh  closed triangle mesh of genus 0, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param np    optional named parameters: `vertex_point_map`, by default the mesh's own
/// \return the form
/// \throws Error  if the mesh is not closed, of genus 0, finite and of positive area
///
/// Complexity: linear, and half a million pairs of points (some 10 ms).
template <class TriangleMesh, class CGAL_NP_TEMPLATE_PARAMETERS>
Shape_form shape_form(const TriangleMesh& mesh, const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::Vertices<TriangleMesh> vertex;
  return Shape_form{internal::form_values(internal::read_surface(
    mesh, internal::vertex_points(mesh, np), internal::Reading::CHECKED, internal::Host_loop(), vertex))};
}

/// What is known of a shape that is searched, or searched for.
struct Shape_description {
  Shape_signature signature; ///< the same in any pose
  Shape_form form;           ///< in the pose of the mesh
};

/// The distance of two shapes by girths, limbs and form. Its unit is that of `distance()` of two signatures.
/// \param a  a shape
/// \param b  another one
/// \return a weighted sum of the distances of signatures and of forms
inline double distance(const Shape_description& a, const Shape_description& b)
{
  return distance(a.signature, b.signature) + internal::weight_of_forms * distance(a.form, b.form);
}

/// How relevant shapes are to the first one of them: by their distance, and by chains of similar shapes among them that
/// lead from one to the other. So shapes are found that differ from the first one, but less from those between.
/// D. Zhou, J. Weston, A. Gretton, O. Bousquet, B. Schölkopf, "Ranking on data manifolds", NIPS 2003; M. Donoser,
/// H. Bischof, "Diffusion processes for retrieval revisited", CVPR 2013. Every shape is a neighbour of its five nearest
/// ones, so that a class should have six members or more to gain from it.
/// \param shapes  random access range of `Shape_description`: the query, and the shapes to rank
/// \return for each of them a number from 0 (no chain leads there) to 1 (the query itself)
///
/// Complexity: that of the inverse of a dense matrix with a row for each shape (0.1 s for 500).
template <class DescriptionRange>
std::vector<double> relevance_of_shapes(const DescriptionRange& shapes)
{
  return internal::diffused_similarity(
    shapes.size(), [&shapes](std::size_t i, std::size_t j) { return distance(shapes[i], shapes[j]); });
}

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SHAPE_FORM_H
