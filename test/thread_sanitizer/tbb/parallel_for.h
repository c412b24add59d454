// SPDX-License-Identifier: GPL-3.0-or-later
// Stands in for the header of TBB where the thread sanitizer checks our code: it sees nothing of how the threads inside
// the library wait for each other, and takes all that they share for races. Here they are plain threads. Neighbouring
// indices are always on different ones.

#ifndef TEST_THREAD_SANITIZER_TBB_PARALLEL_FOR_H
#define TEST_THREAD_SANITIZER_TBB_PARALLEL_FOR_H

#include <tbb/blocked_range.h>

#include <array>
#include <exception>
#include <thread>
#include <vector>

namespace tbb {

template <class Index, class F>
void parallel_for(const blocked_range<Index>& range, const F& f)
{
  constexpr int number_of_threads = 4;
  std::array<std::exception_ptr, number_of_threads> thrown; // a loop that is interrupted is left by an exception
  const auto work = [&](int first) {
    try {
      for(Index i = range.begin() + first; i < range.end(); i += number_of_threads)
        f(blocked_range<Index>(i, i + 1));
    } catch(...) {
      thrown[first] = std::current_exception();
    }
  };
  std::vector<std::thread> threads;
  for(int k = 1; k < number_of_threads && range.begin() + k < range.end(); ++k)
    threads.emplace_back(work, k);
  work(0);
  for(std::thread& thread : threads)
    thread.join();
  for(const std::exception_ptr& one : thrown)
    if(one)
      std::rethrow_exception(one);
}

} // namespace tbb

#endif // TEST_THREAD_SANITIZER_TBB_PARALLEL_FOR_H
