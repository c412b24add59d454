// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "output/csv.h"

namespace tool {

std::string csv_quoted(const std::string& text)
{
  if(text.find_first_of(",\"\n\r") == std::string::npos)
    return text;
  std::string result = "\"";
  for(char c : text)
    result += c == '"' ? "\"\"" : std::string(1, c);
  return result + '"';
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

} // namespace tool
