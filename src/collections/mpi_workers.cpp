// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "collections/mpi_workers.h"

#include "system/refusal.h"

#ifdef SPHERICAL_PARAMETERIZATION_WITH_MPI
#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>
#include <boost/serialization/array.hpp>
#include <boost/serialization/string.hpp>

#include <chrono>
#include <exception>
#include <future>
#include <iostream>
#include <mutex>
#include <thread>

namespace boost::serialization {

template <class Archive>
void serialize(Archive& archive, tool::Signature_row& row, unsigned)
{
  bool has_signature = row.signature.has_value();
  archive& row.name& row.version.bytes& row.version.changed& row.version.hash& row.vertices& row.status& row.map& row
    .message& has_signature;
  if(has_signature && !row.signature)
    row.signature.emplace();
  if(has_signature)
    archive& row.signature->values;
}

} // namespace boost::serialization
#endif

namespace tool {

#ifdef SPHERICAL_PARAMETERIZATION_WITH_MPI
namespace {

namespace mpi = boost::mpi;

/// A thread sends a row, without a name if it has none, and gets the name of a mesh, which is empty if there are no
/// more. A rank whose threads have ended says so.
enum Tag { ROW, MESH, END };

/// Rank 0: hands out meshes until the other ranks have ended.
void serve(const mpi::communicator& world, Signature_batch& batch)
{
  constexpr std::chrono::microseconds pause(500); // signatures take tens of milliseconds
  for(int others = world.size() - 1; others > 0;) {
    const auto status = world.iprobe();
    if(!status) {
      std::this_thread::sleep_for(pause);
      continue;
    }
    Signature_row row;
    world.recv(status->source(), status->tag(), row);
    if(status->tag() == END) {
      --others;
      continue;
    }
    if(!row.name.empty())
      batch.add(row);
    world.send(status->source(), MESH, batch.next().value_or(""));
  }
}

/// Any other rank.
void work_for_rank_0(const mpi::communicator& world, int threads)
{
  std::mutex mutex; // of MPI
  run_on_threads(threads, [&] {
    Signature_row row;
    for(;;) {
      std::string mesh;
      {
        const std::lock_guard<std::mutex> lock(mutex);
        world.send(0, ROW, row);
        world.recv(0, MESH, mesh);
      }
      if(mesh.empty())
        return;
      row = sign_mesh(mesh).value_or(Signature_row()); // none if it was interrupted, which rank 0 will miss
    }
  });
  world.send(0, END, Signature_row());
}

} // namespace

int run_on_all_ranks(int threads_per_rank, const std::function<int(const Batch_workers&)>& action)
{
  const mpi::environment environment(mpi::threading::serialized); // one thread at a time talks
  const mpi::communicator world;
  if(world.rank() > 0) {
    work_for_rank_0(world, threads_per_rank);
    return 0;
  }
  try {
    return action([&](Signature_batch& batch) {
      const auto local =
        std::async(std::launch::async, [&] { run_on_threads(threads_per_rank, [&] { batch.work(); }); });
      serve(world, batch);
    }); // when local is gone, so are its threads
  } catch(const std::exception& exception) {
    std::cerr << "spherical-parameterization: " << exception.what() << std::endl;
    mpi::environment::abort(1); // the other ranks may be waiting
    return 1;
  }
}
#else
int run_on_all_ranks(int, const std::function<int(const Batch_workers&)>&)
{
  throw Refusal("NO_MPI", "--mpi", "this build has no MPI support",
                "configure it with CGAL_SP_WITH_MPI=ON, or use --jobs in one process");
}
#endif

} // namespace tool
