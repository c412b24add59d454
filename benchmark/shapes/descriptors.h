// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef BENCHMARK_DESCRIPTORS_H
#define BENCHMARK_DESCRIPTORS_H

#include "meshes/mesh.h"

#include <functional>
#include <string>
#include <vector>

namespace benchmark {

typedef std::vector<double> Descriptor_values;

/// A way to describe a shape by numbers, to be compared by L1.
struct Descriptor {
  std::string name;
  bool needs_map;
  std::function<Descriptor_values(const Mesh&, Sphere_map)>
    compute;            ///< the map is a conformal one, or stands in for it
  bool is_slow = false; ///< seconds per mesh: left out where many meshes are made
  /// In place of `compute`: from the values of the descriptor before.
  std::function<Descriptor_values(const Descriptor_values&)> derive = {};
};

/// The package's signature, its parts and its variants, and the paper's recipe.
std::vector<Descriptor> own_descriptors();

/// What else there is: D2, SDF, and ShapeDNA where there is Spectra.
std::vector<Descriptor> other_descriptors();

/// The smallest 30 eigenvalues of the Laplacian that are not 0, scaled to area 4 pi and over their number, to which
/// they are proportional by Weyl's law: M. Reuter, F.-E. Wolter, N. Peinecke, "Laplace-Beltrami spectra as 'Shape-DNA'
/// of surfaces and solids", CAD 38 (2006). On the intrinsic Delaunay triangulation, like the package's signature.
/// Where there is Spectra.
Descriptor_values shape_dna(const Mesh& mesh, Sphere_map);

} // namespace benchmark

#endif // BENCHMARK_DESCRIPTORS_H
