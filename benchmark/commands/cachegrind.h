// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef BENCHMARK_CACHEGRIND_H
#define BENCHMARK_CACHEGRIND_H

#include <limits>
#include <string>
#include <vector>

namespace benchmark {

/// The caches that are simulated: always these, so that figures of different machines compare.
constexpr const char* simulated_caches = "D1 32 KiB (8 ways), LL 1 MiB (16 ways), lines of 64 bytes";

struct Cache_misses {
  double first_level = std::numeric_limits<double>::quiet_NaN(); ///< of data, read and written
  double last_level = std::numeric_limits<double>::quiet_NaN();
};

bool has_valgrind();

/// Runs this program with other arguments under valgrind --tool=cachegrind. NaN if that fails.
Cache_misses cache_misses(const std::vector<std::string>& arguments);

} // namespace benchmark

#endif // BENCHMARK_CACHEGRIND_H
