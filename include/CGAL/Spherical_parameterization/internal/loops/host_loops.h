// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOOPS_HOST_LOOPS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOOPS_HOST_LOOPS_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <string>
#include <type_traits>
#include <vector>

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_COMPILED_WITHOUT_TBB
#ifdef CGAL_LINKED_WITH_TBB
#error "the compiled library was built without TBB, and this file is compiled with it: build the library with TBB"
#endif
#elif defined(CGAL_SPHERICAL_PARAMETERIZATION_COMPILED_WITH_TBB) && !defined(CGAL_LINKED_WITH_TBB)
#error "the compiled library was built with TBB: link CGAL::TBB_support, too"
#endif

namespace CGAL::Spherical_parameterization::internal {

// The name tells the two apart: nothing is defined in two ways in a program of which only a part is compiled with TBB.
#ifdef CGAL_LINKED_WITH_TBB
inline namespace with_tbb {
#else
inline namespace without_tbb {
#endif

/// How loops of the host run: on the calling thread, or on all cores.
class Host_loop {
public:
  /// \param on_all_cores  on the threads of the caller's TBB arena; without TBB that is the calling thread, too
  explicit Host_loop(bool on_all_cores = false) : on_all_cores_(on_all_cores) {}

  std::string name() const { return on_all_cores_ ? std::to_string(concurrency()) + " threads" : "one core"; }

  int concurrency() const
  {
#ifdef CGAL_LINKED_WITH_TBB
    if(on_all_cores_)
      return tbb::this_task_arena::max_concurrency();
#endif
    return 1;
  }

  /// Runs f(0) ... f(count-1), in any order.
  template <class F>
  void for_each(int count, F f) const
  {
    const auto run_range = [](void* loop, int begin, int end) {
      for(int i = begin; i < end; ++i)
        (*static_cast<F*>(loop))(i);
    };
#ifdef CGAL_LINKED_WITH_TBB
    run(count, run_range, &f);
#else
    run_range(&f, 0, count);
#endif
  }

private:
#ifdef CGAL_LINKED_WITH_TBB
  /// No template, so that TBB's are instantiated once, and not for every loop.
  void run(int count, void (*run_range)(void*, int, int), void* loop) const
  {
    if(!on_all_cores_ || count <= 1) // a single part would wake other threads in vain
      return run_range(loop, 0, count);
    tbb::parallel_for(tbb::blocked_range<int>(0, count),
                      [=](const tbb::blocked_range<int>& range) { run_range(loop, range.begin(), range.end()); });
  }
#endif

  bool on_all_cores_;
};

} // inline namespace

/// How an execution policy runs loops of the host: a device leaves them to all cores.
template <class ExecutionPolicy>
Host_loop loop_of()
{
  return Host_loop(!std::is_same_v<ExecutionPolicy, CGAL::Sequential_tag>);
}

/// The parts into which 0 ... n-1 is cut; the same for any number of threads.
inline constexpr int part_size = 8192;

/// Runs f(begin, end) on consecutive parts of 0 ... n-1, in any order.
template <int Size = part_size, class Loop, class F>
void for_each_part(const Loop& loop, int n, F f)
{
  loop.for_each(n / Size + 1, [&](int part) {
    const int begin = part * Size;
    f(begin, begin + (std::min)(Size, n - begin)); // begin + Size may be more than an int holds
  });
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
  const std::vector<double> sums = results_of_parts<Size>(loop, n, sum_of_part);
  return std::accumulate(sums.begin(), sums.end(), 0.);
}

/// The smallest i in 0 ... n-1 for which `holds(i)`, or n: the same for any number of threads.
template <class Loop, class Predicate>
int first_index(const Loop& loop, int n, Predicate holds)
{
  const std::vector<int> firsts = results_of_parts(loop, n, [&](int begin, int end) {
    while(begin < end && !holds(begin))
      ++begin;
    return begin < end ? begin : n;
  });
  return *std::min_element(firsts.begin(), firsts.end());
}

/// Calls f(i, corners...) for the faces begin <= i < end, with the values of its three corners in every one of the
/// arrays `at`. Those of later faces are asked for meanwhile: corners may be far apart in memory.
template <class F, class... Arrays>
void for_each_face(const Host_array<std::array<int, 3>>& face, int begin, int end, F f, const Arrays&... at)
{
  constexpr int faces_ahead = 32;
  for(int i = begin; i < end; ++i) {
    if(i < end - faces_ahead)
      for([[maybe_unused]] const int corner : face[i + faces_ahead])
        (__builtin_prefetch(&at[corner]), ...);
    const std::array<int, 3>& corner = face[i];
    f(i, std::array<vec3, 3>{at[corner[0]], at[corner[1]], at[corner[2]]}...);
  }
}

/// The faces f, in their order, for which `holds(f, corners...)`, given their corners in every one of the arrays `at`.
template <class Loop, class Holds, class... Arrays>
std::vector<int> faces_where(const Loop& loop, const Host_array<std::array<int, 3>>& face, Holds holds,
                             const Arrays&... at)
{
  std::vector<int> result;
  for(const std::vector<int>&part : results_of_parts(loop, static_cast<int>(face.size()), [&](int begin, int end) {
        std::vector<int> of_part;
        for_each_face(
          face, begin, end,
          [&](int f, const auto&... corners) {
            if(holds(f, corners...))
              of_part.push_back(f);
          },
          at...);
        return of_part;
      }))
    result.insert(result.end(), part.begin(), part.end());
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOOPS_HOST_LOOPS_H
