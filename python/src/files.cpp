// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// Mesh files and stores of results, by the readers and writers of the tool.

#include "arrays.h"

#include "collections/results.h"
#include "input/files.h"
#include "input/mesh.h"
#include "input/mesh_format.h"
#include "output/atomic_file.h"
#include "output/write_mesh.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace {

py::tuple read_mesh(const std::string& file, bool triangulate)
{
  tool::Soup soup;
  {
    const py::gil_scoped_release no_lock;
    soup = tool::read_triangles(file);
    if(!triangulate)
      tool::check_triangles(file, soup, "triangulate the mesh, or read it with triangulate=True");
  }
  return py::make_tuple(rows_of<double>(soup.points), rows_of<std::int32_t>(soup.triangles));
}

/// `like`: the file of the annotations, or empty.
void write_mesh(const std::string& file, const Doubles& points, const py::array& triangles, bool is_sphere, bool ascii,
                const std::string& like)
{
  const std::optional<tool::Mesh_format> format = tool::format_of_name(file);
  if(!format || *format == tool::Mesh_format::STL)
    throw py::value_error("file: the extension .off, .obj, .ply, .gii, .glb or .gltf, or a name that begins with lh. "
                          "or rh., is needed, not '" +
                          file + "'");
  with_triangles(triangles, [&](auto faces) {
    const Rows<double> rows(points);
    const py::gil_scoped_release no_lock;
    const tool::Annotations annotations = like.empty() ? tool::Annotations() : tool::read_triangles(like).annotations;
    const std::vector<tool::Point> places(rows.begin(), rows.end());
    tool::Atomic_files files;
    tool::write_mesh(files.open(file), {*format, ascii}, tool::Mesh(tool::Mesh::Unchecked(), places, faces), places,
                     is_sphere ? tool::Surface::SPHERE : tool::Surface::SHAPE, annotations);
    files.commit();
  });
}

typedef std::tuple<std::int64_t, std::int64_t, std::string> Version; ///< bytes, changed, hash

Version version(const std::string& file)
{
  const py::gil_scoped_release no_lock;
  const tool::File_version v = tool::version_with_hash(file);
  return {v.bytes, v.changed, v.hash};
}

/// A store of results, which others may use when it is closed.
struct Store {
  std::optional<tool::Results> results;

  explicit Store(const std::string& file) { results.emplace(file); }
  bool is_current(const std::string& name, const std::string& settings)
  {
    return results->current(name, name, settings).has_value();
  }
  std::string some_settings() const { return results->some_settings(); }
  /// Name, settings, version, status, message, value.
  typedef std::tuple<std::string, std::string, Version, std::string, std::string, std::string> Row;
  void put(const std::vector<Row>& rows)
  {
    const py::gil_scoped_release no_lock;
    results->put_together([&] {
      for(const auto& [name, settings, version, status, message, value] : rows) {
        const auto& [bytes, changed, hash] = version;
        results->put(name, name, {bytes, changed, hash}, settings, {status, message, "", value});
      }
    });
  }
  void close() { results.reset(); }
};

} // namespace

void add_files(py::module_& module)
{
  module.def("read_mesh", read_mesh);
  module.def("write_mesh", write_mesh);
  module.def("is_format_known", [](const std::string& file) { return tool::is_format_known(file); });
  module.def("version", version);
  py::class_<Store>(module, "Store")
    .def(py::init<const std::string&>())
    .def("is_current", &Store::is_current)
    .def("some_settings", &Store::some_settings)
    .def("put", &Store::put)
    .def("close", &Store::close);
  module.def("meshes_in", [](const std::string& folder) { return tool::list_meshes({folder}, ""); });
}
