// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_OPENCL_CALL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_OPENCL_CALL_H

#include <CGAL/Spherical_parameterization/OpenCL_error.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Throws an OpenCL_error unless `code` is CL_SUCCESS.
inline void check_opencl(cl_int code, const char* call)
{
  if(code != CL_SUCCESS)
    throw OpenCL_error(call, code);
}

/// The answer of the query `get` (clGetDeviceInfo, ...) about `object` under `key`: a number or a handle.
template <class T, class Query, class Object>
T opencl_value(Query get, const char* call, Object object, cl_uint key)
{
  T value = T();
  check_opencl(get(object, key, sizeof(T), &value, nullptr), call);
  return value;
}

/// A list of values.
template <class T, class Query, class Object>
std::vector<T> opencl_values(Query get, const char* call, Object object, cl_uint key)
{
  std::size_t bytes = 0;
  check_opencl(get(object, key, 0, nullptr, &bytes), call);
  std::vector<T> values(bytes / sizeof(T));
  if(!values.empty())
    check_opencl(get(object, key, bytes, values.data(), nullptr), call);
  return values;
}

/// A text, without blanks and null characters at its ends, which some drivers add.
template <class Query, class Object>
std::string opencl_text(Query get, const char* call, Object object, cl_uint key)
{
  const std::vector<char> characters = opencl_values<char>(get, call, object, key);
  std::string text(characters.begin(), characters.end());
  text.erase(text.find_last_not_of(std::string(" \n\0", 3)) + 1);
  return text.substr(text.find_first_not_of(' ') == std::string::npos ? 0 : text.find_first_not_of(' '));
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_OPENCL_CALL_H
