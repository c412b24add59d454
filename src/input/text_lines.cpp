// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "input/text_lines.h"

#include "system/refusal.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace tool {
namespace {

constexpr const char* white_space = " \t\r\n\v\f";

bool spells_non_finite(std::string token)
{
  for(char& c : token)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for(const char* word : {"nan", "inf", "1.#"}) // the last one: what old Windows programs print
    if(token.find(word) != std::string::npos)
      return true;
  return false;
}

} // namespace

Number to_number(const std::string& token, double& value)
{
  // strtod() would also take hexadecimal numbers, which CGAL's readers do not
  if(token.empty() || token.find_first_not_of("0123456789+-.eE") != std::string::npos)
    return spells_non_finite(token) ? Number::NOT_FINITE : Number::NONE;
  char* end = nullptr;
  value = std::strtod(token.c_str(), &end);
  if(end != token.c_str() + token.size())
    return Number::NONE;
  return std::isfinite(value) ? Number::FINITE : Number::NOT_FINITE;
}

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

std::string in_quotes(std::string_view token)
{
  constexpr std::size_t longest = 24;
  std::string text = "'";
  for(char c : token.substr(0, longest))
    text += std::isprint(static_cast<unsigned char>(c)) ? c : '?';
  return text + (token.size() > longest ? "...'" : "'");
}

std::string_view Tokens::next()
{
  rest_.remove_prefix(std::min(rest_.find_first_not_of(white_space), rest_.size()));
  const std::string_view token = rest_.substr(0, rest_.find_first_of(white_space));
  rest_.remove_prefix(token.size());
  return token;
}

Text_lines::Text_lines(const std::string& file) : file_(file), in_(file, std::ios::binary)
{
  if(!in_)
    throw Refusal(unreadable_file, file, "cannot be opened", "check that it may be read");
  char mark[3] = {}; // that Windows editors put before UTF-8
  if(!in_.read(mark, 3) || std::string_view(mark, 3) != "\xEF\xBB\xBF") {
    in_.clear();
    in_.seekg(0);
  }
}

bool Text_lines::read_line()
{
  if(in_.peek() == std::char_traits<char>::eof())
    return false;
  ++number_;
  std::streambuf& buffer = *in_.rdbuf();
  for(int c = buffer.sbumpc(); c != std::char_traits<char>::eof() && c != '\n'; c = buffer.sbumpc()) {
    if(c == '\0')
      refuse("a zero byte: this is not a text file", "export it again");
    if(c == '\r') {
      if(buffer.sgetc() == '\n')
        buffer.sbumpc();
      break;
    }
    text_ += static_cast<char>(c);
  }
  return true;
}

bool Text_lines::next()
{
  while(true) {
    text_.clear();
    if(!read_line())
      return false;
    text_.resize(std::min(text_.find('#'), text_.size()));
    if(text_.find_first_not_of(white_space) != std::string::npos)
      return true;
  }
}

void Text_lines::join_continued()
{
  while(!text_.empty() && text_.back() == '\\') {
    text_.back() = ' ';
    read_line();
  }
}

void Text_lines::append_point(Tokens& tokens, const char* what, std::size_t index, std::string& out)
{
  for(int i = 0; i < 3; ++i) {
    token_ = tokens.next();
    if(token_.empty())
      refuse(what + (" " + std::to_string(index)) + " has fewer than three coordinates",
             "the file is damaged or cut short; export it again");
    double value = 0;
    switch(to_number(token_, value)) {
    case Number::FINITE:
      out += token_;
      out += i < 2 ? ' ' : '\n';
      break;
    case Number::NOT_FINITE:
      throw Refusal("NON_FINITE_COORDINATE", file_,
                    "line " + std::to_string(number_) + ": " + what + " " + std::to_string(index) +
                      " has the coordinate " + in_quotes(token_),
                    "every coordinate must be a finite number");
    case Number::NONE:
      refuse(what + (" " + std::to_string(index)) + " has the coordinate " + in_quotes(token_) +
               ", which is not a number",
             "the file is damaged; export it again");
    }
  }
}

void Text_lines::refuse(const std::string& wrong, const std::string& remedy) const
{
  throw Refusal(unreadable_file, file_, "line " + std::to_string(number_) + ": " + wrong, remedy);
}

void Text_lines::refuse_cut_short(const std::string& wrong) const
{
  throw Refusal(unreadable_file, file_, "cut short after line " + std::to_string(number_) + ": " + wrong,
                "export it again");
}

} // namespace tool
