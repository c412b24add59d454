// SPDX-License-Identifier: LGPL-3.0-or-later
// What is done with a map: certificate, distortion, segments, textures, the inverse, shape search.

#include "arrays.h"

#include <CGAL/Spherical_parameterization/align_maps.h>
#include <CGAL/Spherical_parameterization/distortion_summary.h>
#include <CGAL/Spherical_parameterization/for_each_index.h>
#include <CGAL/Spherical_parameterization/internal/surface/midpoint_refinement.h>
#include <CGAL/Spherical_parameterization/locate.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>
#include <CGAL/Spherical_parameterization/resample.h>
#include <CGAL/Spherical_parameterization/resampling_weights.h>
#include <CGAL/Spherical_parameterization/segmentation.h>
#include <CGAL/Spherical_parameterization/shape_form.h>
#include <CGAL/Spherical_parameterization/shape_signature.h>
#include <CGAL/Spherical_parameterization/stretch_histogram.h>
#include <CGAL/Spherical_parameterization/texture_coordinates.h>
#include <CGAL/Spherical_parameterization/transfer_properties.h>

#include <pybind11/stl.h>

#include <limits>
#include <utility>

namespace {

typedef Array_map<Mesh::Face_index, double> Face_values;
typedef Array_map<Mesh::Vertex_index, double> Vertex_values;

std::pair<std::size_t, int> certify(const py::array& triangles, const Doubles& sphere, const std::string& policy)
{
  const Mesh mesh = make_mesh(sphere, triangles);
  return on(policy, [&](const auto& p) { return SP::certify_map(p, mesh, sphere_of(sphere)); });
}

Doubles face_distortion(const Doubles& points, const py::array& triangles, const Doubles& sphere,
                        const std::string& measure, const std::string& policy)
{
  const Mesh mesh = make_mesh(points, triangles);
  Doubles values = make_array<double>(mesh.number_of_faces());
  const Face_values map(values);
  on(policy, [&](const auto& p) {
    if(measure == "log_area_stretch")
      SP::face_log_area_stretch(p, mesh, sphere_of(sphere), map);
    else if(measure == "angle_distortion")
      SP::face_angle_distortion(p, mesh, sphere_of(sphere), map);
    else if(measure == "dilatation")
      SP::face_dilatation(p, mesh, sphere_of(sphere), map);
    else
      SP::face_symmetric_dirichlet(p, mesh, sphere_of(sphere), map);
  });
  return values;
}

Doubles vertex_log_area_stretch(const Doubles& points, const py::array& triangles, const Doubles& sphere,
                                const std::string& policy)
{
  const Mesh mesh = make_mesh(points, triangles);
  Doubles values = make_array<double>(mesh.number_of_vertices());
  const Vertex_values map(values);
  on(policy, [&](const auto& p) { SP::vertex_log_area_stretch(p, mesh, sphere_of(sphere), map); });
  return values;
}

py::tuple to_python(const SP::Distribution& d)
{
  return py::make_tuple(d.mean, d.deviation, d.min, d.percentile_1, d.percentile_5, d.median, d.percentile_95,
                        d.percentile_99, d.max);
}

py::tuple distortion_summary(const Doubles& points, const py::array& triangles, const Doubles& sphere,
                             const std::string& policy)
{
  const Mesh mesh = make_mesh(points, triangles);
  const SP::Distortion_summary d =
    on(policy, [&](const auto& p) { return SP::distortion_summary(p, mesh, sphere_of(sphere)); });
  return py::make_tuple(to_python(d.log_area_stretch), to_python(d.angle_distortion), to_python(d.dilatation),
                        to_python(d.symmetric_dirichlet), to_python(d.spherical_symmetric_dirichlet),
                        d.degenerate_faces);
}

/// Of every face, their distribution, and the share of large ones.
py::tuple length_changes(const Doubles& points, const py::array& triangles, const Doubles& other_points,
                         const std::string& policy)
{
  const Mesh mesh = make_mesh(points, triangles);
  Doubles of_faces = make_array<double>(mesh.number_of_faces());
  const Face_values map(of_faces);
  const SP::Length_changes changes =
    on(policy, [&](const auto& p) { return SP::face_length_changes(p, mesh, sphere_of(other_points), map); });
  return py::make_tuple(of_faces, to_python(changes.factor), changes.share_of_large);
}

/// Values of faces as values of vertices.
Doubles mean_over_faces(const Doubles& points, const py::array& triangles, const Doubles& values)
{
  const Mesh mesh = make_mesh(points, triangles);
  Doubles means = make_array<double>(mesh.number_of_vertices());
  const Vertex_values map(means);
  const Array_map<Mesh::Face_index, const double> of_faces(values.data());
  const py::gil_scoped_release no_lock;
  SP::mean_over_faces(mesh, of_faces, map);
  return means;
}

std::variant<SP::Majority_vote, SP::Girth_profiles, SP::Region_growing> segmentation_of(const py::object& options)
{
  const SP::Segment_limits limits{options.attr("minimum_area").cast<double>(),
                                  options.attr("number_of_segments").cast<std::size_t>()};
  if(is_a(options, "RegionGrowing"))
    return SP::Region_growing{limits, options.attr("threshold").cast<double>()};
  if(is_a(options, "GirthProfiles"))
    return SP::Girth_profiles{limits};
  return SP::Majority_vote{limits};
}

py::array segment(const Doubles& points, const py::array& triangles, const Doubles& sphere, const py::object& options,
                  const py::object& stretch, const std::string& policy)
{
  const auto method = segmentation_of(options);
  const Mesh mesh = make_mesh(points, triangles);
  auto labels = make_array<std::int32_t>(mesh.number_of_faces());
  const Array_map<Mesh::Face_index, std::int32_t> map(labels);
  Doubles given = stretch.is_none() ? Doubles() : Doubles(stretch);
  const double* const values = stretch.is_none() ? nullptr : given.data();
  on_watched(policy, [&](const auto& p, const auto& np) {
    const SP::Segmentation_result result = std::visit(
      [&](const auto& chosen) {
        if(values)
          return SP::segmentation_from_area_stretch(p, mesh, sphere_of(sphere),
                                                    Array_map<Mesh::Face_index, const double>(values), map, chosen, np);
        return SP::segmentation_via_area_stretch(p, mesh, sphere_of(sphere), map, chosen, np);
      },
      method);
    if(!result)
      throw SP::Error(result.error, result.detail);
  });
  return labels;
}

typedef std::pair<double, double> UV;

/// Row f, column k of an array (m, 3, 2): the corner k of face f, which is the target of the halfedge before it.
template <class May_be_const>
auto corner_map(May_be_const* first)
{
  return boost::make_function_property_map<Mesh::Halfedge_index>(
    [first](Mesh::Halfedge_index h) -> May_be_const& { return first[3 * (h.idx() / 3) + (h.idx() + 1) % 3]; });
}

py::tuple texture_coordinates(const Doubles& points, const py::array& triangles, const Doubles& sphere,
                              const std::string& chart, const py::object& axes, int bits, const std::string& policy)
{
  typedef std::array<double, 3> Vector;
  SP::Texture_options options;
  if(chart == "octahedral")
    options.chart = SP::Texture_chart::OCTAHEDRAL;
  if(!axes.is_none()) {
    const auto [north, meridian] = axes.cast<std::pair<Vector, Vector>>();
    options.axes = SP::Texture_axes{north, meridian};
  }
  options.bits = bits;
  const Mesh mesh = make_mesh(points, triangles);
  Doubles uv = make_array<double>(mesh.number_of_faces(), 3, 2);
  const auto map = corner_map(reinterpret_cast<UV*>(uv.mutable_data()));
  const SP::Texture_report r = on_watched(policy, [&](const auto& p, const auto& np) {
    return SP::texture_coordinates(p, mesh, sphere_of(sphere), map, options, np);
  });
  return py::make_tuple(uv, r.axes.north, r.axes.meridian, r.seam_faces, r.pole_faces, r.moved_faces,
                        r.unresolved_faces, r.largest_move);
}

/// The ends of the edges along which a texture is cut, the smaller number first, sorted.
py::array texture_seams(const Doubles& points, const py::array& triangles, const Doubles& uv)
{
  const Mesh mesh = make_mesh(points, triangles);
  std::vector<std::array<std::int32_t, 2>> seams;
  {
    const py::gil_scoped_release no_lock;
    std::vector<char> is_seam(num_halfedges(mesh)), is_on_seam(num_vertices(mesh)); // edges have numbers of halfedges
    SP::texture_seams(mesh, corner_map(reinterpret_cast<const UV*>(uv.data())),
                      Array_map<Mesh::Edge_index, char>(is_seam.data()),
                      Array_map<Mesh::Vertex_index, char>(is_on_seam.data()));
    for(const Mesh::Edge_index e : edges(mesh))
      if(is_seam[e.idx()])
        seams.push_back(
          {(std::min)(source(e, mesh), target(e, mesh)).idx(), (std::max)(source(e, mesh), target(e, mesh)).idx()});
    std::sort(seams.begin(), seams.end());
  }
  return rows_of<std::int32_t>(seams);
}

/// The inverse of a map, with the mesh that it needs.
class Locator {
public:
  Locator(const py::array& triangles, const Doubles& sphere, const std::string& policy)
    : mesh_(make_mesh(sphere, triangles)),
      locator_(on(policy, [&](const auto& p) { return SP::Spherical_locator<Mesh>(p, mesh_, sphere_of(sphere)); }))
  {}
  Locator(const Locator&) = delete;

