// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_ATOMIC_FILE_H
#define SPHERICAL_PARAMETERIZATION_TOOL_ATOMIC_FILE_H

#include <fstream>
#include <functional>
#include <ostream>
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

  /// Removes what a process that was killed has left in a folder and its subfolders: temporary files of those files
  /// that `is_ours` says no other process writes.
  static void remove_leftovers(const std::string& folder, const std::function<bool(const std::string&)>& is_ours);

  /// Gives the file its name, or throws a `Refusal` if not all of it could be written.
  void commit();

  /// The same for files that belong together, those that are null left out: none gets its name before all of them have
  /// been written.
  static void commit_all(const std::vector<Atomic_file*>& files);

private:
  void remove();
  void complete();
  void rename();
  [[noreturn]] void refuse(const std::string& wrong) const;

  std::string file_;
  std::string temporary_;
  std::ofstream out_;
  std::unique_ptr<std::ostream> compressed_; ///< before `out_`; may be null
};

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_ATOMIC_FILE_H
