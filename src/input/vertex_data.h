// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tool {

/// What a key in a column of labels stands for.
struct Label {
  int key = 0;
  std::string name;
  std::array<float, 4> rgba = {0, 0, 0, 1}; ///< each from 0 to 1
};

/// A value at every vertex: a number that can be interpolated, or the key of a label, which cannot. NaN: none.
struct Vertex_column {
  std::string name; ///< not empty
  std::vector<double> values;
  bool is_label = false;         ///< then the values are integers in the range of `int`
  std::vector<Label> table = {}; ///< each key once; of keys that are not there no more is known
};

/// Columns of one length, each with a name of its own.
using Vertex_data = std::vector<Vertex_column>;

/// Whether files of surfaces have coordinates or normals by this name: "x", "nx", ...
bool is_point_or_normal(std::string_view name);

/// A column gets a number if one before it has its name.
void number_equal_names(Vertex_data& data);

/// Appends an entry to its table, of a colour that the others do not have.
void add_label(Vertex_column& column, int key, const std::string& name);

/// Reads what a file has for the vertices of a mesh, in their order: FreeSurfer's curv (`lh.thickness`), .annot and
/// .label, GIFTI, .csv with a line of names, and the columns of surfaces that have some. A broken file, or one of
/// another number of vertices, throws a `Refusal`.
Vertex_data read_vertex_data(const std::string& file, std::size_t number_of_vertices);

/// The same of a GIFTI file, whose columns may have any length, unless it names the vertices that they are of.
Vertex_data read_gifti_data(const std::string& file, const std::string& text, std::size_t number_of_vertices);

/// What a column is called that has no name but that of its file: "thickness" of lh.thickness.
std::string name_of_column(const std::string& file);

/// The values at other vertices: `old_vertex` has for each its number before, or -1 for one that is new, and gets none.
Vertex_data carried(const Vertex_data& data, const std::vector<int>& old_vertex);

/// A saturated colour, red, green and blue in [0,1]; `hue` in turns.
std::array<double, 3> colour_of_hue(double hue);

/// Red, green and blue of the i-th of many that are to be told apart.
std::array<std::uint8_t, 3> distinct_colour(std::size_t i);

} // namespace tool