  /// Face numbers (k) and weights (k, 3) in the order of the corners.
  py::tuple locate(const Doubles& directions, const std::string& policy) const
  {
    const Rows<double> queries(directions);
    if(queries.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
      throw py::value_error("directions: at most 2147483647 are located at once");
    auto faces = make_array<std::int32_t>(queries.size());
    auto weights = make_array<double>(queries.size(), 3);
    std::int32_t* const face = faces.mutable_data();
    auto* const weight = reinterpret_cast<std::array<double, 3>*>(weights.mutable_data());
    on(policy, [&](const auto& p) {
      SP::for_each_index(p, static_cast<int>(queries.size()), [&](int i) {
        const auto [f, w] = locator_.locate(queries[i]);
        face[i] = f.idx();
        weight[i] = {w[1], w[2], w[0]}; // the halfedge of a face starts at its last corner
      });
    });
    return py::make_tuple(faces, weights);
  }

  /// Values (n, d) of the vertices at what locate() has found.
  Doubles interpolate(const Doubles& values, const py::array_t<std::int32_t>& faces, const Doubles& weights) const
  {
    const Rows<double> weight(weights);
    const auto columns = static_cast<std::size_t>(values.shape(1));
    Doubles result = make_array<double>(weight.size(), columns);
    double* out = result.mutable_data();
    const double* const in = values.data();
    const std::int32_t* const face = faces.data();
    const py::gil_scoped_release no_lock;
    for(std::size_t i = 0; i < weight.size(); ++i) {
      const std::array<double, 3>& w = weight[i];
      const SP::Face_location<Mesh> place(Mesh::Face_index(face[i]), {w[2], w[0], w[1]});
      for(std::size_t k = 0; k < columns; ++k)
        *out++ = SP::interpolate(mesh_, place, column_at(in + k, columns));
    }
    return result;
  }

  /// One label for every face of the other mesh.
  py::array transfer_segment_labels(const py::array_t<std::int32_t>& labels, const Doubles& points,
                                    const py::array& triangles, const Doubles& sphere,
                                    const py::array_t<std::int32_t>& segments, const std::string& policy) const
  {
    typedef Array_map<Mesh::Face_index, const std::int32_t> Given;
    const Mesh mesh = make_mesh(points, triangles);
    auto result = make_array<std::int32_t>(mesh.number_of_faces());
    const Array_map<Mesh::Face_index, std::int32_t> map(result);
    const Given given(labels.data()), of_segments(segments.data());
    on(policy, [&](const auto& p) {
      SP::transfer_segment_labels(p, locator_, given, mesh, sphere_of(sphere), of_segments, map);
    });
    return result;
  }

  SP::Resampling_weights linear_resampling(const Doubles& directions, const std::string& policy) const
  {
    return on(policy, [&](const auto& p) { return SP::linear_resampling(p, locator_, Rows<double>(directions)); });
  }

  SP::Resampling_weights area_preserving_resampling(const Doubles& sphere, const std::vector<double>& areas,
                                                    const Locator& other, const Doubles& other_sphere,
                                                    const std::vector<double>& other_areas,
                                                    const std::string& policy) const
  {
    return on(policy, [&](const auto& p) {
      return SP::area_preserving_resampling(p, locator_, Rows<double>(sphere), areas, other.locator_,
                                            Rows<double>(other_sphere), other_areas);
    });
  }

  /// The rotation from this map to another one.
  SP::Rotation align(const Doubles& points, const Locator& other, const Doubles& other_points,
                     const std::string& policy) const
  {
    return on(policy, [&](const auto& p) {
      return SP::aligning_rotation(p, locator_, sphere_of(points), other.locator_, sphere_of(other_points));
    });
  }

private:
  Mesh mesh_;
  SP::Spherical_locator<Mesh> locator_;
};

/// Begin of each row, vertices and weights.
py::tuple rows_of_weights(const SP::Resampling_weights& weights)
{
  const auto copy = [](const auto& numbers, auto array) {
    std::copy(numbers.begin(), numbers.end(), array.mutable_data());
    return array;
  };
  return py::make_tuple(copy(weights.begin, make_array<std::int64_t>(weights.begin.size())),
                        copy(weights.vertex, make_array<std::int32_t>(weights.vertex.size())),
                        copy(weights.weight, make_array<double>(weights.weight.size())));
}

SP::Resampling_weights weights_of_rows(const py::tuple& rows)
{
  return {rows[0].cast<std::vector<std::size_t>>(), rows[1].cast<std::vector<int>>(),
          rows[2].cast<std::vector<double>>()};
}

/// Of values (n, d).
Doubles weighted_means(const SP::Resampling_weights& weights, const Doubles& values)
{
  const auto rows = static_cast<std::size_t>(values.shape(0)), columns = static_cast<std::size_t>(values.shape(1));
  Doubles result = make_array<double>(weights.size(), columns);
  const double* const in = values.data();
  double* const out = result.mutable_data();
  const py::gil_scoped_release no_lock;
  std::vector<double> column(rows);
  for(std::size_t k = 0; k < columns; ++k) {
    for(std::size_t i = 0; i < rows; ++i)
      column[i] = in[i * columns + k];
    const std::vector<double> means = weights.means(column);
    for(std::size_t i = 0; i < means.size(); ++i)
      out[i * columns + k] = means[i];
  }
  return result;
}

py::tuple icosphere(int level)
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<int, 3>> triangles;
  SP::make_icosphere_soup(level, points, triangles);
  return py::make_tuple(rows_of<double>(points), rows_of<std::int32_t>(triangles));
}

Doubles shape_signature(const Doubles& points, const py::array& triangles, const Doubles& sphere,
                        const std::string& policy)
{
  const Mesh mesh = make_mesh(points, triangles);
  const SP::Shape_signature signature = on_watched(
    policy, [&](const auto& p, const auto& np) { return SP::shape_signature(p, mesh, sphere_of(sphere), np); });
  return Doubles(static_cast<py::ssize_t>(signature.values.size()), signature.values.data());
}

Doubles shape_form(const Doubles& points, const py::array& triangles)
{
  const Mesh mesh = make_mesh(points, triangles);
  const SP::Shape_form form = without_lock([&mesh] { return SP::shape_form(mesh); });
  return py::array(py::cast(form.values)).cast<Doubles>();
}

/// To the first row, which is a signature and a form, like all others.
std::vector<double> relevance(const Doubles& signatures, const Doubles& forms)
{
  std::vector<SP::Shape_description> shapes(static_cast<std::size_t>(signatures.shape(0)));
  for(std::size_t i = 0; i < shapes.size(); ++i) {
    const auto row = static_cast<py::ssize_t>(i);
    std::copy_n(signatures.data(row, 0), SP::Shape_signature::size, shapes[i].signature.values.begin());
    std::transform(forms.data(row, 0), forms.data(row, 0) + SP::Shape_form::size, shapes[i].form.values.begin(),
                   [](double x) { return static_cast<float>(x); });
  }
  const py::gil_scoped_release no_lock;
  return SP::relevance_of_shapes(shapes);
}

/// From one signature to each row of `index`.
Doubles distances(const Doubles& signature, const Doubles& index)
{
  const auto rows = static_cast<std::size_t>(index.shape(0));
  Doubles result = make_array<double>(rows);
  const auto* const from = reinterpret_cast<const SP::Shape_signature*>(signature.data());
  const auto* const to = reinterpret_cast<const SP::Shape_signature*>(index.data());
  std::transform(to, to + rows, result.mutable_data(), [&](const auto& other) { return distance(*from, other); });
  return result;
}

std::vector<double> stretch_histogram(const Doubles& points, const py::array& triangles, const Doubles& sphere,
                                      const std::string& sampling, const std::string& scale, std::size_t bins,
                                      double low, double high, std::size_t number_of_samples, std::uint32_t seed,
                                      const std::string& policy)
{
  typedef SP::Stretch_histogram Options;
  Options options;
  options.sampling = sampling == "uniform"    ? Options::Sampling::UNIFORM
                     : sampling == "random"   ? Options::Sampling::RANDOM
                     : sampling == "vertices" ? Options::Sampling::VERTICES
                                              : Options::Sampling::EXACT_AREAS;
  options.scale = scale == "linear" ? Options::Scale::LINEAR : Options::Scale::LOGARITHMIC;
  options.bins = bins;
  options.low = low;
  options.high = high;
  options.number_of_samples = number_of_samples;
  options.random_seed = seed;
  const Mesh mesh = make_mesh(points, triangles);
  return on(policy, [&](const auto& p) { return SP::stretch_histogram(p, mesh, sphere_of(sphere), options); });
}

} // namespace

