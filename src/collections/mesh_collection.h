// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "input/files.h"
#include "options/command_line.h"
#include "system/refusal.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tool {

/// Which meshes a step works on, and how many of them at the same time.
struct Collection_options {
  std::vector<std::string> inputs;
  std::string list;
  std::optional<std::int64_t> jobs;
  std::vector<std::string> names; ///< `inputs`, and what is in `list`, which is read once

  /// To be called before what follows. Throws a `Refusal`.
  void read_list() { names = named_inputs(inputs, list); }

  /// Each once, folders replaced by the mesh files in them and in their subfolders. Throws a `Refusal`, also if there
  /// is none.
  std::vector<std::string> meshes() const;

  /// All cores if it was not given.
  int number_of_jobs() const;
};

/// One mesh among many.
struct Item {
  std::string mesh; ///< its file, by the name that the user has for it
  std::string name; ///< of its outputs: their path in the output folder, without extension
};

/// The meshes that the user means, but for those in the other folders, which are those of outputs and the like, if
/// these are in a folder of IN. The name of an item is the path of the mesh below the folder that all of IN have in
/// common, so that meshes of the same name in several folders do not meet; without the extension, unless two of them
/// differ in that only.
///
/// Throws a `Refusal` if there is none, and `CLI::ValidationError` if one of the other folders is a folder of IN.
std::vector<Item> items_of(const Collection_options& options, const std::vector<File_option>& other_folders);

/// The mesh files of a folder and its subfolders, by the names of the items that they are the spheres of; empty for a
/// name that several of them have, with other extensions. None if there is no folder. Throws a `Refusal`.
std::map<std::string, std::string> spheres_in(const std::string& folder);

/// The work on an item.
struct Job {
  std::vector<std::string> inputs;  ///< files that it reads besides the mesh
  std::vector<std::string> outputs; ///< files that it writes
  std::function<Outcome()> run;     ///< called on any thread; does not throw
};

/// Work on many meshes.
struct Collection {
  std::string folder;   ///< of the outputs; empty: there are none, and what is done is not remembered
  std::string settings; ///< all that the results depend on but for the files
  std::vector<Item> items;
  std::function<Job(const Item&)> job; ///< cheap
  int threads;
  /// Told, if it is there, of every item at the end: "OK", or the code of its refusal, and the line.
  std::function<void(const Item&, const std::string& status, const std::string& line)> tell = nullptr;
};

/// Does the work that is not done: every item whose mesh, inputs, settings or outputs are not what the file `meshes.db`
/// in the output folder says of an earlier run. It gets a row of the item, in a transaction, when the outputs have
/// their names. Prints a line per item on stdout, in the order of the items and only when it is in `meshes.db`, and a
/// summary.
///
/// Returns the exit code: 1 if a mesh was refused. What is not about a mesh, as a full disk, is thrown as a `Refusal`,
/// and so is an interruption; outputs that would take the place of each other, or of what is read, as
/// `CLI::ValidationError`, before any work.
int run_collection(const Collection& collection);

} // namespace tool
