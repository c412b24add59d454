// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_MPI_WORKERS_H
#define SPHERICAL_PARAMETERIZATION_TOOL_MPI_WORKERS_H

#include "collections/signature_batch.h"

#include <functional>

namespace tool {

/// Starts MPI, and runs `action` on rank 0, with the threads of all ranks as workers, so many on each. Returns what it
/// returns; 0 on the others, when all is done.
///
/// Throws a `Refusal` in builds without MPI.
int run_on_all_ranks(int threads_per_rank, const std::function<int(const Batch_workers&)>& action);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_MPI_WORKERS_H
