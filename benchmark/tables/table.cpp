// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "tables/table.h"

#include "measure/measure.h"
#include "output/text_writer.h"

#include <CGAL/assertions.h>

#include <cctype>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <stdexcept>
#include <utility>

namespace benchmark {

Cell::Cell(double number)
{
  if(std::isnan(number))
    return;
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, std::abs(number) >= 1e3 && std::abs(number) < 1e9 ? "%.0f" : "%.4g", number);
  text_ = buffer;
}

Table::Table(const std::filesystem::path& folder, const std::string& name, const std::string& title,
             const std::vector<std::string>& notes, std::vector<Cell> columns, const std::vector<Cell>& more_columns)
  : width_(columns.size() + more_columns.size())
{
  std::error_code error;
  create_directories(folder, error);
  markdown_.open(folder / (name + ".md"));
  csv_.open(folder / (name + ".csv"));
  if(!markdown_ || !csv_)
    throw std::runtime_error(folder.string() + ": cannot write " + name + ".md and " + name + ".csv there");

  print("# " + title + "\n\n");
  csv_ << "# " << title << '\n';
  for(const auto& lines : {machine_description(), notes}) {
    for(const std::string& line : lines) {
      print("- " + line + '\n');
      csv_ << "# " << line << '\n';
    }
    print("\n");
  }
  add_row(std::move(columns), more_columns);
  for(std::size_t i = 0; i < width_; ++i)
    print("|---");
  print("|\n");
}

void Table::add_row(std::vector<Cell> cells, const std::vector<Cell>& more_cells)
{
  cells.insert(cells.end(), more_cells.begin(), more_cells.end());
  CGAL_assertion(cells.size() <= width_);
  cells.resize(width_);
  std::string line;
  for(const Cell& cell : cells) {
    line += "| " + (cell.text().empty() ? "-" : cell.text()) + ' ';
    csv_ << (&cell == &cells.front() ? "" : ",") << tool::csv_quoted(cell.text());
  }
  csv_ << std::endl;
  print(line + "|\n");
}

void Table::print(const std::string& markdown)
{
  markdown_ << markdown << std::flush;
  std::cout << markdown << std::flush;
}

std::vector<std::string> csv_fields(const std::string& line)
{
  std::vector<std::string> result(1);
  bool is_quoted = false;
  for(std::size_t i = 0; i < line.size(); ++i) {
    if(line[i] == '"' && is_quoted && i + 1 < line.size() && line[i + 1] == '"')
      result.back() += line[i++];
    else if(line[i] == '"')
      is_quoted = !is_quoted;
    else if(line[i] == ',' && !is_quoted)
      result.emplace_back();
    else
      result.back() += line[i];
  }
  return is_quoted ? std::vector<std::string>() : result;
}

Published_table::Published_table(int number)
{
  const std::string file = BENCHMARK_SOURCE_DIR "/published/table_" + std::to_string(number) + ".csv";
  std::ifstream in(file);
  for(std::string line; std::getline(in, line);)
    if(!line.empty() && line.front() != '#')
      lines_.push_back(csv_fields(line));
  if(lines_.empty())
    throw std::runtime_error(file + ": cannot be read");
}

std::vector<Cell> Published_table::columns() const
{
  std::vector<Cell> columns;
  for(std::size_t i = 2; i < lines_.front().size(); ++i) // after model and weights
    columns.emplace_back("paper: " + lines_.front()[i]);
  return columns;
}

std::vector<Cell> Published_table::figures(const std::string& model, const std::string& weights,
                                           std::size_t vertices) const
{
  std::string letters;
  for(unsigned char c : model)
    if(std::isalpha(c))
      letters += static_cast<char>(std::tolower(c));
  std::vector<Cell> best;
  double smallest_distance = std::log(2.);
  for(const std::vector<std::string>& line : lines_) {
    if(line[1] != weights || letters.rfind(line[0], 0) != 0)
      continue;
    const double distance = std::abs(std::log(std::stod(line[2]) / double(vertices)));
    if(distance > smallest_distance)
      continue;
    smallest_distance = distance;
    best.clear();
    for(std::size_t i = 2; i < line.size(); ++i)
      best.emplace_back(std::stod(line[i]));
  }
  return best;
}

} // namespace benchmark
