// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_ATLAS_H
#define SPHERICAL_PARAMETERIZATION_TOOL_ATLAS_H

#include "input/mesh.h"

#include <CGAL/Spherical_parameterization/shape_atlas.h>

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace tool {

using SP::Atlas_mesh;

/// A mesh of an atlas, sampled at the directions.
struct Atlas_shape {
  std::string name; ///< of its outputs
  std::vector<Point> points;
};

struct Written_atlas {
  std::string text; ///< what was found, in lines without the end of the last one
  std::size_t modes;
};

/// Writes the statistics of shapes to files: `mean.ply`, `variance.ply`, `scores.csv`, `quality.csv`, and of every mode
/// the mean plus and minus two standard deviations, `modes/mode_K_plus.ply` and `_minus.ply`; and `report.json`, the
/// first one: `report`, to which they are added.
Written_atlas write_atlas(const std::function<std::ostream&(const std::string&)>& open, const Atlas_mesh& mesh,
                          std::vector<Atlas_shape> shapes, SP::Atlas_placement placement, int modes, bool ascii,
                          nlohmann::ordered_json& report);

/// Removes the files of modes that an earlier run has left beyond so many.
void remove_other_modes(const std::string& folder, std::size_t modes);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_ATLAS_H
