// SPDX-License-Identifier: LGPL-3.0-or-later

#include "collections/file_version.h"

#include "collections/database.h"
#include "input/mesh_readers.h"

#include <boost/algorithm/hex.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <sstream>

#include <sys/stat.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace tool {
namespace {

/// XXH128 in hexadecimal digits, as `xxhsum -H2` prints it, of the files one behind the other. It is as quick as
/// memory, and guards against edits, not against forgers.
std::string content_hash(const std::vector<std::string>& files)
{
  XXH3_state_t state;
  XXH3_128bits_reset(&state);
  std::array<char, 1 << 16> buffer;
  for(const std::string& file : files) {
    std::ifstream in(file, std::ios::binary);
    while(in.read(buffer.data(), buffer.size()) || in.gcount() > 0)
      XXH3_128bits_update(&state, buffer.data(), static_cast<std::size_t>(in.gcount()));
    if(!in.eof())
      return "";
  }
  XXH128_canonical_t bytes;
  XXH128_canonicalFromHash(&bytes, XXH3_128bits_digest(&state));
  std::string text;
  boost::algorithm::hex_lower(std::begin(bytes.digest), std::end(bytes.digest), std::back_inserter(text));
  return text;
}

/// Sums over the files, without the hash.
File_version version_without_hash(const std::vector<std::string>& files)
{
  std::uint64_t bytes = 0, changes = 0;
  for(const std::string& file : files) {
    struct stat status = {};
    if(stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode))
      return {};
#ifdef __APPLE__
    const timespec changed = status.st_ctimespec;
#else
    const timespec changed = status.st_ctim;
#endif
    constexpr std::uint64_t nano = 1000000000;
    bytes += static_cast<std::uint64_t>(status.st_size);
    changes += static_cast<std::uint64_t>(changed.tv_sec) * nano + static_cast<std::uint64_t>(changed.tv_nsec);
  }
  return {static_cast<std::int64_t>(bytes), static_cast<std::int64_t>(changes), ""};
}

} // namespace

File_version version_of(const std::string& file) { return version_without_hash(files_of_mesh(file)); }

File_version version_with_hash(const std::string& file)
{
  const std::vector<std::string> files = files_of_mesh(file);
  File_version version = version_without_hash(files); // a change from here on makes it another one
  if(version.bytes >= 0)                              // a pipe has no end
    version.hash = content_hash(files);
  return version;
}

const std::string& this_program()
{
  static const std::string program = SPHERICAL_PARAMETERIZATION_VERSION " " + content_hash({"/proc/self/exe"});
  return program;
}

std::string versions_of(const std::vector<std::string>& files)
{
  std::ostringstream text;
  for(const std::string& file : files) {
    const File_version version = version_with_hash(file);
    text << version.bytes << ' ' << version.changed << ' ' << std::quoted(version.hash) << '\n';
  }
  return text.str();
}

bool are_versions(const std::string& versions, const std::vector<std::string>& files)
{
  std::istringstream text(versions);
  return std::all_of(files.begin(), files.end(), [&text](const std::string& file) {
    const File_version now = version_of(file);
    File_version noted;
    return text >> noted.bytes >> noted.changed >> std::quoted(noted.hash) && now.bytes == noted.bytes &&
           (now.changed == noted.changed || version_with_hash(file).hash == noted.hash);
  });
}

bool is_current(Database& database, const std::string& name, const std::string& file)
{
  auto row = database.query(
    "SELECT bytes, changed, hash FROM mesh WHERE name = ? AND status NOT IN ('OUT_OF_MEMORY', 'MemoryError', "
    "'INTERRUPTED', 'INTERNAL_ERROR')",
    name);
  if(!row.next())
    return false;
  const std::vector<std::string> files = files_of_mesh(file);
  const File_version now = version_without_hash(files);
  if(row.integer(0) != now.bytes || row.text(2).empty()) // what could not be read then, or is another one every time
    return false;
  if(row.integer(1) == now.changed)
    return true;
  if(row.text(2) != content_hash(files))
    return false;
  database.run("UPDATE mesh SET changed = ? WHERE name = ?", now.changed, name);
  return true;
}

} // namespace tool
