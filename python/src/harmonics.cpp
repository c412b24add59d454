// SPDX-License-Identifier: LGPL-3.0-or-later
// Spherical harmonics.

#include "arrays.h"

#include <CGAL/Spherical_parameterization/harmonic_alignment.h>
#include <CGAL/Spherical_parameterization/harmonic_files.h>
#include <CGAL/Spherical_parameterization/harmonic_grids.h>
#include <CGAL/Spherical_parameterization/spherical_harmonics.h>

#include <pybind11/stl.h>

#include <sstream>

namespace {

SP::Harmonic_coefficients of_array(const Doubles& array)
{
  return harmonics_at(array.data(), static_cast<int>(array.shape(0)), static_cast<int>(array.shape(1)));
}

Doubles to_array(const SP::Harmonic_coefficients& c)
{
  Doubles array = make_array<double>(c.size(), c.number_of_fields());
  write_harmonics(c, array.mutable_data());
  return array;
}

/// Of all columns; three of them at once are the coordinates of points.
template <class Policy, class Method, class NamedParameters>
SP::Harmonic_analysis analyze(const Policy& policy, const Mesh& mesh, const Sphere& sphere, const double* values,
                              std::size_t columns, int degree, const Method& method, const NamedParameters& np)
{
  if(columns == 3)
    return SP::harmonic_analysis(policy, mesh, sphere, Sphere(reinterpret_cast<const std::array<double, 3>*>(values)),
                                 degree, method, np);
  SP::Harmonic_analysis all;
  all.coefficients = SP::Harmonic_coefficients(degree, static_cast<int>(columns));
  for(std::size_t k = 0; k < columns; ++k) {
    const auto one = SP::harmonic_analysis(policy, mesh, sphere, column_at(values + k, columns), degree, method, np);
    std::copy_n(one.coefficients.field_begin(0), one.coefficients.size(),
                all.coefficients.field_begin(static_cast<int>(k)));
    all.has_converged = all.has_converged && one.has_converged;
    all.iterations = (std::max)(all.iterations, one.iterations);
  }
  return all;
}

py::tuple harmonic_analysis(const py::array& triangles, const Doubles& sphere, const Doubles& values, int degree,
                            const std::string& fit, const std::string& weights, const py::object& points,
                            double accuracy, int iterations, const std::string& policy)
{
  const Mesh mesh = make_mesh(sphere, triangles);
  const Doubles given = points.is_none() ? sphere : Doubles(points);
  const Sphere images = sphere_of(sphere), positions = sphere_of(given);
  const double* const first = values.data();
  const auto columns = static_cast<std::size_t>(values.shape(1));
  SP::Least_squares method;
  method.accuracy = accuracy;
  method.iterations = iterations;
  method.weights = weights == "surface-area" ? SP::Vertex_weights::SURFACE_AREA
                   : weights == "equal"      ? SP::Vertex_weights::EQUAL
                                             : SP::Vertex_weights::SPHERE_AREA;
  const SP::Harmonic_analysis result = on_watched(policy, [&](const auto& p, const auto& watched) {
    const auto np = watched.vertex_point_map(positions);
    if(fit == "integrals")
      return analyze(p, mesh, images, first, columns, degree, SP::Integration{accuracy}, np);
    return analyze(p, mesh, images, first, columns, degree, method, np);
  });
  return py::make_tuple(to_array(result.coefficients), result.has_converged, result.iterations);
}

Doubles harmonic_values(const Doubles& coefficients, const Doubles& directions, const std::string& policy)
{
  const SP::Harmonic_coefficients c = of_array(coefficients);
  const Rows<double> rows(directions);
  const std::vector<double> values =
    on_watched(policy, [&](const auto& p, const auto& np) { return SP::harmonic_values(p, c, rows, np); });
  return array_of(values, rows.size(), c.number_of_fields());
}

/// (d, rows, columns)
Doubles harmonic_grid(const Doubles& coefficients, int rows, int columns, const std::string& policy)
{
  const SP::Harmonic_coefficients c = of_array(coefficients);
  const auto grid = SP::Latitude_longitude_grid::equidistant(rows, columns);
  const std::vector<double> values =
    on_watched(policy, [&](const auto& p, const auto& np) { return SP::harmonic_grid_values(p, c, grid, np); });
  return array_of(values, c.number_of_fields(), rows, columns);
}

Doubles rotated_harmonics(const Doubles& coefficients, const Doubles& rotation)
{
  SP::Rotation r;
  for(std::size_t i = 0; i < 9; ++i)
    r[i / 3][i % 3] = rotation.data()[i];
  const SP::Harmonic_coefficients c = of_array(coefficients);
  return to_array(without_lock([&] { return SP::rotated(c, r); }));
}

SP::Rotation best_rotation(const Doubles& f, const Doubles& g, const std::string& policy)
{
  const SP::Harmonic_coefficients of_f = of_array(f), of_g = of_array(g);
  return on_watched(policy, [&](const auto& p, const auto& np) { return SP::best_rotation(p, of_f, of_g, np); });
}

auto best_alignment(const Doubles& f, const Doubles& g, const std::string& policy)
{
  const SP::Harmonic_coefficients of_f = of_array(f), of_g = of_array(g);
  const SP::Shape_alignment a =
    on_watched(policy, [&](const auto& p, const auto& np) { return SP::best_alignment(p, of_f, of_g, np); });
  return std::tuple(a.space, a.sphere, a.correlation);
}

Doubles mirrored(const Doubles& coefficients) { return to_array(SP::mirrored(of_array(coefficients))); }

auto first_order_ellipsoid(const Doubles& coefficients)
{
  const SP::First_order_ellipsoid e = SP::first_order_ellipsoid(of_array(coefficients));
  return std::tuple(e.centre, e.radii, e.axes, e.sphere_axes);
}

SP::Coefficient_format format_of(const std::string& name)
{
  return name == "csv"    ? SP::Coefficient_format::CSV
         : name == "json" ? SP::Coefficient_format::JSON
                          : SP::Coefficient_format::SPHARM_PDM;
}

std::string harmonics_to_text(const Doubles& coefficients, const std::string& format)
{
  std::ostringstream out;
  SP::write_coefficients(out, of_array(coefficients), format_of(format));
  return out.str();
}

Doubles harmonics_of_text(const std::string& text, const std::string& format)
{
  std::istringstream in(text);
  return to_array(SP::read_coefficients(in, format_of(format)));
}

} // namespace

void add_harmonics(py::module_& module)
{
  module.def("harmonic_analysis", harmonic_analysis);
  module.def("harmonic_values", harmonic_values);
  module.def("harmonic_grid", harmonic_grid);
  module.def("rotated_harmonics", rotated_harmonics);
  module.def("best_rotation", best_rotation);
  module.def("best_alignment", best_alignment);
  module.def("mirrored", mirrored);
  module.def("first_order_ellipsoid", first_order_ellipsoid);
  module.def("harmonics_to_text", harmonics_to_text);
  module.def("harmonics_of_text", harmonics_of_text);
}
