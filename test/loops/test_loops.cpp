// SPDX-License-Identifier: GPL-3.0-or-later
// Loops by parts: every index once, the order of sums fixed, up to the largest int.

#include <CGAL/Spherical_parameterization/for_each_index.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#ifdef __linux__
#include <unistd.h>
#endif

namespace I = CGAL::Spherical_parameterization::internal;

namespace {

/// Runs the first and the last steps of a loop only, the last ones first.
struct Ends_of_loop {
  template <class F>
  void for_each(int count, F f) const
  {
    REQUIRE(count > 4);
    for(int i : {count - 1, count - 2, 1, 0})
      f(i);
  }
};

struct Backwards {
  template <class F>
  void for_each(int count, F f) const
  {
    while(count-- > 0)
      f(count);
  }
};

} // namespace

TEST_CASE("the loop of a policy calls functions that cannot be copied", "[loops]")
{
  std::vector<int> calls(4, 0);
  auto count = [&, one = std::make_unique<int>(1)](int i) { calls[static_cast<std::size_t>(i)] += *one; };
  CGAL::Spherical_parameterization::for_each_index(CGAL::Sequential_tag(), 4, std::move(count));
  CHECK(calls == std::vector<int>(4, 1));
}

TEST_CASE("parts reach the last index, up to the largest int", "[loops]")
{
  constexpr int largest = std::numeric_limits<int>::max();
  const int n = GENERATE_COPY(100000, 5 * I::part_size, largest - I::part_size, largest - 1, largest);
  CAPTURE(n);
  std::vector<std::pair<int, int>> parts;
  I::for_each_part(Ends_of_loop(), n, [&](int begin, int end) { parts.emplace_back(begin, end); });
  REQUIRE(parts.size() == 4);
  const std::pair<int, int> last = parts[0], before = parts[1], second = parts[2], first = parts[3];
  CHECK(first == std::pair(0, I::part_size));
  CHECK(second == std::pair(I::part_size, 2 * I::part_size));
  CHECK(before.second - before.first == I::part_size);
  CHECK(before.second == last.first);
  CHECK(last.second == n);
  CHECK((last.first <= n && n - last.first < I::part_size));
}

TEST_CASE("every index is visited once, and results are those of its part", "[loops]")
{
  constexpr int size = 64;
  for(int n : {0, 1, 63, 64, 65, 640, 1000}) {
    CAPTURE(n);
    std::vector<int> visits(n, 0);
    I::for_each_index<size>(Backwards(), n, [&](int i) { ++visits[i]; });
    CHECK(visits == std::vector<int>(n, 1));
    const std::vector<int> first = I::results_of_parts<size>(Backwards(), n, [](int begin, int) { return begin; });
    for(std::size_t part = 0; part < first.size(); ++part)
      CHECK(first[part] == static_cast<int>(part) * size);
  }
}

TEST_CASE("sums have one order, whatever that of the loop", "[loops]")
{
  const auto term = [](int i) { return std::sin(i) * std::exp(i % 37); };
  constexpr int n = 100000;
  const double sum = I::sum_by_parts(I::Host_loop(), n, term);
  CHECK(I::sum_by_parts(Backwards(), n, term) == sum);
  CHECK(I::sum_by_parts(I::Host_loop(true), n, term) == sum);
  double plain = 0;
  for(int i = 0; i < n; ++i)
    plain += term(i);
  CHECK(sum == Approx(plain));
}

TEST_CASE("the first index is the smallest of all parts", "[loops]")
{
  constexpr int n = 100000;
  for(int first : {0, 1, I::part_size - 1, I::part_size, 54321, n - 1, n})
    CHECK(I::first_index(Backwards(), n, [&](int i) { return i >= first && (i == first || i % 3 == 0); }) == first);
}

TEST_CASE("an array keeps its elements when it grows beyond a large page, and shrinks again", "[loops]")
{
  constexpr int per_page = CGAL::Spherical_parameterization::large_page / sizeof(double);
  I::Host_array<double> numbers;
  for(int i = 0; i < 3 * per_page + 5; ++i)
    numbers.push_back(i);
  numbers.resize(2 * per_page);
  numbers.shrink_to_fit();
  I::Host_array<double> copy = numbers;
  CHECK(reinterpret_cast<std::uintptr_t>(copy.data()) % CGAL::Spherical_parameterization::large_page == 0);
  numbers.resize(per_page / 2);
  numbers.shrink_to_fit();
  copy = numbers;
  copy.shrink_to_fit();
  bool is_kept = true;
  for(int i = 0; i < per_page / 2; ++i)
    is_kept = is_kept && numbers[i] == i && copy[i] == i;
  CHECK(is_kept);
  CHECK(I::Host_array<int>(per_page, -1) == I::Host_array<int>(per_page, -1));
}

#ifdef __linux__
TEST_CASE("what a large array had goes back to the system when it is freed, whatever is allocated after it", "[loops]")
{
  constexpr std::size_t size = 5 * CGAL::Spherical_parameterization::large_page / 2, count = 8;
  const auto resident = [] { // proc(5): the second number, in pages
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages >> pages;
    return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  };
  // twice, since malloc() takes from its heap from then on what is not larger than what was freed
  for(int round = 0; round < 2; ++round) {
    std::vector<I::Host_array<char>> arrays;
    std::vector<std::vector<char>> behind_them;
    for(std::size_t i = 0; i < count; ++i) {
      arrays.emplace_back(size, 'a');
      behind_them.emplace_back(1000, 'b');
    }
    const std::size_t before = resident();
    arrays.clear();
    CHECK(resident() + (count - 1) * size < before);
  }
}
#endif
