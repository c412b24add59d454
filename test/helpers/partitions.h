// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_HELPERS_PARTITIONS_H
#define TEST_HELPERS_PARTITIONS_H

#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace test {

/// Pairs of elements that two partitions of the same elements keep together: what the indices that compare partitions
/// are made of.
struct Pairs_together {
  double in_both, in_a, in_b;
  double all; ///< pairs there are

  /// `keys` is a range of elements, `a` and `b` turn one into its part.
  template <class Range, class A, class B>
  Pairs_together(const Range& keys, A a, B b)
  {
    std::map<std::pair<std::size_t, std::size_t>, double> joint;
    std::map<std::size_t, double> count_a, count_b;
    double n = 0;
    for(const auto& key : keys) {
      ++joint[{a(key), b(key)}];
      ++count_a[a(key)];
      ++count_b[b(key)];
      ++n;
    }
    const auto pairs = [](const auto& counts) {
      double sum = 0;
      for(const auto& [part, count] : counts)
        sum += count * (count - 1) / 2;
      return sum;
    };
    in_both = pairs(joint);
    in_a = pairs(count_a);
    in_b = pairs(count_b);
    all = n * (n - 1) / 2;
  }
};

/// Share of the pairs of elements that one partition keeps together and the other does not: 0 for equal ones.
inline double rand_error(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b)
{
  std::vector<std::size_t> elements(a.size());
  std::iota(elements.begin(), elements.end(), std::size_t(0));
  const auto part_of = [](const auto& parts) { return [&](std::size_t i) { return parts.at(i); }; };
  const Pairs_together pairs(elements, part_of(a), part_of(b));
  return (pairs.in_a + pairs.in_b - 2 * pairs.in_both) / pairs.all;
}

} // namespace test

#endif // TEST_HELPERS_PARTITIONS_H
