// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef BENCHMARK_MACHINE_H
#define BENCHMARK_MACHINE_H

#include <string>
#include <vector>

namespace benchmark {

/// The machine and the software under which a figure was measured, and when, as lines of text.
std::vector<std::string> machine_description();

} // namespace benchmark

#endif // BENCHMARK_MACHINE_H
