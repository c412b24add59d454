// SPDX-License-Identifier: LGPL-3.0-or-later
// The module spherical_parameterization._core: parameterize(), devices, errors. analysis.cpp has what is done with a
// map.

#include "errors.h"

#include "input/any_weights.h"
#include "system/stopwatch.h"

#include <CGAL/Spherical_parameterization/parameterize.h>
#include <CGAL/Spherical_parameterization/version.h>

#include <pybind11/stl.h>

#include <optional>
#include <sstream>

using namespace pybind11::literals;

namespace {

/// Writes to an array, and knows whether it has.
struct Sphere_map {
  typedef Mesh::Vertex_index key_type;
  typedef std::array<double, 3> value_type;
  typedef const value_type& reference;
  typedef boost::read_write_property_map_tag category;

  value_type* first;
  bool* is_written;

  friend reference get(const Sphere_map& map, key_type v) { return map.first[v.idx()]; }
  friend void put(const Sphere_map& map, key_type v, const value_type& p)
  {
    map.first[v.idx()] = p;
    *map.is_written = true;
  }
};

/// The parts of the object `weights` that are needed without the interpreter's lock.
struct Weight_settings {
  std::string name;
  double minimum_angle = 5, maximum_angle = 85;
  Doubles array; ///< empty unless it was given

  explicit Weight_settings(const py::object& weights)
  {
    if(py::isinstance<py::array>(weights))
      array = Doubles(weights);
    else if(py::isinstance<py::str>(weights))
      name = py::str(weights);
    else {
      name = "clamped";
      minimum_angle = weights.attr("minimum_angle").cast<double>();
      maximum_angle = weights.attr("maximum_angle").cast<double>();
    }
  }

