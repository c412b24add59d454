// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BASE_HOST_ARRAY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BASE_HOST_ARRAY_H

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Leaves what is not given a value uninitialized.
template <class T>
struct Uninitialized_allocator : std::allocator<T> {
  template <class U>
  struct rebind {
    typedef Uninitialized_allocator<U> other;
  };

  template <class U>
  void construct(U* at)
  {
    ::new(static_cast<void*>(at)) U;
  }
  template <class U, class... Arguments>
  void construct(U* at, Arguments&&... arguments)
  {
    ::new(static_cast<void*>(at)) U(std::forward<Arguments>(arguments)...);
  }
};

/// An array as long as the mesh, of numbers or vectors. The first to touch its memory, which is when the system maps
/// it, are the threads that fill it.
template <class T>
using Host_array = std::vector<T, Uninitialized_allocator<T>>;

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BASE_HOST_ARRAY_H
