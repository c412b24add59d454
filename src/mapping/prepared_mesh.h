// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "input/mesh.h"
#include "input/mesh_readers.h"
#include "options/mapping_options.h"
#include "preparation/prepare.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tool {

/// A point of a mesh: a face, and the weights of its corners in their order; or none.
struct Place {
  int face = -1;
  std::array<double, 3> weights = {0, 0, 0};
};

/// A mesh that was mended before it was mapped: how it was in its file, and what was done.
struct Prepared_mesh {
  Soup soup;
  Preparation preparation;

  /// The mesh of the file, to be written: nothing but its points and triangles.
  Mesh of_file() const { return Mesh(Mesh::Unchecked(), soup.points, soup.triangles); }
};

/// Reads a mesh file, and mends it as far as `how` says. Throws a `Refusal` if it is then no triangulated sphere.
Input_mesh read_prepared_mesh(const std::string& file, Prepare how, std::optional<Prepared_mesh>& prepared);

/// Whether anything was done.
bool was_mended(const std::optional<Prepared_mesh>& prepared);

/// Lines on what was done, each with its end; empty if the mesh was not mended, or there was nothing to mend.
std::string preparation_text(const std::string& file, const std::optional<Prepared_mesh>& prepared);

/// Labels of the faces of the file, from those of the mended faces: a face that was left out has that of the nearest
/// one, and a component that was left out has a label of its own, from `first_free` on.
std::vector<std::size_t> labels_of_file(const Prepared_mesh& prepared, const std::vector<std::size_t>& labels,
                                        std::size_t first_free);

/// Labels of the mended faces, from those of the faces of the file: a new face has that of the nearest one.
std::vector<std::size_t> labels_of_mended(const Prepared_mesh& prepared, const std::vector<std::size_t>& labels);

/// By vertex of the file: the mended vertex, or one of its copies; -1 if it was left out.
std::vector<int> mended_vertices(const Prepared_mesh& prepared);

/// The same places on the mesh of the file; for those in new faces the nearest ones in faces that were not left out.
std::vector<Place> places_of_file(const Prepared_mesh& prepared, const std::vector<Place>& places);

/// Texture coordinates of the corners of the file, by the halfedges that end there, from those of the mended mesh:
/// those of the same corner, or for what was left out those of the nearest place of the nearest face.
std::vector<std::pair<double, double>> coordinates_of_file(const Prepared_mesh& prepared,
                                                           const std::vector<std::pair<double, double>>& coordinates);

} // namespace tool
