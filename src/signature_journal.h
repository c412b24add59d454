// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_SIGNATURE_JOURNAL_H
#define SPHERICAL_PARAMETERIZATION_TOOL_SIGNATURE_JOURNAL_H

#include <map>
#include <string>

namespace tool {

/// What a batch has done so far, in a file next to its output: one line of the index after the other, in the order in
/// which they were finished. Whenever the program ends, however it does, a later one finds all lines but for one that
/// may be torn, which it drops. Only one program at a time can have it open.
class Signature_journal {
public:
  /// Opens or creates it. Throws a `Refusal`.
  explicit Signature_journal(const std::string& file);
  ~Signature_journal();

  Signature_journal(const Signature_journal&) = delete;
  Signature_journal& operator=(const Signature_journal&) = delete;

  /// The lines by the name of their mesh, without line break.
  const std::map<std::string, std::string>& lines() const { return lines_; }

  /// Hands a line over to the operating system. Throws a `Refusal` if the disk is full.
  void add(const std::string& name, const std::string& line);

  /// Removes the file: all of it is somewhere else.
  void remove();

  const std::string& file() const { return file_; }

private:
  [[noreturn]] void refuse(const std::string& wrong, const std::string& remedy) const;
  void read();
  void write(const std::string& text);

  std::string file_;
  int descriptor_;
  std::map<std::string, std::string> lines_;
};

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_SIGNATURE_JOURNAL_H