void add_analysis(py::module_& module)
{
  module.def("certify", certify);
  module.def("face_distortion", face_distortion);
  module.def("vertex_log_area_stretch", vertex_log_area_stretch);
  module.def("mean_over_faces", mean_over_faces);
  module.def("distortion_summary", distortion_summary);
  module.def("length_changes", length_changes);
  module.def("segment", segment);
  module.def("texture_coordinates", texture_coordinates);
  module.def("texture_seams", texture_seams);
  py::class_<Locator>(module, "Locator")
    .def(py::init<const py::array&, const Doubles&, const std::string&>())
    .def("locate", &Locator::locate)
    .def("interpolate", &Locator::interpolate)
    .def("transfer_segment_labels", &Locator::transfer_segment_labels)
    .def("linear_resampling", &Locator::linear_resampling)
    .def("area_preserving_resampling", &Locator::area_preserving_resampling)
    .def("align", &Locator::align);
  py::class_<SP::Resampling_weights>(module, "ResamplingWeights")
    .def("rows", rows_of_weights)
    .def(py::init(&weights_of_rows))
    .def("__reduce__",
         [](const py::object& weights) {
           return py::make_tuple(py::type::of(weights),
                                 py::make_tuple(rows_of_weights(weights.cast<const SP::Resampling_weights&>())));
         })
    .def("means", weighted_means)
    .def("majorities", &SP::Resampling_weights::majorities<int>, py::call_guard<py::gil_scoped_release>())
    .def("nearest", &SP::Resampling_weights::nearest<int>, py::call_guard<py::gil_scoped_release>());
  module.def("icosphere", icosphere);
  module.def("shape_signature", shape_signature);
  module.def("shape_form", shape_form);
  module.def("relevance", relevance);
  module.def("distances", distances);
  module.def("stretch_histogram", stretch_histogram);
}
