// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef BENCHMARK_MEASURE_H
#define BENCHMARK_MEASURE_H

#include <algorithm>
#include <chrono>
#include <iterator>
#include <string>
#include <vector>

namespace benchmark {

/// Wall-clock seconds since its construction.
class Stopwatch {
public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Calls `measure` for every item once per round, one after the other, so that whatever else the machine does meets all
/// of them alike. Returns for each what has the median of `key`.
template <class Items, class Measure, class Key>
auto interleaved_medians(int rounds, const Items& items, Measure measure, Key key)
{
  typedef decltype(measure(*std::begin(items))) Measurement;
  std::vector<std::vector<Measurement>> taken(std::size(items));
  for(int round = 0; round < rounds; ++round)
    for(std::size_t i = 0; i < taken.size(); ++i)
      taken[i].push_back(measure(items[i]));
  std::vector<Measurement> medians;
  for(std::vector<Measurement>& samples : taken) {
    const auto middle = samples.begin() + samples.size() / 2;
    std::nth_element(samples.begin(), middle, samples.end(),
                     [&](const Measurement& a, const Measurement& b) { return key(a) < key(b); });
    medians.push_back(*middle);
  }
  return medians;
}

/// The machine and the software under which a figure was measured, and when, as lines of text.
std::vector<std::string> machine_description();

/// By how much the resident memory of this process has risen, at its highest, since construction. What the process has
/// freed before is handed back to the system first, since memory that is used again would not count.
class Peak_memory {
public:
  Peak_memory();
  double growth() const; ///< in bytes; NaN where the system does not tell (Linux does)

private:
  double before_;
};

} // namespace benchmark

#endif // BENCHMARK_MEASURE_H
