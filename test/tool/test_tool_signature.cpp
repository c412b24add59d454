// SPDX-License-Identifier: GPL-3.0-or-later
// The command signature: rows, bad meshes, and batches that are stopped.

#include "helpers/meshes.h"
#include "helpers/tool.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

using namespace test;
namespace fs = std::filesystem;

namespace {

/// A folder of 24 meshes, two of them bad.
std::string make_folder(const Scratch& scratch)
{
  std::string folder = scratch / "meshes";
  fs::create_directories(folder + "/more");
  for(int i = 0; i < 22; ++i)
    write_off(folder + (i % 2 ? "/more/" : "/") + std::to_string(i) + ".off", i % 3 == 0 ? dumbbell(4)
                                                                              : i % 3 == 1
                                                                                ? ellipsoid(1, 1 + 0.1 * i, 2, 4)
                                                                                : spiky_star(4, 1 + 0.1 * i));
  write_off(folder + "/torus.off", torus(8, 8));
  write_text(folder + "/more/broken.off", "OFF\n1 2");
  write_text(folder + "/no_mesh.txt", "not looked at");
  return folder;
}

std::size_t lines_in(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(in), {});
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// Waits until the journal has so many lines, the header included.
void wait_for_lines(const std::string& journal, std::size_t lines)
{
  for(int i = 0; i < 60000 && lines_in(journal) < lines; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

std::string undisturbed(const Scratch& scratch, const std::string& folder)
{
  const std::string output = scratch / "undisturbed.csv";
  const Process_result run = run_tool({"signature", folder, "-o", output});
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK_FALSE(fs::exists(output + ".journal"));
  return text_of(output);
}

/// The same command again, which ends with the same file and says that it had something to start from.
void check_resumed(const std::vector<std::string>& command, const std::string& output, const std::string& expected)
{
  CHECK_FALSE(fs::exists(output));
  const Process_result run = run_process(command);
  CAPTURE(run.out, run.err);
  CHECK(run.exit_code == 0);
  CHECK(run.out.find("from an earlier run") != std::string::npos);
  CHECK(text_of(output) == expected);
  CHECK_FALSE(fs::exists(output + ".journal"));
}

} // namespace

TEST_CASE("signature: a row for every mesh, in the order of the names", "[tool][signature]")
{
  Scratch scratch;
  const std::string folder = make_folder(scratch);
  const std::vector<std::string> lines = lines_of(undisturbed(scratch, folder));
  REQUIRE(lines.size() == 25);
  CHECK(lines[0].rfind("name,vertices,status,map,message,girth_coarse_0,", 0) == 0);
  CHECK(std::is_sorted(lines.begin() + 1, lines.end()));
  const auto commas = [](const std::string& line) { return std::count(line.begin(), line.end(), ','); };
  for(const std::string& line : lines) {
    CAPTURE(line);
    CHECK(line.size() > 100);
    if(line.find("torus") != std::string::npos)
      CHECK(line.find(",WRONG_GENUS,,") != std::string::npos);
    else if(line.find("broken") != std::string::npos)
      CHECK(line.find(",UNREADABLE_FILE,,") != std::string::npos);
    else {
      CHECK(commas(line) == 4 + 96);
      CHECK((&line == &lines[0] || line.find(".off,2562,OK,conformal,,") != std::string::npos));
    }
  }
}

TEST_CASE("signature: neither threads nor runs make a difference", "[tool][signature]")
{
  Scratch scratch;
  const std::string folder = make_folder(scratch), output = scratch / "out.csv";
  const std::string expected = undisturbed(scratch, folder);
  for(const char* jobs : {"1", "3"}) {
    REQUIRE(run_tool({"signature", folder, "-o", output, "--jobs", jobs}).exit_code == 0);
    CHECK(text_of(output) == expected);
  }
}

TEST_CASE("signature: files, folders and lists, each mesh once", "[tool][signature]")
{
  Scratch scratch;
  fs::create_directories(scratch / "folder");
  const std::string a = write_off(scratch / "folder/a.off", icosphere(2));
  const std::string b = write_off(scratch / "b, \"quoted\".off", dumbbell(2));
  write_text(scratch / "list.txt", b + "\r\n\n" + (scratch / "folder") + "\n");
  const std::string output = scratch / "out.csv";
  const Process_result run = run_tool({"signature", a, "--list", scratch / "list.txt", "-o", output});
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  const std::vector<std::string> lines = lines_of(text_of(output));
  REQUIRE(lines.size() == 3);
  CHECK(lines[1].rfind(a, 0) == 0);
  CHECK(lines[2].find("b, \"\"quoted\"\".off\",162,OK,") != std::string::npos);
  const Process_result search = run_tool({"search", b, "--index", output, "-k", "1"});
  CHECK(search.out.find("0.0000  " + b) != std::string::npos);
}

TEST_CASE("signature: bad meshes have a row that says why, in one line", "[tool][signature]")
{
  Scratch scratch;
  const std::string good = write_off(scratch / "good.off", icosphere(2));
  const std::string bad = write_off(scratch / "bad.off", open_sphere(2));
  const std::string missing = scratch / "missing.off", output = scratch / "out.csv";
  SECTION("next to a good one")
  {
    const Process_result run = run_tool({"signature", bad, good, missing, "-o", output});
    CHECK(run.exit_code == 0);
    CHECK(lines_of(run.err).size() == 2);
    const std::vector<std::string> lines = lines_of(text_of(output));
    REQUIRE(lines.size() == 4);
    CHECK(lines[1].find(",BOUNDARY,") != std::string::npos);
    CHECK(lines[2].find(",162,OK,conformal,,") != std::string::npos);
    CHECK(lines[3].find("does not exist") != std::string::npos);
  }
  SECTION("alone")
  {
    const Process_result run = run_tool({"signature", bad, "-o", output});
    CHECK(run.exit_code == 1);
    CHECK(is_one_line(run.err));
    CHECK(lines_of(text_of(output)).size() == 2);
    const Process_result search = run_tool({"search", good, "--index", output});
    CHECK(search.exit_code == 1);
    CHECK(search.err.find("no signature") != std::string::npos);
  }
}

TEST_CASE("signature: a shape too thin for doubles gets one from another map", "[tool][signature]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "thin.off", capsule(15, 24)), output = scratch / "out.csv";
  REQUIRE(run_tool({"signature", input, "-o", output}).exit_code == 0);
  const std::string text = text_of(output);
  CHECK((text.find(",OK,uncertified,") != std::string::npos || text.find(",OK,barycentric,") != std::string::npos));
}

TEST_CASE("signature: a batch that was killed goes on where it was", "[tool][signature]")
{
  Scratch scratch;
  const std::string folder = make_folder(scratch), output = scratch / "out.csv";
  const std::string expected = undisturbed(scratch, folder);
  const std::vector<std::string> command = {TOOL, "signature", folder, "-o", output, "--jobs", "2"};
  const std::size_t lines = GENERATE(2, 7, 15);
  Process_options options;
  SECTION("SIGKILL")
  {
    options.meanwhile = [&](int pid) {
      wait_for_lines(output + ".journal", lines);
      kill(pid, SIGKILL);
    };
    CHECK(run_process(command, options).exit_code == 128 + SIGKILL);
  }
  SECTION("SIGINT or SIGTERM")
  {
    const int signal = GENERATE(SIGINT, SIGTERM);
    options.meanwhile = [&](int pid) {
      wait_for_lines(output + ".journal", lines);
      kill(pid, signal);
    };
    const Process_result run = run_process(command, options);
    CHECK(run.exit_code == 128 + signal);
    CHECK(is_one_line(run.err));
    CHECK(run.err.find("the same command") != std::string::npos);
  }
  CHECK(lines_in(output + ".journal") >= lines);
  check_resumed(command, output, expected);
}

namespace {

/// Starts the batch and kills it when its journal has so many lines, the header included.
void run_and_kill(const std::vector<std::string>& command, const std::string& journal, std::size_t lines)
{
  Process_options options;
  options.meanwhile = [&](int pid) {
    wait_for_lines(journal, lines);
    kill(pid, SIGKILL);
  };
  REQUIRE(run_process(command, options).exit_code == 128 + SIGKILL);
}

} // namespace

TEST_CASE("signature: a line of the journal that is torn is computed again", "[tool][signature]")
{
  Scratch scratch;
  const std::string folder = make_folder(scratch), output = scratch / "out.csv", journal = output + ".journal";
  const std::string expected = undisturbed(scratch, folder);
  const std::vector<std::string> command = {TOOL, "signature", folder, "-o", output, "--jobs", "1"};
  run_and_kill(command, journal, 11);
  const std::string text = text_of(journal);
  std::size_t begin = 0; // of the eleventh line
  for(int i = 0; i < 10; ++i)
    begin = text.find('\n', begin) + 1;
  for(const std::size_t torn : {0, 1, 80, 600}) {
    write_text(journal, text.substr(0, begin + torn));
    check_resumed(command, output, expected);
    fs::remove(output);
  }
}

TEST_CASE("signature: a mesh that has changed since the run before is computed again", "[tool][signature]")
{
  Scratch scratch;
  const std::string folder = make_folder(scratch), output = scratch / "out.csv", journal = output + ".journal";
  const std::vector<std::string> command = {TOOL, "signature", folder, "-o", output, "--jobs", "1"};
  run_and_kill(command, journal, 11);
  const std::string line = lines_of(text_of(journal)).at(1);
  const std::size_t name = line.find(folder);
  const std::string mesh = line.substr(name, line.find(".off", name) + 4 - name);
  CAPTURE(mesh);
  std::string changed = text_of(write_off(scratch / "other.off", ellipsoid(1, 5, 2, 4)));
  SECTION("another size") {}
  SECTION("the same size") { changed.resize(fs::file_size(mesh), ' '); }
  SECTION("removed") { changed.clear(); }
  if(changed.empty())
    fs::remove(mesh);
  else
    write_text(mesh, changed);
  check_resumed(command, output, undisturbed(scratch, folder));
}

TEST_CASE("signature: a mesh in the journal that has not changed is not computed again", "[tool][signature]")
{
  Scratch scratch;
  const std::string folder = make_folder(scratch), output = scratch / "out.csv", journal = output + ".journal";
  const std::vector<std::string> command = {TOOL, "signature", folder, "-o", output, "--jobs", "1"};
  run_and_kill(command, journal, 11);
  const std::size_t done = lines_in(journal) - 1;
  CHECK(run_process(command).out.find(", " + std::to_string(done) + " rows from an earlier run") != std::string::npos);
}

TEST_CASE("signature: journals that are not ours are left alone", "[tool][signature]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", icosphere(1)), output = scratch / "out.csv";
  const std::string journal = output + ".journal";
  SECTION("another file of that name")
  {
    write_text(journal, "my diary\n");
    const Process_result run = run_tool({"signature", input, "-o", output});
    CHECK(run.exit_code == 1);
    CHECK(is_one_line(run.err));
    CHECK(text_of(journal) == "my diary\n");
  }
  SECTION("the journal of an older version, which does not say how old the meshes were")
  {
    const std::string old = undisturbed(scratch, input);
    write_text(journal, old);
    const Process_result run = run_tool({"signature", input, "-o", output});
    CHECK(run.exit_code == 1);
    CHECK(is_one_line(run.err));
    CHECK(run.err.find("version") != std::string::npos);
    CHECK(text_of(journal) == old);
  }
  SECTION("another program works on it")
  {
    const int descriptor = open(journal.c_str(), O_RDWR | O_CREAT, 0666);
    REQUIRE(flock(descriptor, LOCK_EX) == 0);
    const Process_result run = run_tool({"signature", input, "-o", output});
    close(descriptor);
    CHECK(run.exit_code == 1);
    CHECK(is_one_line(run.err));
    CHECK(run.err.find("in use") != std::string::npos);
  }
  CHECK_FALSE(fs::exists(output));
}

TEST_CASE("signature: wrong usage, and outputs that cannot be written", "[tool][signature]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", icosphere(1));
  CHECK(run_tool({"signature", input}).exit_code == 2);
  CHECK(run_tool({"signature", "-o", scratch / "out.csv"}).exit_code == 2);
  CHECK(run_tool({"signature", input, "-o", scratch / "out.csv", "--jobs", "0"}).exit_code == 2);
  // an index in the place of what it is made of
  CHECK(run_tool({"signature", input, "-o", input}).exit_code == 2);
  CHECK(run_tool({"signature", scratch.folder(), "-o", input}).exit_code == 2);
  write_text(scratch / "list.txt", input + '\n');
  CHECK(run_tool({"signature", "--list", scratch / "list.txt", "-o", scratch / "list.txt"}).exit_code == 2);
  CHECK(text_of(scratch / "list.txt") == input + '\n');
  CHECK(run_tool({"signature", input, "-o", scratch / "no/such/folder.csv"}).exit_code == 1);
  CHECK(run_tool({"signature", "--list", scratch / "no such list.txt", "-o", scratch / "out.csv"}).exit_code == 1);
  CHECK(run_tool({"signature", scratch.folder() + "/", "-o", scratch / "out.csv"}).exit_code == 0);
  fs::create_directories(scratch / "empty");
  const Process_result run = run_tool({"signature", scratch / "empty", "-o", scratch / "none.csv"});
  CHECK(run.exit_code == 1);
  CHECK(is_one_line(run.err));
}

