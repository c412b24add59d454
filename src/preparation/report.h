// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_PREPARATION_REPORT_H
#define SPHERICAL_PARAMETERIZATION_TOOL_PREPARATION_REPORT_H

#include <CGAL/Spherical_parameterization/preparation/prepare.h>
#include <CGAL/Spherical_parameterization/preparation/surface_distance.h>

#include <nlohmann/json_fwd.hpp>

namespace tool {

/// What was wrong with a mesh, and what was done, for the reports of the tool and of Python.
nlohmann::ordered_json to_json(const CGAL::Spherical_parameterization::preparation::Preparation& preparation);
nlohmann::ordered_json to_json(const CGAL::Spherical_parameterization::preparation::Bounds& bounds);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_PREPARATION_REPORT_H
