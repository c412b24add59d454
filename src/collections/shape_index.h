// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "collections/database.h"
#include "collections/file_version.h"
#include "system/refusal.h"

#include <CGAL/Spherical_parameterization/shape_form.h>

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace tool {

using SP::Shape_description;
using SP::Shape_form;
using SP::Shape_signature;

/// What was done to a mesh before it was mapped.
enum class Mending { NOT_ASKED = 0, NOTHING_TO_DO = 1, DONE = 2 };

/// What is known of a mesh.
struct Signature_row {
  std::string name;         ///< of the file
  File_version version;     ///< of the file
  std::size_t vertices = 0; ///< 0: unknown
  std::string status;       ///< "OK", or the code of what is wrong
  std::string map;          ///< "clamped", "barycentric" or "uncertified"; empty without a signature
  std::string message;      ///< what is wrong, in one line; empty if OK
  Mending mending = Mending::NOT_ASKED;
  std::optional<Shape_signature> signature;
  Shape_form form = {};                          ///< of a mesh that has a signature
  std::optional<Refusal> refusal = std::nullopt; ///< what is wrong, of a row that has just been computed
};

/// The index of what `--output` and `--index` name: next to a table .csv it is a file .db of the same name.
std::string index_of(const std::string& file);

/// Signatures of many meshes, a row each, in a database: doc/shape_search.md describes its tables. All functions throw
/// a `Refusal`.
class Shape_index {
public:
  Shape_index(const std::string& file, Database::Access access);

  /// Whether there is a row of the mesh file as it is now, that is also what a run with or without mending gives.
  bool is_current(const std::string& mesh, bool is_mended);

  /// In a transaction of its own.
  void put(const Signature_row& row);

  std::optional<Signature_row> row(const std::string& mesh) const;

  /// Removes the rows of all other meshes. Returns how many.
  std::size_t keep_only(const std::vector<std::string>& meshes);

  /// Distance and name of the k meshes nearest to `query`, nearest first; fewer if there are not so many signatures.
  /// Exact: distances of rounded coordinates, which are quickly read and computed, only tell which rows to look at.
  std::set<std::pair<double, std::string>> nearest(const Shape_signature& query, std::size_t k) const;

  /// Of a mesh that has a signature.
  Shape_description description(const std::string& mesh) const;

private:
  Database database_;
};

} // namespace tool
