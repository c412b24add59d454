// SPDX-License-Identifier: GPL-3.0-or-later
// What every call goes through: time limit, callback and progress; preconditions and named parameters; numbers in
// sentences.

#include <CGAL/Spherical_parameterization/internal/api/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/context/make_monitor.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/text/text.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <limits>
#include <locale>
#include <string>
#include <thread>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;
namespace I = SP::internal;

namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

/// A monitor whose callback notes the fractions, and says no after so many.
struct Noting {
  explicit Noting(std::size_t last = (std::numeric_limits<std::size_t>::max)()) : last_(last) {}

  std::vector<double> fractions;
  I::Monitor monitor{no_limit,
                     [this](double fraction) {
                       fractions.push_back(fraction);
                       return fractions.size() < last_;
                     },
                     false};

private:
  std::size_t last_;
};

} // namespace

TEST_CASE("progress never goes back, and stays within its stage", "[context]")
{
  Noting noting;
  I::Monitor& monitor = noting.monitor;
  monitor.advance(0);
  monitor.begin_stage(0.2, 0.6);
  for(double share : {0., 0.5, 0.25, std::numeric_limits<double>::quiet_NaN(), -1., 1., 7.})
    CHECK(monitor.advance(share));
  CHECK(monitor.may_go_on());
  CHECK(noting.fractions == std::vector<double>{0, 0, 0.4, 0.4, 0.4, 0.4, 0.6, 0.6, 0.6});
}

TEST_CASE("a loop calls the callback at its beginning, and then every few milliseconds", "[context]")
{
  Noting noting;
  for(int i = 0; i < 10; ++i)
    CHECK(noting.monitor.may_loop_go_on());
  CHECK(noting.fractions.size() >= 1);
  CHECK(noting.fractions.size() < 10);
}

TEST_CASE("the share of a residual is 0 at the first, 1 at the goal, and logarithmic", "[context]")
{
  CHECK(I::Monitor::share(1e-2, 1e-2, 1e-8) == Approx(0));
  CHECK(I::Monitor::share(1e-5, 1e-2, 1e-8) == Approx(0.5));
  CHECK(I::Monitor::share(1e-8, 1e-2, 1e-8) == Approx(1));
  CHECK(I::Monitor::share(0, 1e-2, 1e-8) == 0);
  CHECK(I::Monitor::share(1e-2, 1e-8, 1e-2) == 0);
}

TEST_CASE("who has been told to stop is not asked again, and the reason is kept", "[context]")
{
  SECTION("by the callback")
  {
    Noting noting(2);
    I::Monitor& monitor = noting.monitor;
    CHECK(monitor.may_go_on());
    CHECK_FALSE(monitor.may_go_on());
    CHECK_FALSE(monitor.may_go_on());
    CHECK(noting.fractions.size() == 2);
    CHECK(monitor.termination() == SP::Termination::CALLBACK);
    CHECK(monitor.reason() == "stopped by the callback");
  }
  SECTION("by the time limit, before the callback")
  {
    int calls = 0;
    I::Monitor monitor(
      0, [&](double) { return ++calls > 0; }, false);
    CHECK_FALSE(monitor.may_go_on());
    CHECK(calls == 0);
    CHECK(monitor.termination() == SP::Termination::TIME);
    CHECK(monitor.reason() == "the time limit was reached");
    try {
      monitor.advance_or_throw();
      FAIL("it went on");
    } catch(const SP::Error& error) {
      CHECK(error.code() == SP::Error_code::INTERRUPTED);
      CHECK(error.detail() == "the time limit was reached");
    }
  }
}

TEST_CASE("a limit is over when the time is, and not before", "[context]")
{
  I::Monitor monitor(0.05, nullptr, false);
  const I::Stopwatch watch;
  while(monitor.may_go_on() && watch.seconds() < 30) {
  }
  CHECK(watch.seconds() > 0.04);
  CHECK(watch.seconds() < 30);
}

