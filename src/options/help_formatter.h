// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_HELP_FORMATTER_H
#define SPHERICAL_PARAMETERIZATION_TOOL_HELP_FORMATTER_H

#include <CLI/CLI.hpp>

#include <string>

namespace tool {

/// What `--help` prints, in lines that fit a terminal: per option the kind of its value, its description and its
/// default. What excludes what, which CLI11 would say at every option, is for the descriptions.
class Help_formatter : public CLI::Formatter {
public:
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_option_desc(const CLI::Option* option) const override;
};

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_HELP_FORMATTER_H
