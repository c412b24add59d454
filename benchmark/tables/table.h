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

  const std::string& text() const { return text_; }

private:
  std::string text_;
};

/// The fields of a line of comma-separated values (RFC 4180) without line breaks in them; none if a quote is left open.
std::vector<std::string> csv_fields(const std::string& line);

/// Writes a table row by row to NAME.md and NAME.csv in a folder, and as Markdown to standard output. Both files say
/// first what it is and what machine it is from (in the CSV in lines that start with #). A run that is stopped leaves
/// the rows so far.
class Table {
public:
  /// Throws std::runtime_error if the files cannot be written.
  Table(const std::filesystem::path& folder, const std::string& name, const std::string& title,
        const std::vector<std::string>& notes, std::vector<Cell> columns, const std::vector<Cell>& more_columns = {});

  /// Places that are left over at the end stay empty.
  void add_row(std::vector<Cell> cells, const std::vector<Cell>& more_cells = {});

private:
  void print(const std::string& markdown);

  std::size_t width_;
  std::ofstream markdown_, csv_;
};

/// A table of T. Athanasiadis and I. Fudos, "Parallel computation of spherical parameterizations for mesh analysis",
/// Computers & Graphics 35 (SMI 2011), section 4, from the folder published/. All rows of Tables 1 to 4 are there; the
/// models are often other versions than ours: the number of vertices tells. Left out are Figure 1 (CPU against GPU,
/// logarithmic) and Figure 2 (cache hit rates): they are diagrams without numbers.
class Published_table {
public:
  /// Throws std::runtime_error if there is no such file.
  explicit Published_table(int number);

  /// "paper: vertices" and so on
  std::vector<Cell> columns() const;
  /// The figures for a model of our own, or none: its name has to start with the paper's ("homer_lod_5002" with
  /// "homer"), and the number of vertices to be nearest, and at most twice or half as large.
  std::vector<Cell> figures(const std::string& model, const std::string& weights, std::size_t vertices) const;

private:
  std::vector<std::vector<std::string>> lines_; ///< the first one has the names
};

} // namespace benchmark

#endif // BENCHMARK_TABLE_H
