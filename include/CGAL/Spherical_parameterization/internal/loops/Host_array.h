// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOOPS_HOST_ARRAY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOOPS_HOST_ARRAY_H

#include <boost/core/noinit_adaptor.hpp>

#include <memory>
#include <numeric>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// An array as long as the mesh, of numbers or vectors. What is not given a value is uninitialized: the first to touch
/// the memory, which is when the system maps it, are the threads that fill it.
template <class T>
using Host_array = std::vector<T, boost::noinit_adaptor<std::allocator<T>>>;

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

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOOPS_HOST_ARRAY_H
