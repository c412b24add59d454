// SPDX-License-Identifier: GPL-3.0-or-later
// To run the command-line tool on files of a scratch folder.

#ifndef TEST_HELPERS_TOOL_H
#define TEST_HELPERS_TOOL_H

#include "helpers/policies.h"
#include "helpers/process.h"
#include "helpers/soup.h"

#include <CGAL/IO/polygon_soup_io.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace test {

/// A folder of its own for every test case and policy, with a space in its name, empty at the start.
class Scratch {
  std::filesystem::path m_folder;

public:
  Scratch() : m_folder(std::filesystem::path(SCRATCH_FOLDER) / (default_policy_name() + ' ' + name_of_test_case()))
  {
    std::filesystem::remove_all(m_folder);
    std::filesystem::create_directories(m_folder);
  }
  ~Scratch() { std::filesystem::remove_all(m_folder); }

  std::string operator/(const std::string& file) const { return (m_folder / file).string(); }
  std::string folder() const { return m_folder.string(); }
  std::size_t number_of_files() const
  {
    return std::size_t(
      std::distance(std::filesystem::directory_iterator(m_folder), std::filesystem::directory_iterator()));
  }

private:
  static std::string name_of_test_case()
  {
    std::string name = Catch::getResultCapture().getCurrentTestName();
    std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
    return name;
  }
};

inline std::string text_of(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  REQUIRE(in);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

inline std::vector<std::string> lines_of(const std::string& text)
{
  std::vector<std::string> lines;
  std::istringstream in(text);
  for(std::string line; std::getline(in, line);)
    lines.push_back(line);
  return lines;
}

inline void write_text(const std::string& file, const std::string& text)
{
  std::ofstream(file, std::ios::binary) << text;
}

inline std::string off_text(const Soup& soup)
{
  std::ostringstream out;
  out.precision(17);
  out << "OFF\n" << soup.points.size() << ' ' << soup.faces.size() << " 0\n";
  for(const Point& p : soup.points)
    out << p << '\n';
  for(const auto& face : soup.faces) {
    out << face.size();
    for(std::size_t i : face)
      out << ' ' << i;
    out << '\n';
  }
  return out.str();
}

inline std::string write_off(const std::string& file, const Soup& soup)
{
  write_text(file, off_text(soup));
  return file;
}

inline Soup read(const std::string& file)
{
  Soup soup;
  CAPTURE(file);
  REQUIRE(CGAL::IO::read_polygon_soup(file, soup.points, soup.faces));
  return soup;
}

inline Process_result run_tool(std::vector<std::string> arguments, const Process_options& options = {})
{
  arguments.insert(arguments.begin(), TOOL);
  return run_process(arguments, options);
}

inline bool is_one_line(const std::string& text)
{
  return text.size() > 1 && text.back() == '\n' && std::count(text.begin(), text.end(), '\n') == 1;
}

/// Exit code 1, one line on standard error that says `word` (and the file), nothing written.
inline void check_refused(const Scratch& scratch, const std::string& input, const std::string& word,
                          const std::vector<std::string>& options = {})
{
  const std::size_t files = scratch.number_of_files();
  std::vector<std::string> arguments = {
    "map", input, "-o", scratch / "refused.off", "--stretch-ply", scratch / "refused.ply"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Process_result run = run_tool(arguments);
  CAPTURE(input, word, run.exit_code, run.out, run.err);
  CHECK(run.exit_code == 1);
  CHECK(is_one_line(run.err));
  CHECK(run.err.find(std::filesystem::path(input).filename().string()) != std::string::npos);
  CHECK(run.err.find(word) != std::string::npos);
  CHECK(scratch.number_of_files() == files);
}

} // namespace test

#endif // TEST_HELPERS_TOOL_H
