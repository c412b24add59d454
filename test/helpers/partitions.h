// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_HELPERS_PARTITIONS_H
#define TEST_HELPERS_PARTITIONS_H

#include <cstddef>
#include <map>
#include <utility>

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

} // namespace test

#endif // TEST_HELPERS_PARTITIONS_H
