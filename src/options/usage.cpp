// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "options/usage.h"

#include "input/compression.h"
#include "input/files.h"
#include "input/mesh_format.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <system_error>

namespace tool {
namespace {

constexpr std::size_t line_length = 100;

/// Line breaks between words, so that no line is longer than `width` unless a word is.
std::string wrapped(const std::string& text, std::size_t width)
{
  std::istringstream words(text);
  std::string result, word;
  std::size_t length = 0;
  while(words >> word) {
    const bool fits = length + 1 + word.size() <= width;
    if(length > 0)
      result += fits ? ' ' : '\n';
    length = length > 0 && fits ? length + 1 + word.size() : word.size();
    result += word;
  }
  return result;
}

class Help_formatter : public CLI::Formatter {
public:
  std::string make_option_opts(const CLI::Option* option) const override
  {
    if(option->get_type_size() == 0) // a flag
      return "";
    // CLI11 has TYPE:CHECK of values that are checked; the check says more
    const std::string type = option->get_type_name();
    const std::size_t colon = type.find(':');
    return " " + (colon == std::string::npos ? type : type.substr(colon + 1)) +
           (option->get_expected_max() > 1 ? " ..." : "");
  }

  std::string make_option_desc(const CLI::Option* option) const override
  {
    std::string text = option->get_description();
    if(!option->get_default_str().empty())
      text += " [" + option->get_default_str() + "]";
    if(option->get_required() && !option->get_positional())
      text += " (required)";
    return wrapped(text, line_length - get_column_width());
  }
};

/// Number of letters to insert, remove or replace, and of neighbours to swap (optimal string alignment distance).
std::size_t edit_distance(const std::string& a, const std::string& b)
{
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for(std::size_t i = 0; i <= a.size(); ++i)
    for(std::size_t j = 0; j <= b.size(); ++j) {
      if(i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
      if(i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

/// "; did you mean 'map'?", if one of the names is that similar.
std::string suggestion(const std::string& word, const std::vector<std::string>& names)
{
  std::string best;
  std::size_t least = std::min<std::size_t>(word.size() / 3, 3) + 1; // more changes would make it another word
  for(const std::string& name : names)
    if(const std::size_t distance = edit_distance(word, name); distance < least) {
      least = distance;
      best = name;
    }
  return best.empty() ? "" : "; did you mean '" + best + "'?";
}

std::vector<std::string> command_names(const CLI::App& app)
{
  std::vector<std::string> names;
  for(const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

std::vector<std::string> option_names(const CLI::App& app)
{
  std::vector<std::string> names;
  for(const CLI::Option* option : app.get_options()) {
    for(const std::string& name : option->get_snames())
      names.push_back('-' + name);
    for(const std::string& name : option->get_lnames())
      names.push_back("--" + name);
  }
  return names;
}

namespace fs = std::filesystem;

bool is_same_file(const std::string& a, const std::string& b)
{
  std::error_code error; // of files that do not exist: then their names decide
  return fs::equivalent(a, b, error) || fs::weakly_canonical(a, error) == fs::weakly_canonical(b, error);
}

bool can_be_replaced(const std::string& file)
{
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  return status.type() == fs::file_type::not_found || status.type() == fs::file_type::regular;
}

} // namespace

std::shared_ptr<CLI::FormatterBase> help_formatter() { return std::make_shared<Help_formatter>(); }

std::string usage_error(const CLI::App& app, const CLI::ParseError& error)
{
  const std::vector<CLI::App*> parsed = app.get_subcommands();
  const CLI::App& command = parsed.empty() ? app : *parsed.front();
  const std::vector<std::string> extras = app.remaining(true);
  const bool is_about_presence =
    dynamic_cast<const CLI::RequiredError*>(&error) || dynamic_cast<const CLI::ExtrasError*>(&error);
  if(!is_about_presence)
    return error.what();
  if(parsed.empty() && extras.empty())
    return "a command is required: " + CLI::detail::join(command_names(app), ", ");
  if(parsed.empty() && extras.front()[0] != '-')
    return "unknown command '" + extras.front() + "'" + suggestion(extras.front(), command_names(app));
  for(const std::string& word : extras)
    if(word.size() > 1 && word[0] == '-') {
      const std::string option = word.substr(0, word.find('='));
      std::vector<std::string> names = option_names(command);
      for(const std::string& name : option_names(app)) // some are for all commands
        names.push_back(name);
      return "unknown option '" + option + "'" + suggestion(option, names);
    }
  if(!extras.empty())
    return "unexpected arguments: " + CLI::detail::join(extras, " ");
  return error.what();
}

void require(bool condition, const std::string& option, const std::string& rule)
{
  if(!condition)
    throw CLI::ValidationError(option, rule);
}

void require_extension(const std::string& option, const std::string& file, const std::vector<std::string>& extensions)
{
  const auto found = std::find(extensions.begin(), extensions.end(), lower_case_extension(without_compression(file)));
  require(found != extensions.end(), option,
          "'" + file + "' must have the extension " + CLI::detail::join(extensions, " or "));
}

CLI::Option* add_file_option(CLI::App& command, const std::string& name, std::string& file,
                             const std::string& description)
{
  return command.add_option(name, file, description)->type_name("FILE");
}

void add_footer(CLI::App& command, const std::string& example, const std::string& done, const std::string& not_done)
{
  command.footer(
    "Example: spherical-parameterization " + example + '\n' +
    wrapped("Exit code: 0 " + done + ", 1 " + not_done + ", 2 wrong usage, 130 interrupted.", line_length));
}

void check_files(const std::vector<File_option>& inputs, const std::vector<File_option>& outputs)
{
  std::vector<File_option> files = inputs;
  for(const auto& [option, file] : outputs) {
    if(file.empty())
      continue;
    if(file == standard_stream) { // which is another one for inputs
      for(const auto& [other_option, other_file] : outputs)
        require(other_file != standard_stream || other_option == option, option, "is the same file as " + other_option);
      continue;
    }
    require(can_be_replaced(file), option, "'" + file + "' exists and is not a regular file");
    for(const auto& [other_option, other_file] : files)
      require(other_file.empty() || !is_same_file(file, other_file), option, "is the same file as " + other_option);
    files.emplace_back(option, file);
  }
}

} // namespace tool
