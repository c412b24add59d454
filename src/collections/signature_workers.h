// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_SIGNATURE_WORKERS_H
#define SPHERICAL_PARAMETERIZATION_TOOL_SIGNATURE_WORKERS_H

#include <optional>
#include <string>

namespace tool {

/// A line of the index that is done.
struct Finished_line {
  std::string name; ///< of the mesh
  std::string line;
};

/// What turns meshes into lines of the index for a batch: the threads of this process, or those of all ranks.
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

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_SIGNATURE_WORKERS_H
