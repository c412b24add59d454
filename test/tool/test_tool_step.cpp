// SPDX-License-Identifier: GPL-3.0-or-later
// The command of CONTRIBUTING.md: what a step is given by the runner.

#include "helpers/meshes.h"
#include "helpers/tool.h"

#include "runner/step.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace tool {
Step count_step();
}

using namespace test;
namespace fs = std::filesystem;

namespace {

struct Said {
  int exit_code;
  std::string out, err;
};

/// Runs the tool with no other command than this one, in this process.
Said count(std::vector<std::string> words)
{
  words.insert(words.begin(), {"spherical-parameterization", "count"});
  std::vector<char*> arguments;
  for(std::string& word : words)
    arguments.push_back(word.data());
  std::ostringstream out, err;
  std::streambuf *const cout = std::cout.rdbuf(out.rdbuf()), *const cerr = std::cerr.rdbuf(err.rdbuf());
  const int exit_code = tool::run(static_cast<int>(arguments.size()), arguments.data(), {tool::count_step()});
  std::cout.rdbuf(cout);
  std::cerr.rdbuf(cerr);
  return {exit_code, out.str(), err.str()};
}

} // namespace

TEST_CASE("step: a new command of one file has all that the others have", "[tool][step]")
{
  Scratch scratch;
  const std::string mesh = write_off(scratch / "in.off", icosphere(1)), text = scratch / "count.txt";
  CHECK(count({mesh}).out == mesh + ": 42 vertices\n");
  CHECK(count({mesh, "--faces"}).out == mesh + ": 80 faces\n");
  CHECK(count({"--help"}).out.find("Example: spherical-parameterization count bunny.ply") < std::string::npos);

  CHECK(count({mesh, "-o", text, "--report", scratch / "report.json"}).exit_code == 0);
  CHECK(text_of(text) == "42\n");
  const auto report = nlohmann::json::parse(text_of(scratch / "report.json"));
  CHECK(report.at("number") == 42);
  CHECK(report.at("error_code") == "OK");
  CHECK(report.at("input") == mesh);

  for(const std::vector<std::string>& wrong : std::vector<std::vector<std::string>>{
        {mesh, "-o", scratch / "count.off"}, {mesh, "-o", text, "--report", text}, {mesh, "--face"}, {}})
    CHECK(count(wrong).exit_code == 2);
  CHECK(count({mesh, "--report", mesh}).exit_code == 2); // no input is ever an output
  CHECK(
    count({write_off(scratch / "torus.off", torus(8, 8)), "-o", text, "--report", scratch / "report.json"}).exit_code ==
    1);
  CHECK(nlohmann::json::parse(text_of(scratch / "report.json")).at("error_code") == "WRONG_GENUS");
  CHECK(text_of(text) == "42\n"); // as it was
}

TEST_CASE("step: a new command takes folders, and resumes", "[tool][step]")
{
  Scratch scratch;
  fs::create_directory(scratch / "meshes");
  for(int level = 0; level < 3; ++level)
    write_off(scratch / ("meshes/" + std::to_string(level) + ".off"), icosphere(level));
  const std::string out = scratch / "counts";
  CHECK(count({scratch / "meshes", "-o", out, "-j", "2"}).exit_code == 0);
  CHECK(text_of(out + "/1.txt") == "42\n");
  CHECK(count({scratch / "meshes", "-o", out}).out.find("3 done by an earlier run") < std::string::npos);
  CHECK(count({scratch / "meshes", "-o", out, "--faces"}).out.find("earlier") == std::string::npos);
  CHECK(text_of(out + "/1.txt") == "80\n");
  // an existing folder is one without a slash, too
  CHECK(count({scratch / "meshes/0.off", "-o", out}).exit_code == 0);
  CHECK(text_of(out + "/0.txt") == "12\n");
}

TEST_CASE("step: the manual shows the file of this test", "[tool][step]")
{
  CHECK(text_of(PROJECT_FOLDER "/CONTRIBUTING.md").find(text_of(PROJECT_FOLDER "/test/tool/step/count.cpp")) <
        std::string::npos);
  const std::string table = run_tool({"make-table"}).out;
  CHECK(lines_of(table).size() == 16);
  CHECK(text_of(PROJECT_FOLDER "/doc/commands.md").find(table) < std::string::npos);
}
