// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef BENCHMARK_TIMING_H
#define BENCHMARK_TIMING_H

#include <algorithm>
#include <chrono>
#include <functional>
#include <vector>

namespace benchmark {

/// Wall-clock seconds since its construction.
class Stopwatch {
public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Takes every measurement once per round, one after the other, so that whatever else the machine does meets all of
/// them alike. Returns the median of each.
template <class T, class Less>
std::vector<T> interleaved_medians(int rounds, const std::vector<std::function<T()>>& measurements, Less less)
{
  std::vector<std::vector<T>> taken(measurements.size());
  for(int round = 0; round < rounds; ++round)
    for(std::size_t i = 0; i < measurements.size(); ++i)
      taken[i].push_back(measurements[i]());
  std::vector<T> medians;
  for(std::vector<T>& samples : taken) {
    const auto middle = samples.begin() + samples.size() / 2;
    std::nth_element(samples.begin(), middle, samples.end(), less);
    medians.push_back(*middle);
  }
  return medians;
}

} // namespace benchmark

#endif // BENCHMARK_TIMING_H
