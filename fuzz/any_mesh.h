// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes from arbitrary bytes.

#ifndef FUZZ_ANY_MESH_H
#define FUZZ_ANY_MESH_H

#include "test/helpers/soup.h"
#include "Bytes.h"

namespace fuzz {

/// What closed meshes grow from: vertices 0 to 3, no points yet.
test::Mesh tetrahedron();

/// Closed triangle meshes of genus 0, two edges of which may have the same ends; less often meshes with holes, handles,
/// several components, polygons, isolated or non-manifold vertices, garbage. At most 100 vertices, no points yet.
test::Mesh any_mesh(Bytes& in);

/// Gives a mesh points: few or many different ones, tiny, huge, far away, on a line, in a plane, on a sphere, not
/// finite.
void put_any_points(Bytes& in, test::Mesh& mesh);

/// Whether every edge has ends of its own.
bool is_simplicial(const test::Mesh& mesh);

/// Whether all points are finite.
bool is_finite(const test::Mesh& mesh);

} // namespace fuzz

#endif // FUZZ_ANY_MESH_H
