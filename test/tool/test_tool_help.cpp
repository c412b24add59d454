// SPDX-License-Identifier: GPL-3.0-or-later
// What the tool says of itself: --help, the man page, and the completion in bash.

#include "helpers/tool.h"

#include <regex>
#include <set>
#include <sstream>

using namespace test;

namespace {

typedef std::set<std::string> Words;

std::string help(const std::string& command)
{
  const Process_result run =
    run_tool(command.empty() ? std::vector<std::string>{"--help"} : std::vector<std::string>{command, "--help"});
  REQUIRE(run.exit_code == 0);
  return run.out;
}

/// The first words of the lines of `text` that are indented by two, if they match.
Words entries(const std::string& text, const std::string& pattern)
{
  Words words;
  const std::regex entry("  (" + pattern + ")( .*)?");
  std::smatch match;
  for(const std::string& line : lines_of(text))
    if(std::regex_match(line, match, entry)) {
      std::istringstream names(match[1]);
      for(std::string name; std::getline(names, name, ',');)
        words.insert(name);
    }
  return words;
}

Words options_of(const std::string& command) { return entries(help(command), "-[^ ]*"); }

Words commands()
{
  const std::string text = help("");
  return entries(text.substr(text.find("\nSubcommands:")), "[a-z]+");
}

Words commands_and_none()
{
  Words words = commands();
  words.insert("");
  return words;
}

std::string man_page() { return std::regex_replace(text_of(MAN_PAGE), std::regex("\\\\-"), "-"); }

/// What bash completes the last of the words to.
Words completions(std::vector<std::string> words, const std::string& directory = ".", const std::string& program = TOOL)
{
  words.insert(words.begin(), program);
  const std::string script = ". \"$1\"; shift; COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); "
                             "_spherical_parameterization \"$1\" \"${COMP_WORDS[COMP_CWORD]}\" "
                             "\"${COMP_WORDS[COMP_CWORD - 1]}\"; printf '%s\\n' \"${COMPREPLY[@]}\"";
  std::vector<std::string> command = {"/bin/bash", "-c", script, "bash", BASH_COMPLETION};
  command.insert(command.end(), words.begin(), words.end());
  Process_options options;
  options.directory = directory;
  const Process_result run = run_process(command, options);
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(run.err.empty());
  const std::vector<std::string> lines = lines_of(run.out);
  Words result(lines.begin(), lines.end());
  result.erase("");
  return result;
}

} // namespace

TEST_CASE("help fits a terminal, and has an example", "[tool]")
{
  for(const std::string& command : commands_and_none()) {
    CAPTURE(command);
    for(const std::string& line : lines_of(help(command))) {
      CAPTURE(line);
      CHECK(line.size() <= 100);
      CHECK(line.find("Excludes") == std::string::npos);
    }
    if(command != "devices")
      CHECK(help(command).find("\nExample: ") != std::string::npos);
  }
}

TEST_CASE("the man page is one, and has the exit codes of the help", "[tool]")
{
  const std::string page = man_page();
  for(const std::string& command : commands())
    for(const std::string& option : options_of(command)) {
      CAPTURE(command, option);
      CHECK(page.find(option) != std::string::npos);
    }
  const std::string table = page.substr(page.find("\n.SH EXIT STATUS"), page.find("\n.SH ENVIRONMENT"));
  for(const char* code : {"0", "1", "2", "130"})
    CHECK(table.find("\n.B " + std::string(code) + "\n") != std::string::npos);
  for(const std::string& command : commands())
    CHECK(help(command).find("\nExit code: 0 ") != std::string::npos);
  const Process_result troff =
    run_process({"/bin/sh", "-c", "command -v mandoc >/dev/null || exit 0; mandoc -T lint -W error \"$0\"", MAN_PAGE});
  CAPTURE(troff.out, troff.err);
  CHECK(troff.exit_code == 0);
}

TEST_CASE("completion in bash: commands and options", "[tool]")
{
  Words words = commands();
  const Words options = options_of("");
  words.insert(options.begin(), options.end());
  CHECK(completions({""}) == words);
  CHECK(completions({"se"}) == Words{"search", "segment"});
  for(const std::string& command : commands()) {
    CAPTURE(command);
    CHECK(completions({command, "-"}) == options_of(command));
  }
  CHECK(completions({"map", "in.off", "--max-"}) == Words{"--max-angle", "--max-time"});
}

TEST_CASE("completion in bash: values", "[tool]")
{
  CHECK(completions({"map", "--method", ""}) == Words{"automatic", "balanced", "isometric", "saddle-point"});
  CHECK(completions({"segment", "in.off", "--weights", "c"}) == Words{"clamped", "conformal"});
  CHECK(completions({"map", "--weights", "=", "mean"}) == Words{"mean-value"});
  CHECK(completions({"map", "--weights", "="}).size() == 4);
  CHECK(completions({"map", "--policy", "seq"}) == Words{"sequential"});
  CHECK(completions({"texture", "--chart", ""}) == Words{"latitude-longitude", "octahedral"});
  CHECK(completions({"map", "--accuracy", ""}).empty());
  CHECK(completions({"search", "-k", ""}).empty());
  CHECK(completions({"-v", "map", "--method", "b"}) == Words{"balanced"});
  CHECK(completions({"-q", "certi"}) == Words{"certify"});
}

TEST_CASE("completion in bash: files", "[tool]")
{
  Scratch scratch;
  write_text(scratch / "a mesh.off", "");
  write_text(scratch / "BIG.STL", "");
  write_text(scratch / "notes.txt", "");
  std::filesystem::create_directory(scratch / "folder");
  const std::string here = scratch.folder();
  CHECK(completions({"map", ""}, here) == Words{"BIG.STL", "a mesh.off", "folder"});
  CHECK(completions({"map", "--triangulate", "a"}, here) == Words{"a mesh.off"});
  CHECK(completions({"map", "--fixed", ""}, here) == Words{"BIG.STL", "a mesh.off", "folder", "notes.txt"});
  CHECK(completions({"signature", "--list", "no"}, here) == Words{"notes.txt"});
  CHECK(completions({"certify", "-o", "f"}, here) == Words{"folder"});
}
