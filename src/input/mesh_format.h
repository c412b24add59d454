// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tool {

enum class Mesh_format { OFF, OBJ, PLY, STL, GIFTI, FREESURFER, VTK, VTP, VTU, GLB, GLTF, MNI };

/// How standard input and standard output are called on the command line.
inline const char* const standard_stream = "-";

/// The extension of the files of a format by its name on the command line, "off", "gifti", ...; empty for FreeSurfer's.
std::string extension_of_format(const std::string& name);

/// Not so STL, which has no vertices, nor what is read only for those who have it: unstructured grids and MNI's
/// polygons.
bool is_written(Mesh_format format);

/// The formats that are written, by their names, in the order of `Mesh_format`.
std::vector<std::pair<std::string, Mesh_format>> output_formats();

/// The format that the name of a file stands for: by its extension, in lower or upper case, before which there may be
/// one of a compression; or FreeSurfer's, whose surfaces are called "lh.white", "rh.sphere", ...
std::optional<Mesh_format> format_of_name(const std::string& file);

/// The name of a mesh without the extension. Those of FreeSurfer have none: "lh.white" and "lh.pial" are two meshes.
std::string without_extension(const std::string& file);

/// The format that the content is in, whatever the file is called. Some formats begin with a word that says so; text
/// without one is OBJ or STL if its first statement is one of theirs, and bytes are STL if their number is the one that
/// its header announces. `bytes` may be the beginning of a file of `size` bytes.
std::optional<Mesh_format> format_of_content(std::string_view bytes, std::size_t size);

/// The first word of an OFF file without the letters of columns behind the coordinates (colours, normals, textures),
/// which stand in any order: MeshLab has NCSTOFF.
std::string_view without_off_columns(std::string_view word);

/// The names that files of meshes may have, for messages.
inline const char* const mesh_names = ".off, .obj, .ply, .gii, .vtk, .vtp, .glb, .gltf or lh.NAME (FreeSurfer)";

/// Whether coordinates are written as floats, which moves the points of a sphere: the certificate has to be that of
/// what is written.
bool stores_floats(Mesh_format format);

/// What neuroimaging programs expect of a sphere: radius 100 in GIFTI and FreeSurfer files. Else 1.
double radius_of_spheres(Mesh_format format);

/// Which formats and compressions this build reads and writes, and which library it lacks for others; lines for
/// `--help`.
std::string list_of_formats();

} // namespace tool