  tool::Any_weights weights(const Mesh& mesh) const
  {
    if(array.size() > 0) // one number per halfedge of an array (m, 3): column k is the edge from corner k to the next
      return tool::weight_map(Array_map<Mesh::Edge_index, const double>(array.data()));
    return tool::weights_of(mesh, name, minimum_angle, maximum_angle);
  }
};

std::variant<SP::Balanced, SP::Saddle_point, SP::Isometric, SP::Automatic> method_of(const py::object& options)
{
  const auto number = [&](const char* option) { return options.attr(option).cast<double>(); };
  const auto exponent = [&] { return options.attr("area_exponent").cast<std::optional<double>>(); };
  const auto word = [&](const char* option) { return options.attr(option).cast<std::string>(); };
  if(is_a(options, "Automatic"))
    return SP::Automatic{number("spring_exponent"), exponent(), number("largest_shrinkage")};
  if(is_a(options, "Isometric"))
    return SP::Isometric{exponent(), number("landmark_weight")};
  if(is_a(options, "Balanced"))
    return SP::Balanced{number("spring_exponent")};
  SP::Saddle_point method;
  if(word("splitting") == "gauss-seidel")
    method.splitting = SP::Saddle_point::Splitting::GAUSS_SEIDEL;
  if(word("start") != "centroid")
    method.start = word("start") == "given" ? SP::Saddle_point::Start::GIVEN : SP::Saddle_point::Start::HARMONIC;
  method.relaxation = number("relaxation");
  method.check_interval = options.attr("check_interval").cast<std::size_t>();
  return method;
}

SP::Any_policy policy_of(const py::object& policy)
{
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
  if(py::isinstance<SP::OpenCL_device>(policy))
    return policy.cast<SP::OpenCL_device>();
#endif
  return std::visit([](auto host) -> SP::Any_policy { return host; }, host_policy(py::str(policy)));
}

py::tuple to_python(const SP::Result::Seconds& s)
{
  return py::make_tuple(s.read, s.weights, s.start_map, s.solve, s.certify, s.total);
}

py::object to_python(const std::optional<SP::Termination>& termination)
{
  return termination ? py::cast(SP::get_termination_name(*termination)) : py::none();
}

py::dict to_python(const SP::Result& r)
{
  py::list attempts;
  for(const SP::Result::Attempt& a : r.attempts)
    attempts.append(
      py::make_tuple(a.method, SP::get_error_name(a.error), a.detail, to_python(a.seconds), to_python(a.termination)));
  std::ostringstream text;
  text << r;
  return py::dict("error"_a = SP::get_error_name(r.error), "detail"_a = r.detail,
                  "number_of_vertices"_a = r.number_of_vertices, "number_of_faces"_a = r.number_of_faces,
                  "flipped_faces"_a = r.flipped_faces, "moved_vertices"_a = r.moved_vertices, "degree"_a = r.degree,
                  "residual"_a = r.residual, "energy"_a = r.energy, "density_deviation"_a = r.density_deviation,
                  "smallest_area"_a = r.smallest_area, "smallest_edge"_a = r.smallest_edge, "method"_a = r.method,
                  "fallback_reason"_a = r.fallback_reason, "termination"_a = to_python(r.termination),
                  "start_iterations"_a = r.start_iterations, "iterations"_a = r.iterations, "sweeps"_a = r.sweeps,
                  "seconds"_a = to_python(r.seconds), "attempts"_a = attempts, "device"_a = r.device,
                  "text"_a = text.str());
}

/// Maps to `sphere`, which holds what is given of the map on entry. Returns the fields of the Result, whether there is
/// a map, and whether Ctrl-C has ended the call.
py::tuple parameterize(const Doubles& points, const py::array& triangles, const py::object& method_options,
                       const py::object& weight_options, const py::object& policy_options, const py::object& fixed,
                       const std::optional<Doubles>& density, Doubles sphere, std::optional<double> accuracy,
                       std::optional<std::size_t> iterations, double maximum_running_time, bool verbose,
                       const py::object& progress)
{
  const auto method = method_of(method_options);
  const Weight_settings weights(weight_options);
  const SP::Any_policy policy = policy_of(policy_options);
  const bool* const is_fixed = fixed.is_none() ? nullptr : fixed.cast<py::array_t<bool>>().data();
  const auto is_constrained = boost::make_function_property_map<Mesh::Vertex_index>(
    [is_fixed](Mesh::Vertex_index v) { return is_fixed && is_fixed[v.idx()]; });
  std::optional<Array_map<Mesh::Vertex_index, const double>> of_vertices;
  std::optional<Array_map<Mesh::Face_index, const double>> of_faces;
  if(density && density->size() == points.shape(0))
    of_vertices.emplace(density->data());
  else if(density)
    of_faces.emplace(density->data());
  bool has_map = false;
  const Sphere_map sphere_map{reinterpret_cast<std::array<double, 3>*>(sphere.mutable_data()), &has_map};
  Watch watch{progress};

  const SP::Result result = with_triangles(triangles, [&](auto rows) {
    const Rows<double> positions(points);
    const py::gil_scoped_release no_lock;
    return std::visit(
      [&](const auto& chosen_policy, const auto& chosen_method) {
        typedef std::decay_t<decltype(chosen_method)> Method;
        const tool::Stopwatch reading;
        const Mesh mesh(chosen_policy, positions, rows);
        const double seconds_reading = reading.seconds();
        const auto parameters = CGAL::parameters::edge_weight_map(weights.weights(mesh))
                                  .vertex_is_constrained_map(is_constrained)
                                  .accuracy(accuracy.value_or(Method::default_accuracy))
                                  .number_of_iterations(iterations.value_or(Method::default_number_of_iterations))
                                  .maximum_running_time(maximum_running_time)
                                  .callback(std::ref(watch))
                                  .verbose(verbose);
        SP::Result mapped = SP::parameterize(
          chosen_policy, mesh, chosen_method, sphere_map,
          CGAL::parameters::vertex_density_map(of_vertices, CGAL::parameters::face_density_map(of_faces, parameters)));
        mapped.seconds.read += seconds_reading;
        mapped.seconds.total += seconds_reading;
        return mapped;
      },
      policy, method);
  });
  return py::make_tuple(to_python(result), has_map, watch.was_ctrl_c);
}

void add_devices(py::module_& module)
{
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
  typedef SP::OpenCL_device Device;
  py::class_<Device>(module, "OpenCLDevice", "An OpenCL device as policy; `opencl_device()` makes it.")
    .def_property_readonly(
      "name", [](const Device& d) { return d.info().name; }, "What the device is called.")
    .def_property_readonly("is_double_precision", &Device::is_double_precision, "Whether it computes with 64 bits.")
    .def_property_readonly("smallest_mesh", &Device::smallest_mesh, "Meshes with fewer vertices stay on the host.")
    .def("__reduce__",
         [](const Device&) -> py::tuple { throw py::type_error("a device cannot be pickled; pickle its name"); })
    .def("__repr__", [](const Device& d) { return "<OpenCLDevice " + d.info().name + ">"; });
  module.def("opencl_devices", [] {
    py::list devices;
    for(const SP::OpenCL_device_info& d : SP::opencl_devices())
      devices.append(py::dict("platform"_a = d.platform, "name"_a = d.name, "driver"_a = d.driver,
                              "version"_a = d.version, "memory"_a = d.memory,
                              "largest_allocation"_a = d.largest_allocation, "has_fp64"_a = d.has_fp64,
                              "is_gpu"_a = d.is_gpu, "is_cpu"_a = d.is_cpu));
    return devices;
  });
  module.def("opencl_device", [](const std::string& wanted, const std::string& precision, std::size_t smallest_mesh) {
    Device device =
      SP::opencl_device(SP::find_opencl_device(wanted), precision == "double"   ? Device::Precision::DOUBLE
                                                        : precision == "single" ? Device::Precision::SINGLE
                                                                                : Device::Precision::AUTOMATIC);
    return device.set_smallest_mesh(smallest_mesh);
  });
#else
  struct Device {};
  py::class_<Device>(module, "OpenCLDevice", "There is none: this build has no OpenCL.");
  module.def("opencl_devices", [] { return py::list(); });
  module.def("opencl_device", [](const std::string&, const std::string&, std::size_t) {
    throw py::value_error("this build has no OpenCL");
  });
#endif
}

} // namespace

PYBIND11_MODULE(_core, module)
{
  py::register_exception_translator(translate);
  module.attr("__version__") = CGAL_SPHERICAL_PARAMETERIZATION_VERSION;
  module.def("parameterize", parameterize);
  module.def("error_codes", [] {
#define NAME_AND_SENTENCE(name, sentence) {#name, sentence},
    return std::vector<std::pair<std::string, std::string>>{CGAL_SP_ERROR_CODES(NAME_AND_SENTENCE)};
  });
  add_devices(module);
  add_analysis(module);
  add_files(module);
  add_harmonics(module);
  add_spectrum(module);
  add_statistics(module);
  add_registration(module);
}
