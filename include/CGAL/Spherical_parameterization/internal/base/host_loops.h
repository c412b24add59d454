// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BASE_HOST_LOOPS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BASE_HOST_LOOPS_H

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include <CGAL/tags.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <vector>

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_COMPILED_WITHOUT_TBB
#ifdef CGAL_LINKED_WITH_TBB
#error "the compiled library was built without TBB, and this file is compiled with it: build the library with TBB"
#endif
#elif defined(CGAL_SPHERICAL_PARAMETERIZATION_COMPILED_WITH_TBB) && !defined(CGAL_LINKED_WITH_TBB)
#error "the compiled library was built with TBB: link CGAL::TBB_support, too"
#endif

namespace CGAL::Spherical_parameterization::internal {

/// Runs f(0) ... f(count-1) on the calling thread.
struct Sequential_loop {
  static int concurrency() { return 1; }

  template <class F>
  void for_each(int count, F f) const
  {
    for(int i = 0; i < count; ++i)
      f(i);
  }
};

#ifdef CGAL_LINKED_WITH_TBB
/// Runs f(0) ... f(count-1) in any order on the threads of the caller's TBB arena.
struct Parallel_loop {
  static int concurrency() { return tbb::this_task_arena::max_concurrency(); }

  template <class F>
  void for_each(int count, F f) const
  {
    run(count, [&f](int begin, int end) {
      for(int i = begin; i < end; ++i)
        f(i);
    });
  }

private:
  /// No template, so that TBB's are instantiated once, and not for every loop.
  static void run(int count, const std::function<void(int, int)>& f)
  {
    tbb::parallel_for(tbb::blocked_range<int>(0, count),
                      [&f](const tbb::blocked_range<int>& range) { f(range.begin(), range.end()); });
  }
};

typedef Parallel_loop Default_loop;
#else
typedef Sequential_loop Default_loop;
#endif

/// What an execution policy runs loops of the host with: a device leaves them to all cores.
template <class ExecutionPolicy>
struct Loop_of {
  typedef Default_loop type;
};
template <>
struct Loop_of<CGAL::Sequential_tag> {
  typedef Sequential_loop type;
};

/// One of these loops. What takes it is compiled once, and not for each of them: for steps that are long, like parts.
class Host_loop {
public:
  template <class Loop = Sequential_loop>
  Host_loop(const Loop& loop = Loop())
    : run_([loop](int count, const std::function<void(int)>& f) { loop.for_each(count, std::cref(f)); })
  {}

  template <class F>
  void for_each(int count, F f) const
  {
    run_(count, std::ref(f));
  }

private:
  std::function<void(int, const std::function<void(int)>&)> run_;
};

/// The parts into which 0 ... n-1 is cut; the same for any number of threads.
inline constexpr int part_size = 8192;

/// Runs f(begin, end) on consecutive parts of 0 ... n-1, in any order.
template <int Size = part_size, class Loop, class F>
void for_each_part(const Loop& loop, int n, F f)
{
  loop.for_each(n / Size + 1, [&](int part) { f(part * Size, (std::min)(n, (part + 1) * Size)); });
}

/// Runs f(0) ... f(n-1), part by part: what is small is better run so.
template <int Size = part_size, class Loop, class F>
void for_each_index(const Loop& loop, int n, F f)
{
  for_each_part<Size>(loop, n, [&](int begin, int end) {
    for(int i = begin; i < end; ++i)
      f(i);
  });
}

/// The results of f(begin, end) on these parts, in their order.
template <int Size = part_size, class Loop, class F>
auto results_of_parts(const Loop& loop, int n, F f)
{
  std::vector<decltype(f(0, 0))> results(n / Size + 1);
  for_each_part<Size>(loop, n, [&](int begin, int end) { results[begin / Size] = f(begin, end); });
  return results;
}

/// f(0) + ... + f(n-1), part by part.
template <int Size = part_size, class Loop, class F>
double sum_by_parts(const Loop& loop, int n, F f)
{
  const auto sum_of_part = [&](int begin, int end) {
    double sum = 0;
    for(int i = begin; i < end; ++i)
      sum += f(i);
    return sum;
  };
  double total = 0;
  for(double sum : results_of_parts<Size>(loop, n, sum_of_part))
    total += sum;
  return total;
}

/// The smallest i in 0 ... n-1 for which `holds(i)`, or n: the same for any number of threads.
template <class Loop, class Predicate>
int first_index(const Loop& loop, int n, Predicate holds)
{
  std::atomic<int> first(n);
  for_each_part(loop, n, [&](int begin, int end) {
    for(int i = begin; i < (std::min)(end, first.load(std::memory_order_relaxed)); ++i)
      if(holds(i)) {
        int known = first;
        while(i < known && !first.compare_exchange_weak(known, i))
          ;
        return;
      }
  });
  return first;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BASE_HOST_LOOPS_H
