// SPDX-License-Identifier: GPL-3.0-or-later
// What a machine can do to the tool: no space, no permission, no memory, no time, Ctrl-C. Every output is then there
// complete or not at all, no other file is left, and one line says what is wrong.

#include "helpers/meshes.h"
#include "helpers/tool.h"

#include <chrono>
#include <csignal>
#include <cstdint>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <utility>

#include <nlohmann/json.hpp>

#include <sys/mount.h>

using namespace test;

namespace {

namespace fs = std::filesystem;

/// The exit code of what SIGINT has ended.
constexpr int interrupted = 128 + 2;

/// Bytes on a disk as good as full: enough for the line on standard error, which is a file, too, and for no output.
constexpr long little = 600;

std::set<std::string> files_in(const std::string& folder)
{
  std::set<std::string> files;
  for(const auto& entry : fs::directory_iterator(folder))
    files.insert(entry.path().filename().string());
  return files;
}

/// A command that writes, with the names of what it writes, the first one last.
struct Command {
  std::vector<std::string> arguments;
  std::vector<std::string> outputs;
};

/// What the tool says of its commands.
nlohmann::json list_of_steps() { return nlohmann::json::parse(run_tool({"make-list"}).out); }

/// Commands whose output is a folder, which have tests of their own.
const std::set<std::string> write_folders = {"morph", "atlas"};

/// All commands that write files, each with all of its outputs, working on `input` in the folder, where `sphere.off` is
/// its map and `known.db` an index of it.
std::vector<Command> commands(const Scratch& scratch, const std::string& input)
{
  const std::string sphere = scratch / "sphere.off";
  std::vector<Command> all = {{{"map", input, "-o", scratch / "out.off"}, {"out.off"}}};
  for(const auto& step : list_of_steps()) {
    const std::string name = step.at("name"), takes = step.at("takes");
    if(takes == "nothing" || write_folders.count(name) > 0)
      continue;
    Command command = {{name, input}, {}};
    std::vector<std::string>& arguments = command.arguments;
    if(takes == "pair")
      arguments.insert(arguments.end(), {input, "--sphere", sphere, sphere});
    if(step.at("sphere") == "argument")
      arguments.push_back(sphere);
    if(step.at("sphere") == "option")
      arguments.insert(arguments.end(), {"--sphere", sphere});
    if(name == "harmonics")
      arguments.insert(arguments.end(), {"--degree", "5"});
    if(name == "search")
      arguments.insert(arguments.end(), {"--index", scratch / "known.db"});
    for(const auto& output : step.at("outputs")) {
      const std::string option = output.at("option"), extension = output.at("extension"), kind = output.at("kind");
      if(kind == "folder")
        continue;
      const std::string file = option == "--report"   ? "report.json"
                               : kind == "database"   ? "index.csv"
                               : option == "--output" ? "out" + extension
                                                      : option.substr(2) + extension;
      arguments.insert(arguments.end(), {option, scratch / file});
      command.outputs.push_back(file);
    }
    if(name == "texture")
      command.outputs.insert(command.outputs.end(), {"out.mtl", "out.png"});
    all.push_back(command);
  }
  return all;
}

/// Prepares the folder: the input, its map, and an index.
std::string prepare(const Scratch& scratch, int level = 4)
{
  std::string input = write_off(scratch / "in.off", spiky_star(level, 1));
  REQUIRE(run_tool({"map", input, "-o", scratch / "sphere.off"}).exit_code == 0);
  REQUIRE(run_tool({"signature", input, "-o", scratch / "known.db"}).exit_code == 0);
  return input;
}

/// What may be there after a command that failed: an index, which is there to go on from.
const std::vector<std::string> index_files = {"index.db", "index.db-wal", "index.db-shm", "index.db-journal"};

/// What has to hold then: one line, and nothing else that is new but the report of the failure itself.
void check_failed(const Process_result& run, const Scratch& scratch, const std::set<std::string>& before)
{
  CAPTURE(run.out, run.err);
  CHECK(run.exit_code == 1);
  CHECK(is_one_line(run.err));
  CHECK(run.out.empty());
  std::set<std::string> after = files_in(scratch.folder());
  for(const std::string& kept : index_files)
    after.erase(kept);
  after.erase("report.json");
  CHECK(after == before);
}

void remove_outputs(const Scratch& scratch, const Command& command)
{
  for(const std::string& output : command.outputs)
    fs::remove_all(scratch / output);
  for(const std::string& file : index_files)
    fs::remove(scratch / file);
}

} // namespace

