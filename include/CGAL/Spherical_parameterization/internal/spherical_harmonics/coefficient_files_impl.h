// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_COEFFICIENT_FILES_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_COEFFICIENT_FILES_IMPL_H

#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/coefficient_files.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The digits that give the same number when read, in every locale.
CGAL_SP_INLINE std::string digits(double x)
{
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), x).ptr};
}

/// Reads numbers and punctuation, with spaces anywhere between them.
class Number_reader {
public:
  explicit Number_reader(std::string_view text) : text_(text) {}

  bool at_end()
  {
    skip_spaces();
    return text_.empty();
  }

  void expect(char c)
  {
    if(!follows(c))
      fail(std::string("'") + c + "' is missing");
  }

  bool follows(char c)
  {
    skip_spaces();
    const bool does = !text_.empty() && text_.front() == c;
    if(does)
      text_.remove_prefix(1);
    return does;
  }

  template <class Number>
  Number number()
  {
    skip_spaces();
    if(!text_.empty() && text_.front() == '+')
      text_.remove_prefix(1);
    Number x = 0;
    const auto [end, error] = std::from_chars(text_.data(), text_.data() + text_.size(), x);
    if(error != std::errc() || !std::isfinite(static_cast<double>(x)))
      fail("a number is missing");
    text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
    return x;
  }

  [[noreturn]] void fail(const std::string& wrong) const
  {
    throw std::runtime_error("no file of harmonic coefficients: " + wrong + " at \"" +
                             std::string(text_.substr(0, 20)) + '"');
  }

private:
  void skip_spaces() { text_.remove_prefix((std::min)(text_.find_first_not_of(" \t\r\n"), text_.size())); }

  std::string_view text_;
};

/// The degree of so many coefficients.
CGAL_SP_INLINE int degree_of_size(std::size_t size)
{
  const int degree = static_cast<int>(std::lround(std::sqrt(static_cast<double>(size)))) - 1;
  if(degree < 0 || degree > largest_harmonic_degree ||
     static_cast<std::size_t>(degree + 1) * static_cast<std::size_t>(degree + 1) != size)
    throw std::runtime_error("no file of harmonic coefficients: " + std::to_string(size) +
                             " coefficients are not those of a degree");
  return degree;
}

/// A line for every l and m, the header l,m,x,y,z, or value0, ... if there are not three functions.
CGAL_SP_CORE std::string csv_of(const Harmonic_coefficients& c)
{
  std::string text = "l,m";
  for(int field = 0; field < c.number_of_fields(); ++field)
    text += c.number_of_fields() == 3 ? std::string(",") + "xyz"[field] : ",value" + std::to_string(field);
  text += '\n';
  for(int l = 0; l <= c.degree(); ++l)
    for(int m = -l; m <= l; ++m) {
      text += std::to_string(l) + ',' + std::to_string(m);
      for(int field = 0; field < c.number_of_fields(); ++field)
        text += ',' + digits(c(l, m, field));
      text += '\n';
    }
  return text;
}

CGAL_SP_CORE Harmonic_coefficients coefficients_of_csv(const std::string& text)
{
  const std::size_t first_line = (std::min)(text.find('\n'), text.size());
  const auto fields = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(first_line), ',') - 1;
  Number_reader reader(std::string_view(text).substr(first_line));
  if(text.compare(0, 3, "l,m") != 0 || fields < 1)
    Number_reader(text).fail("the header l,m,... is missing");
  std::vector<double> value; // row after row
  int l = 0, m = 0;
  while(!reader.at_end()) {
    const int row_l = reader.number<int>();
    reader.expect(',');
    const int row_m = reader.number<int>();
    if(row_l != l || row_m != m)
      reader.fail("the line of l = " + std::to_string(l) + ", m = " + std::to_string(m) + " is missing");
    for(int field = 0; field < fields; ++field) {
      reader.expect(',');
      value.push_back(reader.number<double>());
    }
    if(++m > l)
      m = -++l;
  }
  const auto rows = value.size() / static_cast<std::size_t>(fields);
  Harmonic_coefficients c(degree_of_size(rows), static_cast<int>(fields));
  for(std::size_t i = 0; i < value.size(); ++i)
    c.field_begin(static_cast<int>(i % fields))[i / fields] = value[i];
  return c;
}

