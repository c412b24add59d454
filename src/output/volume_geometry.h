// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_VOLUME_GEOMETRY_H
#define SPHERICAL_PARAMETERIZATION_TOOL_VOLUME_GEOMETRY_H

#include "input/annotations.h"

#include <string>

namespace tool {

/// \name How the volume lies that a surface was made from
/// FreeSurfer says it in lines behind the triangles of its own files, and in GIFTI by entries "VolGeom..." of the
/// points. What a file has in the other form is not lost.
/// @{

/// The metadata of the points for a GIFTI file.
Annotations::Metadata gifti_points_with_geometry(const Annotations& annotations);

/// The bytes behind the triangles for a file of FreeSurfer.
std::string freesurfer_tags(const Annotations& annotations);
/// @}

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_VOLUME_GEOMETRY_H