TEST_CASE("faults: a disk that is full leaves nothing half-written", "[tool][faults]")
{
  Scratch scratch;
  const std::string input = prepare(scratch);
  const auto before = files_in(scratch.folder());
  for(const Command& command : commands(scratch, input)) {
    CAPTURE(command.arguments);
    REQUIRE(run_tool(command.arguments).exit_code == 0);
    long largest = 0;
    for(const std::string& output : command.outputs)
      largest = std::max(largest, static_cast<long>(fs::file_size(scratch / output)));
    remove_outputs(scratch, command);
    const bool has_seconds =
      command.arguments.front() == "view" || (command.outputs.size() == 1 && command.outputs.front() == "report.json");
    const long too_little = has_seconds ? 50 : 1; // which have some digits more or less
    for(const long space : {little, largest / 2, largest - too_little}) {
      CAPTURE(space);
      Process_options options;
      options.largest_file = space;
      const Process_result run = run_tool(command.arguments, options);
      check_failed(run, scratch, before);
      CHECK(run.err.find("written") != std::string::npos);
      remove_outputs(scratch, command);
    }
  }
}

TEST_CASE("faults: a disk that is full ends a compressed output, too", "[tool][faults]")
{
  Scratch scratch;
  const std::string input = prepare(scratch);
  const auto before = files_in(scratch.folder());
  Process_options options;
  options.largest_file = 8192; // the output has more, however well it is compressed
  for(const char* name : {"out.off.gz", "out.off.xz", "out.off.zst", "out.off.bz2"}) {
    CAPTURE(name);
    const Process_result run = run_tool({"map", input, "-o", scratch / name}, options);
    check_failed(run, scratch, before);
    CHECK(run.err.find("could not be written completely") != std::string::npos);
  }
}

TEST_CASE("faults: no folder for temporary files", "[tool][faults]")
{
  Scratch scratch;
  const std::string input = prepare(scratch, 1);
  const Process_result run =
    run_process({"/usr/bin/env", "TMPDIR=" + scratch / "none", TOOL, "map", input, "-o", "-", "--format", "off"});
  check_failed(run, scratch, files_in(scratch.folder()));
  CHECK(run.err.find("set TMPDIR") != std::string::npos);
}

TEST_CASE("faults: every command that writes is tried", "[tool][faults]")
{
  Scratch scratch;
  std::set<std::string> tried = write_folders, all;
  for(const Command& command : commands(scratch, "in.off"))
    tried.insert(command.arguments.front());
  for(const auto& step : list_of_steps())
    if(!step.at("outputs").empty())
      all.insert(step.at("name"));
  CHECK(tried == all);
  CHECK(all.size() >= 13);
}

TEST_CASE("faults: of the steps of morph, of an atlas, and of parts, all are written or none", "[tool][faults]")
{
  Scratch scratch;
  const std::string input = prepare(scratch, 2), sphere = scratch / "sphere.off";
  fs::create_directory(scratch / "meshes");
  for(const double stretch : {1., 1.5})
    write_off(scratch / ("meshes/" + std::to_string(int(2 * stretch)) + ".off"), ellipsoid(1, stretch, 2, 2));
  const auto check = [&](const std::vector<std::string>& command, const std::string& largest,
                         const std::vector<std::string>& outputs) {
    REQUIRE(run_tool(command).exit_code == 0);
    Process_options options;
    options.largest_file =
      static_cast<long>(fs::file_size(scratch / largest)) - 100; // seconds have more or fewer digits
    for(const std::string& output : outputs) {
      CHECK(fs::exists(scratch / output));
      fs::remove(scratch / output);
    }
    CHECK(run_tool(command, options).exit_code == 1);
    for(const std::string& output : outputs)
      CHECK_FALSE(fs::exists(scratch / output));
  };
  check({"morph", input, input, "--sphere", sphere, sphere, "-o", scratch / "way", "--steps", "2"}, "way/morph.html",
        {"way/morph.html", "way/step_0.ply", "way/step_1.ply", "way/step_2.ply"});
  check({"atlas", scratch / "meshes", "-o", scratch / "atlas", "--level", "4"}, "atlas/variance.ply",
        {"atlas/variance.ply", "atlas/mean.ply", "atlas/scores.csv", "atlas/report.json", "atlas/modes/mode_1_plus.ply",
         "atlas/modes/mode_1_minus.ply"});
  check({"prepare", write_off(scratch / "two.off", joined(icosphere(0), icosphere(0), Vector(9, 0, 0))), "-o",
         scratch / "part.off", "--steps", "merge,split", "--report", scratch / "report.json"},
        "report.json", {"part_1.off", "part_2.off", "report.json"});
}

