// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <chrono>

namespace tool {

/// Begins with its life.
class Stopwatch {
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();

public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
};

} // namespace tool
