// SPDX-License-Identifier: GPL-3.0-or-later

#include "helpers/check.h"

#include <catch2/catch.hpp>

#include <cctype>

namespace test {

bool mentions(const std::string& text, std::size_t number)
{
  const std::string digits = std::to_string(number);
  auto is_word = [&](std::size_t i) { return i < text.size() && std::isalnum(static_cast<unsigned char>(text[i])); };
  for(std::size_t at = text.find(digits); at != std::string::npos; at = text.find(digits, at + 1))
    if(!is_word(at - 1) && !is_word(at + digits.size())) // at - 1 may wrap round: then it is no word
      return true;
  return false;
}

void check_certificate(const Result& result, const Soup& soup, const Sphere& sphere, const Settings& settings,
                       double energy_tolerance)
{
  const auto* balanced = std::get_if<SP::Balanced>(&settings.method);
  const double exponent = balanced ? balanced->spring_exponent : 2;
  const auto springs = make_springs(soup, settings.weights);
  std::vector<std::size_t> fixed;
  for(const auto& [vertex, position] : settings.fixed)
    fixed.push_back(vertex);

  CAPTURE(result, settings.accuracy, exponent);
  CHECK(result.number_of_vertices == soup.points.size());
  CHECK(result.number_of_faces == soup.faces.size());
  CHECK(count_vertices_off_sphere(sphere) == 0);
  CHECK(result.flipped_faces == count_flipped_faces(soup, sphere));
  CHECK(result.degree == degree(soup, sphere));
  CHECK(result.smallest_area == Approx(smallest_area(soup, sphere)).epsilon(1e-6).margin(1e-35));
  // the margin: where all vertices have run into one point, their distances are rounding errors
  CHECK(result.energy == Approx(energy(springs, sphere, exponent)).epsilon(energy_tolerance).margin(1e-14));
  if(balanced && exponent == 2 && fixed.empty())
    // a bound from below: the masses of the balance, which the solver has chosen, are not in the result
    CHECK(balanced_residual(springs, sphere) <= (1 + 1e-6) * result.residual + 1e-13);
  else
    CHECK(result.residual == Approx(residual(springs, sphere, fixed, exponent)).epsilon(1e-6).margin(1e-13));

  const bool is_valid = result.flipped_faces == 0 && result.degree == 1;
  CHECK(bool(result) == (result.error == Error_code::OK));
  CHECK(result.detail.empty() == bool(result));
  if(result)
    CHECK((is_valid && result.residual <= settings.accuracy));
  if(result.error == Error_code::NOT_BIJECTIVE)
    CHECK((!is_valid && result.residual <= settings.accuracy));
  if(result.error == Error_code::NOT_CONVERGED)
    CHECK(!(result.residual <= settings.accuracy));
}

} // namespace test
