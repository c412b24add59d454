// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_SIGNATURE_POOL_H
#define SPHERICAL_PARAMETERIZATION_TOOL_SIGNATURE_POOL_H

#include "collections/signature_workers.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace tool {

/// Threads that turn mesh files into lines of the index. All functions are to be called by one thread, the owner of the
/// pool.
class Signature_pool : public Signature_workers {
public:
  /// With fewer threads if the system has no more. Throws std::system_error if it has none.
  explicit Signature_pool(int threads);

  /// Gives up the work that is not done.
  ~Signature_pool() override;

  Signature_pool(const Signature_pool&) = delete;
  Signature_pool& operator=(const Signature_pool&) = delete;

  int idle() const override { return static_cast<int>(threads_.size()) - busy_; }

  void start(const std::string& mesh) override;
  std::optional<Finished_line> wait() override { return wait_for(std::chrono::milliseconds(100)); }

  /// The next line that is finished, if there is one within that time. Throws what a thread has ended with.
  std::optional<Finished_line> wait_for(std::chrono::milliseconds time);

private:
  void work_or_report();
  void work();

  std::mutex mutex_;
  std::condition_variable has_work_, has_result_;
  std::deque<std::string> meshes_;
  std::deque<Finished_line> finished_;
  std::exception_ptr error_;
  std::atomic<bool> is_cancelled_{false};
  int busy_ = 0; ///< started and not handed out yet
  std::vector<std::thread> threads_;
};

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_SIGNATURE_POOL_H
