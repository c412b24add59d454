// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "system/interruption.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace tool {

/// Stores what was computed; empty if there is nothing, as after an interruption.
typedef std::function<void()> Store;

/// Calls `compute(i)` for all i below `count`, on this thread and so many more that they are `threads`, or as many as
/// the system has; and what it returns, once, on one thread at a time.
///
/// Begins no more of them after a signal, if they are watched for, and after an exception, the first of which
/// it throws when all threads have ended.
inline void compute_in_parallel(std::size_t count, int threads, const std::function<Store(std::size_t)>& compute)
{
  std::atomic<std::size_t> begun{0};
  std::atomic<bool> has_failed{false};
  std::exception_ptr error;
  std::mutex mutex; // of what stores, and of the error
  const auto work = [&] {
    try {
      for(std::size_t i; !has_failed && !was_interrupted() && (i = begun++) < count;)
        if(const Store store = compute(i)) {
          const std::lock_guard<std::mutex> lock(mutex);
          store();
        }
    } catch(...) {
      const std::lock_guard<std::mutex> lock(mutex);
      if(!has_failed.exchange(true))
        error = std::current_exception();
    }
  };

  std::vector<std::thread> others;
  try {
    for(std::size_t i = 1; i < std::min(count, static_cast<std::size_t>(threads)); ++i)
      others.emplace_back(work);
  } catch(const std::system_error&) { // there are no more of them
  } catch(const std::bad_alloc&) {    // nor is there memory for them
  }
  work();
  for(std::thread& other : others)
    other.join();
  if(error)
    std::rethrow_exception(error);
}

} // namespace tool
