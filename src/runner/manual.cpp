// SPDX-License-Identifier: GPL-3.0-or-later

#include "runner/step.h"

#include "input/files.h"

#include <CLI/CLI.hpp>
#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <iterator>
#include <sstream>

namespace tool {
namespace {

std::vector<const CLI::Option*> options_of(const CLI::App& command)
{
  return command.get_options([](const CLI::Option* option) { return !option->get_group().empty(); });
}

/// As troff wants it.
std::string escaped(std::string text)
{
  boost::replace_all(text, "\\", "\\\\");
  boost::replace_all(text, "-", "\\-");
  boost::replace_all(text, "\n", " ");
  return text.find_first_of(".'") == 0 ? "\\&" + text : text;
}

void describe(std::ostream& out, const CLI::Option* option)
{
  const bool is_flag = option->get_expected_max() == 0;
  out << ".TP\n\\fB" << escaped(option->get_positional() ? option->get_name() : join(names_of(option), ", ")) << "\\fR"
      << (is_flag || option->get_positional() ? "" : " \\fI" + escaped(option->get_type_name()) + "\\fR") << '\n'
      << escaped(option->get_description())
      << (option->get_default_str().empty() ? "" : " [" + escaped(option->get_default_str()) + ']')
      << (option->get_required() && !option->get_positional() ? " (required)" : "") << ".\n";
}

/// What a step cannot do, in words; empty if it can.
std::string why_not(const Step& step, const std::string& what)
{
  const Takes& takes = step.takes;
  const bool is_of_each = takes.meshes == Takes::EACH;
  if(takes.meshes == Takes::NONE)
    return what == "Ctrl-C" || what == "pipe" ? "" : "takes no mesh";
  if(what == "--prepare" && takes.prepare == Prepare::NO)
    return step.name == "prepare" ? "always" : "no";
  if((what == "--jobs" || what == "resumed") && !is_of_each && takes.meshes != Takes::TOGETHER)
    return takes.meshes == Takes::PAIR ? "takes one pair" : "takes one query";
  if(what == "progress" && takes.method == nullptr && takes.meshes != Takes::TOGETHER)
    return is_of_each ? "with many meshes only" : "no";
  if(what == "pipe" && !step.gives.empty()) {
    const Output& first = step.gives.front();
    if(first.kind == Output::FOLDER && !is_of_each)
      return "writes a folder";
    if(first.kind == Output::DATABASE)
      return "writes a database";
    if(first.kind == Output::FILE && first.extensions.size() > 1)
      return "format from the file name";
  }
  return "";
}

/// The man page: `frame`, with the commands and their options in the place of the line "@STEPS@".
std::string man_page(const CLI::App& app, const std::string& frame)
{
  std::ostringstream text;
  text << ".SH COMMANDS\n";
  for(const CLI::App* command : commands_of(app))
    text << ".TP\n.B " << command->get_name() << '\n' << escaped(command->get_description()) << ".\n";
  text << ".SH OPTIONS OF ALL COMMANDS\n";
  for(const CLI::Option* option : options_of(app))
    describe(text, option);
  for(const CLI::App* command : commands_of(app)) {
    if(options_of(*command).size() == 1) // --help
      continue;
    std::string name = command->get_name();
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
    text << ".SH " << name << '\n';
    bool says_how_to_map = false;
    for(const CLI::Option* option : options_of(*command))
      if(option->get_group() == general_options)
        describe(text, option);
      else
        says_how_to_map = true;
    std::istringstream footer(command->get_footer());
    bool begins = true; // a paragraph
    for(std::string line; std::getline(footer, line); begins = false) {
      begins = begins || line.find("Example:") == 0 || line.find("Exit code:") == 0;
      text << (begins ? ".PP\n" : "") << escaped(line) << '\n';
    }
    if(says_how_to_map)
      text << ".PP\nAlso all options of the section HOW TO MAP.\n";
  }
  text << ".SH HOW TO MAP\n";
  std::string group = general_options;
  for(const CLI::Option* option : options_of(*app.get_subcommand("map")))
    if(option->get_group() != general_options) {
      if(option->get_group() != group)
        text << ".SS " << (group = option->get_group()) << '\n';
      describe(text, option);
    }
  return boost::replace_all_copy(frame, "@STEPS@\n", text.str());
}

/// Commands, options, their values, and files.
std::string bash_completion(const CLI::App& app)
{
  std::ostringstream text;
  text << "# Completion of the command line of spherical-parameterization in bash, made from its list of commands.\n"
       << "declare -A _spherical_parameterization_words=(\n";
  std::vector<std::string> first;
  for(const CLI::App* command : commands_of(app))
    first.push_back(command->get_name());
  const auto add = [&text](const CLI::App& command, const std::string& name, std::vector<std::string> words) {
    for(const CLI::Option* option : options_of(command)) {
      const std::vector<std::string> names = names_of(option);
      words.insert(words.end(), names.begin(), names.end());
      if(option->get_expected_max() == 0)
        continue;
      std::string values = option->get_type_name(); // {off,obj}, FILE, or of a number or the like: nothing
      values = values[0] == '{' ? boost::replace_all_copy(values.substr(1, values.size() - 2), ",", " ")
               : (values.find("FILE") == 0 || values.find("FOLDER") == 0) ? "FILE"
                                                                          : "";
      for(const std::string& option_name : names)
        text << "  [" << name << ' ' << option_name << "]='" << values << "'\n";
    }
    text << "  [" << name << "]='" << join(words, " ") << "'\n";
  };
  add(app, "-", first);
  for(const CLI::App* command : commands_of(app))
    add(*command, command->get_name(), {});
  text << R"bash()

# _spherical_parameterization PROGRAM CURRENT PREVIOUS
_spherical_parameterization()
{
  local current=$2 previous=$3 command=- words=FILE file i
  COMPREPLY=()
  for ((i = 1; i < COMP_CWORD; ++i)); do # the first word that is no option
    [[ ${COMP_WORDS[i]} = -* ]] || { command=${COMP_WORDS[i]}; break; }
  done
  if [ "$current" = = ]; then # readline makes a word of the '=' in --option=value
    current=''
  elif [ "$previous" = = ]; then
    previous=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  if [[ $previous = -* && -v _spherical_parameterization_words["$command $previous"] ]]; then
    words=${_spherical_parameterization_words["$command $previous"]}
  elif [[ $current = -* || $command = - ]]; then
    words=${_spherical_parameterization_words["$command"]}
  else
    previous=''
  fi
  if [ "$words" != FILE ]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
    return
  fi
  compopt -o filenames 2>/dev/null
  while IFS= read -r file; do # of arguments meshes only
    if [ -n "$previous" ] || [ -d "$file" ] ||
      [[ ' off obj ply stl gii vtk vtp vtu glb gltf gz xz zst bz2 ' = *" $(tr '[:upper:]' '[:lower:]' <<<"${file##*.}") "* ]]; then
      COMPREPLY+=("$file")
    fi
  done < <(compgen -f -- "$current")
}

complete -F _spherical_parameterization spherical-parameterization
)bash";
  return text.str();
}

/// What every command can do, or in a line why not; in Markdown.
std::string table_of_steps(const std::vector<Step>& all)
{
  const std::vector<std::string> columns = {"--report", "--prepare", "--jobs",    "resumed", "progress",
                                            "Ctrl-C",   "full disk", "`kill -9`", "pipe"};
  std::ostringstream text;
  text << "| command | " << join(columns, " | ") << " |\n|---"
       << join(std::vector<std::string>(columns.size(), "|---"), "") << "|\n";
  for(const Step& step : all) {
    text << "| `" << step.name << "` |";
    for(const std::string& column : columns) {
      const std::string why = why_not(step, column);
      text << ' ' << (why.empty() ? "yes" : why) << " |";
    }
    text << '\n';
  }
  return text.str();
}

/// For the tests, which run all of them.
std::string steps_as_json(const std::vector<Step>& all)
{
  Json list = Json::array();
  // in the order of the enumerators
  constexpr const char *takes[] = {"nothing", "each", "pair", "together", "one"},
                       *kinds[] = {"file", "mesh", "folder", "database"}, *spheres[] = {"no", "option", "argument"};
  static_assert(std::size(takes) == Takes::ONE + 1 && std::size(kinds) == Output::DATABASE + 1 &&
                std::size(spheres) == Takes::ARGUMENT + 1);
  for(const Step& step : all) {
    Json outputs = Json::array();
    for(const Output& output : step.gives)
      outputs.push_back({{"option", output.option()},
                         {"extension", output.extensions.empty() ? ".off" : output.extensions.front()},
                         {"kind", kinds[output.kind]}});
    if(step.takes.meshes != Takes::NONE)
      outputs.push_back({{"option", "--report"}, {"extension", ".json"}, {"kind", "file"}});
    list.push_back({{"name", step.name},
                    {"takes", takes[step.takes.meshes]},
                    {"sphere", spheres[step.takes.sphere]},
                    {"outputs", outputs}});
  }
  return list.dump(2) + '\n';
}

} // namespace

std::optional<std::string> manual(const CLI::App& app, const std::vector<Step>& all, int argc, char** argv)
{
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  if(words.size() == 2 && words[0] == "make-man-page")
    return man_page(app, read_file(words[1]));
  if(words == std::vector<std::string>{"make-completion"})
    return bash_completion(app);
  if(words == std::vector<std::string>{"make-table"})
    return table_of_steps(all);
  if(words == std::vector<std::string>{"make-list"})
    return steps_as_json(all);
  return std::nullopt;
}

} // namespace tool
