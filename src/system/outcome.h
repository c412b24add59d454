// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_OUTCOME_H
#define SPHERICAL_PARAMETERIZATION_TOOL_OUTCOME_H

#include "system/refusal.h"

#include <optional>
#include <string>

namespace tool {

/// What a command has to say of a mesh.
struct Outcome {
  std::optional<Refusal> refusal;
  std::string text; ///< of a mesh alone, before the refusal if there is one: lines, without the end of the last one
  std::string line; ///< of one among many, if it is not refused: does not name the mesh, and is the same in every run
};

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_OUTCOME_H
