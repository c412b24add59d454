// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_SIGNATURE_POOL_H
#define SPHERICAL_PARAMETERIZATION_TOOL_SIGNATURE_POOL_H

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

/// A line of the index that is done.
struct Finished_line {
  std::string name; ///< of the mesh
  std::string line;
};

/// Threads that turn mesh files into lines of the index. All functions are for one thread, their owner's.
class Signature_pool {
public:
  /// With fewer threads if the system has no more. Throws std::system_error if it has none.
  explicit Signature_pool(int threads);

  /// Gives up the work that is not done.
  ~Signature_pool();

  Signature_pool(const Signature_pool&) = delete;
  Signature_pool& operator=(const Signature_pool&) = delete;

  /// How many threads have nothing to do.
  int idle() const { return static_cast<int>(threads_.size()) - busy_; }

  void start(const std::string& mesh);

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
