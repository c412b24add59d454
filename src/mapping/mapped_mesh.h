// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_MAPPED_MESH_H
#define SPHERICAL_PARAMETERIZATION_TOOL_MAPPED_MESH_H

#include "input/mesh.h"
#include "options/mapping_options.h"

#include <CGAL/Spherical_parameterization/Result.h>

#include <memory>
#include <optional>

namespace tool {

struct Map_settings;

/// The mesh that a command works on, and its certified spherical map. A command is
///
///     read_input(options, input);      // refuses what is not a triangulated sphere
///     Atomic_file file(output);        // refuses what cannot be written, before the work
///     map_input(options, input);       // refuses what has no certified map
///     ...
///
/// inside `guarded()`.
struct Mapped_mesh {
  const Mesh& mesh() const { return file->mesh; }

  std::optional<Input_mesh> file;                  ///< what has been read
  Sphere sphere;                                   ///< unit vectors
  CGAL::Spherical_parameterization::Result result; ///< of mapping; with --sphere nothing but sizes and certificate
  std::shared_ptr<Map_settings> settings;
  double seconds_read = 0; ///< reading and checking
};

/// Reads the mesh, and from here on watches for interruption. Throws a `Refusal`, and what `make_policy()` throws.
void read_input(const Mapping_options& options, Mapped_mesh& input);

/// What a command needs.
enum class Map_quality {
  CERTIFIED, ///< no flipped face, degree 1
  CONVERGED  ///< or flipped faces where limbs are too thin for doubles
};

/// Maps the mesh with a progress bar, or reads the sphere that the user has. Throws a `Refusal` if there is no such
/// map; then, too, `input.result` says what happened.
void map_input(const Mapping_options& options, Mapped_mesh& input, Map_quality quality = Map_quality::CERTIFIED);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_MAPPED_MESH_H
