// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_MANUAL_H
#define SPHERICAL_PARAMETERIZATION_TOOL_MANUAL_H

#include "runner/step.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace tool {

/// What is made from the steps when the program is built, and for the tests, if that is what the command line asks for:
/// the man page (of `make-man-page FRAME`), the completion in bash, the table of the manual, the list of the steps.
std::optional<std::string> manual(const CLI::App& app, const std::vector<Step>& all, int argc, char** argv);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_MANUAL_H
