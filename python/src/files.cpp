// SPDX-License-Identifier: LGPL-3.0-or-later
// Mesh files and stores of results, by the readers and writers of the tool.

#include "arrays.h"

#include "collections/results.h"
#include "input/compression.h"
#include "input/files.h"
#include "input/mesh.h"
#include "input/mesh_format.h"
#include "output/atomic_file.h"
#include "output/write_mesh.h"
#include "output/write_vertex_data.h"

#include <pybind11/stl.h>

#include <optional>
#include <utility>

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

typedef py::array_t<std::int64_t, py::array::c_style> Polygons;

/// The triangles of polygons that have been read from `file` by somebody else; each block has those of one size.
py::array triangles_of(const std::string& file, const Doubles& points, const std::vector<Polygons>& blocks)
{
  tool::Soup soup;
  const Rows<double> rows(points);
  soup.points.resize(rows.size());
  for(std::size_t v = 0; v < rows.size(); ++v)
    for(std::size_t k = 0; k < 3; ++k)
      soup.set_coordinate(file, v, k, rows[v][k]);
  if(soup.non_finite)
    throw tool::Refusal(*soup.non_finite);
  std::vector<int> corners;
  for(const Polygons& block : blocks)
    for(py::ssize_t i = 0; i < block.shape(0); ++i) {
      corners.clear();
      for(py::ssize_t k = 0; k < block.shape(1); ++k)
        corners.push_back(
          tool::checked_corner(file, soup.faces, static_cast<double>(*block.data(i, k)), soup.points.size()));
      soup.add_face(corners);
    }
  without_lock([&soup] { tool::cut_polygons(soup); });
  return rows_of<std::int32_t>(soup.triangles);
}

/// Name, values, and of labels keys, names and colours. Names are bytes, since those of a file may be no UTF-8.
typedef std::optional<std::vector<std::tuple<int, py::bytes, std::array<float, 4>>>> Table;
typedef std::tuple<py::bytes, Doubles, Table> Column;

std::vector<Column> read_data(const std::string& file, std::size_t number_of_vertices)
{
  const tool::Vertex_data data = without_lock([&] { return tool::read_vertex_data(file, number_of_vertices); });
  std::vector<Column> columns;
  for(const tool::Vertex_column& column : data) {
    Table table;
    if(column.is_label)
      table.emplace();
    for(const tool::Label& label : column.table)
      table->emplace_back(label.key, label.name, label.rgba);
    columns.emplace_back(column.name, Doubles(static_cast<py::ssize_t>(column.values.size()), column.values.data()),
                         table);
  }
  return columns;
}

tool::Vertex_data data_of(const std::vector<Column>& columns)
{
  tool::Vertex_data data;
  for(const auto& [name, values, table] : columns) {
    tool::Vertex_column column = {name, {values.data(), values.data() + values.size()}, table.has_value()};
    for(const auto& [key, label, rgba] : table.value_or(Table::value_type()))
      column.table.push_back({key, label, rgba});
    data.push_back(std::move(column));
  }
  tool::number_equal_names(data);
  return data;
}

void write_data(const std::string& file, const std::vector<Column>& columns)
{
  if(!tool::data_format_of_name(file))
    throw py::value_error("file: '" + file + "' must be called " + tool::data_names);
  const tool::Vertex_data data = data_of(columns);
  const py::gil_scoped_release no_lock;
  tool::Atomic_files files;
  tool::write_vertex_data(files.open(file), file, data);
  files.commit();
}

/// `like`: the file of the annotations, or empty.
void write_mesh(const std::string& file, const Doubles& points, const py::array& triangles, bool is_sphere, bool ascii,
                const std::string& like, const std::vector<Column>& columns)
{
  const std::optional<tool::Mesh_format> format = tool::format_of_name(file);
  if(!format || !tool::is_written(*format))
    throw py::value_error("file: '" + file + "' must be called " + tool::mesh_names);
  const tool::Vertex_data data = data_of(columns);
  with_triangles(triangles, [&](auto faces) {
    const Rows<double> rows(points);
    const py::gil_scoped_release no_lock;
    const tool::Annotations annotations = like.empty() ? tool::Annotations() : tool::read_triangles(like).annotations;
    const std::vector<tool::Point> places(rows.begin(), rows.end());
    tool::Atomic_files files;
    tool::write_mesh(files.open(file), {*format, ascii, file}, tool::Mesh(tool::Mesh::Unchecked(), places, faces),
                     places, is_sphere ? tool::Surface::SPHERE : tool::Surface::SHAPE, annotations, data);
    files.commit();
  });
}

py::bytes read_text(const std::string& file)
{
  std::string text;
  {
    const py::gil_scoped_release no_lock;
    text = tool::decompressed(file, tool::read_file(file));
  }
  return text;
}

void write_text(const std::string& file, const std::string& text)
{
  const py::gil_scoped_release no_lock;
  tool::Atomic_files files;
  files.open(file) << text;
  files.commit();
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
  module.def("triangles_of", triangles_of);
  module.def("read_text", read_text);
  module.def("write_text", write_text);
  module.def("write_mesh", write_mesh);
  module.def("read_data", read_data);
  module.def("write_data", write_data);
  module.def("is_format_known", [](const std::string& file) { return tool::is_format_known(file); });
  module.def("without_compression", [](const std::string& file) { return py::bytes(tool::without_compression(file)); });
  module.def("version", version);
  py::class_<Store>(module, "Store")
    .def(py::init<const std::string&>())
    .def("is_current", &Store::is_current)
    .def("some_settings", &Store::some_settings)
    .def("put", &Store::put)
    .def("close", &Store::close);
  module.def("meshes_in", [](const std::string& folder) { // as bytes, since names of files may be no UTF-8
    const auto names = tool::list_meshes({folder});
    return std::vector<py::bytes>(names.begin(), names.end());
  });
}
