// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "system/refusal.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tool {

std::string lower_case(std::string_view text);

/// What a token says as a number. `NOT_FINITE` covers every spelling of NaN and infinity, and overflow; the value is
/// then NaN or infinite.
enum class Number { FINITE, NOT_FINITE, NONE };
Number to_number(std::string_view token, double& value);
Number to_number(std::string_view token, float& value);

/// The integer a token spells, if it spells one.
std::optional<std::int64_t> to_integer(std::string_view token);

/// `token` in quotes, short and printable whatever bytes a broken file has there.
std::string in_quotes(std::string_view token);

/// The text in which bytes are written as %20.
std::string percent_decoded(std::string_view text);

/// Takes the next token, which ends at white space, off the text; empty at the end.
std::string_view next_token(std::string_view& text);

/// Without the mark that Windows editors put before UTF-8.
std::string_view without_mark(std::string_view text);

/// Takes the next number off the text. Throws a `Refusal` if there is none, or something else.
double next_number(const std::string& file, std::string_view& text);

/// The lines of a text file, whatever they end with (LF, CR LF or CR).
class Text_lines {
public:
  /// `file` is the name, for refusals.
  Text_lines(const std::string& file, std::string text);
  Text_lines(const Text_lines&) = delete;
  Text_lines& operator=(const Text_lines&) = delete;

  /// Moves to the next line that is neither blank nor a comment (from '#' on); `false` at the end of the file.
  bool next();

  /// Appends the lines that follow as long as there is a backslash at the end.
  void join_continued();

  std::string_view line() const { return line_; }
  std::size_t number_of_bytes() const { return text_.size(); }

  /// The lines that follow.
  std::string_view rest() const { return std::string_view(text_).substr(end_); }

  /// The next token of the line; empty at its end.
  std::string_view token() { return next_token(tokens_); }

  /// The next three tokens, checked to be numbers. `what` and `index` name their vertex in a refusal. The first
  /// coordinate that is not finite is noted.
  std::array<double, 3> point(const char* what, std::size_t index, std::optional<Refusal>& non_finite);

  /// Throws a `Refusal` that names this line.
  [[noreturn]] void refuse(const std::string& wrong, const std::string& remedy) const;

  /// Throws a `Refusal` because the file ends too early.
  [[noreturn]] void refuse_cut_short(const std::string& wrong) const;

private:
  std::string_view next_line();

  std::string file_;
  std::string text_;
  std::size_t end_;         ///< of what has been read
  std::string_view line_;   ///< without its end and its comment
  std::string_view tokens_; ///< of the line, as far as they have not been read
  std::size_t number_ = 0;
};

} // namespace tool
