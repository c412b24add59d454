// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <boost/algorithm/string/join.hpp>

#include <string>
#include <utility>
#include <vector>

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

} // namespace tool
