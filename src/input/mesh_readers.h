// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "input/vertex_data.h"
#include "system/refusal.h"

#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tool {

/// What neuroimaging files say beside the surface: of which hemisphere and subject it is, and how the volume lies from
/// which it was made. It is kept when a file of the same format is written, and the last, when one of the other is.
struct Annotations {
  using Metadata = std::vector<std::pair<std::string, std::string>>; ///< names and values

  Metadata gifti;                                           ///< of the file
  Metadata gifti_points;                                    ///< of the points
  std::vector<std::array<std::string, 3>> gifti_transforms; ///< of the points: from a space, to a space, matrix
  std::string freesurfer; ///< the bytes behind the triangles: the volume geometry and other tags
};

/// Those of a mesh for points in the space of another one, which may be none that is known.
Annotations in_space_of(const Annotations& other, Annotations own);

/// A mesh as a file has it: nothing is known yet about how the faces fit together.
struct Soup {
  struct Polygon {
    std::size_t face; ///< its number, counted from 0
    std::size_t corners;
  };

  std::vector<std::array<double, 3>> points;
  SP::Large_array<std::array<int, 3>> triangles; ///< of polygons, too, which `read_soup()` has cut
  std::size_t faces = 0;                         ///< in the file
  std::vector<Polygon> polygons;                 ///< the faces of more than three vertices, in their order
  std::optional<Refusal> non_finite;             ///< of the first coordinate that is no finite number, if there is one
  Annotations annotations;
  Vertex_data data; ///< at the vertices

  /// A polygon becomes a fan, until `cut_polygons()` sees its points, which may be behind it in the file.
  /// \pre there are at least three corners
  void add_face(const std::vector<int>& corners)
  {
    if(corners.size() > 3)
      polygons.push_back({faces, corners.size()});
    for(std::size_t i = 2; i < corners.size(); ++i)
      triangles.push_back({corners[0], corners[i - 1], corners[i]});
    ++faces;
  }

  /// A strip of triangles, each of which has two corners of the one before. Every second one is listed in reverse.
  /// Those with a corner twice only lead to the next one, and are left out.
  void add_strip(const std::vector<int>& corners)
  {
    for(std::size_t i = 2; i < corners.size(); ++i) {
      const int a = corners[i - 2 + i % 2], b = corners[i - 1 - i % 2], c = corners[i];
      if(a != b && b != c && c != a) {
        triangles.push_back({a, b, c});
        ++faces;
      }
    }
  }

  /// Of one of the points, which are there. It is noted if it is no finite number.
  void set_coordinate(const std::string& file, std::size_t vertex, std::size_t axis, double x)
  {
    points[vertex][axis] = x;
    if(!std::isfinite(x))
      note_non_finite(file, "vertex " + std::to_string(vertex) + " has the coordinate " + std::to_string(x));
  }

  /// Of coordinates that are no finite numbers, the first one is kept.
  void note_non_finite(const std::string& file, const std::string& wrong)
  {
    if(!non_finite)
      non_finite.emplace(Error_code::NON_FINITE_COORDINATE, file, wrong, non_finite_remedy);
  }
};

/// Above this, 32-bit indices could not number all halfedges.
constexpr std::size_t largest_count = 700'000'000;

/// Which coordinates a mesh may have.
enum class Coordinates {
  FINITE, ///< numbers
  ANY     ///< or NaN and infinity, with which nothing but mending can be done
};

/// Reads the bytes of a mesh file, compressed or not, in the format of its content, or else of its name. Throws a
/// `Refusal`.
Soup read_soup(const std::string& file, std::string bytes, Coordinates coordinates = Coordinates::FINITE);

/// Reads any triangles, and polygons as triangles, from a mesh file. Throws a `Refusal`.
Soup read_triangles(const std::string& file, Coordinates coordinates = Coordinates::FINITE);

/// The files that a mesh is in: `file`, and if it is called .gltf or .glb, those that it names, if they are there.
std::vector<std::string> files_of_mesh(const std::string& file);

/// Whether the name of a file, or its first bytes, are those of a mesh. Throws a `Refusal` if it cannot be read.
bool is_format_known(const std::string& file);

/// Throws a `Refusal` of polygons that are no triangles.
void check_triangles(const std::string& file, const Soup& soup, const std::string& remedy);

/// Cuts polygons that are not convex anew: by the triangles of their fans, some faces would be folded back. In bounded
/// time: wild polygons of tens of thousands of corners may stay folded.
void cut_polygons(Soup& soup);

/// Throws the `Refusal` of a file with so many vertices and no faces.
[[noreturn]] void refuse_point_cloud(const std::string& file, std::size_t vertices);

/// A corner as an index. Throws a `Refusal` if it is not the number of one of so many vertices.
int checked_corner(const std::string& file, std::size_t face, double corner, std::size_t number_of_vertices);

/// \name Readers, one per file format
/// They read the bytes of a file once. A broken file is refused in one sentence before it costs memory or yields a
/// wrong mesh: header counts against the size of the file, words that are no numbers, indices out of range, files that
/// are cut short, and dialects of the format. Vertices and faces keep the order of the file.
///
/// On return all indices are in range, and all coordinates finite, unless `Soup::non_finite` says otherwise. Everything
/// else throws a `Refusal`, which names `file`.
/// @{
Soup read_off(const std::string& file, std::string text);
Soup read_obj(const std::string& file, std::string text);
Soup read_ply(const std::string& file, std::string bytes);
Soup read_stl(const std::string& file, std::string bytes); ///< corners at the same place become one vertex
Soup read_gifti(const std::string& file, std::string text);
Soup read_freesurfer(const std::string& file, std::string bytes);
Soup read_vtk(const std::string& file, std::string bytes);     ///< PolyData, or faces as an unstructured grid
Soup read_vtk_xml(const std::string& file, std::string bytes); ///< the same
Soup read_glb(const std::string& file, std::string bytes);     ///< vertices at the same place become one
Soup read_gltf(const std::string& file, std::string text);     ///< the same; other files are looked for next to it
Soup read_mni(const std::string& file, std::string text);
/// @}

struct Fixed_vertex {
  std::size_t index;
  std::array<double, 3> position; ///< a direction, to be taken as it is if its length is 1
};

/// Reads a positive number for every vertex or every face. Throws a `Refusal` that names the first word that is none,
/// or says how many there are if that does not fit. Four of a tetrahedron are those of the vertices.
std::vector<double> read_densities(const std::string& file, std::size_t number_of_vertices,
                                   std::size_t number_of_faces);

/// Reads the label of every face: whole numbers from 0 on. Throws a `Refusal` as above.
std::vector<std::size_t> read_labels(const std::string& file, std::size_t number_of_faces);

/// Reads lines `index x y z`: the number of a vertex, from 0 on, and the direction it is to have on the sphere.
/// Throws a `Refusal` that names the first line that does not fit a mesh of so many vertices.
std::vector<Fixed_vertex> read_fixed_vertices(const std::string& file, std::size_t number_of_vertices);

} // namespace tool
