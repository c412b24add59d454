// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>
#include <functional>

namespace tool {

/// Stores what was computed; empty if there is nothing, as after an interruption.
typedef std::function<void()> Store;

/// Calls `compute(i)` for all i below `count`, on this thread and so many more that they are `threads`, or as many as
/// the system has; and what it returns, once, on one thread at a time.
///
/// Begins no more of them after SIGINT or SIGTERM, if they are watched for, and after an exception, the first of which
/// it throws when all threads have ended.
void compute_in_parallel(std::size_t count, int threads, const std::function<Store(std::size_t)>& compute);

} // namespace tool
