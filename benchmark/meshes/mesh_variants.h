// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef BENCHMARK_MESH_VARIANTS_H
#define BENCHMARK_MESH_VARIANTS_H

#include "meshes/mesh.h"

#include <functional>
#include <string>
#include <vector>

namespace benchmark {

/// The same shape by other triangles, or nearly the same.
struct Mesh_variant {
  std::string name;
  std::function<Mesh(const Mesh&)> make;
};

/// Remeshed, decimated, subdivided, with noise.
std::vector<Mesh_variant> mesh_variants();

} // namespace benchmark

#endif // BENCHMARK_MESH_VARIANTS_H
