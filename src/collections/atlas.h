// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_ATLAS_H
#define SPHERICAL_PARAMETERIZATION_TOOL_ATLAS_H

#include "input/mesh.h"

#include <CGAL/Spherical_parameterization/shape_atlas.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace tool {

using SP::Atlas_mesh;

/// A mesh of an atlas, sampled at the directions.
struct Atlas_shape {
  std::string name; ///< of its outputs
  std::vector<Point> points;
};

/// Writes the statistics of shapes into a folder: `mean.ply`, `variance.ply`, `scores.csv`, and of every mode the mean
/// plus and minus two standard deviations, `modes/mode_K_plus.ply` and `_minus.ply`; and, as the last one,
/// `report.json`: `report`, to which they are added. Files of modes of an earlier run are removed. None of them gets
/// its name before all have been written. Returns what was found, in lines without the end of the last one.
std::string write_atlas(const std::string& folder, const Atlas_mesh& mesh, std::vector<Atlas_shape> shapes,
                        SP::Atlas_placement placement, int modes, bool ascii, nlohmann::ordered_json report);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_ATLAS_H