TEST_CASE("faults: an old output stays as it was where the new one cannot be written", "[tool][faults]")
{
  Scratch scratch;
  const std::string input = prepare(scratch);
  for(const Command& command : commands(scratch, input)) {
    CAPTURE(command.arguments);
    for(const std::string& output : command.outputs)
      if(output != "report.json")
        write_text(scratch / output, "old");
    const auto before = files_in(scratch.folder());
    Process_options options;
    options.largest_file = little;
    check_failed(run_tool(command.arguments, options), scratch, before);
    for(const std::string& output : command.outputs)
      if(output != "report.json")
        CHECK(text_of(scratch / output) == "old");
    remove_outputs(scratch, command);
  }
}

TEST_CASE("faults: a folder that does not exist, and a folder in the place of a file", "[tool][faults]")
{
  Scratch scratch;
  const std::string input = prepare(scratch);
  for(const Command& command : commands(scratch, input))
    for(const std::string& output : command.outputs) {
      if(output == "report.json" || output == "out.mtl" || output == "out.png")
        continue;
      CAPTURE(command.arguments, output);
      const auto before = files_in(scratch.folder());
      std::vector<std::string> arguments = command.arguments;
      std::replace(arguments.begin(), arguments.end(), scratch / output, scratch / ("no folder/" + output));
      check_failed(run_tool(arguments), scratch, before);
      remove_outputs(scratch, command);

      fs::create_directory(scratch / output);
      const Process_result run = run_tool(command.arguments);
      CAPTURE(run.err);
      CHECK(run.exit_code != 0);
      CHECK_FALSE(run.err.empty());
      CHECK(fs::is_empty(scratch / output));
      remove_outputs(scratch, command);
      CHECK(files_in(scratch.folder()) == before);
    }
}

namespace {

/// A disk of its own in the place of a folder, if we may.
class Small_disk {
public:
  Small_disk(std::string folder, const std::string& size)
    : folder_(std::move(folder)), is_there_(mount("tmpfs", folder_.c_str(), "tmpfs", 0, ("size=" + size).c_str()) == 0)
  {}
  ~Small_disk()
  {
    if(is_there_)
      umount(folder_.c_str());
  }
  Small_disk(const Small_disk&) = delete;
  Small_disk& operator=(const Small_disk&) = delete;

  bool is_there() const { return is_there_; }

  /// Fills it but for so many bytes, or a few more.
  void leave(std::uintmax_t bytes) const
  {
    const std::string filler = folder_ + "/filler";
    write_text(filler, "");
    write_text(filler, std::string(fs::space(folder_).available - bytes, 'x'));
  }

private:
  std::string folder_;
  bool is_there_;
};

} // namespace

TEST_CASE("faults: a disk that is full, and not only for one file", "[tool][faults]")
{
  Scratch scratch;
  const Small_disk disk(scratch.folder(), "16m");
  if(!disk.is_there()) {
    std::cout << "SKIPPED: this user may not mount a tmpfs" << std::endl;
    return;
  }
  const std::string input = prepare(scratch);
  for(const Command& command : commands(scratch, input)) {
    CAPTURE(command.arguments);
    REQUIRE(run_tool(command.arguments).exit_code == 0);
    std::uintmax_t all = 0;
    for(const std::string& output : command.outputs)
      all += fs::file_size(scratch / output);
    remove_outputs(scratch, command);
    for(const std::uintmax_t space : {std::uintmax_t(0), all / 2}) {
      CAPTURE(space);
      disk.leave(space);
      const auto before = files_in(scratch.folder());
      const Process_result run = run_tool(command.arguments);
      check_failed(run, scratch, before);
      CHECK(run.err.find("written") != std::string::npos);
      CHECK(run.err.find("Success") == std::string::npos); // as the reason
      fs::remove(scratch / "filler");
      remove_outputs(scratch, command);
    }
  }
}

