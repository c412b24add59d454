// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef BENCHMARK_DESCRIPTORS_H
#define BENCHMARK_DESCRIPTORS_H

#include "meshes/mesh.h"
#include "shapes/retrieval_measures.h"

#include <functional>
#include <string>
#include <vector>

namespace benchmark {

/// A way to describe a shape by numbers, to be compared by L1.
struct Descriptor {
  std::string name;
  bool needs_map;
  std::function<Descriptor_values(const Mesh&, Sphere_map)>
    compute;            ///< the map is a conformal one, or stands in for it
  bool is_slow = false; ///< seconds per mesh: left out where many meshes are made
};

/// The package's signature, its parts and its variants.
std::vector<Descriptor> own_descriptors();

/// What else there is: the paper's recipe, D2, SDF, and ShapeDNA where there is Spectra.
std::vector<Descriptor> other_descriptors();

/// The map that the descriptors are given: the conformal one, certified or not; where it does not converge, the
/// barycentric one if that is certified. Throws std::runtime_error where there is nothing to map. Returns "conformal",
/// "barycentric" or "uncertified".
const char* map_for_descriptors(Mesh& mesh, Sphere_map sphere);

} // namespace benchmark

#endif // BENCHMARK_DESCRIPTORS_H
