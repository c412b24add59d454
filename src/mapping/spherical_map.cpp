// SPDX-License-Identifier: GPL-3.0-or-later

#include "mapping/spherical_map.h"

#include "input/any_weights.h"

#include <CGAL/Spherical_parameterization/parameterize.h>

#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace tool {

SP::Any_policy make_policy(const Mapping_options& options)
{
  if(options.policy == "sequential")
    return CGAL::Sequential_tag();
#ifdef CGAL_LINKED_WITH_TBB
  if(options.policy == "tbb")
    return CGAL::Parallel_tag();
#endif
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
  if(options.policy == "opencl") {
    using Precision = SP::OpenCL_device::Precision;
    const Precision precision = options.precision == "double"   ? Precision::DOUBLE
                                : options.precision == "single" ? Precision::SINGLE
                                                                : Precision::AUTOMATIC;
    // One for all meshes, whose kernels are compiled once. Never deleted: drivers crash after main().
    static std::mutex mutex;
    static auto& devices = *new std::map<std::pair<std::string, Precision>, SP::OpenCL_device>;
    const std::lock_guard<std::mutex> lock(mutex);
    const std::pair key(options.device, precision);
    auto device = devices.find(key);
    if(device == devices.end())
      device = devices.emplace(key, SP::opencl_device(SP::find_opencl_device(options.device), precision)).first;
    return device->second;
  }
#endif
  throw std::invalid_argument("unknown policy '" + options.policy + "'");
}

Any_method method_of(const Mapping_options& options)
{
  if(options.method == "balanced")
    return SP::Balanced{options.spring_exponent};
  if(options.method == "isometric")
    return SP::Isometric{options.area_exponent, options.landmark_weight.value_or(SP::Isometric().landmark_weight)};
  if(options.method == "automatic") {
    SP::Automatic method;
    method.spring_exponent = options.spring_exponent;
    method.area_exponent = options.area_exponent;
    method.largest_shrinkage = options.largest_shrinkage;
    return method;
  }
  SP::Saddle_point method;
  if(options.splitting == "gauss-seidel")
    method.splitting = SP::Saddle_point::Splitting::GAUSS_SEIDEL;
  if(options.start == "harmonic")
    method.start = SP::Saddle_point::Start::HARMONIC;
  method.relaxation = options.relaxation;
  method.check_interval = static_cast<std::size_t>(options.check_interval);
  return method;
}

SP::Result map_to_sphere(const Mesh& mesh, Sphere& sphere, const Mapping_options& options, const Map_data& data,
                         const std::function<bool(double)>& go_on)
{
  const std::size_t n = mesh.number_of_vertices();
  std::vector<bool> is_fixed(n, false);
  sphere.clear();
  if(!data.fixed_vertices.empty())
    sphere.resize(n);
  for(const Fixed_vertex& fixed : data.fixed_vertices) {
    is_fixed[fixed.index] = true;
    sphere[fixed.index] = fixed.position;
  }
  const auto is_fixed_map = boost::make_function_property_map<Mesh::Vertex_index>(
    [&is_fixed](Mesh::Vertex_index v) -> bool { return is_fixed[static_cast<std::size_t>(v.idx())]; });
  // Where nothing is read from it, the sphere takes its memory when the solver has given its own back.
  const auto sphere_map =
    boost::make_function_property_map<Mesh::Vertex_index>([&sphere, n](Mesh::Vertex_index v) -> Point& {
      if(sphere.empty())
        sphere.resize(n);
      return sphere[static_cast<std::size_t>(v.idx())];
    });
  const Any_weights weights = weights_of(mesh, options.weights, options.min_angle, options.max_angle);

  const auto densities = [&data](auto descriptor, std::size_t number) {
    return data.density.size() == number ? std::optional(as_map<decltype(descriptor)>(data.density)) : std::nullopt;
  };
  const auto of_vertices = densities(Mesh::Vertex_index(), n);
  const auto of_faces = densities(Mesh::Face_index(), of_vertices ? 0 : mesh.number_of_faces());

  return std::visit(
    [&](const auto& policy, const auto& method) {
      using Method = std::decay_t<decltype(method)>;
      const auto common = CGAL::parameters::edge_weight_map(weights)
                            .vertex_is_constrained_map(is_fixed_map)
                            .accuracy(options.accuracy.value_or(Method::default_accuracy))
                            .number_of_iterations(static_cast<std::size_t>(
                              options.iterations.value_or(Method::default_number_of_iterations)))
                            .maximum_running_time(options.max_time.value_or(std::numeric_limits<double>::infinity()))
                            .callback(go_on);
      return SP::parameterize(
        policy, mesh, method, sphere_map,
        CGAL::parameters::vertex_density_map(of_vertices, CGAL::parameters::face_density_map(of_faces, common)));
    },
    data.policy, method_of(options));
}

} // namespace tool
