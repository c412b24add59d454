// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "collections/signature_pool.h"

#include "collections/sign_mesh.h"

#include <system_error>

namespace tool {

Signature_pool::Signature_pool(int threads)
{
  threads_.reserve(static_cast<std::size_t>(threads));
  try {
    for(int i = 0; i < threads; ++i)
      threads_.emplace_back([this] { work_or_report(); });
  } catch(const std::system_error&) { // the system has no more of them
    if(threads_.empty())
      throw;
  }
}

Signature_pool::~Signature_pool()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_cancelled_ = true;
  }
  has_work_.notify_all();
  for(std::thread& thread : threads_)
    thread.join();
}

void Signature_pool::start(const std::string& mesh)
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    meshes_.push_back(mesh);
  }
  ++busy_;
  has_work_.notify_one();
}

std::optional<Finished_line> Signature_pool::wait_for(std::chrono::milliseconds time)
{
  std::unique_lock<std::mutex> lock(mutex_);
  if(!has_result_.wait_for(lock, time, [this] { return !finished_.empty() || error_; }))
    return std::nullopt;
  if(error_)
    std::rethrow_exception(error_);
  Finished_line result = std::move(finished_.front());
  finished_.pop_front();
  --busy_;
  return result;
}

void Signature_pool::work_or_report()
{
  try {
    work();
  } catch(...) { // whatever is wrong with a mesh is in its line: this is about the program, as when memory runs out
    const std::lock_guard<std::mutex> lock(mutex_);
    error_ = std::current_exception();
    has_result_.notify_one();
  }
}

void Signature_pool::work()
{
  for(;;) {
    std::string mesh;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      has_work_.wait(lock, [this] { return is_cancelled_ || !meshes_.empty(); });
      if(is_cancelled_)
        return;
      mesh = std::move(meshes_.front());
      meshes_.pop_front();
    }
    const std::optional<Signature_row> row = sign_mesh(mesh, [this] { return !is_cancelled_; });
    if(!row) // cancelled
      return;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      finished_.push_back({mesh, to_index_line(*row)});
    }
    has_result_.notify_one();
  }
}

} // namespace tool
