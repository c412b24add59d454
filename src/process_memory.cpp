// SPDX-License-Identifier: GPL-3.0-or-later

#include "process_memory.h"

#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>

#ifdef __GLIBC__ // which the headers above define

#include <malloc.h>

using CGAL::Spherical_parameterization::large_page;

void* operator new(std::size_t size)
{
  void* const p = size < large_page ? std::malloc((std::max)(size, std::size_t(1)))
                                    : std::aligned_alloc(large_page, (size / large_page + 1) * large_page);
  if(!p)
    throw std::bad_alloc();
  if(size >= large_page)
    CGAL::Spherical_parameterization::use_large_pages(p, size);
  return p;
}

void operator delete(void* p) noexcept { std::free(p); }

void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace {

/// A stack that cannot grow later, for want of memory, is a crash and not a bad_alloc. Products of Eigen's matrices
/// take up to 256 kB of it.
void grow_stack()
{
  constexpr std::size_t size = 1 << 19, page = 1 << 12;
  [[maybe_unused]] volatile char stack[size];
  for(std::size_t i = 0; i < size; i += page)
    stack[i] = 0;
}

} // namespace

void tool::manage_memory()
{
  grow_stack();
  mallopt(M_MMAP_THRESHOLD, large_page); // fixed: what is above goes back to the system
  mallopt(M_TRIM_THRESHOLD, 1 << 26);
}

#else

void tool::manage_memory() {}

#endif
