// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "input/mesh_readers.h"
#include "input/vertex_data.h"

#include <optional>
#include <ostream>
#include <string>

namespace tool {

/// Files of values and labels at vertices.
enum class Data_format { CSV, FUNC_GII, SHAPE_GII, LABEL_GII, ANNOT, LABEL, CURV };

/// The names that they may have, for messages.
inline const char* const data_names =
  ".csv, .func.gii, .shape.gii, .label.gii, .annot, .label, or as lh.thickness (FreeSurfer's curv)";

/// The format that a name stands for.
std::optional<Data_format> data_format_of_name(const std::string& file);

/// Writes the columns that the format of the name holds: .annot and .label.gii labels, .func.gii, .shape.gii, .label
/// and curv numbers, .csv all. Throws a `Refusal` if there is none, or more than one in .annot, .label and curv.
/// `annotations` are those of the surface.
void write_vertex_data(std::ostream& out, const std::string& file, const Vertex_data& data,
                       const Annotations& annotations = {});

/// The key in a format of integers, or another number where there is none.
int key_of(double value, int none = -1);

/// \name One function per format
/// With columns that it holds, and tables that have all keys.
/// @{
void write_gifti_data(std::ostream& out, const std::string& file, const Vertex_data& data, Data_format format,
                      const Annotations& annotations);
void write_annot(std::ostream& out, const std::string& file, const Vertex_column& column);
void write_curv(std::ostream& out, const Vertex_column& column);
/// @}

} // namespace tool
