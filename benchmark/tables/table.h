// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef BENCHMARK_TABLE_H
#define BENCHMARK_TABLE_H

#include <filesystem>
#include <fstream>
#include <string>
#include <type_traits>
#include <vector>

namespace benchmark {

/// What stands in one place of a table: text, a number, or nothing.
class Cell {
public:
  Cell() = default;
  Cell(const char* text) : text_(text) {}
  Cell(std::string text) : text_(std::move(text)) {}
  Cell(double number); ///< to four digits; NaN: nothing
  template <class Integer, std::enable_if_t<std::is_integral_v<Integer>, int> = 0>
  Cell(Integer number) : text_(std::to_string(number))
  {}

  std::string markdown() const { return text_.empty() ? "-" : text_; }
  std::string csv() const; ///< quoted where it has to be

private:
  std::string text_;
};

/// Writes a table row by row to NAME.md and NAME.csv in a folder, and as Markdown to standard output. Both files say
/// first what it is and what machine it is from (in the CSV in lines that start with #). A run that is stopped leaves
/// the rows so far.
class Table {
public:
  /// Throws std::runtime_error if the files cannot be written.
  Table(const std::filesystem::path& folder, const std::string& name, const std::string& title,
        const std::vector<std::string>& notes, const std::vector<std::string>& columns);

  void add_row(const std::vector<Cell>& cells);

private:
  void print(const std::string& markdown);

  std::size_t width_;
  std::ofstream markdown_, csv_;
};

} // namespace benchmark

#endif // BENCHMARK_TABLE_H
