// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "input/mesh_readers.h"

#include <CGAL/Spherical_parameterization/preparation/prepare.h>
#include <CGAL/Spherical_parameterization/preparation/surface_distance.h>

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace tool {

using namespace CGAL::Spherical_parameterization::preparation;

using Json = nlohmann::ordered_json; ///< of reports, in which the order is kept

/// Mends a mesh; `file` is what it was read from. Throws a `Refusal` if it has no face that can be used, and at an
/// interruption.
Preparation prepare(const std::string& file, const Soup& soup, const Preparation_settings& settings);

/// What was wrong with a mesh, and what was done, for the reports of the tool and of Python.
Json to_json(const Preparation& preparation);
Json to_json(const Bounds& bounds);

/// The value, or null.
Json known(bool is_known, const Json& value);

} // namespace tool
