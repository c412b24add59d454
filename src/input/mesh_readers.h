// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_MESH_READERS_H
#define SPHERICAL_PARAMETERIZATION_TOOL_MESH_READERS_H

#include "input/annotations.h"

#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace tool {

/// A mesh as a file has it: nothing is known yet about how the faces fit together.
struct Soup {
  std::vector<std::array<double, 3>> points;
  CGAL::Spherical_parameterization::internal::Host_array<std::array<int, 3>>
    triangles;                   ///< polygons are cut into fans, which is right for convex ones
  std::size_t faces = 0;         ///< in the file
  std::size_t polygons = 0;      ///< those of more than three vertices
  std::size_t first_polygon = 0; ///< its number, counted from 0
  std::size_t size_of_first_polygon = 0;
  Annotations annotations;

  /// \pre there are at least three corners
  void add_face(const std::vector<int>& corners)
  {
    if(corners.size() > 3 && polygons++ == 0) {
      first_polygon = faces;
      size_of_first_polygon = corners.size();
    }
    for(std::size_t i = 2; i < corners.size(); ++i)
      triangles.push_back({corners[0], corners[i - 1], corners[i]});
    ++faces;
  }
};

/// Above this, 32-bit indices could not number all halfedges.
constexpr std::size_t largest_count = 700'000'000;

/// Reads the bytes of a mesh file, compressed or not, in the format of its content, or else of its name.
Soup read_soup(const std::string& file, std::string bytes);

/// Reads any triangles, and polygons as triangles, from a mesh file. Throws a `Refusal` as the readers do.
Soup read_triangles(const std::string& file);

/// Throws a `Refusal` of polygons that are no triangles.
void check_triangles(const std::string& file, const Soup& soup);

/// Throws a `Refusal` if `corner` is not the number of one of so many vertices.
void check_corner(const std::string& file, std::size_t face, int corner, std::size_t number_of_vertices);

/// \name Readers, one per file format
/// They read the bytes of a file once. A broken file is refused in one sentence before it costs memory or yields a
/// wrong mesh: header counts against the size of the file, numbers that are none, NaN, indices out of range, files that
/// are cut short, and dialects of the format. Vertices and faces keep the order of the file.
///
/// On return all coordinates are finite, and all indices in range. Everything else throws a `Refusal`, which names
/// `file`.
/// @{
Soup read_off(const std::string& file, std::string text);
Soup read_obj(const std::string& file, std::string text);
Soup read_ply(const std::string& file, const std::string& bytes);
Soup read_stl(const std::string& file, std::string bytes); ///< corners at the same place become one vertex
Soup read_gifti(const std::string& file, const std::string& text);
Soup read_freesurfer(const std::string& file, const std::string& bytes);
Soup read_glb(const std::string& file, const std::string& bytes); ///< vertices at the same place become one
Soup read_gltf(const std::string& file, const std::string& text); ///< the same; other files are looked for next to it
/// @}

struct Fixed_vertex {
  std::size_t index;
  std::array<double, 3> position; ///< on the unit sphere
};

/// Reads lines `index x y z`: the number of a vertex, from 0 on, and the direction it is to have on the sphere.
/// Throws a `Refusal` that names the first line that does not fit a mesh of so many vertices.
std::vector<Fixed_vertex> read_fixed_vertices(const std::string& file, std::size_t number_of_vertices);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_MESH_READERS_H
