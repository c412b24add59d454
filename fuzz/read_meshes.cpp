// SPDX-License-Identifier: GPL-3.0-or-later

#include "Input_file.h"
#include "targets.h"

#include "input/mesh_readers.h"
#include "input/mesh.h"
#include "mapping/spherical_map.h"
#include "output/write_mesh.h"
#include "system/refusal.h"

#include <CGAL/boost/graph/iterator.h>

#include <cmath>
#include <cstring>
#include <optional>
#include <sstream>
#include <string>

namespace fuzz {
namespace {

void check_refusal(const tool::Refusal& refusal)
{
  const std::string text = refusal.what();
  promise(text.find_first_of("\n\r") == std::string::npos && text.find('\0') == std::string::npos,
          "a refusal of several lines: " + text);
  promise(!refusal.code().empty(), "a refusal without code: " + text);
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

/// What is written is read again, to the last bit.
void check_round_trip(const tool::Mesh& mesh)
{
  std::ostringstream out;
  tool::write_mesh(out, "copy.off", mesh, mesh.points());
  const std::string text = out.str();
  const Input_file copy(".copy.off", reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  const std::optional<tool::Mesh> again = read(copy.name(), tool::Polygons::REFUSE);
  promise(again && again->number_of_vertices() == mesh.number_of_vertices() &&
            again->number_of_faces() == mesh.number_of_faces(),
          "a mesh that cannot be read again");
  promise(again->points() == mesh.points(), "a point that comes back changed");
}

} // namespace

void read_meshes(const std::uint8_t* data, std::size_t size)
{
  if(size == 0)
    return;
  const char* const extensions[] = {".off", ".ply", ".obj", ".stl", ".txt"};
  const std::string extension = extensions[*data % 5];
  const bool triangulate = *data >= 128;
  const Input_file file(extension, data + 1, size - 1);
  if(extension == ".txt") {
    try {
      tool::read_fixed_vertices(file.name(), 12);
    } catch(const tool::Refusal& refusal) {
      check_refusal(refusal);
    }
    return;
  }
  const std::optional<tool::Mesh> mesh =
    read(file.name(), triangulate ? tool::Polygons::TRIANGULATE : tool::Polygons::REFUSE);
  if(!mesh)
    return;
  check_mesh(*mesh);
  check_round_trip(*mesh);

  tool::Sphere sphere;
  try {
    tool::read_sphere(file.name(), "the mesh", *mesh, sphere);
    for(const tool::Point& p : sphere)
      promise(std::abs(std::hypot(p[0], p[1], p[2]) - 1) < 1e-12, "a sphere that is none");
  } catch(const tool::Refusal& refusal) {
    check_refusal(refusal);
  }
}

} // namespace fuzz
