// SPDX-License-Identifier: LGPL-3.0-or-later
// Registration of two maps.

#include "arrays.h"

#include <CGAL/Spherical_parameterization/moebius_centring.h>
#include <CGAL/Spherical_parameterization/register_maps.h>
#include <CGAL/Spherical_parameterization/rigid_path.h>

#include <pybind11/stl.h>

#include <utility>

namespace {

typedef Array_map<Mesh::Vertex_index, std::array<double, 3>> Written_sphere;

/// Whether Ctrl-C has ended the call; the registered map and the figures, in the order of the fields of RegisteredMap.
py::tuple register_maps(const Doubles& points_a, const py::array& triangles_a, const Doubles& sphere_a,
                        const Doubles& points_b, const py::array& triangles_b, const Doubles& sphere_b,
                        const std::string& motion, double curvature_weight, double stretch_weight,
                        double isometry_weight, double position_weight,
                        const std::vector<std::tuple<std::vector<double>, std::vector<double>, double>>& features,
                        double landmark_weight, const std::vector<std::pair<int, int>>& pairs,
                        const std::string& policy, double maximum_running_time, const py::object& progress)
{
  const Mesh a = make_mesh(points_a, triangles_a), b = make_mesh(points_b, triangles_b);
  const Sphere images_a = sphere_of(sphere_a), images_b = sphere_of(sphere_b);
  SP::Registration method;
  method.motion = motion == "rotation"  ? SP::Registration::Motion::ROTATION
                  : motion == "moebius" ? SP::Registration::Motion::MOEBIUS
                                        : SP::Registration::Motion::DEFORMATION;
  method.curvature_weight = curvature_weight;
  method.stretch_weight = stretch_weight;
  method.isometry_weight = isometry_weight;
  method.position_weight = position_weight;
  for(const auto& [of_a, of_b, weight] : features)
    method.features.push_back({of_a, of_b, weight});
  method.landmark_weight = landmark_weight;
  std::vector<SP::Landmark_pair<Mesh, Mesh>> landmarks;
  for(const auto& [i, j] : pairs)
    landmarks.emplace_back(Mesh::Vertex_index(i), Mesh::Vertex_index(j));
  Doubles registered = make_array<double>(a.number_of_vertices(), 3);
  const Written_sphere out(registered);
  Watch watch{progress};
  const auto parameters = CGAL::parameters::maximum_running_time(maximum_running_time).callback(std::ref(watch));
  const SP::Registration_result r = on(policy, [&](const auto& p) {
    return SP::register_maps(p, SP::mapped_mesh(a, images_a), SP::mapped_mesh(b, images_b), out, method, landmarks,
                             parameters);
  });
  const bool is_complete = r.error != SP::Error_code::INTERRUPTED;
  if(!r && is_complete)
    throw SP::Error(r.error, r.detail);
  return py::make_tuple(watch.was_ctrl_c, registered, is_complete, r.start, r.margin, r.signature_difference,
                        SP::get_trust_name(r.trust()), r.rotation, r.mismatch_before, r.mismatch, r.stretching,
                        r.distortion, r.largest_landmark_distance, r.iterations, r.seconds.total);
}

std::pair<Doubles, double> moebius_centred(const Doubles& sphere, const py::array& triangles, const Doubles& masses)
{
  const Mesh mesh = make_mesh(sphere, triangles);
  Doubles centred = make_array<double>(mesh.number_of_vertices(), 3);
  const double distance =
    SP::moebius_centred_map(mesh, sphere_of(sphere), column_at(masses.data(), 1), Written_sphere(centred));
  return {centred, distance};
}

/// The places of the points at steps + 1 times.
py::array morph(const Doubles& points, const Doubles& others, int steps)
{
  const auto size = static_cast<std::size_t>(points.shape(0));
  py::array_t<double, py::array::c_style> all = make_array<double>(steps + 1, size, 3);
  auto* const out = reinterpret_cast<std::array<double, 3>*>(all.mutable_data());
  const py::gil_scoped_release no_lock;
  const auto path = SP::rigid_path(Rows<double>(points), Rows<double>(others));
  for(int step = 0; step <= steps; ++step) {
    const auto places = path(double(step) / steps);
    std::copy(places.begin(), places.end(), out + static_cast<std::size_t>(step) * size);
  }
  return std::move(all);
}

} // namespace

void add_registration(py::module_& module)
{
  module.def("register_maps", register_maps);
  module.def("moebius_centred", moebius_centred);
  module.def("morph", morph);
}
