// SPDX-License-Identifier: GPL-3.0-or-later
// Valid spherical maps from arbitrary bytes.

#ifndef FUZZ_ANY_MAP_H
#define FUZZ_ANY_MAP_H

#include "test/helpers/soup.h"
#include "Bytes.h"

namespace fuzz {

typedef test::Mesh::Property_map<test::Mesh::Vertex_index, test::Point> Sphere_map;

/// A closed mesh and its map: no flipped face, degree 1, unit vectors up to rounding. Its triangles may be as small and
/// as thin as doubles allow, and as large as a hemisphere. At most 80 vertices; without points.
test::Mesh any_valid_map(Bytes& in);

/// The map of a mesh from `any_valid_map()`.
Sphere_map sphere_of(const test::Mesh& mesh);

} // namespace fuzz

#endif // FUZZ_ANY_MAP_H
