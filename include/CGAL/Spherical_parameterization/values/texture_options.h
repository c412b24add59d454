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

/// Charts of the sphere.
enum class Texture_chart {
  /// u = longitude / 2 pi, v = 1/2 + latitude / pi, as for maps of the earth. Faces across the seam extend beyond u =
  /// 1, so textures repeat in u. Corners at a pole get the mean u of the two other corners.
  LATITUDE_LONGITUDE,
  /// The octahedral map to the unit square: areas differ by a factor of at most 5.2, and there is no cut at the poles.
  /// Faces across a side of the square extend beyond it. There a texture must repeat, rotated by 180 degrees about the
  /// midpoint of the side (as a checker of an even number of squares does).
  OCTAHEDRAL
};

/// The axes of the chart: two directions that are not parallel. They need not be orthogonal or normalized.
struct Texture_axes {
  std::array<double, 3> north;    ///< mapped to v = 1, or to the centre of the square
  std::array<double, 3> meridian; ///< longitude 0
};

/// The options of `texture_coordinates()`.
struct Texture_options {
  Texture_chart chart = Texture_chart::LATITUDE_LONGITUDE; ///< the chart
  /// Default: the axes of the least distorted texture of latitude and longitude; the south pole is at a vertex, in most
  /// cases the tip of a limb.
  std::optional<Texture_axes> axes;
  /// Coordinates are multiples of 2^-bits, 1 to 52. With 23 they are floats, as viewers use, without further rounding.
  int bits = 52;
};

/// The report of `texture_coordinates()`.
struct Texture_report {
  Texture_axes axes;          ///< those of the options, or those that were chosen
  std::size_t seam_faces = 0; ///< with a corner beyond the side of the square
  std::size_t pole_faces = 0; ///< around a pole, or with a corner there (latitude and longitude)
  /// Faces with a moved corner. Without the move the plane triangle of the corners would be flipped or degenerate:
  /// these are faces too small for the grid, and long faces along which the chart is curved.
  std::size_t moved_faces = 0;
  std::size_t unresolved_faces = 0; ///< those that were too small: moved by at most two cells of the grid
  double largest_move = 0;          ///< largest move of a corner, in units of u and v
};

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_VALUES_TEXTURE_OPTIONS_H
