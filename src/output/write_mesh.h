// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "input/mesh.h"
#include "input/mesh_format.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace tool {

/// In which format to write.
struct Output_format {
  Mesh_format format = Mesh_format::PLY;
  bool ascii = false;              ///< PLY, VTK and VTP as text
  std::string name = "the output"; ///< of the file, for messages
};

/// What the points of a mesh are. Spheres are written with the radius that the format's programs expect.
enum class Surface { SHAPE, SPHERE };

/// Writes the faces of `mesh` over other points. `annotations` are those of the file that the mesh was read from, and
/// `data` is what the vertices have, for formats that hold it: PLY, VTK and VTP.
void write_mesh(std::ostream& out, const Output_format& format, const Mesh& mesh, const std::vector<Point>& points,
                Surface surface, const Annotations& annotations = {}, const Vertex_data& data = {});

/// Throws a `Refusal` if floats cannot hold the points: the largest coordinate is beyond their range, above or below.
void check_float_range(const std::string& file, const std::vector<Point>& points);

/// The same, if the format holds floats, also if the points are so far from the origin that rounding moves them by more
/// than a thousandth of the size of the mesh.
void check_floats(const Output_format& format, const std::vector<Point>& points);

/// The coordinates that are read from a file of that format, which may hold floats and other radii.
Point as_stored(Mesh_format format, Surface surface, Point point);

/// A property of vertices or faces.
struct Ply_column {
  enum class Type { UCHAR, INT, DOUBLE };
  Type type;
  std::string name;
  std::function<double(std::size_t)> value; ///< of vertex or face i; in the range of the type
};

/// What a PLY file has beside points and triangles.
struct Ply_extras {
  std::string comment; ///< one line, or empty
  std::vector<Ply_column> of_vertices;
  std::vector<Ply_column> of_faces;
};

/// The columns under names that a PLY file can have: without spaces, and each once. Colours are bytes, labels integers.
std::vector<Ply_column> ply_columns(const Vertex_data& data);

using Colour = std::array<std::uint8_t, 3>;

/// Red, green and blue of vertices or faces. The colours are kept by reference.
std::vector<Ply_column> colour_columns(const std::vector<Colour>& colours);

/// Writes a PLY file: little-endian binary, or text with the fewest digits from which the same numbers are read.
void write_ply(std::ostream& out, bool is_text, const Mesh& mesh, const std::vector<Point>& points,
               const Ply_extras& extras = {});

/// Writes the mesh as PLY over any points, with a value of this name at every vertex, and coloured by it: light grey at
/// 0, red above, blue below.
void write_coloured_ply(std::ostream& out, bool ascii, const Mesh& mesh, const std::vector<Point>& points,
                        const std::string& name, const std::vector<double>& values);

/// Writes the mesh as PLY with the segment of every face, and faces coloured by it. Segment i has the same colour in
/// every file.
void write_segments_ply(std::ostream& out, bool ascii, const Mesh& mesh, const std::vector<std::size_t>& segments,
                        std::size_t number_of_segments, const Vertex_data& data = {});

/// A position in the texture.
using Uv = std::pair<double, double>;

/// Writes the mesh as OBJ with one `vt` for every position that a vertex has in the texture; `uv` has those at the
/// targets of the halfedges. No digit is left out: with less, slivers may flip when the file is read.
void write_textured_obj(std::ostream& out, const Mesh& mesh, const std::vector<Uv>& uv,
                        const std::string& material_file);

/// Writes the mesh as glTF 2.0 with a vertex for every position that one has in the texture, and the image, a PNG or
/// JPEG file, inside.
void write_textured_gltf(std::ostream& out, const Output_format& format, const Mesh& mesh, const std::vector<Uv>& uv,
                         const std::string& image);

/// The media type of a PNG or JPEG file by its first bytes, which is all that glTF can hold; empty for others.
std::string type_of_image(const std::string& image);

/// The material `texture`: white, with the image.
void write_material(std::ostream& out, const std::string& image_file);

/// Writes a PNG of a checker, whose squares are white and of a hue that goes once round with u. The number of squares
/// is even in both directions, so that it repeats whether shifted or turned by 180 degrees. Throws a
/// `std::runtime_error`.
void write_checker(std::ostream& out, int columns, int rows);

/// \name One function per format
/// With spheres of the radius that the format has.
/// @{
void write_gifti(std::ostream& out, const Mesh& mesh, const std::vector<Point>& points, Surface surface,
                 const Annotations& annotations);
void write_freesurfer(std::ostream& out, const Mesh& mesh, const std::vector<Point>& points, Surface surface,
                      const Annotations& annotations);
void write_vtk(std::ostream& out, bool is_text, const Mesh& mesh, const std::vector<Point>& points,
               const Vertex_data& data);
void write_vtp(std::ostream& out, bool is_text, const Mesh& mesh, const std::vector<Point>& points,
               const Vertex_data& data);
void write_gltf(std::ostream& out, Mesh_format format, const Mesh& mesh, const std::vector<Point>& points);
/// @}

} // namespace tool
