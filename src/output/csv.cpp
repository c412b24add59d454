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

} // namespace tool
