// SPDX-License-Identifier: GPL-3.0-or-later
// The command signature: rows, bad meshes, and batches that are stopped.

#include "helpers/meshes.h"
#include "helpers/tool.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <sqlite3.h>
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

/// How many rows the index has at this moment; it may be in use.
int rows_in(const std::string& index)
{
  sqlite3* database = nullptr;
  sqlite3_stmt* statement = nullptr;
  int rows = 0;
  if(sqlite3_open_v2(index.c_str(), &database, SQLITE_OPEN_READONLY, nullptr) == SQLITE_OK &&
     sqlite3_prepare_v2(database, "SELECT count(*) FROM mesh", -1, &statement, nullptr) == SQLITE_OK &&
     sqlite3_step(statement) == SQLITE_ROW)
    rows = sqlite3_column_int(statement, 0);
  sqlite3_finalize(statement);
  sqlite3_close(database);
  return rows;
}

void wait_for_rows(const std::string& index, int rows)
{
  for(int i = 0; i < 60000 && rows_in(index) < rows; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

void check_is_one_file(const std::string& index)
{
  CHECK(fs::exists(index));
  for(const char* other : {"-wal", "-shm", "-journal"})
    CHECK_FALSE(fs::exists(index + other));
}

std::string undisturbed(const Scratch& scratch, const std::string& folder)
{
  const std::string output = scratch / "undisturbed.csv";
  const Process_result run = run_tool({"signature", folder, "-o", output});
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 1); // two of the meshes are refused
  check_is_one_file(scratch / "undisturbed.db");
  return text_of(output);
}

/// Starts the batch and kills it when its index has so many rows.
void run_and_kill(const std::vector<std::string>& command, const std::string& index, int rows)
{
  Process_options options;
  options.meanwhile = [&](int pid) {
    wait_for_rows(index, rows);
    kill(pid, SIGKILL);
  };
  REQUIRE(run_process(command, options).exit_code == 128 + SIGKILL);
}

/// The same command again, which says that it had so many rows to start from, and ends with the same file.
void check_resumed(const std::vector<std::string>& command, int rows, const std::string& expected)
{
  const Process_result run = run_process(command);
  CAPTURE(run.out, run.err, rows);
  CHECK(run.exit_code == 1);
  CHECK((run.out.find(", " + std::to_string(rows) + " rows from an earlier run") != std::string::npos) == (rows > 0));
  CHECK(text_of(command.at(4)) == expected);
  check_is_one_file(fs::path(command.at(4)).replace_extension(".db").string());
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
      CHECK((&line == &lines[0] || line.find(".off,2562,OK,clamped,,") != std::string::npos));
    }
  }
}

TEST_CASE("signature: the standard input is another mesh every time", "[tool][signature]")
{
  Scratch scratch;
  const std::string index = scratch / "out.db";
  for(const Soup& soup : {bumpy_sphere(2), icosphere(2)}) {
    const std::string in = write_off(scratch / "in.off", soup);
    const std::string command = "'" + std::string(TOOL) + "' signature - -o '" + index + "' < '" + in + "'";
    REQUIRE(run_process({"/bin/sh", "-c", command}).exit_code == 0);
    const Process_result run = run_tool({"search", in, "--index", index});
    CAPTURE(run.out);
    CHECK(run.out.find(" 0.0000  -") != std::string::npos);
    const Process_result again = run_tool({"search", in, "--index", index, "--rerank", "1"});
    CAPTURE(again.out);
    CHECK(again.out.find("that of the run that made the index") != std::string::npos);
  }
}

TEST_CASE("signature: names that mean something to SQLite are names of files", "[tool][signature]")
{
  Scratch scratch;
  const std::string in = write_off(scratch / "in.off", icosphere(1));
  for(const char* name : {":memory:", "file:x.db"}) {
    Process_options options;
    options.directory = fs::path(in).parent_path().string();
    CHECK(run_tool({"signature", "in.off", "-o", name}, options).exit_code == 0);
    const Process_result run = run_tool({"search", "in.off", "--index", name}, options);
    CAPTURE(name, run.out, run.err);
    CHECK(run.exit_code == 0);
    CHECK(fs::exists(scratch / name));
  }
}

TEST_CASE("signature: a file that could not be read is tried again when it can", "[tool][signature]")
{
  Process_options options;
  options.as_nobody = true;
  if(geteuid() != 0 || run_tool({"--version"}, options).exit_code != 0) // nobody may run it where it is
    return;
  Scratch scratch;
  fs::permissions(scratch.folder(), fs::perms::all);
  const std::string in = write_off(scratch / "in.off", icosphere(1)), index = scratch / "out.db";
  fs::permissions(in, fs::perms::owner_read);
  CHECK(run_tool({"signature", in, "-o", index}, options).exit_code == 1);
  CHECK(run_tool({"signature", in, "-o", index}).exit_code == 0);
}

