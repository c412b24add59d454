// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_SIGNATURE_INDEX_H
#define SPHERICAL_PARAMETERIZATION_TOOL_SIGNATURE_INDEX_H

#include <CGAL/Spherical_parameterization/shape_signature.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tool {

using CGAL::Spherical_parameterization::Shape_signature;

/// One line of an index of signatures: doc/shape_search.md describes the format.
struct Signature_row {
  std::string name;         ///< of the mesh file
  std::size_t vertices = 0; ///< 0: unknown
  std::string status;       ///< "OK", or the code of what is wrong
  std::string map;          ///< "conformal", "barycentric" or "uncertified"; empty without a signature
  std::string message;      ///< what is wrong, in one line; empty if OK
  std::optional<Shape_signature> signature;
};

/// The first line, with the names of the columns. Lines have no line break at the end.
std::string index_header();

/// The same text for the same row wherever and whenever it is written: numbers have the fewest digits from which the
/// same double is read again.
std::string to_index_line(const Signature_row& row);

/// The row of a line, if it is a complete one.
std::optional<Signature_row> from_index_line(const std::string& line);

/// Throws a `Refusal`.
std::vector<Signature_row> read_index(const std::string& file);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_SIGNATURE_INDEX_H
