// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "collections/file_version.h"

#include "collections/database.h"
#include "input/files.h"
#include "system/refusal.h"

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/nil_generator.hpp>
#include <boost/uuid/uuid_io.hpp>

#include <sys/stat.h>

namespace tool {
namespace {

std::string content_hash(const std::string& file)
{
  try {
    const boost::uuids::name_generator_sha1 sha1(boost::uuids::nil_uuid());
    return to_string(sha1(read_file(file)));
  } catch(const Refusal&) {
    return "";
  }
}

} // namespace

File_version version_of(const std::string& file)
{
  struct stat status = {};
  if(stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode))
    return {};
  constexpr std::int64_t nano = 1000000000;
  return {status.st_size, status.st_ctim.tv_sec * nano + status.st_ctim.tv_nsec, ""};
}

File_version version_with_hash(const std::string& file)
{
  File_version version = version_of(file); // a change from here on makes it another one
  if(version.bytes >= 0)                   // a pipe has no end
    version.hash = content_hash(file);
  return version;
}

bool is_current(Database& database, const std::string& name, const std::string& file)
{
  auto row = database.query("SELECT bytes, changed, hash FROM mesh "
                            "WHERE name = ? AND status NOT IN ('OUT_OF_MEMORY', 'INTERRUPTED')",
                            name);
  const File_version now = version_of(file);
  if(!row.next() || row.integer(0) != now.bytes)
    return false;
  if(row.integer(1) == now.changed)
    return true;
  if(row.text(2) != content_hash(file))
    return false;
  database.run("UPDATE mesh SET changed = ? WHERE name = ?", now.changed, name);
  return true;
}

} // namespace tool
