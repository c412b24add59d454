// SPDX-License-Identifier: LGPL-3.0-or-later
// What the files of the binding share: arrays of numpy as ranges and meshes, policies by name, Ctrl-C.
// The functions of the module are private: the Python files next to it check shapes and types before they call.

#pragma once

#include <CGAL/Spherical_parameterization/Any_policy.h>
#include <CGAL/Spherical_parameterization/Indexed_triangle_mesh.h>
#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/values/Harmonic_coefficients.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/property_map/function_property_map.hpp>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

namespace py = pybind11;
namespace SP = CGAL::Spherical_parameterization;

typedef SP::Indexed_triangle_mesh Mesh;
typedef py::array_t<double, py::array::c_style> Doubles;

/// The rows of an array (n, 3) where it is: nothing is copied.
template <class Number>
struct Rows {
  explicit Rows(const py::array& array)
    : first_(static_cast<const std::array<Number, 3>*>(array.data())), size_(static_cast<std::size_t>(array.shape(0)))
  {}
  const std::array<Number, 3>* data() const { return first_; }
  std::size_t size() const { return size_; }
  const std::array<Number, 3>* begin() const { return first_; }
  const std::array<Number, 3>* end() const { return first_ + size_; }
  const std::array<Number, 3>& operator[](std::size_t i) const { return first_[i]; }

private:
  const std::array<Number, 3>* first_;
  std::size_t size_;
};

/// Calls f without the interpreter's lock.
template <class F>
auto without_lock(F f)
{
  const py::gil_scoped_release no_lock;
  return f();
}

/// Calls f with the triangles as they are, of 32 or of 64 bits.
template <class F>
auto with_triangles(const py::array& triangles, F f)
{
  if(triangles.itemsize() == sizeof(std::int32_t))
    return f(Rows<std::int32_t>(triangles));
  return f(Rows<std::int64_t>(triangles));
}

/// Needs the interpreter's lock on entry, and gives it up while it reads.
inline Mesh make_mesh(const py::array& points, const py::array& triangles)
{
  return with_triangles(triangles, [&](auto rows) {
    const Rows<double> positions(points);
    const py::gil_scoped_release no_lock;
    return Mesh(positions, rows);
  });
}

/// An array as a property map: row i is the value of the descriptor with number i.
template <class Descriptor, class Value>
struct Array_map {
  typedef Descriptor key_type;
  typedef std::remove_const_t<Value> value_type;
  typedef Value& reference;
  typedef boost::lvalue_property_map_tag category;

  Value* first;

  explicit Array_map(Value* data) : first(data) {}
  template <class Number>
  explicit Array_map(py::array_t<Number, py::array::c_style>& array)
    : first(reinterpret_cast<Value*>(array.mutable_data()))
  {}
  friend reference get(const Array_map& map, Descriptor d) { return map.first[d.idx()]; }
  friend void put(const Array_map& map, Descriptor d, const Value& value) { map.first[d.idx()] = value; }
};

typedef Array_map<Mesh::Vertex_index, const std::array<double, 3>> Sphere; ///< a map that is read only

inline Sphere sphere_of(const Doubles& array)
{
  return Sphere(reinterpret_cast<const std::array<double, 3>*>(array.data()));
}

typedef std::variant<CGAL::Sequential_tag
#ifdef CGAL_LINKED_WITH_TBB
                     ,
                     CGAL::Parallel_tag
#endif
                     >
  Host_policy;

/// "sequential" or "parallel"
inline Host_policy host_policy(const std::string& name)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(name == "parallel")
    return CGAL::Parallel_tag();
#else
  if(name == "parallel")
    throw py::value_error("policy 'parallel': this build has no TBB");
#endif
  if(name != "sequential")
    throw py::value_error("policy '" + name + "': 'sequential' or 'parallel' is needed");
  return CGAL::Sequential_tag();
}

/// Calls f(policy) without the interpreter's lock.
template <class F>
auto on(const std::string& policy, F f)
{
  const Host_policy chosen = host_policy(policy);
  const py::gil_scoped_release no_lock;
  return std::visit(f, chosen);
}

