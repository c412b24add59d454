// SPDX-License-Identifier: GPL-3.0-or-later
// What is said about a command line that is wrong.

#include "helpers/meshes.h"
#include "helpers/tool.h"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace test;

namespace {

/// Exit code 2, and all of the words on standard error.
void check_usage(const std::vector<std::string>& arguments, const std::vector<std::string>& words)
{
  const Process_result run = run_tool(arguments);
  CAPTURE(arguments, run.out, run.err);
  CHECK(run.exit_code == 2);
  CHECK(run.out.empty());
  for(const std::string& word : words) {
    CAPTURE(word);
    CHECK(run.err.find(word) != std::string::npos);
  }
}

} // namespace

TEST_CASE("usage: an unknown command is named, and the one that was meant", "[tool][usage]")
{
  check_usage({"mpa", "x"}, {"unknown command 'mpa'", "did you mean 'map'?"});
  check_usage({"serach"}, {"unknown command 'serach'", "did you mean 'search'?"});
  check_usage({"no-such-command", "x.off", "-o", "y.off"}, {"unknown command 'no-such-command'"});
  CHECK(run_tool({"no-such-command"}).err.find("did you mean") == std::string::npos);
  check_usage({}, {"command", "map", "devices"});
}

TEST_CASE("usage: an unknown option is named before what is missing", "[tool][usage]")
{
  check_usage({"map", "a.off", "--weigths", "x"}, {"unknown option '--weigths'", "did you mean '--weights'?"});
  check_usage({"map", "--weigths=x", "a.off"}, {"unknown option '--weigths'", "did you mean '--weights'?"});
  check_usage({"map", "a.off", "-o", "b.off", "--no-such-option"}, {"unknown option '--no-such-option'"});
  check_usage({"--verison"}, {"unknown option '--verison'", "did you mean '--version'?"});
  check_usage({"search", "a.off", "-n", "3"}, {"unknown option '-n'"});
}

TEST_CASE("usage: unexpected arguments come in the order in which they were typed", "[tool][usage]")
{
  check_usage({"register", "a.off", "b.off", "-o", "c.off", "one", "two", "three"}, {"unexpected", "one two three"});
  check_usage({"search", "a.off", "--index", "i.db", "one", "two"}, {"unexpected", "one two"});
  check_usage({"view", "a.off", "b.off", "-o", "c.html"}, {"--output", "is a folder"});
}

TEST_CASE("usage: one input can be the standard input", "[tool][usage]")
{
  check_usage({"view", "-"}, {"--output", "the standard input has no name"});
  check_usage({"texture", "a.off", "-o", "-"}, {"--format", "is required for the standard output"});
  check_usage({"certify", "-", "-"}, {"SPHERE", "reads the standard input, as IN does"});
  check_usage({"register", "-", "-", "-o", "c.off"}, {"B", "reads the standard input, as A does"});
  check_usage({"search", "-", "--index", "i.db", "--rerank", "2"}, {"QUERY", "is read more than once"});
  check_usage({"search", "-", "--index", "i.db", "--picture", "p.ply"}, {"QUERY", "is read more than once"});
  check_usage({"resample", "a.off", "-o", "b.off", "--to-sphere", "-"}, {"--to-sphere", "is read more than once"});
  check_usage({"atlas", "a.off", "b.off", "-o", "c", "--template", "-"}, {"--template", "is read more than once"});
}

TEST_CASE("usage: what is missing is wrong usage", "[tool][usage]")
{
  check_usage({"map", "-o", "b.off"}, {"IN"});
  check_usage({"map", "a.off"}, {"--output"});
  check_usage({"search", "--index", "a.csv"}, {"QUERY"});
  check_usage({"search", "a.off"}, {"--index"});
  check_usage({"signature", "-o", "a.csv"}, {"IN"});
}

TEST_CASE("an output that is named in two ways is one file", "[tool]")
{
  Scratch scratch;
  write_off(scratch / "in.off", icosphere(1));
  Process_options here;
  here.directory = scratch.folder();
  for(const std::string& other : std::vector<std::string>{"./out.ply", "missing/../out.ply", scratch / "out.ply"}) {
    const Process_result run = run_tool({"map", "in.off", "-o", "out.ply", "--stretch-ply", other}, here);
    CAPTURE(other, run.err);
    CHECK(run.exit_code == 2);
    CHECK(run.err.find("--stretch-ply: is the same file as --output") != std::string::npos);
    CHECK(scratch.number_of_files() == 1);
  }
}
