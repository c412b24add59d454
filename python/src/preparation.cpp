// SPDX-License-Identifier: GPL-3.0-or-later
// The module spherical_parameterization._preparation. It is under the GPL, as the packages of CGAL that mend meshes and
// the page that shows them are, and a module by itself, so that the others are not.

#include "errors.h"

#include "input/mesh.h"
#include "preparation/prepare.h"
#include "runner/page.h"
#include "system/stopwatch.h"

#include <nlohmann/json.hpp>

#include <pybind11/stl.h>

#include <optional>
#include <sstream>

namespace {

namespace preparation = SP::preparation;

/// Points, triangles, both maps, the report as JSON, and whether Ctrl-C has ended the call.
py::tuple prepare(const Doubles& points, const py::array_t<std::int32_t>& triangles, double merge_distance,
                  bool largest, bool fills_holes, bool cuts_handles,
                  const std::optional<std::pair<std::optional<double>, std::optional<double>>>& wrap,
                  double maximum_running_time)
{
  preparation::Preparation_settings settings;
  settings.merge_distance = merge_distance;
  if(!largest)
    settings.components = preparation::Preparation_settings::Components::TOGETHER;
  settings.fills_holes = fills_holes;
  settings.cuts_handles = cuts_handles;
  if(wrap)
    settings.wrap = preparation::Preparation_settings::Wrap{wrap->first, wrap->second};
  const Rows<double> places(points);
  const Rows<std::int32_t> corners(triangles);
  const preparation::Triangle_soup soup(places, corners);
  Watch watch{py::none()};
  const auto watched = CGAL::parameters::maximum_running_time(maximum_running_time).callback(std::ref(watch));
  preparation::Glued_surface result;
  nlohmann::ordered_json report;
  try {
    const py::gil_scoped_release no_lock;
    const tool::Stopwatch stopwatch;
    const preparation::Preparation done = preparation::prepare(soup, settings, watched);
    result = preparation::joined(done.parts);
    const double diagonal = preparation::diagonal(soup);
    constexpr double tolerance = 1e-4; // as a part of the diagonal, as the tool has it
    const auto distance = preparation::hausdorff_distance(soup, done.parts, tolerance * diagonal, [&] {
      if(!watch(0))
        throw SP::Error(SP::Error_code::INTERRUPTED, "by Ctrl-C");
      if(stopwatch.seconds() >= maximum_running_time)
        throw SP::Error(SP::Error_code::INTERRUPTED, "the time limit was reached");
    });
    report = {{"preparation", tool::to_json(done)},
              {"diagonal", diagonal},
              {"distance_from_output_to_input", tool::to_json(distance.from_new)},
              {"distance_from_input_to_output", tool::to_json(distance.from_old)}};
  } catch(const SP::Error&) {
    if(!watch.was_ctrl_c)
      throw;
  }
  const auto numbers = [](const std::vector<int>& values) {
    return py::array_t<std::int32_t>(static_cast<py::ssize_t>(values.size()), values.data());
  };
  return py::make_tuple(watch.was_ctrl_c, rows_of<double>(result.points), rows_of<std::int32_t>(result.faces),
                        numbers(result.old_vertex), numbers(result.old_face), report.dump());
}

/// The page of a mesh with its map, as the command `view` makes it: measures of faces by name, and the report as JSON.
std::string page(const std::vector<Doubles>& shapes, const py::array& triangles,
                 const std::vector<std::pair<std::string, std::vector<double>>>& measures, const std::string& report)
{
  tool::Page result;
  std::vector<tool::Point> points;
  for(const Doubles& shape : shapes) {
    const Rows<double> rows(shape);
    points.assign(rows.begin(), rows.end());
    tool::Page::check_size("the mesh", points.size());
    result.add(points);
  }
  for(const auto& [name, values] : measures)
    result.header[name] = result.add(values);
  with_triangles(triangles, [&](auto faces) { result.add(tool::Mesh(tool::Mesh::Unchecked(), points, faces)); });
  result.header["report"] = nlohmann::ordered_json::parse(report);
  std::ostringstream html;
  result.write(html);
  return html.str();
}

} // namespace

PYBIND11_MODULE(_preparation, module)
{
  py::register_local_exception_translator(translate);
  module.def("prepare", prepare);
  module.def("page", page);
}