namespace {

/// mpirun with three ranks on this machine; empty where that cannot be.
std::vector<std::string> three_ranks()
{
  if(std::string(MPIRUN).empty()) {
    std::cout << "SKIPPED: no mpirun, or built without MPI (Debian: libboost-mpi-dev, openmpi-bin)" << std::endl;
    return {};
  }
  return {MPIRUN, "--allow-run-as-root", "--oversubscribe", "-n", "3"};
}

/// The processes that `pid` has started.
std::vector<int> children_of(int pid)
{
  std::vector<int> children;
  std::ifstream in("/proc/" + std::to_string(pid) + "/task/" + std::to_string(pid) + "/children");
  for(int child; in >> child;)
    children.push_back(child);
  return children;
}

} // namespace

TEST_CASE("signature: three ranks of MPI write the same file", "[tool][signature][mpi]")
{
  std::vector<std::string> command = three_ranks();
  if(command.empty())
    return;
  Scratch scratch;
  const std::string folder = make_folder(scratch), output = scratch / "out.csv";
  const std::string expected = undisturbed(scratch, folder);
  command.insert(command.end(), {TOOL, "signature", folder, "-o", output, "--mpi", "--jobs", "1"});
  SECTION("undisturbed")
  {
    const Process_result run = run_process(command);
    CAPTURE(run.out, run.err);
    CHECK(run.exit_code == 0);
    CHECK(lines_of(run.out).size() == 1); // of one rank
    CHECK(text_of(output) == expected);
  }
  SECTION("a rank dies")
  {
    const std::size_t rank = GENERATE(0u, 1u, 2u);
    Process_options options;
    options.meanwhile = [&](int pid) {
      wait_for_lines(output + ".journal", 4);
      const std::vector<int> ranks = children_of(pid);
      REQUIRE(ranks.size() == 3);
      kill(ranks[rank], SIGKILL);
    };
    const Process_result run = run_process(command, options);
    CHECK(run.exit_code != 0); // all of them end
    const std::size_t done = lines_in(output + ".journal");
    CHECK(done >= 4);
    const std::string said = std::to_string(done - 1) + " rows from an earlier run";
    const Process_result again = run_process(command);
    CAPTURE(again.out, again.err);
    CHECK(again.out.find(said) != std::string::npos);
    CHECK(text_of(output) == expected);
  }
  SECTION("bad arguments end it, too")
  {
    command.back() = "0";
    CHECK(run_process(command).exit_code != 0);
  }
}

TEST_CASE("signature: a program that a rank of MPI starts is none itself", "[tool][signature][mpi]")
{
  std::vector<std::string> command = three_ranks();
  if(command.empty())
    return;
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", icosphere(2)), output = scratch / "out.csv";
  const std::string script = "\"$0\" signature \"$1\" -o \"$2$OMPI_COMM_WORLD_RANK\"; exit $?";
  command.insert(command.end(), {"/bin/sh", "-c", script, TOOL, input, output});
  const Process_result run = run_process(command);
  CAPTURE(run.out, run.err);
  CHECK(run.exit_code == 0);
  const std::string expected = undisturbed(scratch, input);
  for(const char* rank : {"0", "1", "2"})
    CHECK((fs::exists(output + rank) && text_of(output + rank) == expected));
}