CGAL_SP_CORE std::string json_of(const Harmonic_coefficients& c)
{
  std::string text = "{\n\"degree\": " + std::to_string(c.degree()) +
                     ",\n\"functions\": " + std::to_string(c.number_of_fields()) +
                     ",\n\"harmonics\": \"real orthonormal, without Condon-Shortley phase, number l*l+l+m\""
                     ",\n\"coefficients\": [";
  for(int field = 0; field < c.number_of_fields(); ++field) {
    text += field == 0 ? "\n[" : ",\n[";
    for(int i = 0; i < c.size(); ++i)
      text += (i == 0 ? "" : ",") + digits(c.field_begin(field)[i]);
    text += ']';
  }
  return text + "]\n}\n";
}

/// Of the object, the array "coefficients". (Boost.PropertyTree would have to be compiled in every file that includes
/// the package, with notes about Boost's own headers.)
CGAL_SP_CORE Harmonic_coefficients coefficients_of_json(const std::string& text)
{
  const std::string key = "\"coefficients\"";
  const std::size_t begin = text.find(key);
  if(begin == std::string::npos || text.find_last_not_of(" \t\r\n") != text.rfind('}'))
    Number_reader(text).fail(key + " or the end is missing");
  Number_reader reader(std::string_view(text).substr(begin + key.size()));
  reader.expect(':');
  reader.expect('[');
  std::vector<double> value; // function after function
  int functions = 0;
  std::size_t size = 0; // of the first one
  do {
    reader.expect('[');
    do
      value.push_back(reader.number<double>());
    while(reader.follows(','));
    reader.expect(']');
    size = functions++ == 0 ? value.size() : size;
    if(value.size() != static_cast<std::size_t>(functions) * size)
      reader.fail("not all functions have as many");
  } while(reader.follows(','));
  reader.expect(']');
  Harmonic_coefficients c(degree_of_size(size), functions);
  c.values() = std::move(value);
  return c;
}

/// What SPHARM-PDM's functions are times to be ours: they have the Condon-Shortley phase and no sqrt 2. For every
/// degree m = 0 comes first, then the cosine and the sine of m = 1, 2, ...
inline double spharm_pdm_factor(int m) { return m == 0 ? 1 : (m % 2 == 0 ? 1 : -1) * std::sqrt(2.); }

CGAL_SP_CORE std::string spharm_pdm_of(const Harmonic_coefficients& c)
{
  if(c.number_of_fields() != 3)
    throw std::runtime_error("files of SPHARM-PDM have the coefficients of three functions");
  std::string text = "{ " + std::to_string(c.size()) + ",";
  for(int l = 0; l <= c.degree(); ++l)
    for(int i = 0; i <= 2 * l; ++i) {
      const int m = (i + 1) / 2 * (i % 2 == 1 ? 1 : -1);
      text += l == 0 ? "{" : ",\n{";
      for(int field = 0; field < 3; ++field)
        text += (field == 0 ? "" : ", ") + digits(spharm_pdm_factor(m) * c(l, m, field));
      text += '}';
    }
  return text + "}";
}

CGAL_SP_CORE Harmonic_coefficients coefficients_of_spharm_pdm(const std::string& text)
{
  Number_reader reader(text);
  reader.expect('{');
  const auto size = static_cast<std::size_t>((std::max)(reader.number<int>(), 0));
  constexpr std::size_t shortest = 8; // ",{0,0,0}"
  if(size > text.size() / shortest)
    reader.fail("cut short, since it announces " + std::to_string(size) + " coefficients,");
  Harmonic_coefficients c(degree_of_size(size), 3);
  for(int l = 0; l <= c.degree(); ++l)
    for(int i = 0; i <= 2 * l; ++i) {
      const int m = (i + 1) / 2 * (i % 2 == 1 ? 1 : -1);
      reader.expect(',');
      reader.expect('{');
      for(int field = 0; field < 3; ++field) {
        if(field > 0)
          reader.expect(',');
        c(l, m, field) = reader.number<double>() / spharm_pdm_factor(m);
      }
      reader.expect('}');
    }
  reader.follows(',');
  reader.expect('}');
  return c;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_COEFFICIENT_FILES_IMPL_H
