// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_SIGNATURE_BATCH_H
#define SPHERICAL_PARAMETERIZATION_TOOL_SIGNATURE_BATCH_H

#include "collections/signature_workers.h"

#include <cstddef>
#include <string>
#include <vector>

namespace tool {

struct Batch_summary {
  std::size_t meshes = 0;
  std::size_t resumed = 0;                    ///< of these, how many an earlier run had done
  std::vector<std::string> without_signature; ///< why, one line each
};

/// Where a batch that writes to `output` keeps what is done.
std::string journal_of(const std::string& output);

/// Writes the index of `meshes` to `output`, in their order. Until it is complete, a journal keeps the rows that are
/// done: a batch that was stopped is resumed, and ends with the same bytes. Rows of files whose size or time of change
/// is another one now are computed again. Throws a `Refusal`, also when interrupted.
Batch_summary run_batch(const std::vector<std::string>& meshes, const std::string& output, Signature_workers& workers);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_SIGNATURE_BATCH_H
