// SPDX-License-Identifier: LGPL-3.0-or-later

#include "collections/database.h"

#include "input/files.h"
#include "system/refusal.h"

#include <filesystem>
#include <new>
#include <utility>

#include <sqlite3.h>

namespace tool {

Database::Database(const std::string& file, const Format& format, Access access)
  : file_(file), database_(nullptr, sqlite3_close)
{
  const bool writes = access == Access::WRITE;
  if(writes)
    lock_.emplace(file, Lock::Kind::FILE);
  else
    check_readable(file);
  sqlite3* database = nullptr;
  const std::string path =
    std::filesystem::absolute(file).string(); // names such as ":memory:" mean something to SQLite
  const int opened =
    sqlite3_open_v2(path.c_str(), &database, writes ? SQLITE_OPEN_READWRITE : SQLITE_OPEN_READONLY, nullptr);
  database_.reset(database);
  check(opened);
  constexpr int patience = 10000; // milliseconds, for others to end what they read or write
  sqlite3_busy_timeout(database, patience);

  const auto number = [this](const char* sql) {
    Rows rows = query(sql);
    return rows.next() ? rows.integer(0) : 0;
  };
  if(writes && number("PRAGMA application_id") == 0 && number("SELECT count(*) FROM sqlite_master") == 0) {
    const std::string id = std::to_string(format.id);
    const std::string create = std::string("BEGIN;") + format.schema + ";PRAGMA application_id=" + id + ";COMMIT";
    check(sqlite3_exec(database, create.c_str(), nullptr, nullptr, nullptr));
  }
  if(number("PRAGMA application_id") != format.id)
    refuse_file(file, std::string("is not ") + format.name + " of this version of the program",
                "choose another name, or remove it");
  if(writes) { // commits that need not wait for the disk: a power cut may lose the last ones, nothing else does
    run("PRAGMA journal_mode=WAL");
    run("PRAGMA synchronous=NORMAL");
    run("PRAGMA wal_autocheckpoint=10000"); // pages. Fewer waits for the disk; pages that are written often are written
                                            // once
  }
}

Database::~Database()
{
  if(lock_) {
    statements_.clear();                                              // or they would keep it open
    for(const char* sql : {"ROLLBACK", "PRAGMA journal_mode=DELETE"}) // then it is one file, that anybody can read
      sqlite3_exec(database_.get(), sql, nullptr, nullptr, nullptr);
  }
}

Database::Rows::Rows(const Database& database, const char* sql)
  : database_(database), kept_(database.statements_[sql]), statement_(std::move(kept_))
{
  if(statement_)
    return;
  sqlite3_stmt* statement = nullptr;
  database.check(sqlite3_prepare_v2(database.database_.get(), sql, -1, &statement, nullptr));
  statement_.reset(statement);
}

Database::Rows::~Rows()
{
  sqlite3_reset(statement_.get());
  sqlite3_clear_bindings(statement_.get());
  kept_ = std::move(statement_);
}

void Database::Finalize::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

int Database::Rows::bind(int i, std::int64_t value) { return sqlite3_bind_int64(statement_.get(), i, value); }

int Database::Rows::bind(int i, const std::string& text)
{
  return sqlite3_bind_text(statement_.get(), i, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT);
}

int Database::Rows::bind(int i, const Bytes& bytes)
{
  return sqlite3_bind_blob(statement_.get(), i, bytes.data, static_cast<int>(bytes.size), SQLITE_TRANSIENT);
}

bool Database::Rows::next()
{
  const int code = sqlite3_step(statement_.get());
  if(code != SQLITE_ROW)
    database_.check(code);
  return code == SQLITE_ROW;
}

std::int64_t Database::Rows::integer(int column) const { return sqlite3_column_int64(statement_.get(), column); }

std::string_view Database::Rows::bytes(int column) const
{
  const void* data = sqlite3_column_blob(statement_.get(), column);
  return {static_cast<const char*>(data), static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column))};
}

void Database::refuse_damaged(const std::string& what) const
{
  refuse_file(file_, "is damaged (" + what + ")", "remove it, and write it again");
}

void Database::check(int code) const
{
  const std::string what = database_ ? sqlite3_errmsg(database_.get()) : "";
  switch(code) {
  case SQLITE_OK:
  case SQLITE_DONE: return;
  case SQLITE_NOMEM: throw std::bad_alloc();
  case SQLITE_NOTADB: refuse_file(file_, "is no database", "choose another one");
  case SQLITE_CORRUPT:
  case SQLITE_ERROR: refuse_damaged(what); // as when a table is not there
  case SQLITE_BUSY: Lock::refuse(file_);
  default:
    throw Refusal(lock_ ? unwritable_file : unreadable_file, file_,
                  std::string("cannot be ") + (lock_ ? "written" : "read") + " (" + what + ")",
                  "check its permissions, those of its folder, and the space on the disk");
  }
}

} // namespace tool
