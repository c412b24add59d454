// SPDX-License-Identifier: GPL-3.0-or-later

#include "options/option.h"

#include "options/command_line.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <type_traits>

namespace tool {
namespace {

bool is_in(const std::string& interval, double x)
{
  char* end = nullptr;
  const double low = std::strtod(interval.c_str() + 1, &end), high = std::strtod(end + 1, &end);
  return (interval.front() == '[' ? x >= low : x > low) && (*end == ']' ? x <= high : x < high);
}

/// As a sentence: "must be positive".
std::string rule_of(const std::string& interval)
{
  const std::string low = interval.substr(1, interval.find(',') - 1);
  if(interval.find("inf") == std::string::npos)
    return "must be in " + interval;
  return low == "0" && interval.front() == '(' ? "must be positive"
         : interval.front() == '('             ? "must be more than " + low
                                               : "must be " + low + " or more";
}

template <class T>
struct Content {
  using type = T;
};
template <class T>
struct Content<std::optional<T>> {
  using type = T;
};

} // namespace

std::string Option::kind_of_value() const
{
  if(!words.empty() || !kind.empty())
    return words.empty() ? kind : '{' + join(words, ",") + '}';
  return std::visit(
    [](auto* target) -> std::string {
      using T = typename Content<std::decay_t<decltype(*target)>>::type;
      return std::is_same_v<T, bool> ? "" : std::is_integral_v<T> ? "N" : std::is_same_v<T, double> ? "X" : "FILE";
    },
    value);
}

nlohmann::ordered_json Option::json() const
{
  return std::visit(
    [](auto* target) -> nlohmann::ordered_json {
      using T = std::decay_t<decltype(*target)>;
      if constexpr(std::is_same_v<T, std::string>)
        return target->empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(*target);
      else if constexpr(std::is_same_v<T, typename Content<T>::type>)
        return *target;
      else
        return *target ? nlohmann::ordered_json(**target) : nlohmann::ordered_json(nullptr);
    },
    value);
}

std::string Option::default_text() const
{
  std::ostringstream text;
  if(const auto number = std::get_if<double*>(&value); number != nullptr && std::isfinite(**number))
    text << **number;
  if(const auto number = std::get_if<int*>(&value))
    text << **number;
  if(const auto word = std::get_if<std::string*>(&value))
    text << **word;
  return text.str();
}

void Option::set(const std::vector<std::string>& typed) const
{
  for(const std::string& word : typed)
    require(!word.empty(), name(), "is empty");
  const auto number = [this](const std::string& word, bool is_whole) {
    char* end = nullptr;
    const double x = std::strtod(word.c_str(), &end);
    require(!word.empty() && *end == '\0' && std::isfinite(x), name(), "'" + word + "' is no number");
    require(!is_whole || x == std::floor(x), name(), "'" + word + "' is no whole number");
    require(!is_whole || std::abs(x) < 1e15, name(), "'" + word + "' is too large a number");
    if(!interval.empty())
      require(is_in(interval, x), name(), rule_of(interval));
    return x;
  };
  std::visit(
    [&](auto* target) {
      using T = std::decay_t<decltype(*target)>;
      using C = typename Content<T>::type;
      if constexpr(std::is_same_v<T, bool>)
        *target = true;
      else if constexpr(std::is_same_v<T, std::vector<std::string>>)
        *target = typed;
      else if constexpr(std::is_same_v<T, std::string>)
        *target = typed.front();
      else if constexpr(std::is_arithmetic_v<C>)
        *target = static_cast<C>(number(typed.front(), std::is_integral_v<C>));
      else
        *target = {number(typed[0], false), number(typed[1], false), number(typed[2], false)};
    },
    value);
  if(!words.empty())
    require(std::find(words.begin(), words.end(), typed.front()) != words.end(), name(),
            "'" + typed.front() + "' is none of " + join(words, ", ") + suggestion(typed.front(), words));
}

bool Options::is_of_use(const Option& option) const
{
  if(option.other.empty())
    return true;
  const auto decides =
    std::find_if(begin(), end(), [&option](const Option& other) { return other.name() == option.other; });
  if(const auto is_there = std::get_if<bool*>(&decides->value))
    return **is_there;
  if(const auto are_there = std::get_if<std::vector<std::string>*>(&decides->value))
    return !(*are_there)->empty();
  const std::string& value = **std::get_if<std::string*>(&decides->value);
  const auto& values = option.values;
  return values.empty() ? !value.empty() : std::find(values.begin(), values.end(), value) != values.end();
}

} // namespace tool