TEST_CASE("signature: neither threads nor runs make a difference", "[tool][signature]")
{
  Scratch scratch;
  const std::string folder = make_folder(scratch), output = scratch / "out.csv";
  const std::string expected = undisturbed(scratch, folder);
  for(const char* jobs : {"1", "3"}) {
    fs::remove(scratch / "out.db");
    REQUIRE(run_tool({"signature", folder, "-o", output, "--jobs", jobs}).exit_code == 1);
    CHECK(text_of(output) == expected);
  }
}

TEST_CASE("signature: files, folders and lists, each mesh once", "[tool][signature]")
{
  Scratch scratch;
  fs::create_directories(scratch / "folder");
  const std::string a = write_off(scratch / "folder/a.off", icosphere(2));
  const std::string b = write_off(scratch / "b, \"quoted\".off", dumbbell(2));
  write_text(scratch / "folder/._a.off", "what macOS leaves"); // hidden
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
    CHECK(run.exit_code == 1);
    CHECK(lines_of(run.err).size() == 2);
    const std::vector<std::string> lines = lines_of(text_of(output));
    REQUIRE(lines.size() == 4);
    CHECK(lines[1].find(",BOUNDARY,") != std::string::npos);
    CHECK(lines[2].find(",162,OK,clamped,,") != std::string::npos);
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
  const std::string folder = make_folder(scratch), output = scratch / "out.csv", index = scratch / "out.db";
  const std::string expected = undisturbed(scratch, folder);
  const std::vector<std::string> command = {TOOL, "signature", folder, "-o", output, "--jobs", "2"};
  const int rows = GENERATE(1, 6, 14);
  SECTION("SIGKILL") { run_and_kill(command, index, rows); }
  SECTION("SIGINT or SIGTERM")
  {
    const int signal = GENERATE(SIGINT, SIGTERM);
    Process_options options;
    options.meanwhile = [&](int pid) {
      wait_for_rows(index, rows);
      kill(pid, signal);
    };
    const Process_result run = run_process(command, options);
    CHECK(run.exit_code == 128 + signal);
    CHECK(is_one_line(run.err));
    CHECK(run.err.find("the same command") != std::string::npos);
    check_is_one_file(index);
  }
  CHECK_FALSE(fs::exists(output));
  CHECK(rows_in(index) >= rows);
  check_resumed(command, rows_in(index), expected);
}

TEST_CASE("signature: what was being written when the machine stopped is computed again", "[tool][signature]")
{
  Scratch scratch;
  const std::string folder = make_folder(scratch), output = scratch / "out.csv", index = scratch / "out.db";
  const std::string expected = undisturbed(scratch, folder);
  const std::vector<std::string> command = {TOOL, "signature", folder, "-o", output, "--jobs", "1"};
  run_and_kill(command, index, 10);
  const std::string database = text_of(index), log = text_of(index + "-wal");
  int before = 0;
  for(const double share : {0.05, 0.5, 0.9, 1.}) {
    write_text(index, database);
    write_text(index + "-wal", log.substr(0, static_cast<std::size_t>(share * static_cast<double>(log.size()))));
    fs::remove(index + "-shm");
    const int rows = rows_in(index);
    CHECK(rows >= before);
    check_resumed(command, rows, expected);
    before = rows;
  }
  CHECK(before >= 10);
}

TEST_CASE("signature: an index is brought up to date", "[tool][signature]")
{
  Scratch scratch;
  const std::string folder = make_folder(scratch), output = scratch / "out.csv", mesh = folder + "/0.off";
  const std::vector<std::string> command = {TOOL, "signature", folder, "-o", output, "--jobs", "2"};
  check_resumed(command, 0, undisturbed(scratch, folder));
  const std::string text = text_of(mesh);
  const auto time = fs::last_write_time(mesh);
  std::string edited = text_of(write_off(scratch / "other.off", ellipsoid(1, 5, 2, 4)));
  int rows = 24;
  SECTION("nothing has changed") {}
  SECTION("a mesh was written again as it was") { write_text(mesh, text); }
  SECTION("a mesh was edited")
  {
    write_text(mesh, edited);
    --rows;
  }
  SECTION("a mesh was edited, and has its size and time as before")
  {
    edited.resize(text.size(), ' ');
    write_text(mesh, edited);
    fs::last_write_time(mesh, time);
    --rows;
  }
  SECTION("a mesh was removed")
  {
    fs::remove(mesh);
    --rows;
  }
  SECTION("a mesh is new") { write_text(folder + "/new.off", edited); }
  fs::remove(scratch / "undisturbed.db");
  check_resumed(command, rows, undisturbed(scratch, folder));
  const int meshes = static_cast<int>(lines_of(text_of(output)).size()) - 1;
  CHECK(rows_in(scratch / "out.db") == meshes);
  check_resumed(command, meshes, text_of(output));
}

