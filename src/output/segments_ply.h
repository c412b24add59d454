// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_SEGMENTS_PLY_H
#define SPHERICAL_PARAMETERIZATION_TOOL_SEGMENTS_PLY_H

#include "input/mesh.h"

#include <cstddef>
#include <ostream>

namespace tool {

using Segment_map = Mesh::Property_map<Mesh::Face_index, std::size_t>;

/// Writes the mesh as PLY with the segment of every face, and faces coloured by it. Segment i has the same colour in
/// every file.
void write_segments_ply(std::ostream& out, const Mesh& mesh, Segment_map segments, std::size_t number_of_segments);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_SEGMENTS_PLY_H
