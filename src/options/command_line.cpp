// SPDX-License-Identifier: GPL-3.0-or-later

#include "options/command_line.h"

#include "options/usage.h"

#include <CLI/CLI.hpp>

#include <sstream>

namespace tool {
namespace {

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
  for(const std::string& word : extras)
    if(word.size() > 1 && word[0] == '-') {
      const std::string option = word.substr(0, word.find('='));
      std::vector<std::string> names = option_names(command);
      for(const std::string& name : option_names(app)) // some are for all commands
        names.push_back(name);
      return "unknown option '" + option + "'" + suggestion(option, names);
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
