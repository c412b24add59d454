// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEXTURE_COORDINATES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEXTURE_COORDINATES_H

#include <CGAL/Spherical_parameterization/internal/texture/least_harmful_poles.h>
#include <CGAL/Spherical_parameterization/internal/base/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/texture/texture_charts.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationTexture
/// @{

/// How the sphere is laid out in the plane.
enum class Texture_chart {
  /// u = longitude / 2 pi, v = 1/2 + latitude / pi, as for maps of the earth. Faces across the seam are continued past
  /// u = 1, so that textures repeat in u. Corners at a pole have the mean u of the two other corners.
  LATITUDE_LONGITUDE,
  /// The octahedral map to the unit square: areas differ by at most 5.2, nothing is torn at the poles. Faces across the
  /// sides of the square are continued past them, where a texture has to repeat turned by 180 degrees about the
  /// midpoint of the side (as a checker of an even number of squares does).
  OCTAHEDRAL
};

/// Where the chart is on the sphere; two directions that are not parallel. They need not be orthogonal or normalised.
struct Texture_axes {
  std::array<double, 3> north;    ///< to v = 1, or the centre of the octahedral square
  std::array<double, 3> meridian; ///< longitude 0
};

/// What `texture_coordinates()` is to do.
struct Texture_options {
  Texture_chart chart = Texture_chart::LATITUDE_LONGITUDE; ///< how the sphere is laid out in the plane
  /// Default: where the texture of latitude and longitude is least distorted, the south pole in a vertex, mostly in the
  /// tip of a limb.
  std::optional<Texture_axes> axes;
  /// Coordinates are multiples of 2^-bits, 1 to 52. With 23 they are floats, as viewers use, without further rounding.
  int bits = 52;
};

/// What `texture_coordinates()` had to do.
struct Texture_report {
  Texture_axes axes;          ///< where the chart is: those of the options, or those that were chosen
  std::size_t seam_faces = 0; ///< with a corner past the side of the square
  std::size_t pole_faces = 0; ///< round a pole, or with a corner there (latitude and longitude)
  /// Faces of which a corner was moved, since the plane triangle between the images of the corners would have been
  /// flipped or degenerate: those that are too small for the grid, and long ones along which the chart is curved.
  std::size_t moved_faces = 0;
  std::size_t unresolved_faces = 0; ///< of these the ones too small: moved by at most two cells of the grid
  double largest_move = 0;          ///< how far a corner was moved at most, in units of u and v
};

/// Texture coordinates for every corner of a valid map.
///
/// Guarantee: every face has a counter-clockwise uv triangle that is not degenerate, by an exact predicate on the
/// coordinates handed out; also for limbs that are smaller on the sphere than the coordinates resolve. This may open
/// seams between neighbouring faces: in limbs narrower than a cell of the grid, and along faces so long and thin that
/// the chart bends them by more than their width (`Texture_report` says how many and how far). u and v are in [0, 1],
/// for faces across the seam in [-1, 2].
///
/// \param mesh        a closed triangle mesh, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors; a valid map
/// \param uv_map      writable, key halfedge_descriptor, value constructible from two doubles: the corner of face(h) at
///                    target(h)
/// \param options     the chart, where it is on the sphere, and the grid of the coordinates
/// \param np          optional named parameters: `vertex_point_map`, for the choice of the poles
/// \return what had to be done
/// \throws std::invalid_argument if the map has flipped faces, the axes are parallel or not finite, or the bits make no
///         sense; before anything is written
///
/// Complexity: O(n log n); the logarithm is for the choice of the poles.
template <class TriangleMesh, class VertexSphereMap, class HalfedgeUVMap,
          class NamedParameters = parameters::Default_named_parameters>
Texture_report texture_coordinates(const TriangleMesh& mesh, VertexSphereMap sphere_map, HalfedgeUVMap uv_map,
                                   const Texture_options& options = Texture_options(),
                                   const NamedParameters& np = parameters::default_values());

