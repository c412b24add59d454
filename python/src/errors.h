// SPDX-License-Identifier: LGPL-3.0-or-later
// Exceptions of C++ as those of Python.

#pragma once

#include "arrays.h"

#include "system/refusal.h"

#include <CGAL/assertions.h>
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
#include <CGAL/Spherical_parameterization/values/OpenCL_error.h>
#endif

#include <exception>
#include <utility>

/// An exception of errors.py.
template <class... Arguments>
void raise(const char* type, Arguments&&... arguments)
{
  const py::object exception = py::module_::import("spherical_parameterization.errors").attr(type);
  PyErr_SetObject(exception.ptr(), exception(std::forward<Arguments>(arguments)...).ptr());
}

/// A text that may have the name of a file, which may be no UTF-8.
inline py::object text_of(const char* what)
{
  return py::reinterpret_steal<py::object>(PyUnicode_DecodeFSDefault(what));
}

inline void translate(std::exception_ptr pointer)
{
  try {
    if(pointer)
      std::rethrow_exception(pointer);
  } catch(const SP::Error& error) {
    raise("MeshError", SP::get_error_name(error.code()), error.detail());
  } catch(const tool::Refusal& refusal) { // of a file
    if(refusal.code() == tool::unreadable_file || refusal.code() == tool::unwritable_file ||
       refusal.code() == tool::unwritable_data)
      PyErr_SetObject(PyExc_OSError, text_of(refusal.what()).ptr());
    else
      raise("MeshError", refusal.code(), text_of(refusal.what()));
  } catch(const CGAL::Failure_exception& failure) {
    PyErr_SetString(PyExc_ValueError, failure.message().c_str());
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
  } catch(const SP::OpenCL_error& error) {
    raise("DeviceError", error.what());
#endif
  }
}
