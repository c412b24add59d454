// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tool {

class Database;

/// What an edited file differs in. Those that it names, as a .gltf does, belong to it: sizes and times are sums.
struct File_version {
  std::int64_t bytes = -1;   ///< -1: it is not there, or no regular file
  std::int64_t changed = -1; ///< when, in nanoseconds; permissions are a change, too
  std::string hash;          ///< of the contents; empty if they cannot be read
};

/// Of the file as it is now, without the hash. Of files only a .gltf or .glb is read.
File_version version_of(const std::string& file);

/// With the hash. The file may change meanwhile: then it has another version afterwards.
File_version version_with_hash(const std::string& file);

/// The version of the program, and a hash of its file: another build of the same version may give other results.
const std::string& this_program();

/// Sizes, times of change and hashes of files, a line each.
std::string versions_of(const std::vector<std::string>& files);

/// Whether the files are what their versions say: of the same sizes, and not changed since, or of the same contents.
bool are_versions(const std::string& versions, const std::vector<std::string>& files);

/// Whether the row `name` of the table `mesh` is about the file as it is now: its size and time of change are those of
/// the columns `bytes` and `changed`; or its contents that of `hash`, and then the time in the row is set. Rows of what
/// may succeed another time, as for want of memory or time, are not current.
bool is_current(Database& database, const std::string& name, const std::string& file);

} // namespace tool
