// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "tables/table.h"

#include "measure/machine.h"
#include "output/csv.h"

#include <CGAL/assertions.h>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <stdexcept>

namespace benchmark {

Cell::Cell(double number)
{
  if(std::isnan(number))
    return;
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, std::abs(number) >= 1e3 && std::abs(number) < 1e9 ? "%.0f" : "%.4g", number);
  text_ = buffer;
}

std::string Cell::csv() const { return tool::csv_quoted(text_); }

Table::Table(const std::filesystem::path& folder, const std::string& name, const std::string& title,
             const std::vector<std::string>& notes, const std::vector<std::string>& columns)
  : width_(columns.size())
{
  std::error_code error;
  create_directories(folder, error);
  markdown_.open(folder / (name + ".md"));
  csv_.open(folder / (name + ".csv"));
  if(!markdown_ || !csv_)
    throw std::runtime_error(folder.string() + ": cannot write " + name + ".md and " + name + ".csv there");

  std::string head = "# " + title + "\n\n";
  csv_ << "# " << title << '\n';
  for(const auto& lines : {machine_description(), notes}) {
    for(const std::string& line : lines) {
      head += "- " + line + '\n';
      csv_ << "# " << line << '\n';
    }
    head += '\n';
  }
  std::string names, rule;
  for(const std::string& column : columns) {
    names += "| " + column + ' ';
    rule += "|---";
    csv_ << (&column == &columns.front() ? "" : ",") << Cell(column).csv();
  }
  csv_ << std::endl;
  print(head + names + "|\n" + rule + "|\n");
}

void Table::add_row(const std::vector<Cell>& cells)
{
  CGAL_assertion(cells.size() == width_);
  std::string line;
  for(const Cell& cell : cells) {
    line += "| " + cell.markdown() + ' ';
    csv_ << (&cell == &cells.front() ? "" : ",") << cell.csv();
  }
  csv_ << std::endl;
  print(line + "|\n");
}

void Table::print(const std::string& markdown)
{
  markdown_ << markdown << std::flush;
  std::cout << markdown << std::flush;
}

} // namespace benchmark
