// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_ANNOTATIONS_H
#define SPHERICAL_PARAMETERIZATION_TOOL_ANNOTATIONS_H

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace tool {

/// What neuroimaging files say beside the surface: of which hemisphere and subject it is, and how the volume lies from
/// which it was made. It is kept when a file of the same format is written, and the last, when one of the other is.
struct Annotations {
  using Metadata = std::vector<std::pair<std::string, std::string>>; ///< names and values

  Metadata gifti;                                           ///< of the file
  Metadata gifti_points;                                    ///< of the points
  std::vector<std::array<std::string, 3>> gifti_transforms; ///< of the points: from a space, to a space, matrix
  std::string freesurfer; ///< the bytes behind the triangles: the volume geometry and other tags
};

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_ANNOTATIONS_H
