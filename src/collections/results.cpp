// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "collections/results.h"

namespace tool {

std::optional<Results::Row> Results::current(const std::string& name, const std::string& mesh,
                                             const std::string& settings)
{
  if(!is_current(database_, name, mesh))
    return std::nullopt;
  auto row = database_.query("SELECT status, message, outputs, value FROM mesh "
                             "WHERE name = ? AND mesh = ? AND settings = ?",
                             name, mesh, settings);
  if(!row.next())
    return std::nullopt;
  return Row{row.text(0), row.text(1), row.text(2), row.text(3)};
}

bool Results::has(const std::string& name) const
{
  return database_.query("SELECT 1 FROM mesh WHERE name = ?", name).next();
}

std::string Results::some_settings() const
{
  auto row = database_.query("SELECT settings FROM mesh LIMIT 1");
  return row.next() ? row.text(0) : "";
}

void Results::put(const std::string& name, const std::string& mesh, const File_version& version,
                  const std::string& settings, const Row& row)
{
  database_.run("INSERT OR REPLACE INTO mesh VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?)", name, mesh, version.bytes,
                version.changed, version.hash, settings, row.status, row.message, row.outputs, row.value);
}

} // namespace tool
