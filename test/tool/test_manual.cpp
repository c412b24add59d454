// SPDX-License-Identifier: GPL-3.0-or-later
// What the manual says of the sources.

#include "helpers/tool.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

using namespace test;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> matches(const std::string& text, const std::string& pattern)
{
  const std::regex expression(pattern);
  std::vector<std::string> result;
  for(std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end; ++match)
    result.push_back((*match)[1]);
  return result;
}

} // namespace

TEST_CASE("manual: the constants of the solvers are in the files that it names", "[manual]")
{
  const fs::path package = PROJECT_FOLDER "/include/CGAL/Spherical_parameterization";
  std::size_t number = 0;
  for(const std::string& line : lines_of(text_of(PROJECT_FOLDER "/doc/solver_constants.md"))) {
    const std::vector<std::string> columns = matches(line, "([^|]+)[|]"); // constants, values, files, why
    if(columns.size() < 4)
      continue;
    std::string sources;
    fs::path folder;
    for(const fs::path file : matches(columns[2], "([\\w/]+[.]h)")) {
      folder = file.has_parent_path() ? file.parent_path() : folder; // that of the file before, if none is given
      for(const fs::path& name : {package / folder / file.filename(), package / "internal" / folder / file.filename()})
        if(fs::exists(name))
          sources += text_of(name.string());
    }
    for(const std::string& name : matches(columns[0], "`(\\w+)`")) {
      INFO(columns[2] << ": " << name);
      CHECK(std::regex_search(sources, std::regex("\\b" + name + "\\b")));
      ++number;
    }
  }
  CHECK(number > 100);
}
