// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "collections/shape_index.h"
#include "mapping/prepared_mesh.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tool {

/// The row of a mesh file, on one core: its signature, or what is wrong with it. The same every time, to the last bit.
/// None if the program is interrupted meanwhile. If `mends`, the mesh is mended first, as by the command `prepare`, and
/// `what_was_done` is filled in if it is given.
///
/// The map is the conformal one, also where its only fault is faces flipped in limbs thinner than doubles resolve: all
/// that the signature needs of a map is where the sphere is large. Where the conformal one does not converge, or does
/// not cover the sphere once, the barycentric one takes its place if it is valid.
std::optional<Signature_row> sign_mesh(const std::string& file, bool mends,
                                       std::optional<Prepared_mesh>* what_was_done = nullptr);

struct Batch_summary {
  std::size_t meshes = 0;
  std::size_t resumed = 0;                    ///< of these, how many an earlier run had done
  std::size_t mended = 0;                     ///< that had to be, and have a signature
  std::size_t removed = 0;                    ///< rows of other meshes
  std::vector<std::string> without_signature; ///< why, one line each
};

/// Brings an index up to date: rows that are missing, or whose mesh file is another one now, are computed on so many
/// threads, and put into it one by one. At the end the index has the rows of the meshes and no others; if the output is
/// a .csv, their table is written, in the order of the meshes. Throws a `Refusal`, also when interrupted.
Batch_summary update_index(const std::vector<std::string>& meshes, const std::string& output, int threads, bool mends);

} // namespace tool
