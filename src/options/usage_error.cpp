// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "options/usage_error.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

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

} // namespace

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
      return "unknown option '" + option + "'" + suggestion(option, option_names(command));
    }
  if(!extras.empty())
    return "unexpected arguments: " + CLI::detail::join(extras, " ");
  return error.what();
}

} // namespace tool
