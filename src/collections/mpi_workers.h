// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_MPI_WORKERS_H
#define SPHERICAL_PARAMETERIZATION_TOOL_MPI_WORKERS_H

#include "collections/signature_workers.h"

#include <functional>

namespace tool {

/// Starts MPI. Rank 0 calls `batch` with the threads of all ranks as its workers, so many on each; the others work for
/// it until it is done. If one rank ends otherwise, all do. Returns what `batch` returns on rank 0, and 0 on the
/// others.
///
/// Throws a `Refusal` in builds without MPI.
int run_on_all_ranks(int threads_per_rank, const std::function<int(Signature_workers&)>& batch);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_MPI_WORKERS_H
