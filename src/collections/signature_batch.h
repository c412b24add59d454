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

/// Writes the index of `meshes` to `output`, in their order. What is done is kept in a journal as long as not all is: a
/// batch that was stopped, however, goes on where it was, and ends with the same bytes.
/// Throws a `Refusal`, also when interrupted.
Batch_summary run_batch(const std::vector<std::string>& meshes, const std::string& output, Signature_workers& workers);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_SIGNATURE_BATCH_H
