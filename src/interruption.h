// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_INTERRUPTION_H
#define SPHERICAL_PARAMETERIZATION_TOOL_INTERRUPTION_H

namespace tool {

/// From now on the first SIGINT or SIGTERM is only noted, so that work can end in good order. A second one kills.
void watch_for_interruption();

bool was_interrupted();

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_INTERRUPTION_H
