// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOOPS_HOST_ARRAY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOOPS_HOST_ARRAY_H

#include <boost/core/noinit_adaptor.hpp>

#include <memory>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// An array as long as the mesh, of numbers or vectors. What is not given a value is uninitialized: the first to touch
/// the memory, which is when the system maps it, are the threads that fill it.
template <class T>
using Host_array = std::vector<T, boost::noinit_adaptor<std::allocator<T>>>;

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOOPS_HOST_ARRAY_H
