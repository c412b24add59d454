// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "mapping/mapped_mesh.h"
#include "system/refusal.h"

#include <CGAL/Spherical_parameterization/distortion_summary.h>

#include <cstddef>
#include <optional>
#include <string>

namespace tool {

/// What a command did besides mapping.
struct Report {
  std::optional<SP::Distortion_summary> distortion; ///< of a map, if it was measured
  double seconds_measure = 0;                       ///< the distortion, or what the command is for
  double seconds_write = 0;
  double seconds_total = 0;
  std::optional<Refusal> refusal; ///< its log is too long for the JSON file
};

/// The most memory that the process has had so far.
std::size_t peak_memory_bytes();

/// What `--verbose` adds: the methods that were tried for a map, and the memory. Lines without the end of the last one.
std::string verbose_text(const SP::Result& result);

/// The report, for programs to read. What is not known is null: all of the map if there is none, and how it was made if
/// it was given (--sphere, `certify`). File names need not be valid
/// UTF-8, which has to be replaced in text.
Json report_json(const Mapping_options& options, const Mapped_mesh& input, const Report& report);

} // namespace tool
