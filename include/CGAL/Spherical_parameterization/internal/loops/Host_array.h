// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOOPS_HOST_ARRAY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOOPS_HOST_ARRAY_H

#include <cstddef>
#include <cstdint>
#include <new>
#include <numeric>
#include <utility>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>
#endif

/// \cond SKIP_IN_MANUAL

namespace CGAL::Spherical_parameterization {

/// In bytes; more than any array has where there is no way to ask for one.
#ifdef __linux__
constexpr std::size_t large_page = 1 << 21;
#else
constexpr std::size_t large_page = ~(~std::size_t(0) >> 1);
#endif

/// Asks Linux for pages of 2 MB instead of 4 kB, as NumPy does. Where the system is set to give them only to those who
/// ask, a process maps, clears and looks up 512 times as many pages without that: it took a third of the time of a map
/// of 1.7 million vertices. The last bytes, of less than a page, are left as they are: the rest of it would be wasted.
/// \param p  a multiple of `large_page`
inline void use_large_pages([[maybe_unused]] void* p, [[maybe_unused]] std::size_t bytes)
{
#ifdef __linux__
  madvise(p, bytes / large_page * large_page, MADV_HUGEPAGE); // who refuses it gives small ones
#endif
}

namespace internal {

/// Memory straight from the system, at a multiple of `large_page`. glibc's `new` would soon take it from its heap,
/// where multiples of 2 MB leave gaps that stay with the process: a map took up to a quarter more.
inline void* map_memory([[maybe_unused]] std::size_t bytes)
{
#ifdef __linux__
  const std::size_t page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE)), size = (bytes + page - 1) / page * page;
  void* const mapped = mmap(nullptr, size + large_page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if(mapped == MAP_FAILED)
    throw std::bad_alloc();
  char* const begin = static_cast<char*>(mapped);
  const std::size_t before = large_page - reinterpret_cast<std::uintptr_t>(begin) % large_page;
  char* const p = begin + before;
  munmap(begin, before);
  if(before < large_page)
    munmap(p + size, large_page - before);
  use_large_pages(p, size);
  return p;
#else
  throw std::bad_alloc();
#endif
}

inline void unmap_memory([[maybe_unused]] void* p, [[maybe_unused]] std::size_t bytes) noexcept
{
#ifdef __linux__
  munmap(p, bytes);
#endif
}

/// Large pages where they fit in, and elements that are given no value are not initialized.
template <class T>
struct Large_array_allocator {
  typedef T value_type;

  Large_array_allocator() = default;
  template <class U>
  Large_array_allocator(const Large_array_allocator<U>&) noexcept
  {}

  T* allocate(std::size_t n)
  {
    const std::size_t bytes = n * sizeof(T);
    return static_cast<T*>(bytes < large_page ? ::operator new(bytes) : map_memory(bytes));
  }

  void deallocate(T* p, std::size_t n) noexcept
  {
    const std::size_t bytes = n * sizeof(T);
    if(bytes < large_page)
      ::operator delete(p);
    else
      unmap_memory(p, bytes);
  }

  template <class U>
  void construct(U* p)
  {
    ::new(static_cast<void*>(p)) U;
  }
  template <class U, class... Arguments>
  void construct(U* p, Arguments&&... arguments)
  {
    ::new(static_cast<void*>(p)) U(std::forward<Arguments>(arguments)...);
  }

  friend bool operator==(const Large_array_allocator&, const Large_array_allocator&) { return true; }
  friend bool operator!=(const Large_array_allocator&, const Large_array_allocator&) { return false; }
};

/// An array as long as a mesh, of numbers or vectors, in the memory of the host. The first to touch that, which is when
/// the system maps it, are the threads that fill it.
template <class T>
using Host_array = std::vector<T, Large_array_allocator<T>>;

/// The numbers 0 ... n-1 by their keys, which are below `keys`, in ascending order for each key; those with negative
/// keys are left out. `begin` gets where the numbers of each key begin, and in the end where the last ones end.
template <class Offsets, class Key>
Host_array<int> sorted_by_key(int n, int keys, Offsets& begin, Key key)
{
  begin.assign(keys + 1, 0);
  for(int i = 0; i < n; ++i)
    if(key(i) >= 0)
      ++begin[key(i) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  Offsets next(begin.begin(), begin.end() - 1);
  Host_array<int> sorted(begin.back());
  for(int i = 0; i < n; ++i)
    if(key(i) >= 0)
      sorted[next[key(i)]++] = i;
  return sorted;
}

} // namespace internal

/// For readers of files: an `Indexed_triangle_mesh` takes it over.
template <class T>
using Large_array = internal::Host_array<T>;

} // namespace CGAL::Spherical_parameterization

/// \endcond

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOOPS_HOST_ARRAY_H
