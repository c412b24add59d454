// SPDX-License-Identifier: LGPL-3.0-or-later

#include "input/text_lines.h"

#include <boost/algorithm/string/case_conv.hpp>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>
#include <utility>

namespace tool {
namespace {

bool is_white(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

bool spells_non_finite(std::string_view token)
{
  for(const char* word : {"nan", "inf", "1.#"}) // the last one: what old Windows programs print
    if(lower_case(token).find(word) != std::string::npos)
      return true;
  return false;
}

template <class Real>
Number read_number(std::string_view token, Real& value)
{
  std::string_view digits = token; // without a plus, which from_chars() does not take
  if(digits.size() > 1 && digits[0] == '+' && digits[1] != '-')
    digits.remove_prefix(1);
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if(stop != end || error == std::errc::invalid_argument) {
    value = std::numeric_limits<Real>::quiet_NaN();
    return spells_non_finite(token) ? Number::NOT_FINITE : Number::NONE;
  }
  if(error == std::errc::result_out_of_range) { // too large or too small, and only this tells
    std::istringstream text{std::string(digits)};
    text.imbue(std::locale::classic()); // in others, which a host may have set, a number ends at its point
    double rounded = 0;
    text >> rounded;
    const bool is_too_large = text.fail() && std::abs(rounded) > 1;
    value = static_cast<Real>(is_too_large ? std::copysign(std::numeric_limits<double>::infinity(), rounded) : rounded);
  }
  return std::isfinite(value) ? Number::FINITE : Number::NOT_FINITE;
}

} // namespace

std::string lower_case(std::string_view text) { return boost::algorithm::to_lower_copy(std::string(text)); }

Number to_number(std::string_view token, double& value) { return read_number(token, value); }
Number to_number(std::string_view token, float& value) { return read_number(token, value); }

std::optional<std::int64_t> to_integer(std::string_view token)
{
  if(token.size() > 1 && token[0] == '+' && token[1] != '-')
    token.remove_prefix(1);
  std::int64_t value = 0;
  const char* end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  if(token.empty() || error != std::errc() || stop != end)
    return std::nullopt;
  return value;
}

std::string percent_decoded(std::string_view text)
{
  std::string decoded;
  for(std::size_t i = 0; i < text.size(); ++i) {
    unsigned char byte = 0;
    const char* const end = text.data() + std::min(i + 3, text.size());
    if(text[i] == '%' && i + 2 < text.size() && std::from_chars(text.data() + i + 1, end, byte, 16).ptr == end) {
      decoded += static_cast<char>(byte);
      i += 2;
    } else
      decoded += text[i];
  }
  return decoded;
}

std::string in_quotes(std::string_view token)
{
  constexpr std::size_t longest = 24;
  std::string text = "'";
  for(char c : token.substr(0, longest))
    text += std::isprint(static_cast<unsigned char>(c)) ? c : '?';
  return text + (token.size() > longest ? "...'" : "'");
}

std::string_view next_token(std::string_view& text)
{
  const auto begin = std::find_if_not(text.begin(), text.end(), is_white);
  const auto end = std::find_if(begin, text.end(), is_white);
  const auto skipped = static_cast<std::size_t>(begin - text.begin());
  const std::string_view token = text.substr(skipped, static_cast<std::size_t>(end - begin));
  text.remove_prefix(skipped + token.size());
  return token;
}

double next_number(const std::string& file, std::string_view& text)
{
  const std::string_view token = next_token(text);
  double value = 0;
  if(to_number(token, value) == Number::NONE)
    refuse_file(file, token.empty() ? "cut short" : in_quotes(token) + " stands where a number should be");
  return value;
}

std::string_view without_mark(std::string_view text)
{
  return text.substr(0, 3) == "\xef\xbb\xbf" ? text.substr(3) : text;
}

Text_lines::Text_lines(const std::string& file, std::string text)
  : file_(file), text_(std::move(text)), end_(text_.size() - without_mark(text_).size())
{}

/// The next line, comment and all; empty at the end of the file.
std::string_view Text_lines::next_line()
{
  if(end_ == text_.size())
    return {};
  ++number_;
  const std::size_t begin = end_;
  const auto is_end = [](char c) { return c == '\n' || c == '\r' || c == '\0'; };
  end_ = static_cast<std::size_t>(
    std::find_if(text_.begin() + static_cast<std::ptrdiff_t>(begin), text_.end(), is_end) - text_.begin());
  const std::string_view line = std::string_view(text_).substr(begin, end_ - begin);
  if(end_ < text_.size() && text_[end_] == '\0')
    refuse("a zero byte: this is not a text file", "export it again");
  if(text_.compare(end_, 2, "\r\n") == 0)
    ++end_;
  end_ = std::min(end_ + 1, text_.size());
  return line;
}

bool Text_lines::next()
{
  while(end_ < text_.size()) {
    line_ = next_line();
    std::size_t comment = line_.find('#');
    while(comment != std::string_view::npos && comment >= 2 && line_.substr(comment - 2, 2) == "1.") // 1.#QNAN
      comment = line_.find('#', comment + 1);
    line_ = line_.substr(0, comment);
    tokens_ = line_;
    if(!std::all_of(line_.begin(), line_.end(), is_white))
      return true;
  }
  return false;
}

void Text_lines::join_continued()
{
  while(!line_.empty() && line_.back() == '\\') {
    const auto begin = static_cast<std::size_t>(line_.data() - text_.data());
    const std::size_t backslash = begin + line_.size() - 1, next = end_;
    const std::size_t end = next + next_line().size();
    std::fill(&text_[backslash], &text_[next], ' '); // over its end and its comment, too
    line_ = std::string_view(text_).substr(begin, end - begin);
  }
  tokens_ = line_;
}

std::array<double, 3> Text_lines::point(const char* what, std::size_t index, std::optional<Refusal>& non_finite)
{
  std::array<double, 3> point;
  for(double& x : point) {
    const std::string_view coordinate = token();
    const Number number = to_number(coordinate, x);
    if(number == Number::FINITE)
      continue;
    const std::string name = what + (" " + std::to_string(index));
    if(coordinate.empty())
      refuse(name + " has fewer than three coordinates", damaged_or_cut_short);
    if(number == Number::NONE)
      refuse(name + " has the coordinate " + in_quotes(coordinate) + ", which is not a number", damaged);
    if(!non_finite)
      non_finite.emplace(Error_code::NON_FINITE_COORDINATE, file_,
                         "line " + std::to_string(number_) + ": " + name + " has the coordinate " +
                           in_quotes(coordinate),
                         non_finite_remedy);
  }
  return point;
}

void Text_lines::refuse(const std::string& wrong, const std::string& remedy) const
{
  refuse_file(file_, "line " + std::to_string(number_) + ": " + wrong, remedy);
}

void Text_lines::refuse_cut_short(const std::string& wrong) const
{
  refuse_file(file_, "cut short after line " + std::to_string(number_) + ": " + wrong, "export it again");
}

} // namespace tool
