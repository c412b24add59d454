// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_SIGNATURE_WORKERS_H
#define SPHERICAL_PARAMETERIZATION_TOOL_SIGNATURE_WORKERS_H

#include "collections/signature_pool.h"

#include <optional>
#include <string>

namespace tool {

/// Whoever turns meshes into lines of the index for a batch: the threads of this process, or those of all ranks.
class Signature_workers {
public:
  virtual ~Signature_workers() = default;

  /// How many meshes can be handed out now.
  virtual int idle() const = 0;

  /// \pre idle() > 0
  virtual void start(const std::string& mesh) = 0;

  /// The next line that is finished, if there is one soon.
  virtual std::optional<Finished_line> wait() = 0;
};

/// The threads of this process.
class Local_workers : public Signature_workers {
public:
  explicit Local_workers(int threads) : pool_(threads) {}

  int idle() const override { return pool_.idle(); }
  void start(const std::string& mesh) override { pool_.start(mesh); }
  std::optional<Finished_line> wait() override { return pool_.wait_for(std::chrono::milliseconds(100)); }

private:
  Signature_pool pool_;
};

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_SIGNATURE_WORKERS_H