TEST_CASE("faults: folders and files that one may not write or read", "[tool][faults]")
{
  Scratch scratch;
  const std::string input = prepare(scratch);
  Process_options options;
  options.as_nobody = true;
  if(run_tool({"--version"}, options).exit_code != 0) {
    std::cout << "SKIPPED: the user nobody may not run the tool where it is" << std::endl;
    return;
  }
  fs::create_directory(scratch / "closed");
  fs::copy(input, scratch / "closed/in.off");
  fs::permissions(scratch / "closed", fs::perms::none);
  for(const char* extension : {".off", ".obj", ".ply", ".stl"}) {
    fs::copy(input, scratch / ("unreadable" + std::string(extension)));
    fs::permissions(scratch / ("unreadable" + std::string(extension)), fs::perms::none);
  }
  const auto before = files_in(scratch.folder());
  for(const char* file : {"closed/in.off", "unreadable.off", "unreadable.obj", "unreadable.ply", "unreadable.stl"}) {
    CAPTURE(file);
    const Process_result run = run_tool({"map", scratch / file, "-o", scratch / "out.off"}, options);
    check_failed(run, scratch, before);
    CHECK((run.err.find("Permission denied") != std::string::npos || run.err.find("may be read") != std::string::npos));
  }
  fs::permissions(scratch.folder(),
                  fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read | fs::perms::others_exec);
  for(const Command& command : commands(scratch, input)) {
    CAPTURE(command.arguments);
    const Process_result run = run_tool(command.arguments, options);
    check_failed(run, scratch, before);
    CHECK(run.err.find("Permission denied") != std::string::npos);
  }
  for(const std::string& path : {scratch.folder(), scratch / "closed"})
    fs::permissions(path, fs::perms::owner_all);
}

TEST_CASE("faults: a batch goes on with the threads it can have", "[tool][faults]")
{
  Scratch scratch;
  for(int i = 0; i < 5; ++i)
    write_off(scratch / ("in_" + std::to_string(i) + ".off"), spiky_star(3, 1 + i));
  REQUIRE(run_tool({"signature", scratch.folder(), "-o", scratch / "expected.csv", "-j", "1"}).exit_code == 0);
  constexpr long gibi = 1 << 30;
  Process_options options;
  options.address_space = 4 * gibi;
  options.stack = gibi; // so that there is room for two or three
  const Process_result run =
    run_tool({"signature", scratch.folder(), "-o", scratch / "index.csv", "-j", "64"}, options);
  CAPTURE(run.err);
  CHECK(run.exit_code == 0);
  CHECK(text_of(scratch / "index.csv") == text_of(scratch / "expected.csv"));

  fs::remove(scratch / "index.db");
  options.stack = 8 * gibi; // and for none but the first
  CHECK(run_tool({"signature", scratch.folder(), "-o", scratch / "index.csv", "-j", "64"}, options).exit_code == 0);
  CHECK(text_of(scratch / "index.csv") == text_of(scratch / "expected.csv"));
}

