// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_JOURNAL_H
#define SPHERICAL_PARAMETERIZATION_TOOL_JOURNAL_H

#include <functional>
#include <map>
#include <optional>
#include <string>

namespace tool {

/// What a batch has done so far, in a file next to its output: one line of a table after the other, in the order in
/// which they were finished. Whenever the program ends, however it does, a later one finds all lines but for one that
/// may be torn, which it drops. Only one program at a time can have it open.
class Journal {
public:
  /// The name of what a line is about, if the line is complete.
  typedef std::function<std::optional<std::string>(const std::string& line)> Name_of;

  /// Opens or creates it. `header` is its first line. Throws a `Refusal`.
  Journal(const std::string& file, const std::string& header, const Name_of& name_of);
  ~Journal();

  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// The lines by name, without line break.
  const std::map<std::string, std::string>& lines() const { return lines_; }

  /// Hands a line over to the operating system. Throws a `Refusal` if the disk is full.
  void add(const std::string& name, const std::string& line);

  /// Removes the file: all of it is somewhere else.
  void remove();

  const std::string& file() const { return file_; }

private:
  [[noreturn]] void refuse(const std::string& wrong, const std::string& remedy) const;
  void read(const std::string& header, const Name_of& name_of);
  void write(const std::string& text);

  std::string file_;
  int descriptor_;
  std::map<std::string, std::string> lines_;
};

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_JOURNAL_H
