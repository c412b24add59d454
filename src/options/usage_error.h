// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_USAGE_ERROR_H
#define SPHERICAL_PARAMETERIZATION_TOOL_USAGE_ERROR_H

#include <string>

namespace CLI {
class App;
class ParseError;
} // namespace CLI

namespace tool {

/// What is wrong with the command line that `app` has refused. An unknown command or option is named first, with the
/// known one that is most similar, since what is missing may only be misspelled; then arguments that nothing takes, in
/// the order in which they were typed; then what CLI11 says.
std::string usage_error(const CLI::App& app, const CLI::ParseError& error);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_USAGE_ERROR_H
