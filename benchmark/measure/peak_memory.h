// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef BENCHMARK_PEAK_MEMORY_H
#define BENCHMARK_PEAK_MEMORY_H

namespace benchmark {

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

#endif // BENCHMARK_PEAK_MEMORY_H
