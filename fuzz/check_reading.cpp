// SPDX-License-Identifier: GPL-3.0-or-later

#include "check_reading.h"

#include "Input_file.h"
#include "targets.h"

#include "input/mesh.h"
#include "mapping/spherical_map.h"
#include "output/write_mesh.h"
#include "output/write_vertex_data.h"

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace fuzz {

void check_refusal(const tool::Refusal& refusal)
{
  const std::string text = refusal.what();
  promise(text.find_first_of("\n\r") == std::string::npos && text.find('\0') == std::string::npos,
          "a refusal of several lines: " + text);
  promise(!refusal.code().empty(), "a refusal without code: " + text);
}

namespace {

/// All coordinates as a file of the format has them.
std::vector<tool::Point> all_as_stored(tool::Mesh_format format, tool::Surface surface, std::vector<tool::Point> points)
{
  for(tool::Point& p : points)
    p = tool::as_stored(format, surface, p);
  return points;
}

std::optional<tool::Mesh> read(const std::string& file, tool::Polygons polygons)
{
  try {
    return tool::read_mesh(file, polygons).mesh;
  } catch(const tool::Refusal& refusal) {
    check_refusal(refusal);
    return std::nullopt;
  }
}

/// What the rest of the tool takes for granted.
void check_mesh(const tool::Mesh& mesh)
{
  for(const auto h : halfedges(mesh)) {
    const auto twin = opposite(h, mesh);
    promise(twin != h && opposite(twin, mesh) == h, "a mesh that is not closed");
    promise(source(twin, mesh) == target(h, mesh) && target(twin, mesh) == source(h, mesh),
            "halfedges that do not fit");
  }
  std::size_t corners = 0;
  for(const auto v : vertices(mesh))
    corners += CGAL::halfedges_around_target(v, mesh).size();
  promise(corners == num_halfedges(mesh), "a vertex whose faces form no disk");
  promise(mesh.number_of_vertices() == mesh.number_of_faces() / 2 + 2, "a mesh of another genus, or in parts");
  for(const tool::Point& p : mesh.points())
    for(const double x : p)
      promise(std::isfinite(x), "a coordinate that is not finite");
}

/// What is written is read again, to the last bit that the format holds.
void check_round_trip(const tool::Mesh& mesh, const tool::Output_format& format, const std::string& name)
{
  std::ostringstream out;
  std::vector<tool::Point> stored;
  try {
    stored = all_as_stored(format.format, tool::Surface::SHAPE, mesh.points());
    tool::write_mesh(out, format, mesh, mesh.points(), tool::Surface::SHAPE);
  } catch(const tool::Refusal& refusal) { // beyond the range of floats
    check_refusal(refusal);
    return;
  }
  const std::string bytes = out.str();
  const Input_file copy(name, reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  const std::optional<tool::Mesh> again = read(copy.name(), tool::Polygons::REFUSE);
  if(format.format == tool::Mesh_format::GLB) { // which does not keep vertices at the same place apart
    std::sort(stored.begin(), stored.end());
    if(std::adjacent_find(stored.begin(), stored.end()) != stored.end())
      return;
    promise(again && again->number_of_faces() == mesh.number_of_faces(), "a GLB mesh that cannot be read again");
    return;
  }
  promise(again && again->number_of_vertices() == mesh.number_of_vertices() &&
            again->number_of_faces() == mesh.number_of_faces(),
          "a mesh that cannot be read again");
  promise(again->points() == stored, "a point that comes back changed");
}

} // namespace

void check_file(const std::string& file, bool triangulate)
{
  const std::optional<tool::Mesh> mesh = read(file, triangulate ? tool::Polygons::TRIANGULATE : tool::Polygons::REFUSE);
  if(!mesh)
    return;
  check_mesh(*mesh);
  check_round_trip(*mesh, {tool::Mesh_format::OFF}, ".copy.off");
  check_round_trip(*mesh, {tool::Mesh_format::PLY}, ".copy.ply");
  check_round_trip(*mesh, {tool::Mesh_format::FREESURFER}, ".copy.white");
  check_round_trip(*mesh, {tool::Mesh_format::GLB}, ".copy.glb");
  check_round_trip(*mesh, {tool::Mesh_format::GIFTI}, ".copy.gii");
  check_round_trip(*mesh, {tool::Mesh_format::VTK}, ".copy.vtk");
  check_round_trip(*mesh, {tool::Mesh_format::VTP}, ".copy.vtp");

  tool::Sphere sphere;
  try {
    tool::read_sphere(CGAL::Sequential_tag(), file, "the mesh", *mesh, sphere);
    for(const tool::Point& p : sphere)
      promise(std::abs(std::hypot(p[0], p[1], p[2]) - 1) < 1e-12, "a sphere that is none");
  } catch(const tool::Refusal& refusal) {
    check_refusal(refusal);
  }
}

namespace {

bool is_same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

void check_columns(const tool::Vertex_data& data, std::size_t number_of_vertices)
{
  std::set<std::string> names;
  promise(!data.empty(), "data without columns");
  for(const tool::Vertex_column& column : data) {
    promise(!column.name.empty() && names.insert(column.name).second, "a column without a name of its own");
    promise(column.values.size() == number_of_vertices, "a column of another size");
    promise(column.is_label || column.table.empty(), "a table of numbers");
    std::set<double> keys;
    for(const tool::Label& label : column.table) {
      promise(keys.insert(label.key).second, "a key that is there twice");
      for(const float x : label.rgba)
        promise(x >= 0 && x <= 1, "a colour out of range");
    }
    for(const double value : column.values)
      promise(!column.is_label || std::isnan(value) || value == static_cast<int>(value), "a label that is no integer");
  }
}

/// What a format holds of the columns is read again, as far as it can be told: .csv has the names of labels only.
void check_columns_again(const tool::Vertex_data& data, const std::string& name)
{
  const bool has_labels = name == ".copy.label.gii" || name == ".copy.annot", has_all = name == ".copy.csv";
  tool::Vertex_data expected;
  for(const tool::Vertex_column& column : data)
    if(has_all || column.is_label == has_labels)
      expected.push_back(column);
  std::ostringstream out;
  try {
    tool::write_vertex_data(out, name, data);
  } catch(const tool::Refusal& refusal) {
    check_refusal(refusal);
    return;
  }
  const std::string bytes = out.str();
  const Input_file copy(name, reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  tool::Vertex_data again;
  try {
    again = tool::read_vertex_data(copy.name(), data.front().values.size());
  } catch(const tool::Refusal& refusal) {
    const std::string text = refusal.what();
    promise(has_all && text.find("only numbers") != std::string::npos, "data that cannot be read again: " + text);
    return;
  }
  check_columns(again, data.front().values.size());
  promise(again.size() == expected.size(), "a column that does not come back");
  std::map<double, double> numbers; // of the keys of .annot
  for(std::size_t k = 0; k < again.size(); ++k)
    for(std::size_t v = 0; v < again[k].values.size(); ++v) {
      double value = expected[k].values[v];
      if(name == ".copy.annot" && !std::isnan(value))
        value = numbers.emplace(value, again[k].values[v]).first->second;
      promise((has_all && expected[k].is_label) || (name == ".copy.annot" && std::isnan(value)) || // which may be black
                is_same(again[k].values[v], name == ".copy.func.gii" ? static_cast<float>(value) : value),
              "a value that comes back changed");
    }
}

} // namespace

void check_data(const std::string& file, std::size_t number_of_vertices)
{
  tool::Vertex_data data;
  try {
    data = tool::read_vertex_data(file, number_of_vertices);
  } catch(const tool::Refusal& refusal) {
    check_refusal(refusal);
    return;
  }
  check_columns(data, number_of_vertices);
  for(const char* name : {".copy.csv", ".copy.func.gii", ".copy.label.gii", ".copy.annot", ".copy.label"})
    check_columns_again(data, name);
}

} // namespace fuzz
