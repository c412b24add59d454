// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_VALUES_TEXTURE_OPTIONS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_VALUES_TEXTURE_OPTIONS_H

#include <array>
#include <cstddef>
#include <optional>

namespace CGAL::Spherical_parameterization {

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

/// Where the chart is on the sphere; two directions that are not parallel. They need not be orthogonal or normalized.
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

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_VALUES_TEXTURE_OPTIONS_H