TEST_CASE("the callback is called by the thread of the monitor, and not while that is silent", "[context]")
{
  Noting noting;
  I::Monitor& monitor = noting.monitor;
  std::thread([&] { CHECK(monitor.may_go_on()); }).join();
  CHECK(noting.fractions.empty());
  monitor.set_silent(true);
  CHECK(monitor.advance(0.5));
  CHECK(noting.fractions.empty());
  monitor.set_silent(false);
  CHECK(monitor.may_go_on());
  CHECK(noting.fractions == std::vector<double>{0.5});
}

TEST_CASE("a watched loop runs everything once, asks while it lasts, and ends where it has to", "[context]")
{
  const int count = 150;
  std::vector<int> times(count, 0);
  const auto work = [&](int i) {
    ++times[i];
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  Noting noting;
  I::Watched_loop(I::Host_loop(), noting.monitor).for_each(count, work);
  CHECK(std::count(times.begin(), times.end(), 1) == count);
  CHECK(noting.fractions.size() >= 15); // slices grow only where they take less than 5 ms
  CHECK(noting.fractions.size() < std::size_t(count));
  Noting ended(3);
  CHECK_THROWS_AS(I::Watched_loop(I::Host_loop(), ended.monitor).for_each(count, work), SP::Error);
  CHECK(ended.fractions.size() == 3);
  CHECK(std::count(times.begin(), times.end(), 1) > 0);
}

TEST_CASE("a monitor is what the named parameters ask for", "[context]")
{
  I::Monitor unlimited = I::make_monitor(CGAL::parameters::default_values());
  CHECK(unlimited.may_go_on());
  I::Monitor over = I::make_monitor(CGAL::parameters::maximum_running_time(0));
  CHECK_FALSE(over.may_go_on());
  I::Monitor stopped = I::make_monitor(CGAL::parameters::callback([](double) { return false; }));
  CHECK_FALSE(stopped.may_go_on());
  CHECK_THROWS_AS(I::make_monitor(CGAL::parameters::maximum_running_time(-1)), CGAL::Precondition_exception);
  CHECK_THROWS_AS(I::make_monitor(CGAL::parameters::maximum_running_time(std::numeric_limits<double>::quiet_NaN())),
                  CGAL::Precondition_exception);
}

TEST_CASE("preconditions hold with NDEBUG, too, and say what is wrong", "[api]")
{
  CGAL_SP_PRECONDITION(1 < 2, "one is less than two");
  try {
    CGAL_SP_PRECONDITION(2 < 1, "two is less than one");
    FAIL("it went on");
  } catch(const CGAL::Precondition_exception& exception) {
    CHECK(exception.expression() == "2 < 1");
    CHECK(exception.message() == "two is less than one");
  }
}

TEST_CASE("points are those that are given, else the mesh's own", "[api]")
{
  typedef CGAL::Simple_cartesian<double>::Point_3 Point;
  typedef CGAL::Surface_mesh<Point> Mesh;
  Mesh mesh;
  const auto v = mesh.add_vertex(Point(1, 2, 3));
  const auto others = mesh.add_property_map<Mesh::Vertex_index, Point>("v:other", Point(4, 5, 6)).first;
  CHECK(get(I::vertex_points(mesh, CGAL::parameters::default_values()), v) == Point(1, 2, 3));
  CHECK(get(I::vertex_points(mesh, CGAL::parameters::vertex_point_map(others)), v) == Point(4, 5, 6));
  CHECK(get(I::vertex_points(mesh, CGAL::parameters::verbose(false).vertex_point_map(others)), v) == Point(4, 5, 6));
}

TEST_CASE("numbers in sentences", "[text]")
{
  CHECK(I::counted(0, "face is", "faces are") == "0 faces are");
  CHECK(I::counted(1, "face is", "faces are") == "1 face is");
  CHECK(I::counted(2, "face is", "faces are") == "2 faces are");

  struct Commas : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale(), new Commas));
  const std::string text = I::to_string(1.23456);
  std::locale::global(before);
  CHECK(text == "1.23");
}
