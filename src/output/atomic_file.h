// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <cstddef>
#include <fstream>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

namespace tool {

/// An output file that is there complete or not at all: it gets its name only when everything has been written.
class Atomic_file {
public:
  /// Opens a temporary file next to `file`, or throws a `Refusal`. What is written is compressed if the last extension
  /// of `file` says so. The standard output, "-", is a file, too: it gets all or nothing.
  explicit Atomic_file(const std::string& file);

  /// Removes what has not been committed.
  ~Atomic_file();

  Atomic_file(const Atomic_file&) = delete;
  Atomic_file& operator=(const Atomic_file&) = delete;

  std::ostream& stream() { return compressed_ ? *compressed_ : out_; }

  /// Creates a folder for such files, with those above it, if it is not there. Throws a `Refusal`.
  static void create_folder(const std::string& folder);

  /// Removes what a process that was killed has left in a folder and its subfolders: temporary files of `files`, which
  /// no other process writes.
  static void remove_leftovers(const std::string& folder, const std::vector<std::string>& files);

  /// Closes it when all has been written, and waits until it is on the disk. Throws a `Refusal` if that fails.
  void complete();

  /// Gives the file its name, once it is complete. Throws a `Refusal`.
  void rename();

private:
  void open();
  void remove();
  [[noreturn]] void refuse(const std::string& wrong) const;

  std::string file_;
  std::string temporary_;
  std::ofstream out_;
  std::unique_ptr<std::ostream> compressed_; ///< before `out_`; may be null
};

/// The files of a command: none gets its name before all of them have been written.
class Atomic_files {
public:
  /// One more file. Throws a `Refusal`, as all that follows.
  std::ostream& open(const std::string& file);

  /// Closes the files that are open: all of them have been written. For those who write more files than a process may
  /// have open.
  void complete();

  /// Gives the files their names, that of the first one last.
  void commit();

  /// The same, if the program, which works on `input`, has not been interrupted.
  void commit(const std::string& input);

private:
  std::vector<std::unique_ptr<Atomic_file>> files_;
  std::size_t completed_ = 0; ///< how many of them are closed
};

} // namespace tool
