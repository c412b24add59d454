// SPDX-License-Identifier: GPL-3.0-or-later

#include "options/command_line.h"

#include "input/compression.h"
#include "input/files.h"
#include "input/mesh_format.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>
#include <system_error>
#include <unordered_map>

#include <sys/stat.h>

namespace tool {
namespace {

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

namespace fs = std::filesystem;

/// Files by what they are, and by their places for those that do not exist.
class Named_files {
public:
  /// The option that has named the file before; empty if there is none.
  std::string add(const File_option& named)
  {
    const auto& [option, file] = named;
    const auto [same_place, is_new_place] = by_place_.emplace(place_of(file).string(), option);
    struct stat status;
    if(stat(file.c_str(), &status) == 0)
      if(const auto [same, is_new] = by_node_.emplace(std::pair(status.st_dev, status.st_ino), option); !is_new)
        return same->second;
    return is_new_place ? "" : same_place->second;
  }

private:
  std::unordered_map<std::string, std::string> by_place_;
  std::map<std::pair<dev_t, ino_t>, std::string> by_node_;
};

constexpr int many = CLI::detail::expected_max_vector_size;

class Help_formatter : public CLI::Formatter {
public:
  std::string make_option_opts(const CLI::Option* option) const override
  {
    if(option->get_expected_max() == 0) // a flag
      return "";
    return " " + option->get_type_name() + (option->get_expected_max() == many ? " ..." : "");
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

std::vector<std::string> command_names(const CLI::App& app)
{
  std::vector<std::string> names;
  for(const CLI::App* command : commands_of(app))
    names.push_back(command->get_name());
  return names;
}

std::vector<std::string> option_names(const CLI::App& app)
{
  std::vector<std::string> names;
  for(const CLI::Option* option : app.get_options())
    for(const std::string& name : names_of(option))
      names.push_back(name);
  return names;
}

} // namespace

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

void require(bool condition, const std::string& option, const std::string& rule)
{
  if(!condition)
    throw CLI::ValidationError(option, rule);
}

void require_extension(const std::string& option, const std::string& file, const std::vector<std::string>& extensions)
{
  const auto found = std::find(extensions.begin(), extensions.end(), lower_case_extension(without_compression(file)));
  require(found != extensions.end(), option, "'" + file + "' must have the extension " + join(extensions, " or "));
}

void check_files(const std::vector<File_option>& inputs, const std::vector<File_option>& outputs)
{
  std::string reader; // of the standard input
  Named_files files;
  for(const auto& [option, file] : inputs)
    if(file != standard_stream)
      files.add({option, file});
    else {
      require(reader != option, option, "is read more than once, as the standard input cannot be; name a file");
      require(reader.empty(), option, "reads the standard input, as " + reader + " does");
      reader = option;
    }
  for(const auto& [option, file] : outputs) {
    if(file.empty())
      continue;
    if(file == standard_stream) { // which is another one for inputs
      for(const auto& [other_option, other_file] : outputs)
        require(other_file != standard_stream || other_option == option, option, "is the same file as " + other_option);
      continue;
    }
    std::error_code none;
    const fs::file_type type = fs::status(file, none).type();
    require(type == fs::file_type::not_found || type == fs::file_type::regular || type == fs::file_type::none, option,
            "'" + file + "' exists and is not a regular file"); // none: not to be known, as where access is forbidden
    const std::string other = files.add({option, file});
    require(other.empty(), option, "is the same file as " + other);
  }
}

std::vector<const CLI::App*> commands_of(const CLI::App& app)
{
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<std::string> names_of(const CLI::Option* option)
{
  std::vector<std::string> names;
  for(const std::string& name : option->get_snames())
    names.push_back('-' + name);
  for(const std::string& name : option->get_lnames())
    names.push_back("--" + name);
  return names;
}

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
    return "a command is required: " + join(command_names(app), ", ");
  if(parsed.empty() && extras.front()[0] != '-')
    return "unknown command '" + extras.front() + "'" + suggestion(extras.front(), command_names(app));
  for(const std::string& word : extras) {
    if(word == "--") // behind it there are no options
      return error.what();
    if(word.size() > 1 && word[0] == '-') {
      const std::string option = word.substr(0, word.find('='));
      std::vector<std::string> names = option_names(command);
      for(const std::string& name : option_names(app)) // some are for all commands
        names.push_back(name);
      return "unknown option '" + option + "'" + suggestion(option, names);
    }
  }
  if(!extras.empty())
    return "unexpected arguments: " + join(extras, " ");
  return error.what();
}

void add_options(CLI::App& command, const Options& options)
{
  for(const Option& option : options) {
    if(option.is_flag()) {
      command
        .add_flag_function(
          option.names, [&option](std::int64_t) { option.set({}); }, option.description)
        ->disable_flag_override() // --flag=false would be true
        ->group(option.group);
      continue;
    }
    CLI::Option* const added = command.add_option(
      option.names,
      [&option](const std::vector<std::string>& typed) {
        option.set(typed);
        return true;
      },
      option.description);
    added->group(option.group)->type_name(option.kind_of_value())->required(option.is_required);
    added->expected(option.count > 0 ? static_cast<int>(option.count) : 1,
                    option.count > 0 ? static_cast<int>(option.count) : many);
    added->allow_extra_args(option.count == 0);
    added->default_str(option.default_text());
  }
}

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

} // namespace tool