/// The callback of a call: asks Python now and then whether to go on.
struct Watch {
  py::object progress = py::none(); ///< or a callable
  bool was_ctrl_c = false;
  std::chrono::steady_clock::time_point last = {}; ///< long ago: the first call asks

  bool operator()(double fraction)
  {
    constexpr std::chrono::milliseconds interval(50); // the lock may be some way off
    const bool is_last = fraction >= 1;
    if((is_last && progress.is_none()) || (!is_last && std::chrono::steady_clock::now() - last < interval))
      return true;
    const py::gil_scoped_acquire lock;
    try {
      if(PyErr_CheckSignals() != 0)
        throw py::error_already_set();
      const bool is_stopped = !progress.is_none() && progress(fraction).is(py::bool_(false));
      last = std::chrono::steady_clock::now();
      return !is_stopped;
    } catch(py::error_already_set& error) {
      if(!error.matches(PyExc_KeyboardInterrupt))
        throw;
      was_ctrl_c = true;
      return false;
    }
  }
};

/// Calls f(policy, np) as on() does, with named parameters by which Ctrl-C ends it with a KeyboardInterrupt.
template <class F>
auto on_watched(const std::string& policy, F f)
{
  Watch watch;
  try {
    return on(policy, [&](const auto& p) { return f(p, CGAL::parameters::callback(std::ref(watch))); });
  } catch(const SP::Error&) {
    if(!watch.was_ctrl_c)
      throw;
    PyErr_SetNone(PyExc_KeyboardInterrupt);
    throw py::error_already_set();
  }
}

/// Whether options are of a class of methods.py, or of one that inherits from it.
inline bool is_a(const py::object& options, const char* name)
{
  return py::isinstance(options, py::module_::import("spherical_parameterization.methods").attr(name));
}

template <class Number, class... Sizes>
py::array_t<Number, py::array::c_style> make_array(Sizes... sizes)
{
  return py::array_t<Number, py::array::c_style>(std::vector<py::ssize_t>{static_cast<py::ssize_t>(sizes)...});
}

/// Numbers as an array of such sizes, row after row.
template <class... Sizes>
Doubles array_of(const std::vector<double>& numbers, Sizes... sizes)
{
  Doubles array = make_array<double>(sizes...);
  std::copy(numbers.begin(), numbers.end(), array.mutable_data());
  return array;
}

/// A vector of arrays of d numbers as an array (n, d).
template <class Number, class Rows_of_numbers>
py::array_t<Number, py::array::c_style> rows_of(const Rows_of_numbers& rows)
{
  constexpr std::size_t width = std::tuple_size<typename Rows_of_numbers::value_type>::value;
  auto array = make_array<Number>(rows.size(), width);
  std::copy(rows.begin(), rows.end(), reinterpret_cast<std::array<Number, width>*>(array.mutable_data()));
  return array;
}

/// A column of an array (n, d), read from its first number on, as a property map.
inline auto column_at(const double* first, std::size_t columns)
{
  return boost::make_function_property_map<Mesh::Vertex_index>(
    [=](Mesh::Vertex_index v) { return first[columns * static_cast<std::size_t>(v.idx())]; });
}

/// \name Coefficients of harmonics
/// Arrays ((L + 1)^2, d): a row for every l and m, a column for every function.
/// @{

/// Of the array that begins at `first`.
inline SP::Harmonic_coefficients harmonics_at(const double* first, int rows, int columns)
{
  SP::Harmonic_coefficients c(static_cast<int>(std::lround(std::sqrt(rows))) - 1, columns);
  for(int i = 0; i < rows; ++i)
    for(int k = 0; k < columns; ++k)
      c.field_begin(k)[i] = first[i * columns + k];
  return c;
}

inline void write_harmonics(const SP::Harmonic_coefficients& c, double* out)
{
  for(int i = 0; i < c.size(); ++i)
    for(int k = 0; k < c.number_of_fields(); ++k)
      *out++ = c.field_begin(k)[i];
}
/// @}

void add_analysis(py::module_& module);
void add_files(py::module_& module);
void add_harmonics(py::module_& module);
void add_spectrum(py::module_& module);
void add_statistics(py::module_& module);
void add_registration(py::module_& module);
