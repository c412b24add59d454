// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_SIGNATURE_BATCH_H
#define SPHERICAL_PARAMETERIZATION_TOOL_SIGNATURE_BATCH_H

#include "collections/shape_index.h"
#include "system/progress_bar.h"

#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace tool {

/// The row of a mesh file, on one core: its signature, or what is wrong with it. The same every time, to the last bit.
/// None if the program is interrupted meanwhile.
///
/// The map is the conformal one, also where its only fault is faces flipped in limbs thinner than doubles resolve: all
/// that the signature needs of a map is where the sphere is large. Where the conformal one does not converge, the
/// barycentric one takes its place if it is valid.
std::optional<Signature_row> sign_mesh(const std::string& file);

struct Batch_summary {
  std::size_t meshes = 0;
  std::size_t resumed = 0;                    ///< of these, how many an earlier run had done
  std::size_t removed = 0;                    ///< rows of other meshes
  std::vector<std::string> without_signature; ///< why, one line each
};

/// Brings an index up to date: rows that are missing, or whose mesh file is another one now, are computed and put into
/// it one by one. next(), add() and work() can be called on any threads.
class Signature_batch {
public:
  /// Throws a `Refusal`.
  Signature_batch(const std::vector<std::string>& meshes, const std::string& output);

  /// A mesh to be signed; none if all are under way, or the work is to end.
  std::optional<std::string> next();

  /// A row that is done. What goes wrong is thrown by finish().
  void add(const Signature_row& row);

  /// Signs one mesh after the other until there is none.
  void work();

  /// Once the workers have ended: the index has the rows of the meshes and no others; if the output is a .csv, their
  /// table is written, in the order of the meshes. Throws a `Refusal`, also when interrupted.
  Batch_summary finish();

private:
  std::vector<std::string> meshes_;
  std::string output_;
  Shape_index index_;
  std::mutex mutex_; ///< of all that follows, and the index
  std::vector<std::string> missing_;
  std::size_t started_ = 0, finished_ = 0;
  std::exception_ptr error_;
  std::optional<Progress_bar> bar_;
};

/// Works on a batch until next() has no more meshes.
typedef std::function<void(Signature_batch&)> Batch_workers;

/// Calls `work` on this thread and so many more that they are `threads`, or as many as the system has.
void run_on_threads(int threads, const std::function<void()>& work);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_SIGNATURE_BATCH_H
