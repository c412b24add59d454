// SPDX-License-Identifier: LGPL-3.0-or-later
// Statistics of shapes. A set of n shapes is an array (n, m, 3): of vertices, or of coefficients of harmonics.

#include "arrays.h"

#include <CGAL/Spherical_parameterization/shape_atlas.h>

#include <pybind11/stl.h>

#include <optional>

namespace {

using SP::Shape_points;

void read_shape(const double* first, std::size_t rows, Shape_points& shape)
{
  const auto* points = reinterpret_cast<const std::array<double, 3>*>(first);
  shape.assign(points, points + rows);
}
void read_shape(const double* first, std::size_t rows, SP::Harmonic_coefficients& shape)
{
  shape = harmonics_at(first, static_cast<int>(rows), 3);
}

void write_shape(const Shape_points& shape, double* out)
{
  for(const auto& p : shape)
    out = std::copy(p.begin(), p.end(), out);
}
void write_shape(const SP::Harmonic_coefficients& shape, double* out) { write_harmonics(shape, out); }

template <class Shape>
std::vector<Shape> read_shapes(const Doubles& array)
{
  std::vector<Shape> shapes(static_cast<std::size_t>(array.shape(0)));
  const auto rows = static_cast<std::size_t>(array.shape(1));
  for(std::size_t i = 0; i < shapes.size(); ++i)
    read_shape(array.data() + 3 * rows * i, rows, shapes[i]);
  return shapes;
}

template <class Shape>
Doubles to_array(const std::vector<Shape>& shapes, std::size_t rows)
{
  Doubles array = make_array<double>(shapes.size(), rows, 3);
  for(std::size_t i = 0; i < shapes.size(); ++i)
    write_shape(shapes[i], array.mutable_data() + 3 * rows * i);
  return array;
}

/// Calls f with shapes of the kind.
template <class F>
py::tuple with_shapes(const Doubles& array, bool are_harmonics, F f)
{
  if(are_harmonics)
    return f(read_shapes<SP::Harmonic_coefficients>(array));
  return f(read_shapes<Shape_points>(array));
}

py::tuple align_shapes(const Doubles& array, bool are_harmonics, const std::vector<double>& weights, bool rotate,
                       bool scale, double accuracy, int iterations, const std::string& policy)
{
  return with_shapes(array, are_harmonics, [&](auto shapes) {
    const SP::Procrustes_alignment a = on_watched(policy, [&](const auto& p, const auto& np) {
      return SP::align_shapes(p, shapes, SP::Procrustes{rotate, scale, accuracy, iterations}, weights, np);
    });
    std::vector<double> scales;
    std::vector<std::array<std::array<double, 3>, 3>> rotations;
    std::vector<std::array<double, 3>> translations;
    for(const SP::Similarity& motion : a.motions) {
      scales.push_back(motion.scale);
      rotations.push_back(motion.rotation);
      translations.push_back(motion.translation);
    }
    return py::make_tuple(to_array(shapes, static_cast<std::size_t>(array.shape(1))), scales, rotations, translations,
                          a.deviation, a.has_converged, a.iterations);
  });
}

template <class Statistics>
py::tuple to_python(const Statistics& s, std::size_t rows)
{
  Doubles mean = make_array<double>(rows, 3);
  write_shape(s.mean, mean.mutable_data());
  return py::make_tuple(mean, to_array(s.modes, rows), s.variances, s.scores, s.total_variance);
}

py::tuple shape_statistics(const Doubles& array, bool are_harmonics, const std::vector<double>& weights, int modes,
                           const std::string& policy)
{
  return with_shapes(array, are_harmonics, [&](const auto& shapes) {
    const auto s = on_watched(
      policy, [&](const auto& p, const auto& np) { return SP::shape_statistics(p, shapes, weights, modes, np); });
    return to_python(s, static_cast<std::size_t>(array.shape(1)));
  });
}

py::tuple left_out_errors(const Doubles& array, bool are_harmonics, const std::vector<double>& weights, int groups,
                          const std::string& policy)
{
  return with_shapes(array, are_harmonics, [&](const auto& shapes) {
    return py::make_tuple(on_watched(
      policy, [&](const auto& p, const auto& np) { return SP::left_out_errors(p, shapes, weights, groups, np); }));
  });
}

py::tuple model_quality(const Doubles& array, bool are_harmonics, const std::vector<double>& weights, int groups,
                        int samples, std::uint32_t seed, const std::string& policy)
{
  return with_shapes(array, are_harmonics, [&](const auto& shapes) {
    const SP::Model_quality q = on_watched(policy, [&](const auto& p, const auto& np) {
      return SP::model_quality(p, shapes, weights, groups, samples, seed, np);
    });
    return py::make_tuple(q.compactness, q.generalization, q.specificity, q.specificity_error);
  });
}

std::vector<double> mean_vertex_areas(const Doubles& array, const py::array& triangles, const std::string& policy)
{
  const auto shapes = read_shapes<Shape_points>(array);
  Doubles first = make_array<double>(array.shape(1), 3);
  write_shape(shapes.front(), first.mutable_data());
  const Mesh mesh = make_mesh(first, triangles);
  return on_watched(policy, [&](const auto& p, const auto& np) { return SP::mean_vertex_areas(p, mesh, shapes, np); });
}

/// Of points, triangles and maps. `level` of the icosphere, or -1 for the vertices of the template. Returns the
/// parts of an Atlas.
py::tuple shape_atlas(const std::vector<std::tuple<Doubles, py::array, Doubles>>& meshes, std::size_t first, int rounds,
                      int level, int placement, int modes, const std::string& policy)
{
  std::vector<Mesh> made;
  for(const auto& [points, triangles, sphere] : meshes)
    made.push_back(make_mesh(points, triangles));
  std::vector<decltype(SP::mapped_mesh(made[0], sphere_of(Doubles())))> maps;
  for(std::size_t i = 0; i < meshes.size(); ++i)
    maps.push_back(SP::mapped_mesh(made[i], sphere_of(std::get<2>(meshes[i]))));
  const Rows<double> of_template(std::get<2>(meshes[first]));
  std::optional<SP::Atlas_mesh> mesh;
  const SP::Shape_atlas atlas = on_watched(policy, [&](const auto& p, const auto& np) {
    mesh =
      level < 0 ? SP::Atlas_mesh{made[first], {of_template.begin(), of_template.end()}} : SP::icosphere_of_atlas(level);
    return SP::shape_atlas(p, maps, first, rounds, *mesh, static_cast<SP::Atlas_placement>(placement), modes, np);
  });
  std::vector<std::array<std::int32_t, 3>> triangles;
  for(std::size_t f = 0; f < mesh->mesh.number_of_faces(); ++f)
    triangles.push_back(mesh->mesh.triangle(f));
  const std::size_t rows = mesh->directions.size();
  return py::make_tuple(rows_of<std::int32_t>(triangles), rows_of<double>(mesh->directions),
                        to_array(atlas.shapes, rows), atlas.weights, to_python(atlas.statistics, rows), atlas.members,
                        atlas.refused);
}

} // namespace

void add_statistics(py::module_& module)
{
  module.def("align_shapes", align_shapes);
  module.def("shape_statistics", shape_statistics);
  module.def("left_out_errors", left_out_errors);
  module.def("model_quality", model_quality);
  module.def("mean_vertex_areas", mean_vertex_areas);
  module.def("shape_atlas", shape_atlas);
}
