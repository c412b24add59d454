// SPDX-License-Identifier: GPL-3.0-or-later
// Arguments out of range violate a precondition, in Release builds, too.

#include "helpers/meshes.h"

#include <CGAL/Spherical_parameterization/parameterize.h>
#include <CGAL/assertions_behaviour.h>
#include <CGAL/exceptions.h>

#include <boost/property_map/function_property_map.hpp>
#include <catch2/catch.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
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
  check_refused(SP::Balanced(), CGAL::parameters::maximum_running_time(nan));
  check_refused(SP::Balanced(), CGAL::parameters::maximum_running_time(-1.));
  check_refused(SP::Balanced{0.5});
  check_refused(SP::Balanced{nan});
  check_refused(SP::Isometric{-1});
  check_refused(SP::Automatic{1.5});
  check_refused(SP::Automatic{2, nan});
  check_refused(SP::Automatic{2, 1, 0.5});
  check_refused(SP::Automatic{2, 1, nan});
  SP::Saddle_point method;
  method.relaxation = 1;
  check_refused(method);
  method.relaxation = 0.5;
  method.check_interval = 0;
  check_refused(method);
}

TEST_CASE("what a callback throws goes through, an Error of the package, too", "[misuse]")
{
  const Soup soup = icosphere(2);
  std::vector<std::array<double, 3>> sphere;
  const auto stop = [](double) -> bool { throw SP::Error(SP::Error_code::BOUNDARY, "of the caller"); };
  CHECK_THROWS_AS(SP::parameterize_triangle_soup(CGAL::Sequential_tag(), soup.points, soup.faces, SP::Automatic(),
                                                 sphere, CGAL::parameters::callback(stop)),
                  SP::Error);
}

TEST_CASE("a mesh that has been read has a size, also where the rest is refused", "[misuse]")
{
  const Soup soup = icosphere(2);
  std::vector<std::array<double, 3>> sphere;
  const auto weights =
    boost::make_function_property_map<std::pair<std::size_t, std::size_t>>([](const auto&) { return -1.; });
  const SP::Result result =
    SP::parameterize_triangle_soup(CGAL::Sequential_tag(), soup.points, soup.faces, SP::Balanced(), sphere,
                                   CGAL::parameters::edge_weight_map(weights));
  CHECK(result.error == SP::Error_code::BAD_WEIGHT);
  CHECK(result.number_of_vertices == soup.points.size());
  CHECK(result.number_of_faces == soup.faces.size());
}
