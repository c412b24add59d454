// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_USAGE_H
#define SPHERICAL_PARAMETERIZATION_TOOL_USAGE_H

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CLI {
class App;
class FormatterBase;
class Option;
class ParseError;
} // namespace CLI

namespace tool {

/// What `--help` prints, in lines that fit a terminal: per option the kind of its value, its description and its
/// default. What excludes what, which CLI11 would say at every option, is for the descriptions.
std::shared_ptr<CLI::FormatterBase> help_formatter();

/// What is wrong with the command line that `app` has refused. An unknown command or option is named first, with the
/// known one that is most similar, since what is missing may only be misspelled; then arguments that nothing takes, in
/// the order in which they were typed; then what CLI11 says.
std::string usage_error(const CLI::App& app, const CLI::ParseError& error);

/// Throws a `CLI::ValidationError`, which is wrong usage, if the rule for an option is broken.
void require(bool condition, const std::string& option, const std::string& rule);

/// Throws at an option that names a file without one of the extensions, as in ".off, .ply". One of a compression may
/// follow.
void require_extension(const std::string& option, const std::string& file, const std::vector<std::string>& extensions);

/// An option that names a file.
CLI::Option* add_file_option(CLI::App& command, const std::string& name, std::string& file,
                             const std::string& description);

/// An option whose value is checked, and whose default --help says.
template <class App, class Value, class Check>
void add_checked_option(App& command, const std::string& name, Value& value, const std::string& description,
                        const Check& check)
{
  command.add_option(name, value, description)->check(check)->capture_default_str();
}

/// What --help says at the end: an example, and the exit codes. `done` is what 0 stands for, `not_done` what 1 does.
void add_footer(CLI::App& command, const std::string& example, const std::string& done = "the files were written",
                const std::string& not_done = "nothing was written (stderr says why)");

/// An option, and the file it names; empty if it was not given.
using File_option = std::pair<std::string, std::string>;

/// Throws if an output is the same file as an input or another output, or is there and no regular file: renaming a new
/// file over a device would remove the device.
void check_files(const std::vector<File_option>& inputs, const std::vector<File_option>& outputs);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_USAGE_H
