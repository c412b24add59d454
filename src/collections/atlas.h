// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_ATLAS_H
#define SPHERICAL_PARAMETERIZATION_TOOL_ATLAS_H

#include "input/mesh.h"

#include <CGAL/Spherical_parameterization/values/Procrustes.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace tool {

/// How the shapes of an atlas are brought together in space.
enum class Placement {
  AS_THEY_STAND,
  CENTRED,   ///< centres at the origin
  RIGID,     ///< turned, too
  SIMILARITY ///< and of one size
};

/// Vertices and faces that all shapes of an atlas get, by the directions of the vertices.
struct Atlas_mesh {
  Mesh mesh;         ///< its points do not matter
  Sphere directions; ///< of the vertices
};

/// A mesh of an atlas, sampled at the directions.
struct Atlas_shape {
  std::string name; ///< of its outputs
  std::vector<Point> points;
};

/// Brings shapes together.
SP::Procrustes_alignment align(const Atlas_mesh& mesh, std::vector<std::vector<Point>>& shapes, Placement placement);

/// The mean of shapes that have been brought together.
std::vector<Point> mean_of(const std::vector<std::vector<Point>>& shapes);

/// Writes the statistics of shapes into a folder: `mean.ply`, `variance.ply`, `scores.csv`, and of every mode the mean
/// plus and minus two standard deviations, `modes/mode_K_plus.ply` and `_minus.ply`; and, as the last one,
/// `report.json`: `report`, to which they are added. Files of modes of an earlier run are removed. None of them gets
/// its name before all have been written. Returns what was found, in lines without the end of the last one.
std::string write_atlas(const std::string& folder, const Atlas_mesh& mesh, std::vector<Atlas_shape> shapes,
                        Placement placement, int modes, bool ascii, nlohmann::ordered_json report);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_ATLAS_H
