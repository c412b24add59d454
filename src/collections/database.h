// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "collections/lock.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace tool {

/// A BLOB; NULL without data.
struct Bytes {
  const void* data = nullptr;
  std::size_t size = 0;
};

/// A database of SQLite in one file. What has been committed is there whenever the program ends, however it does. All
/// functions throw a `Refusal` that says what is wrong with the file.
class Database {
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  typedef std::unique_ptr<sqlite3_stmt, Finalize> Statement;

public:
  struct Format {
    std::int32_t id;    ///< PRAGMA application_id
    const char* name;   ///< for messages
    const char* schema; ///< SQL that makes the tables
  };

  enum class Access { READ, WRITE };

  /// To write: creates it where there is no file, and keeps other processes from writing until it is closed.
  Database(const std::string& file, const Format& format, Access access);

  /// What has not been committed is lost.
  ~Database();

  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  /// The rows of a statement, one at a time.
  class Rows {
  public:
    ~Rows();
    Rows(const Rows&) = delete;
    Rows& operator=(const Rows&) = delete;

    /// Whether there is one more. To be called before the first one, too.
    bool next();

    std::int64_t integer(int column) const;
    std::string text(int column) const { return std::string(bytes(column)); }
    std::string_view bytes(int column) const; ///< until next(); empty for NULL

  private:
    friend class Database;
    Rows(const Database& database, const char* sql);
    template <class... Values>
    Rows(const Database& database, const char* sql, const Values&... values) : Rows(database, sql)
    {
      int i = 0;
      (database.check(bind(++i, values)), ...);
    }
    int bind(int i, std::int64_t value);
    int bind(int i, const std::string& text);
    int bind(int i, const Bytes& bytes);

    const Database& database_;
    Statement& kept_; ///< where it is kept for the next time
    Statement statement_;
  };

  /// Prepares one statement of SQL, with the values for its question marks.
  template <class... Values>
  Rows query(const char* sql, const Values&... values) const
  {
    return Rows(*this, sql, values...);
  }

  /// Executes it.
  template <class... Values>
  void run(const char* sql, const Values&... values)
  {
    query(sql, values...).next();
  }

  /// What is read makes no sense.
  [[noreturn]] void refuse_damaged(const std::string& what) const;

private:
  void check(int code) const;

  std::string file_;
  std::optional<Lock> lock_; ///< of who writes. To be gone after the database
  std::unique_ptr<sqlite3, int (*)(sqlite3*)> database_;
  mutable std::map<std::string, Statement> statements_; ///< prepared, by their SQL. To be gone before the database
};

} // namespace tool