TEST_CASE("faults: too little memory is said in one line, whenever it is missing", "[tool][faults]")
{
  Scratch scratch;
  const std::string input = prepare(scratch, 6); // which needs more than the program does without a mesh
  const auto before = files_in(scratch.folder());
  constexpr long mebi = 1 << 20;
  // A program in which nothing is needed but the libraries tells where to begin.
  long enough = 16 * mebi;
  for(Process_options options; options.address_space = enough, run_tool({"--version"}, options).exit_code != 0;)
    enough += 4 * mebi;
  for(const Command& command : commands(scratch, input)) {
    std::vector<std::string> arguments = command.arguments;
    const std::set<std::string> with_policy = {"harmonics", "map",     "register", "resample",
                                               "segment",   "texture", "view"};
    if(with_policy.count(arguments.front()) > 0) // threads of TBB need more than the rest
      arguments.insert(arguments.end(), {"--policy", "sequential"});
    if(arguments.front() == "signature")
      arguments.insert(arguments.end(), {"-j", "1"});
    CAPTURE(arguments);
    int failures = 0;
    bool is_done = false;
    for(long space = enough; !is_done; space += 16 * mebi) {
      REQUIRE(space < enough + 1024 * mebi);
      Process_options options;
      options.address_space = space;
      const Process_result run = run_tool(arguments, options);
      CAPTURE(space / mebi, run.exit_code, run.err);
      is_done = run.exit_code == 0;
      if(!is_done) {
        ++failures;
        CHECK(run.exit_code == 1);
        CHECK(is_one_line(run.err));
        std::set<std::string> after = files_in(scratch.folder());
        for(const std::string& kept : index_files) // with a row that says so
          after.erase(kept);
        after.erase("index.csv");
        after.erase("report.json");
        CHECK(after == before);
      }
      remove_outputs(scratch, command);
    }
    CHECK(failures > 0);
  }
}

namespace {

struct Mapping {
  std::vector<std::string> options;
  bool is_endless; ///< does it go on for longer than the test?
};

std::vector<Mapping> mappings()
{
  return {{{"--method", "balanced"}, false},
          {{"--method", "balanced", "--spring-exponent", "4"}, false},
          {{"--method", "saddle-point", "--accuracy", "1e-14"}, true},
          {{"--method", "saddle-point", "--splitting", "gauss-seidel", "--accuracy", "1e-14"}, true},
          {{"--method", "isometric"}, false},
          {{"--method", "automatic"}, false}};
}

/// Without the lines of a driver whose compiler has been stopped, too.
std::string own_words(const std::string& text)
{
  std::istringstream lines(text);
  std::string words;
  for(std::string line; std::getline(lines, line);)
    if(line.find("spherical-parameterization: ") == 0)
      words += line + '\n';
  return words;
}

/// Stops the command at moments all over its time, by `stop(milliseconds, arguments)`, and checks that it ends soon,
/// with all of its output or with none.
template <class Stop>
void check_stops(const Scratch& scratch, const std::vector<std::string>& arguments, bool is_endless, int expected,
                 const Stop& stop)
{
  typedef std::chrono::steady_clock Clock;
  constexpr std::chrono::milliseconds soon(10000); // on a busy machine, too
  const auto before = files_in(scratch.folder());
  std::chrono::milliseconds time(2000);
  if(!is_endless) {
    const auto begin = Clock::now();
    REQUIRE(run_tool(arguments).exit_code == 0);
    time = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - begin);
    fs::remove(scratch / "out.off");
  }
  for(const double share : {0.02, 0.15, 0.35, 0.55, 0.75, 0.95}) {
    const int after = std::max(1, static_cast<int>(share * static_cast<double>(time.count())));
    const auto begin = Clock::now();
    const Process_result run = stop(after, arguments);
    CAPTURE(arguments, after, run.exit_code, run.out, run.err);
    CHECK(Clock::now() - begin < std::chrono::milliseconds(after) + soon);
    if(run.exit_code == 0) { // it was done before
      CHECK_FALSE(is_endless);
      CHECK(run.err.empty());
      CHECK(read(scratch / "out.off").points.size() == read(scratch / "in.off").points.size());
      fs::remove(scratch / "out.off");
    } else {
      CHECK(run.exit_code == expected);
      const std::string words = own_words(run.err);
      CHECK((is_one_line(words) || (expected == interrupted && words.empty()))); // if it had not begun yet
    }
    CHECK(files_in(scratch.folder()) == before);
  }
}

std::vector<std::string> policies()
{
  std::vector<std::string> names = {"sequential"};
#ifdef CGAL_LINKED_WITH_TBB
  names.emplace_back("tbb");
#endif
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
  if(some_policy<CGAL::Spherical_parameterization::OpenCL_device>())
    names.emplace_back("opencl");
#endif
  return names;
}

