// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_TEXT_LINES_H
#define SPHERICAL_PARAMETERIZATION_TOOL_TEXT_LINES_H

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

namespace tool {

/// What a token says as a number. `NOT_FINITE` covers every spelling of NaN and infinity, and overflow.
enum class Number { FINITE, NOT_FINITE, NONE };
Number to_number(const std::string& token, double& value);

/// The integer a token spells, if it spells one.
std::optional<std::int64_t> to_integer(std::string_view token);

/// `token` in quotes, short and printable whatever bytes a broken file has there.
std::string in_quotes(std::string_view token);

/// Takes a line apart at white space.
class Tokens {
public:
  explicit Tokens(std::string_view line) : rest_(line) {}

  /// The next token; empty at the end.
  std::string_view next();

private:
  std::string_view rest_;
};

/// The lines of a text file, whatever they end with (LF, CR LF or CR).
class Text_lines {
public:
  explicit Text_lines(const std::string& file);

  /// Moves to the next line that is neither blank nor a comment (from '#' on); `false` at the end of the file.
  bool next();

  /// Appends the lines that follow as long as there is a backslash at the end.
  void join_continued();

  const std::string& text() const { return text_; }

  /// Appends the next three tokens, checked to be finite numbers, to `out`.
  /// `what` and `index` name their vertex in a refusal.
  void append_point(Tokens& tokens, const char* what, std::size_t index, std::string& out);

  /// Throws a `Refusal` that names this line.
  [[noreturn]] void refuse(const std::string& wrong, const std::string& remedy) const;

  /// Throws a `Refusal` because the file ends too early.
  [[noreturn]] void refuse_cut_short(const std::string& wrong) const;

private:
  bool read_line();

  std::string file_;
  std::ifstream in_;
  std::string text_;
  std::string token_;
  std::size_t number_ = 0;
};

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_TEXT_LINES_H
