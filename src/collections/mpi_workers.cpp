// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "collections/mpi_workers.h"

#include "collections/signature_pool.h"
#include "system/interruption.h"
#include "system/refusal.h"

#ifdef SPHERICAL_PARAMETERIZATION_WITH_MPI
#include <boost/mpi/collectives.hpp>
#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>

#include <chrono>
#include <utility>
#include <vector>
#endif

namespace tool {

#ifdef SPHERICAL_PARAMETERIZATION_WITH_MPI
namespace {

namespace mpi = boost::mpi;

/// mesh name and line of the index; a mesh to sign comes without a line, and without a name there is no more to come
typedef std::pair<std::string, std::string> Message;
enum Tag { WORK, RESULT };

/// How long threads are waited for before messages are looked at again, and the other way round. Signatures take tens
/// of milliseconds.
constexpr std::chrono::milliseconds poll_interval(2);

/// Rank 0: the threads of all ranks.
class All_ranks : public Signature_workers {
public:
  All_ranks(const mpi::communicator& world, int threads)
    : world_(world), local_(threads), idle_(static_cast<std::size_t>(world.size()), threads)
  {
    idle_[0] = 0; // those of this rank are counted by the pool
  }

  /// The others may end.
  ~All_ranks() override
  {
    for(int rank = 1; rank < world_.size(); ++rank)
      world_.send(rank, WORK, Message());
    for(int rank = 1; rank < world_.size();) { // what is under way must arrive; the last message of each is empty
      Message message;
      world_.recv(mpi::any_source, RESULT, message);
      rank += message.first.empty();
    }
  }

  int idle() const override
  {
    int sum = local_.idle();
    for(int threads : idle_)
      sum += threads;
    return sum;
  }

  void start(const std::string& mesh) override
  {
    for(int rank = 1; rank < world_.size(); ++rank)
      if(idle_[static_cast<std::size_t>(rank)] > 0) {
        --idle_[static_cast<std::size_t>(rank)];
        world_.send(rank, WORK, Message(mesh, ""));
        return;
      }
    local_.start(mesh);
  }

  std::optional<Finished_line> wait() override
  {
    if(const auto status = world_.iprobe(mpi::any_source, RESULT)) {
      Message message;
      world_.recv(status->source(), RESULT, message);
      ++idle_[static_cast<std::size_t>(status->source())];
      return Finished_line{message.first, message.second};
    }
    return local_.wait_for(poll_interval);
  }

private:
  mpi::communicator world_;
  Signature_pool local_;
  std::vector<int> idle_; ///< by rank
};

/// Any other rank.
void work_for_rank_0(const mpi::communicator& world, int threads)
{
  constexpr std::chrono::seconds patience(2);
  Signature_pool pool(threads);
  std::optional<std::chrono::steady_clock::time_point> interrupted;
  for(;;) {
    if(was_interrupted()) {
      const auto now = std::chrono::steady_clock::now();
      if(now - interrupted.value_or(now) > patience) // rank 0 does not know, and would wait for ever
        mpi::environment::abort(1);
      interrupted = interrupted.value_or(now);
    }
    while(world.iprobe(0, WORK)) {
      Message message;
      world.recv(0, WORK, message);
      if(message.first.empty()) {
        world.send(0, RESULT, Message());
        return;
      }
      pool.start(message.first);
    }
    if(const auto result = pool.wait_for(poll_interval))
      world.send(0, RESULT, Message(result->name, result->line));
  }
}

} // namespace

int run_on_all_ranks(int threads_per_rank, const std::function<int(Signature_workers&)>& batch)
{
  const mpi::environment environment(mpi::threading::funneled); // threads compute; one of them talks
  const mpi::communicator world;
  if(world.rank() > 0) {
    work_for_rank_0(world, threads_per_rank);
    return 0;
  }
  All_ranks workers(world, threads_per_rank);
  return batch(workers);
}
#else
int run_on_all_ranks(int, const std::function<int(Signature_workers&)>&)
{
  throw Refusal("NO_MPI", "--mpi", "this build has no MPI support",
                "configure it with CGAL_SP_WITH_MPI=ON, or use --jobs in one process");
}
#endif

} // namespace tool