TEST_CASE("signature: a mesh that could not be read is looked at again", "[tool][signature]")
{
  Scratch scratch;
  const std::string mesh = scratch / "in.off", index = scratch / "out.db";
  CHECK(run_tool({"signature", mesh, "-o", index}).exit_code == 1);
  write_off(mesh, icosphere(1));
  CHECK(run_tool({"signature", mesh, "-o", index}).exit_code == 0);
}

TEST_CASE("signature: files that are no index, or damaged, are left alone", "[tool][signature]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", icosphere(1)), index = scratch / "out.db";
  SECTION("another file of that name") { write_text(index, "my diary\n" + std::string(2000, '.')); }
  SECTION("the database of another program")
  {
    sqlite3* database = nullptr;
    REQUIRE(sqlite3_open(index.c_str(), &database) == SQLITE_OK);
    REQUIRE(sqlite3_exec(database, "CREATE TABLE diary(text)", nullptr, nullptr, nullptr) == SQLITE_OK);
    sqlite3_close(database);
  }
  SECTION("a damaged index")
  {
    REQUIRE(run_tool({"signature", input, "-o", index}).exit_code == 0);
    std::string bytes = text_of(index);
    std::fill(bytes.begin() + 200, bytes.end(), 'x');
    write_text(index, bytes);
  }
  const std::string before = text_of(index);
  const Process_result run = run_tool({"signature", input, "-o", index});
  CAPTURE(run.err);
  CHECK(run.exit_code == 1);
  CHECK(is_one_line(run.err));
  CHECK(text_of(index) == before);
}

TEST_CASE("signature: one run at a time writes an index, and others may read it", "[tool][signature]")
{
  Scratch scratch;
  const std::string folder = make_folder(scratch), output = scratch / "out.csv", index = scratch / "out.db";
  const std::string expected = undisturbed(scratch, folder);
  const std::vector<std::string> command = {TOOL, "signature", folder, "-o", output, "--jobs", "1"};
  Process_options options;
  options.meanwhile = [&](int pid) {
    wait_for_rows(index, 4);
    kill(pid, SIGSTOP);
    const Process_result second = run_process(command);
    CHECK(second.exit_code == 1);
    CHECK(is_one_line(second.err));
    CHECK(second.err.find("in use") != std::string::npos);
    CHECK(run_tool({"search", folder + "/0.off", "--index", index}).exit_code == 0);
    kill(pid, SIGCONT);
  };
  CHECK(run_process(command, options).exit_code == 1);
  CHECK(text_of(output) == expected);
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

TEST_CASE("signature --prepare: rows of meshes that have to be mended", "[tool][signature]")
{
  Scratch scratch;
  const std::string folder = scratch / "meshes", index = scratch / "index.db";
  fs::create_directories(folder);
  write_off(folder + "/ball.off", bumpy_sphere(3));
  write_off(folder + "/open.off", open_sphere(3));
  write_off(folder + "/torus.off", torus(20, 10));
  write_text(folder + "/broken.off", "OFF\n1 2");
  const auto sign = [&](const std::vector<std::string>& more) {
    std::vector<std::string> command = {"signature", folder, "-o", index};
    command.insert(command.end(), more.begin(), more.end());
    const Process_result run = run_tool(command);
    CHECK(run.exit_code == 1);
    return run.out;
  };
  CHECK(sign({}) == index + ": 4 meshes, 1 signature\n");
  // what was refused without mending is tried again, what was not and what cannot be read is not
  CHECK(sign({"--prepare"}) == index + ": 4 meshes, 3 signatures, 2 of repaired meshes, 1 rows from an earlier run\n");
  CHECK(sign({"--prepare"}) == index + ": 4 meshes, 3 signatures, 2 of repaired meshes, 4 rows from an earlier run\n");

  const auto first = [&](const std::string& query, const std::vector<std::string>& more) {
    std::vector<std::string> command = {"search", query, "--index", index, "-k", "1"};
    command.insert(command.end(), more.begin(), more.end());
    const Process_result run = run_tool(command);
    CAPTURE(run.err);
    return run.exit_code == 0 ? lines_of(run.out).back() : "";
  };
  CHECK(first(folder + "/torus.off", {"--prepare"}) == "  0.0000  " + folder + "/torus.off");
  CHECK(first(folder + "/torus.off", {}).empty());
  // the signature is that of the mesh that the command prepare writes
  REQUIRE(run_tool({"prepare", folder + "/open.off", "-o", scratch / "closed.off"}).exit_code == 0);
  CHECK(first(scratch / "closed.off", {}) == "  0.0000  " + folder + "/open.off");

  CHECK(sign({}) == index + ": 4 meshes, 1 signature, 2 rows from an earlier run\n");
}
