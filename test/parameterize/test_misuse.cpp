// SPDX-License-Identifier: GPL-3.0-or-later
// Arguments out of range violate a precondition, in Release builds, too.

#include "helpers/meshes.h"

#include <CGAL/Spherical_parameterization/parameterize.h>
#include <CGAL/assertions_behaviour.h>
#include <CGAL/exceptions.h>

#include <catch2/catch.hpp>

#include <array>
#include <limits>
#include <vector>

using namespace test;
namespace SP = CGAL::Spherical_parameterization;

namespace {

/// CGAL says on std::cerr what it throws.
struct Quiet_failures {
  CGAL::Failure_function before =
    CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
  ~Quiet_failures() { CGAL::set_error_handler(before); }
};

template <class Method, class NamedParameters>
void check_refused(const Method& method, const NamedParameters& np)
{
  const Quiet_failures quiet;
  const Soup soup = icosphere(1);
  std::vector<std::array<double, 3>> sphere;
  CHECK_THROWS_AS(SP::parameterize_triangle_soup(CGAL::Sequential_tag(), soup.points, soup.faces, method, sphere, np),
                  CGAL::Precondition_exception);
  CHECK(sphere.empty());
}

template <class Method>
void check_refused(const Method& method)
{
  check_refused(method, CGAL::parameters::default_values());
}

} // namespace

TEST_CASE("arguments out of range violate a precondition", "[misuse]")
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  check_refused(SP::Balanced(), CGAL::parameters::accuracy(-1.));
  check_refused(SP::Balanced(), CGAL::parameters::accuracy(nan));
  check_refused(SP::Balanced(), CGAL::parameters::number_of_iterations(-3));
  check_refused(SP::Balanced(), CGAL::parameters::maximum_running_time(-1.));
  check_refused(SP::Balanced{0.5});
  check_refused(SP::Balanced{nan});
  check_refused(SP::Isometric{-1});
  check_refused(SP::Automatic{1.5});
  check_refused(SP::Automatic{2, 3, nan});
  SP::Saddle_point method;
  method.relaxation = 1;
  check_refused(method);
  method.relaxation = 0.5;
  method.check_interval = 0;
  check_refused(method);
}
