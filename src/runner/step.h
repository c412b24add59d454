// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "collections/mesh_collection.h"
#include "mapping/mapped_mesh.h"
#include "mapping/report.h"
#include "options/command_line.h"
#include "options/mapping_options.h"
#include "output/atomic_file.h"
#include "output/write_mesh.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <map>
#include <optional>
#include <ostream>
#include <set>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace tool {

struct Step;
struct Work;

/// What was asked of a step: what it works on, and where it is to write.
struct Request {
  Mapping_options options;                    ///< the mesh, and how it comes by its map
  std::string other;                          ///< the second mesh of a pair
  std::vector<std::string> spheres;           ///< of both
  Collection_options meshes;                  ///< of a step that takes them together
  std::map<std::string, std::string> outputs; ///< files by the options that name them, as in "--labels"
  std::string format;                         ///< of the mesh that is --output; empty: its name says it
  bool ascii = false;
  bool is_one_of_many = false;
  std::map<std::string, std::string> given; ///< what was typed, by the names of options

  /// The file; empty if it was not asked for.
  const std::string& file(const std::string& option = "--output") const;

  /// How to write this mesh. Throws a `CLI::ValidationError` if its name does not say it.
  Output_format mesh_format(const std::string& option = "--output") const;

  bool has(const std::string& option) const { return given.count(option) > 0; }

  /// What was typed: all on which results depend but for the program and the files. `left_out` are options on which
  /// they do not depend.
  std::string settings(const std::set<std::string>& left_out = {}) const;
};

/// A step at work on one mesh, or on all that it takes together. A step is
///
///     run.read();      // refuses what is not a triangulated sphere
///     run.map();       // refuses what has no certified map
///     *run.out("--output") << ...;
///     run.commit();    // now the files get their names
///     run.line = ...;
///
/// What cannot be written is refused before the work. Files get their names together, when all have been written, or
/// never.
class Run : public Request {
public:
  explicit Run(const Request& request) : Request(request) {}

  void read()
  {
    read_input(options, input);
    data = input.file->data;
    annotations = input.file->annotations;
  }
  void map() { map_input(options, input); }
  const Mesh& mesh() const { return input.mesh(); }

  /// The file of this option; null if it was not asked for.
  std::ostream* out(const std::string& option = "--output");

  /// Writes a mesh there, if it was asked for, with `data` and `annotations`.
  void write(const std::string& option, const Mesh& mesh, const std::vector<Point>& points, Surface surface);

  /// One more file that gets its name with the others.
  std::ostream& open(const std::string& file) { return files_.open(file); }

  /// All files that are open have been written: for those who write more than a process may have open.
  void complete() { files_.complete(); }

  /// Gives the files their names, with the report. Throws a `Refusal`, also when interrupted. A step that has nothing
  /// to say of it need not call it. \param is_late  something has got its name already: an interruption comes too late
  void commit(bool is_late = false);

  /// How messages call the mesh, and --output.
  std::string name_of_input() const;
  std::string name_of_output() const;

  Mapped_mesh input;
  Vertex_data data;        ///< at the vertices of the meshes that are written, and for --data-output: those of `input`
  Annotations annotations; ///< of these meshes
  Report figures;
  Json details;      ///< what the report says besides
  std::string text;  ///< for people, of a mesh alone; lines without the end of the last one. Also said with a refusal
  std::string line;  ///< of one among many, if it is not refused: does not name the mesh, and is the same in every run
  int exit_code = 0; ///< 1: something was refused, and the rest done

private:
  friend Outcome perform(const Step& step, const Work& work, Run& run);
  void begin(const Step& step);
  void write_report();

  Atomic_files report_, files_;
  std::map<std::string, std::ostream*> streams_;
  Stopwatch total_;
  bool has_maps_ = false;
  bool is_committed_ = false;
};

/// Writes a file for people and programs: indented, with a line end. Bytes of file names that are no UTF-8 are
/// replaced.
void write_json(std::ostream& out, const Json& json);

/// Does the work of a request, with its files and its report.
Outcome perform(const Step& step, const Work& work, Run& run);

/// A file that a step writes.
struct Output {
  std::string names; ///< of its option, as in "-o,--output"
  std::string description;
  std::vector<std::string> extensions = {}; ///< that it may have, the first one in a folder; none: any
  enum Kind { FILE, MESH, FOLDER, DATABASE } kind = FILE;
  enum When { IF_NAMED, REQUIRED, ALWAYS } when = IF_NAMED; ///< always: if not named, IN with the extension, here

  std::string option() const { return names.substr(names.rfind(',') + 1); }
};

/// What a step reads.
struct Takes {
  enum Meshes {
    NONE,
    EACH,     ///< IN, one or many, each by itself
    PAIR,     ///< A and B
    TOGETHER, ///< IN, many
    ONE       ///< QUERY
  } meshes = NONE;
  const char* method = nullptr; ///< default of how they are mapped; null: they are not
  const char* weights = "conformal";
  enum Sphere { NO_SPHERE, OPTION, ARGUMENT } sphere = NO_SPHERE; ///< that was made before
  Prepare prepare = Prepare::NO;                                  ///< what --prepare does
  const char* prepared = "the result is for all faces of IN";
  const char* what = nullptr; ///< is IN; null: closed meshes
};

/// What a step does.
struct Work {
  typedef std::vector<File_option> Files;

  std::function<void(Run&)> run;                         ///< does it; throws
  Options options = {};                                  ///< its own
  std::function<void(const Request&)> check = nullptr;   ///< throws what is wrong usage
  std::function<Files(const Request&)> reads = nullptr;  ///< besides what it takes
  std::function<Files(const Request&)> writes = nullptr; ///< besides what options name
};

/// A command of the tool, as data: all that its command line has, and what is common to all, comes from it.
struct Step {
  std::string name;
  std::string summary;
  Takes takes;
  std::vector<Output> gives; ///< --output first
  std::function<Work()> work;
  std::string example; ///< of a command line, without the program
  std::string notes = "";
};

/// All of them.
const std::vector<Step>& steps();

/// What is made from the steps when the program is built, and for the tests, if that is what the command line asks for:
/// the man page (of `make-man-page FRAME`), the completion in bash, the table of the manual, the list of the steps.
std::optional<std::string> manual(const CLI::App& app, const std::vector<Step>& all, int argc, char** argv);

/// The program: parses the command line, and runs its step. Returns the exit code: 0, 1 for a failure, 2 for wrong
/// usage. Throws what is thrown outside of a step.
int run(int argc, char** argv, const std::vector<Step>& all);

} // namespace tool
