// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "options/option.h"

#include <boost/algorithm/string/join.hpp>

#include <cstddef>
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

using boost::algorithm::join;

/// "; did you mean 'map'?", if one of the names is that similar to the word.
std::string suggestion(const std::string& word, const std::vector<std::string>& names);

/// Throws a `CLI::ValidationError`, which is wrong usage, if the rule for an option is broken.
void require(bool condition, const std::string& option, const std::string& rule);

/// Throws at an option that names a file without one of the extensions, as in ".off, .ply". One of a compression may
/// follow.
void require_extension(const std::string& option, const std::string& file, const std::vector<std::string>& extensions);

/// An option, and the file it names; empty if it was not given.
using File_option = std::pair<std::string, std::string>;

/// Throws if an output is the same file as an input or another output, or is there and no regular file: renaming a new
/// file over a device would remove the device.
void check_files(const std::vector<File_option>& inputs, const std::vector<File_option>& outputs);

/// Adds options to a command. They have to live as long as it does.
void add_options(CLI::App& command, const Options& options);

std::vector<const CLI::App*> commands_of(const CLI::App& app);

/// "-o", "--output"
std::vector<std::string> names_of(const CLI::Option* option);

/// What `--help` prints, in lines that fit a terminal: per option the kind of its value, its description and its
/// default. What excludes what, which CLI11 would say at every option, is for the descriptions.
std::shared_ptr<CLI::FormatterBase> help_formatter();

/// What is wrong with the command line that `app` has refused. An unknown command or option is named first, with the
/// known one that is most similar, since what is missing may only be misspelled; then arguments that nothing takes, in
/// the order in which they were typed; then what CLI11 says.
std::string usage_error(const CLI::App& app, const CLI::ParseError& error);

constexpr std::size_t line_length = 100; ///< of a terminal

/// Line breaks between words, so that no line is longer than `width` unless a word is.
std::string wrapped(const std::string& text, std::size_t width = line_length);

} // namespace tool
