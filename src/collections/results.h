// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "collections/database.h"
#include "collections/file_version.h"

#include <optional>
#include <string>

namespace tool {

/// What the tool and Python have computed of many meshes, in a file of SQLite: a row for each, by its name.
///
/// A row is that of a mesh file as it was, and of all that the result depends on besides: another version of the file,
/// or other settings, are computed again.
class Results {
public:
  struct Row {
    std::string status;  ///< "OK", or the code of an error
    std::string message; ///< in words
    std::string outputs; ///< the versions of the files that were written
    std::string value;   ///< what a function of Python has returned, as JSON; empty if it has not
  };

  /// Creates the file if it is not there. Throws a `Refusal`, as all that follows.
  explicit Results(const std::string& file) : database_(file, format, Database::Access::WRITE)
  {
    database_.run("PRAGMA synchronous=FULL"); // what is told to be done survives a power cut, too
  }

  /// None if it has to be computed.
  /// \param name      of the row
  /// \param mesh      the file
  /// \param settings  all else on which the result depends
  std::optional<Row> current(const std::string& name, const std::string& mesh, const std::string& settings)
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

  /// The settings of some row, empty if there is none.
  std::string some_settings() const
  {
    auto row = database_.query("SELECT settings FROM mesh LIMIT 1");
    return row.next() ? row.text(0) : "";
  }

  /// Writes a row. It is on the disk on return, but within `put_together()`.
  void put(const std::string& name, const std::string& mesh, const File_version& version, const std::string& settings,
           const Row& row)
  {
    database_.run("INSERT OR REPLACE INTO mesh VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?)", name, mesh, version.bytes,
                  version.changed, version.hash, settings, row.status, row.message, row.outputs, row.value);
  }

  /// Calls f, which puts rows: they are on the disk together on return, and none of them if f throws and this is
  /// destroyed then.
  template <class F>
  void put_together(F f)
  {
    database_.run("BEGIN");
    f();
    database_.run("COMMIT");
  }

private:
  static constexpr Database::Format format = {0x53504d55, "the results of many meshes", R"(
    CREATE TABLE mesh(name TEXT PRIMARY KEY, mesh TEXT NOT NULL,
      bytes INTEGER NOT NULL, changed INTEGER NOT NULL, hash TEXT NOT NULL, settings TEXT NOT NULL,
      status TEXT NOT NULL, message TEXT NOT NULL, outputs TEXT NOT NULL, value TEXT NOT NULL))"};

  Database database_;
};

} // namespace tool