namespace internal {

inline Frame frame_of(const Texture_axes& axes)
{
  const vec3 north = {axes.north[0], axes.north[1], axes.north[2]};
  const vec3 meridian = {axes.meridian[0], axes.meridian[1], axes.meridian[2]};
  const vec3 normal = outer(scaled_to_unit_box(north), scaled_to_unit_box(meridian));
  if(!is_finite(north) || !is_finite(meridian) || !(inner(normal, normal) > 1e-20))
    throw std::invalid_argument("the axes of the texture are parallel or no directions");
  const bool is_unit = std::abs(inner(north, north) - 1) <= 1e-15;
  return Frame(is_unit ? north : scaled_to_unit_box(north), scaled_to_unit_box(meridian));
}

/// Any meridian will do: that of the coordinate axis farthest from the pole.
inline Texture_axes axes_with_south_pole(vec3 south)
{
  const double x = std::abs(south.x), y = std::abs(south.y), z = std::abs(south.z);
  Texture_axes axes = {{-south.x, -south.y, -south.z}, {0, 0, 0}};
  axes.meridian[x <= y && x <= z ? 0 : y <= z ? 1 : 2] = 1;
  return axes;
}

template <class TriangleMesh, class VertexSphereMap, class HalfedgeUVMap, class Chart>
void put_texture_coordinates(const TriangleMesh& mesh, VertexSphereMap sphere_map, HalfedgeUVMap uv_map,
                             const Chart& chart, const Uv_grid& grid, Texture_report& report)
{
  typedef typename boost::property_traits<HalfedgeUVMap>::value_type UV;
  for(auto f : faces(mesh)) {
    const Charted_face face = chart(corners(mesh, sphere_map, f));
    report.seam_faces += face.is_at_seam;
    report.pole_faces += face.is_at_pole;
    Uv_triangle uv = grid.rounded(face.uv);
    if(!is_counterclockwise(uv)) {
      uv = grid.turned_over(face.uv, face.area);
      double move = 0;
      for(int k = 0; k < 3; ++k)
        move = (std::max)(move, distance(uv[k], face.uv[k]));
      ++report.moved_faces;
      report.unresolved_faces += move <= 2 * grid.cell();
      report.largest_move = (std::max)(report.largest_move, move);
      chart.into_range(uv);
    }
    auto h = halfedge(f, mesh);
    for(int k = 0; k < 3; ++k, h = next(h, mesh))
      put(uv_map, h, UV(uv[(k + 1) % 3].x, uv[(k + 1) % 3].y)); // corner 0 is the source of the first halfedge
  }
}

} // namespace internal

template <class TriangleMesh, class VertexSphereMap, class HalfedgeUVMap, class NamedParameters>
Texture_report texture_coordinates(const TriangleMesh& mesh, VertexSphereMap sphere_map, HalfedgeUVMap uv_map,
                                   const Texture_options& options, const NamedParameters& np)
{
  if(options.bits < 1 || options.bits > 52)
    throw std::invalid_argument("texture coordinates have 1 to 52 bits");
  if(const std::size_t flipped = number_of_flipped_faces(mesh, sphere_map); flipped > 0)
    throw std::invalid_argument("no texture coordinates: the map has " + std::to_string(flipped) + " flipped faces");

  Texture_report report;
  report.axes = options.axes ? *options.axes
                             : internal::axes_with_south_pole(internal::least_harmful_south_pole(
                                 mesh, internal::vertex_points(mesh, np), sphere_map));
  const internal::Frame frame = internal::frame_of(report.axes);
  const internal::Uv_grid grid(options.bits);
  if(options.chart == Texture_chart::LATITUDE_LONGITUDE)
    internal::put_texture_coordinates(mesh, sphere_map, uv_map, internal::Latitude_longitude_chart(frame), grid,
                                      report);
  else
    internal::put_texture_coordinates(mesh, sphere_map, uv_map, internal::Octahedral_chart(frame), grid, report);
  return report;
}

/// @}

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEXTURE_COORDINATES_H
