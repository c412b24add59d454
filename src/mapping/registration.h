// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_REGISTRATION_H
#define SPHERICAL_PARAMETERIZATION_TOOL_REGISTRATION_H

#include "input/mesh.h"

#include <string>
#include <vector>

namespace tool {

/// A mesh with other points, and its map.
struct Mapped_shape {
  const Mesh* mesh;
  const std::vector<Point>* points;
  const Sphere* sphere;
};

/// The map of `shape`, which was read from `file`, moved so that places that correspond have the same image as in the
/// map of `to`. On one core. Throws a `Refusal`.
Sphere registered_map(const std::string& file, const Mapped_shape& shape, const Mapped_shape& to);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_REGISTRATION_H