template <class Stop>
void check_stops_of_all_methods(int expected, const Stop& stop)
{
  Scratch scratch;
  for(const std::string& policy : policies()) {
    for(const Mapping& mapping : mappings()) {
      const int level = policy == "opencl" || mapping.is_endless ? 5 : 4; // devices are not used for less
      const std::string input = write_off(scratch / "in.off", spiky_star(level, 1));
      std::vector<std::string> arguments = {"map", input, "-o", scratch / "out.off", "--policy", policy};
      arguments.insert(arguments.end(), mapping.options.begin(), mapping.options.end());
      check_stops(scratch, arguments, mapping.is_endless, expected, stop);
    }
  }
}

} // namespace

TEST_CASE("faults: SIGINT in any phase of any method ends it in good order", "[tool][faults]")
{
  check_stops_of_all_methods(interrupted, [](int after, const std::vector<std::string>& command) {
    Process_options options;
    options.interrupt_after = after;
    return run_tool(command, options);
  });
}

TEST_CASE("faults: the time limit in any phase of any method ends it in good order", "[tool][faults]")
{
  check_stops_of_all_methods(1, [](int after, std::vector<std::string> command) {
    command.insert(command.end(), {"--max-time", std::to_string(after / 1000.)});
    return run_tool(command);
  });
}

TEST_CASE("faults: SIGINT in a command that uses a map", "[tool][faults]")
{
  Scratch scratch;
  const std::string input = prepare(scratch);
  for(const Command& command : commands(scratch, input)) {
    if(command.arguments.front() == "map")
      continue;
    for(const int after : {1, 5, 10, 20, 40, 80, 160}) {
      const auto before = files_in(scratch.folder());
      Process_options options;
      options.interrupt_after = after;
      const Process_result run = run_tool(command.arguments, options);
      CAPTURE(command.arguments, after, run.exit_code, run.out, run.err);
      if(run.exit_code == 0)
        for(const std::string& output : command.outputs)
          CHECK(fs::exists(scratch / output));
      else {
        CHECK(run.exit_code == interrupted);
        CHECK((is_one_line(run.err) || run.err.empty()));
        std::set<std::string> left = files_in(scratch.folder());
        for(const std::string& kept : index_files)
          left.erase(kept);
        CHECK(left == before);
      }
      remove_outputs(scratch, command);
    }
  }
}

TEST_CASE("faults: kill -9 in a command leaves what is complete, and nothing else with a name", "[tool][faults]")
{
  Scratch scratch;
  const std::string input = prepare(scratch);
  for(const Command& command : commands(scratch, input)) {
    REQUIRE(run_tool(command.arguments).exit_code == 0);
    std::map<std::string, std::uintmax_t> whole;
    for(const std::string& output : command.outputs)
      whole[output] = fs::file_size(scratch / output);
    const std::uintmax_t digits = command.arguments.front() == "view" ? 50 : 0; // of the seconds in it, more or less
    remove_outputs(scratch, command);
    for(const int after : {5, 20, 60}) {
      Process_options options;
      options.meanwhile = [after](int pid) {
        std::this_thread::sleep_for(std::chrono::milliseconds(after));
        kill(pid, SIGKILL);
      };
      run_tool(command.arguments, options);
      CAPTURE(command.arguments, after);
      for(const auto& [output, size] : whole)
        if(output != "report.json" && fs::exists(scratch / output)) { // which has seconds, too
          CHECK(fs::file_size(scratch / output) >= size - digits);
          CHECK(fs::file_size(scratch / output) <= size + digits);
        }
      REQUIRE(run_tool(command.arguments).exit_code == 0); // as if nothing had been
      remove_outputs(scratch, command);
    }
  }
}

TEST_CASE("faults: a standard output that cannot be written", "[tool][faults]")
{
  Scratch scratch;
  const std::string input = prepare(scratch, 2);
  std::vector<std::vector<std::string>> all = {{"--version"}, {"--help"}, {"map", "--help"}, {"devices"}};
  for(const Command& command : commands(scratch, input))
    all.push_back(command.arguments);
  for(const std::vector<std::string>& arguments : all) {
    std::vector<std::string> command = {"/bin/sh", "-c", "exec \"$0\" \"$@\" > /dev/full", TOOL};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const Process_result run = run_process(command);
    CAPTURE(arguments, run.err);
    CHECK(run.exit_code == 1);
    CHECK(is_one_line(run.err));
    CHECK(run.err.find("standard output") != std::string::npos);
  }
}
