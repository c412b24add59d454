// SPDX-License-Identifier: GPL-3.0-or-later
// The folders of src/ include each other in one direction only: that of src/CMakeLists.txt.

#include "helpers/tool.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

using namespace test;
namespace fs = std::filesystem;

TEST_CASE("the rooms of the tool: includes go one way", "[tool][rooms]")
{
  const std::vector<std::string> order = {"system",  "input",       "output", "options", "preparation",
                                          "mapping", "collections", "runner", "steps"};
  const auto place = [&order](const std::string& room) { return std::find(order.begin(), order.end(), room); };
  const fs::path source = fs::path(PROJECT_FOLDER) / "src";
  const std::regex include("#include \"([a-z]+)/.*");
  std::size_t includes = 0;
  for(const auto& entry : fs::recursive_directory_iterator(source)) {
    const std::string extension = entry.path().extension().string();
    if(extension != ".h" && extension != ".cpp")
      continue;
    const std::string room = entry.path().parent_path().filename().string();
    const bool is_main = entry.path().parent_path() == source;
    CAPTURE(entry.path());
    CHECK((is_main || place(room) != order.end()));
    std::smatch match;
    for(const std::string& line : lines_of(text_of(entry.path().string())))
      if(std::regex_match(line, match, include)) {
        CAPTURE(line);
        CHECK(place(match[1]) != order.end());
        CHECK((is_main || place(match[1]) <= place(room)));
        ++includes;
      }
  }
  CHECK(includes > 50);
}
