// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace tool {

/// Where the value of an option goes. What is there before is its default.
using Value = std::variant<bool*, int*, double*, std::string*, std::optional<std::int64_t>*, std::optional<double>*,
                           std::optional<std::array<double, 3>>*, std::vector<std::string>*>;

/// An option of the command line as data: from it come help, man page, completion, checks, and settings in reports.
struct Option {
  std::string names; ///< as in "-o,--output"; of an argument its name, as in "IN"
  Value value;
  std::string description;
  std::string group;                    ///< heading in the help
  std::string kind = {};                ///< of the value, for the help; texts without one are a "FILE"
  std::vector<std::string> words = {};  ///< of which the value has to be one, if there are any
  std::string interval = {};            ///< that a number has to be in, as in "[0,1)"
  std::string other = {};               ///< option that decides whether this one is of use:
  std::vector<std::string> values = {}; ///< by having one of these values; a flag, or a list, by being given
  std::size_t count = 1;                ///< of values; 0: one or more
  bool is_required = false;

  /// \name For declarations: each returns the option
  /// @{
  Option& of(std::vector<std::string> all) { return set_member(words, std::move(all)); }
  Option& in(const std::string& numbers) { return set_member(interval, numbers); }
  Option& is(const char* what) { return set_member(kind, what); }
  Option& times(std::size_t n) { return set_member(count, n); }
  Option& required() { return set_member(is_required, true); }
  Option& only_with(const char* option, std::vector<std::string> of_values = {})
  {
    other = option;
    return set_member(values, std::move(of_values));
  }
  /// @}

  /// The last of its names, as it is in messages and settings.
  std::string name() const { return names.substr(names.rfind(',') + 1); }

  bool is_flag() const { return std::holds_alternative<bool*>(value); }

  /// "FILE", "{off,obj}", "N", "X"; empty for flags.
  std::string kind_of_value() const;

  /// As `--help` says it; empty if there is none.
  std::string default_text() const;

  /// For programs; null if there is none.
  nlohmann::ordered_json json() const;

  /// Takes what was typed. Throws a `CLI::ValidationError` if it is no such value.
  void set(const std::vector<std::string>& typed) const;

private:
  template <class Member, class Given>
  Option& set_member(Member& member, Given&& given)
  {
    member = std::forward<Given>(given);
    return *this;
  }
};

/// The options of a command, in the order of the help.
class Options {
public:
  /// Options that are added from now on have this heading.
  void begin_group(const char* name) { group_ = name; }

  /// Adds one, as in `options("-k,--number", number, "How many there are").in("[1,100]")`.
  template <class T>
  Option& operator()(const std::string& names, T& value, const std::string& description)
  {
    return all_.emplace_back(Option{names, &value, description, group_});
  }

  auto begin() const { return all_.begin(); }
  auto end() const { return all_.end(); }

  /// Whether the option has a meaning beside the values of the others.
  bool is_of_use(const Option& option) const;

private:
  std::deque<Option> all_; ///< which do not move
  const char* group_ = "Options";
};

/// The group of the options that do not say how to map.
inline const char* const general_options = "Options";

} // namespace tool
