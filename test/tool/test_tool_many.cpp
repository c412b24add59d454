// SPDX-License-Identifier: GPL-3.0-or-later
// Commands on many meshes: names of outputs, lines, resumption.

#include "helpers/meshes.h"
#include "helpers/tool.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include <sqlite3.h>

using namespace test;
namespace fs = std::filesystem;

namespace {

/// A folder of 12 meshes and 2 that are refused; two of each name.
std::string make_folder(const Scratch& scratch, int level = 3)
{
  std::string folder = scratch / "meshes";
  fs::create_directories(folder + "/more");
  for(int i = 0; i < 12; ++i)
    write_off(folder + (i % 2 ? "/more/" : "/") + std::to_string(i / 2) + ".off",
              i % 3 == 0   ? dumbbell(level)
              : i % 3 == 1 ? ellipsoid(1, 1 + 0.1 * i, 2, level)
                           : spiky_star(level, 1 + 0.1 * i));
  write_off(folder + "/torus.off", torus(8, 8));
  write_text(folder + "/more/broken.off", "OFF\n1 2");
  write_text(folder + "/no_mesh.txt", "not looked at");
  return folder;
}

/// All files of a folder but the database, by their paths in it.
std::map<std::string, std::string> files_in(const std::string& folder)
{
  std::map<std::string, std::string> files;
  for(const auto& entry : fs::recursive_directory_iterator(folder))
    if(entry.is_regular_file() && entry.path().filename().string().rfind("meshes.db", 0) != 0)
      files[entry.path().lexically_relative(folder).string()] = text_of(entry.path().string());
  return files;
}

/// A number in the database of results, which may be in use; -1 if there is none.
int query(const std::string& folder, const char* sql)
{
  sqlite3* database = nullptr;
  sqlite3_stmt* statement = nullptr;
  int number = -1;
  if(sqlite3_open_v2((folder + "/meshes.db").c_str(), &database, SQLITE_OPEN_READONLY, nullptr) == SQLITE_OK &&
     sqlite3_prepare_v2(database, sql, -1, &statement, nullptr) == SQLITE_OK && sqlite3_step(statement) == SQLITE_ROW)
    number = sqlite3_column_int(statement, 0);
  sqlite3_finalize(statement);
  sqlite3_close(database);
  return number;
}

int rows_in(const std::string& folder) { return query(folder, "SELECT count(*) FROM mesh"); }

void wait_for_rows(const std::string& folder, int rows)
{
  for(int i = 0; i < 60000 && rows_in(folder) < rows; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

/// The lines of the meshes, without the last one, which counts them.
std::vector<std::string> mesh_lines(const Process_result& run)
{
  std::vector<std::string> lines = lines_of(run.out);
  REQUIRE_FALSE(lines.empty());
  lines.pop_back();
  return lines;
}

bool says(const Process_result& run, const std::string& word) { return run.out.find(word) != std::string::npos; }

/// A command that works on many meshes and what it writes for one.
struct Command {
  std::vector<std::string> arguments; ///< without IN and OUT
  std::vector<std::string> extensions;
};

std::vector<Command> commands()
{
  return {{{"map", "--report", "report.json", "--stretch-ply", "stretch.ply"}, {"ply", "stretch.ply"}},
          {{"map", "--format", "off"}, {"off"}},
          {{"segment", "--labels", "labels.txt"}, {"ply", "labels.txt"}},
          {{"texture"}, {"obj", "mtl", "png"}},
          {{"resample", "--level", "2", "--output-sphere", "sphere.off", "--format", "obj"}, {"obj", "sphere.off"}}};
}

Process_result run_many(std::vector<std::string> arguments, const std::string& in, const std::string& out,
                        const std::vector<std::string>& more = {})
{
  arguments.insert(arguments.begin() + 1, in);
  arguments.insert(arguments.end(), {"-o", out});
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_tool(arguments);
}

} // namespace

TEST_CASE("many: every command on a folder writes what it writes for each mesh alone", "[tool][many]")
{
  Scratch scratch;
  const std::string folder = make_folder(scratch), out = scratch / "out";
  for(const Command& command : commands()) {
    CAPTURE(command.arguments);
    const Process_result run = run_many(command.arguments, folder, out);
    CAPTURE(run.out, run.err);
    CHECK(run.exit_code == 1); // two are refused
    CHECK(is_one_line(run.err));
    CHECK(run.err.find("2 of 14") != std::string::npos);
    CHECK(lines_of(run.out).size() == 15);
    CHECK(lines_of(run.out).back() == out + ": 14 meshes, 2 refused");
    CHECK(says(run, "torus.off: has genus 1"));
    CHECK(says(run, "broken.off: "));

    std::map<std::string, std::string> found = files_in(out);
    for(const std::string name : {"0", "5", "more/0", "more/3"}) {
      fs::create_directories(scratch / "alone");
      std::vector<std::string> alone = command.arguments;
      for(std::size_t i = 1; i < alone.size(); ++i) // FILE, which is the end of a name in a folder
        if(alone[i].find('.') != std::string::npos)
          alone[i].insert(0, scratch / ("alone/" + fs::path(name).filename().string() + '.'));
      if(const auto format = std::find(alone.begin(), alone.end(), "--format"); format != alone.end())
        alone.erase(format, format + 2);
      alone.insert(alone.begin() + 1, folder + "/" + name + ".off");
      alone.insert(alone.end(), {"-o", scratch / ("alone/" + fs::path(name).filename().string() + '.' +
                                                  command.extensions.front())});
      REQUIRE(run_tool(alone).exit_code == 0);
      for(const auto& [file, text] : files_in(scratch / "alone"))
        if(file.find("report") == std::string::npos) // it has seconds
          CHECK(found.at((fs::path(name).parent_path() / file).string()) == text);
      fs::remove_all(scratch / "alone");
    }
    std::size_t outputs = 0;
    for(const auto& [file, text] : found)
      outputs += file.find("report") == std::string::npos;
    CHECK(outputs == 12 * command.extensions.size());
    fs::remove_all(out);
  }
}

TEST_CASE("many: neither threads nor runs make a difference", "[tool][many]")
{
  Scratch scratch;
  const std::string folder = make_folder(scratch);
  const std::vector<std::string> map = {"map", "--method", "automatic"};
  const Process_result one = run_many(map, folder, scratch / "1", {"-j", "1"});
  const Process_result three = run_many(map, folder, scratch / "3", {"--jobs", "3"});
  CHECK(mesh_lines(one) == mesh_lines(three));
  CHECK(files_in(scratch / "1") == files_in(scratch / "3"));
  const Process_result again = run_many(map, folder, scratch / "3", {"-j", "2"});
  CHECK(mesh_lines(again) == mesh_lines(one));
  CHECK(says(again, ", 14 done by an earlier run"));
  CHECK(again.exit_code == 1);
}

TEST_CASE("many: a run that was stopped goes on where it was", "[tool][many]")
{
  Scratch scratch;
  const std::string folder = make_folder(scratch, 4), out = scratch / "out";
  const Process_result whole = run_many({"map"}, folder, scratch / "whole", {"-j", "1"});
  const int rows = GENERATE(1, 5, 9);
  const int signal = GENERATE(SIGKILL, SIGINT, SIGTERM, SIGHUP);
  Process_options options;
  options.meanwhile = [&](int pid) {
    wait_for_rows(out, rows);
    kill(pid, signal);
  };
  const Process_result stopped = run_tool({"map", folder, "-o", out, "-j", "2"}, options);
  CAPTURE(rows, signal, stopped.exit_code, stopped.out, stopped.err);
  REQUIRE(stopped.exit_code == 128 + signal);
  const int done = rows_in(out);
  CHECK(done >= rows);
  if(signal != SIGKILL) {
    CHECK(is_one_line(stopped.err));
    CHECK(stopped.err.find("with " + std::to_string(done) + " of 14 meshes done") != std::string::npos);
  }
  // what was reported is there: no line without its row, and no row without its files
  const std::vector<std::string> lines = lines_of(stopped.out), all = mesh_lines(whole);
  REQUIRE(static_cast<int>(lines.size()) <= done);
  CHECK(std::vector<std::string>(all.begin(), all.begin() + static_cast<long>(lines.size())) == lines);
  CHECK(static_cast<int>(files_in(out).size()) >= query(out, "SELECT count(*) FROM mesh WHERE status = 'OK'"));

  if(signal == SIGKILL)
    write_text(out + "/1.ply.part12", "left by another process that was killed");
  write_text(out + "/other.ply.part12", "not of this run");
  const Process_result resumed = run_tool({"map", folder, "-o", out, "-j", "2"});
  CHECK(says(resumed, ", " + std::to_string(done) + " done by an earlier run"));
  CHECK(fs::remove(out + "/other.ply.part12"));
  CHECK(mesh_lines(resumed) == mesh_lines(whole));
  CHECK(files_in(out) == files_in(scratch / "whole"));
}

TEST_CASE("many: SIGINT stays ignored where a shell has said so", "[tool][many]")
{
  Scratch scratch;
  const std::string folder = make_folder(scratch, 4), out = scratch / "out";
  Process_options options;
  options.meanwhile = [&](int pid) {
    wait_for_rows(out, 1);
    kill(pid, SIGINT);
  };
  const Process_result run = run_process(
    {"/bin/sh", "-c", "trap '' INT; exec \"$@\"", "sh", TOOL, "map", folder, "-o", out, "-j", "1"}, options);
  CAPTURE(run.out, run.err);
  CHECK(run.exit_code == 1); // two are refused
  CHECK(lines_of(run.out).size() == 15);
}

TEST_CASE("many: what has changed is done again, and nothing else", "[tool][many]")
{
  Scratch scratch;
  const std::string folder = make_folder(scratch), out = scratch / "out", mesh = folder + "/more/2.off";
  const std::string sphere = out + "/more/2.ply";
  std::vector<std::string> map = {"map"};
  REQUIRE(run_many(map, folder, out).exit_code == 1);
  const auto before = files_in(out);
  const std::string text = text_of(mesh);
  const auto time = fs::last_write_time(mesh);
  int kept = 14, meshes = 14, refused = 2;
  bool is_same = true;
  SECTION("nothing has changed") {}
  SECTION("a mesh was written again as it was") { write_text(mesh, text); }
  SECTION("a mesh was edited, and has its size and time as before")
  {
    std::string edited = off_text(ellipsoid(1, 5, 2, 2));
    edited.resize(text.size(), '\n');
    write_text(mesh, edited);
    fs::last_write_time(mesh, time);
    kept = 13;
    is_same = false;
  }
  SECTION("a mesh was edited, and is refused now: its sphere goes")
  {
    write_off(mesh, open_sphere(2));
    kept = 13;
    refused = 3;
    is_same = false;
  }
  SECTION("an output is missing")
  {
    fs::remove(sphere);
    kept = 13;
  }
  SECTION("an output is not what was written")
  {
    write_text(sphere, "cut sho");
    kept = 13;
  }
  SECTION("an output of the same size is not what was written")
  {
    write_text(sphere, std::string(text_of(sphere).size(), 'x'));
    kept = 13;
  }
  SECTION("an output was written again as it was") { write_text(sphere, std::string(text_of(sphere))); }
  SECTION("a mesh was removed, whose sphere stays")
  {
    fs::remove(mesh);
    kept = meshes = 13;
  }
  SECTION("a mesh is new")
  {
    write_text(folder + "/new.off", text);
    meshes = 15;
    is_same = false;
  }
  SECTION("other options")
  {
    map.insert(map.end(), {"--weights", "barycentric"});
    kept = 0;
    is_same = false;
  }
  SECTION("another number of jobs is none of them") { map.insert(map.end(), {"-j", "1"}); }
  const Process_result run = run_many(map, folder, out);
  CAPTURE(run.out, run.err);
  CHECK(lines_of(run.out).back() == out + ": " + std::to_string(meshes) + " meshes, " + std::to_string(refused) +
                                      " refused" +
                                      (kept > 0 ? ", " + std::to_string(kept) + " done by an earlier run" : ""));
  CHECK((files_in(out) == before) == is_same);
  CHECK(fs::exists(sphere) == (refused == 2));
}

TEST_CASE("many: a .gltf has changed when the file with its bytes has", "[tool][many]")
{
  Scratch scratch;
  fs::create_directory(scratch / "meshes");
  const auto write_bytes = [&](float longest) { // an octahedron
    const std::array<float, 18> points = {longest, 0, 0, 0, 1, 0, 0, 0, 1, -1, 0, 0, 0, -1, 0, 0, 0, -1};
    const std::array<std::uint8_t, 24> corners = {0, 1, 2, 1, 3, 2, 3, 4, 2, 4, 0, 2,
                                                  1, 0, 5, 3, 1, 5, 4, 3, 5, 0, 4, 5};
    write_text(scratch / "meshes/the points.bin",
               std::string(reinterpret_cast<const char*>(points.data()), sizeof(points)) +
                 std::string(corners.begin(), corners.end()));
  };
  write_text(scratch / "meshes/in.gltf", R"({"asset": {"version": "2.0"},
    "buffers": [{"uri": "the%20points.bin", "byteLength": 96}, {"uri": 5}, {"uri": "not there.bin"}],
    "bufferViews": [{"buffer": 0, "byteLength": 72}, {"buffer": 0, "byteOffset": 72, "byteLength": 24}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 6},
                  {"bufferView": 1, "componentType": 5121, "type": "SCALAR", "count": 24}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}]})");
  const auto done_before = [&] {
    const Process_result run = run_tool({"map", scratch / "meshes", "-o", scratch / "out"});
    CAPTURE(run.out, run.err);
    REQUIRE(run.exit_code == 0);
    return run.out.find("done by an earlier run") != std::string::npos;
  };
  write_bytes(2);
  CHECK_FALSE(done_before());
  CHECK(done_before());
  write_bytes(2);
  CHECK(done_before());
  write_bytes(3);
  CHECK_FALSE(done_before());
  CHECK(done_before());
}

TEST_CASE("many: results of other options or of another program are not taken over", "[tool][many]")
{
  Scratch scratch;
  fs::create_directory(scratch / "meshes");
  write_off(scratch / "meshes/in.off", icosphere(1));
  std::vector<std::string> map = {"map", scratch / "meshes", "-o", scratch / "out", "--weights", "clamped"};
  const auto is_done_again = [](const Process_result& run) {
    CAPTURE(run.err);
    REQUIRE(run.exit_code == 0);
    return run.out.find("done by an earlier run") == std::string::npos;
  };
  CHECK(is_done_again(run_tool(map)));
  CHECK_FALSE(is_done_again(run_tool(map)));
  const std::vector<std::vector<std::string>> more = {{"--min-angle", "6"},
                                                      {"--max-angle", "84"},
                                                      {"--spring-exponent", "2"},
                                                      {"--area-exponent", "1"},
                                                      {"--largest-shrinkage", "9"},
                                                      {"--accuracy", "1e-8"},
                                                      {"--iterations", "99"},
                                                      {"--max-time", "1e6"},
                                                      {"--triangulate"},
                                                      {"--prepare"},
                                                      {"--policy", "sequential"},
                                                      {"--report", "r.json"},
                                                      {"--ascii"}};
  for(const std::vector<std::string>& options : more) {
    CAPTURE(options);
    map.insert(map.end(), options.begin(), options.end());
    CHECK(is_done_again(run_tool(map)));
  }
  CHECK_FALSE(is_done_again(run_tool(map)));

  // as a compiler may make it of the same version
  const std::string other = scratch / "another build";
  fs::copy(TOOL, other);
  std::ofstream(other, std::ios::app) << '\n';
  const auto run_other = [&other](std::vector<std::string> command) {
    command.insert(command.begin(), other);
    return run_process(command);
  };
  CHECK(is_done_again(run_other(map)));
  const std::vector<std::string> signature = {"signature", scratch / "meshes", "-o", scratch / "index.db"};
  CHECK(run_tool(signature).out.find("earlier run") == std::string::npos);
  CHECK(run_tool(signature).out.find("1 rows from an earlier run") < std::string::npos);
  CHECK(run_other(signature).out.find("earlier run") == std::string::npos);
}

TEST_CASE("many: what was made of meshes that are away stays, and is known again when they are back", "[tool][many]")
{
  Scratch scratch;
  const std::string folder = make_folder(scratch, 2), out = scratch / "out", away = scratch / "away";
  std::string names;
  for(const char* name : {"0.off", "more/0.off", "1.off"})
    names += folder + '/' + name + '\n';
  write_text(scratch / "list.txt", names);
  const std::vector<std::string> command = {"map", "--list", scratch / "list.txt", "-o", out, "--report", "r.json"};
  REQUIRE(run_tool(command).exit_code == 0);
  const auto before = files_in(out);
  REQUIRE(before.size() == 6);
  fs::rename(folder, away);
  const Process_result missing = run_tool(command);
  CHECK(says(missing, "does not exist"));
  CHECK(lines_of(missing.out).back() == out + ": 3 meshes, 3 refused");
  CHECK(files_in(out) == before);
  fs::rename(away, folder);
  CHECK(lines_of(run_tool(command).out).back() == out + ": 3 meshes, 0 refused, 3 done by an earlier run");
}

TEST_CASE("many: of a mesh that is refused no older output stays, known or not", "[tool][many]")
{
  Scratch scratch;
  const std::string folder = scratch / "in", out = scratch / "out";
  fs::create_directories(folder);
  write_off(folder + "/a.off", icosphere(2));
  write_off(folder + "/b.off", icosphere(2));
  const std::vector<std::string> command = {"map", folder, "-o", out, "--report", "r.json"};
  REQUIRE(run_tool(command).exit_code == 0);
  write_off(folder + "/a.off", open_sphere(2));
  fs::remove(out + "/meshes.db");
  CHECK(run_tool(command).exit_code == 1);
  CHECK_FALSE(fs::exists(out + "/a.ply"));
  CHECK(fs::exists(out + "/a.r.json")); // which says why
  CHECK(fs::exists(out + "/b.ply"));
}

TEST_CASE("many: a full disk takes no older output", "[tool][many]")
{
  Scratch scratch;
  const std::string folder = scratch / "in", out = scratch / "out";
  fs::create_directories(folder);
  write_off(folder + "/a.off", icosphere(5));
  write_off(folder + "/b.off", icosphere(2));
  REQUIRE(run_tool({"map", folder, "-o", out}).exit_code == 0);
  const auto before = files_in(out);
  Process_options options;
  options.largest_file = 200000; // which the database does not reach
  const Process_result run = run_tool({"map", folder, "-o", out, "--method", "isometric"}, options);
  CAPTURE(run.out, run.err);
  CHECK(run.exit_code == 1);
  CHECK(run.err.find("a.ply") != std::string::npos);
  CHECK(files_in(out).at("a.ply") == before.at("a.ply"));
}

TEST_CASE("many: a list may be a pipe", "[tool][many]")
{
  Scratch scratch;
  const std::string in = write_off(scratch / "a.off", icosphere(1)), out = scratch / "out";
  for(const char* command : {"map", "signature"}) {
    const Process_result run =
      run_process({"/bin/sh", "-c",
                   "echo '" + in + "' | '" + TOOL + "' " + command + " --list /dev/stdin -o '" + out +
                     (std::string(command) == "map" ? "" : ".db") + "'"});
    CAPTURE(command, run.out, run.err);
    CHECK(run.exit_code == 0);
  }
  CHECK(fs::exists(out + "/a.ply"));
}

TEST_CASE("many: nothing is printed into the database where the standard output is closed", "[tool][many]")
{
  Scratch scratch;
  const std::string in = write_off(scratch / "a.off", icosphere(1)), out = scratch / "out";
  for(const char* closed : {" >&-", " 2>&-", " <&- >&- 2>&-"}) {
    run_process({"/bin/sh", "-c", '\'' + std::string(TOOL) + "' map '" + in + "' -o '" + out + "/' -j 1" + closed});
    CAPTURE(closed);
    CHECK(query(out, "PRAGMA page_count") * query(out, "PRAGMA page_size") ==
          static_cast<int>(fs::file_size(out + "/meshes.db")));
  }
}

TEST_CASE("many: two maps of one mesh", "[tool][many]")
{
  Scratch scratch;
  const std::string folder = scratch / "in", spheres = scratch / "spheres";
  fs::create_directories(folder);
  write_off(folder + "/a.off", icosphere(1));
  REQUIRE(run_tool({"map", folder, "-o", spheres}).exit_code == 0);
  REQUIRE(run_tool({"map", folder, "-o", spheres, "--format", "off"}).exit_code == 0);
  const Process_result run = run_tool({"certify", folder, spheres});
  CHECK(run.exit_code == 1);
  CHECK(run.err.find(spheres + "/a: is the name of several maps") != std::string::npos);
}

TEST_CASE("many: spheres that were written before", "[tool][many]")
{
  Scratch scratch;
  const std::string folder = make_folder(scratch), spheres = scratch / "spheres", out = scratch / "out";
  // the map that segment makes itself
  REQUIRE(run_many({"map", "--method", "balanced", "--weights", "clamped"}, folder, spheres).exit_code == 1);
  fs::remove(spheres + "/3.ply");
  const std::string format = GENERATE("ply", "off"); // of one of them: any will do
  if(format == "off")
    REQUIRE(
      run_tool({"map", folder + "/3.off", "-o", spheres + "/3.off", "--method", "balanced", "--weights", "clamped"})
        .exit_code == 0);
  const Process_result run = run_many({"segment", "--labels", "l.txt"}, folder, out, {"--sphere", spheres});
  CAPTURE(run.out);
  CHECK(lines_of(run.out).back() == out + ": 14 meshes, " + (format == "off" ? "2" : "3") + " refused");
  CHECK(says(run, spheres + "/3.ply: does not exist") == (format == "ply"));
  REQUIRE(run_many({"segment", "--labels", "l.txt"}, folder, scratch / "direct").exit_code == 1);
  for(const auto& [file, text] : files_in(out))
    CHECK(files_in(scratch / "direct").at(file) == text);

  // another sphere is another input
  REQUIRE(run_tool({"map", folder + "/4.off", "-o", spheres + "/4.ply", "--weights", "barycentric"}).exit_code == 0);
  const Process_result again = run_many({"segment", "--labels", "l.txt"}, folder, out, {"--sphere", spheres});
  CHECK(says(again, std::string(format == "off" ? ", 13" : ", 12") + " done by an earlier run"));
}

TEST_CASE("many: prepare mends a folder, and certify looks at spheres by their names", "[tool][many]")
{
  Scratch scratch;
  const std::string folder = make_folder(scratch, 2), closed = scratch / "closed", spheres = scratch / "spheres",
                    reports = scratch / "reports";
  const Process_result only_said = run_tool({"prepare", folder});
  CHECK(lines_of(only_said.out).size() == 15);
  const Process_result prepared =
    run_many({"prepare", "--vertex-map", "vertices.txt", "--report", "report.json"}, folder, closed);
  CAPTURE(prepared.out, prepared.err);
  CHECK(prepared.exit_code == 1); // one is broken
  CHECK(mesh_lines(prepared) == mesh_lines(only_said));
  CHECK(says(prepared, "torus.off: "));
  CHECK(says(prepared, "cut 1 handle"));
  CHECK(says(prepared, "0.off: 162 vertices, 320 faces, a closed surface of genus 0, which 'map' accepts; Hausdorff "
                       "distance to IN 0; nothing to repair"));
  CHECK(files_in(closed).count("torus.vertices.txt") == 1);
  CHECK(files_in(closed).count("more/broken.report.json") == 1);
  CHECK(files_in(closed).size() == 13 * 3 + 1);
  CHECK(says(run_many({"prepare", "--vertex-map", "vertices.txt", "--report", "report.json"}, folder, closed),
             "14 done by an earlier run"));

  REQUIRE(run_many({"map"}, closed, spheres).exit_code == 0);
  const std::vector<std::string> certify = {"certify", closed, spheres, "--report", "report.json", "-o", reports};
  const Process_result valid = run_tool(certify);
  CAPTURE(valid.out, valid.err);
  CHECK(valid.exit_code == 0);
  CHECK(lines_of(valid.out).size() == 14);
  for(const std::string& line : mesh_lines(valid))
    CHECK(line.find(": valid spherical map: 0 flipped faces, degree 1, ") != std::string::npos);
  CHECK(files_in(reports).size() == 13);
  CHECK(says(run_tool(certify), "13 done by an earlier run"));

  // a sphere of another mesh, and one that is not there
  fs::copy_file(spheres + "/torus.ply", spheres + "/0.ply", fs::copy_options::overwrite_existing);
  fs::remove(spheres + "/more/1.ply");
  const Process_result refused = run_tool(certify);
  CAPTURE(refused.out, refused.err);
  CHECK(refused.exit_code == 1);
  CHECK(says(refused, "0.ply: has "));
  CHECK(says(refused, "more/1.ply: does not exist"));
  CHECK(says(refused, "13 meshes, 2 refused, 11 done by an earlier run"));

  // without a folder nothing is remembered; a mesh and its sphere alone need none
  const Process_result two = run_tool({"certify", closed + "/torus.ply", closed + "/1.ply", spheres, "-j", "2"});
  CHECK(two.exit_code == 0);
  CHECK(lines_of(two.out).size() == 3);
  CHECK(run_tool({"certify", closed + "/torus.ply", spheres + "/torus.ply"}).exit_code == 0);
  for(const std::vector<std::string>& wrong :
      std::vector<std::vector<std::string>>{{"certify", closed + "/torus.ply"},
                                            {"certify", closed + "/torus.ply", spheres + "/torus.ply", "-o", reports},
                                            {"certify", closed, closed}})
    CHECK(run_tool(wrong).exit_code == 2);
  CHECK(run_tool({"certify", closed, spheres + "/torus.ply"}).exit_code == 1);
}

TEST_CASE("many: names of outputs", "[tool][many]")
{
  Scratch scratch;
  const auto mesh = [&](const std::string& file) {
    fs::create_directories(fs::path(scratch / file).parent_path());
    return write_off(scratch / file, icosphere(1));
  };
  const std::string a = mesh("in/a/x.off"), b = mesh("in/b/x.off"), deep = mesh("in/b/c/y.z.off");
  const std::string out = scratch / "out";
  const auto written = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"map", "-o", out});
    const Process_result run = run_tool(arguments);
    CAPTURE(arguments, run.out, run.err);
    CHECK(run.exit_code == 0);
    std::vector<std::string> names;
    for(const auto& [file, text] : files_in(out))
      names.push_back(file);
    fs::remove_all(out);
    return names;
  };
  typedef std::vector<std::string> Names;
  CHECK(written({scratch / "in"}) == Names{"a/x.ply", "b/c/y.z.ply", "b/x.ply"});
  CHECK(written({scratch / "in/"}) == Names{"a/x.ply", "b/c/y.z.ply", "b/x.ply"});
  CHECK(written({a, b}) == Names{"a/x.ply", "b/x.ply"});
  CHECK(written({scratch / "in/a", b}) == Names{"a/x.ply", "b/x.ply"});
  CHECK(written({scratch / "in/a"}) == Names{"x.ply"});
  write_text(scratch / "list.txt", a + "\n" + (scratch / "in/b") + "\n");
  CHECK(written({"--list", scratch / "list.txt"}) == Names{"a/x.ply", "b/c/y.z.ply", "b/x.ply"});
  write_text(scratch / "list.txt",
             "\xef\xbb\xbf" + a + "\r\n" + (scratch / "in/b") + "\r\n"); // as editors of Windows do
  CHECK(written({"--list", scratch / "list.txt"}) == Names{"a/x.ply", "b/c/y.z.ply", "b/x.ply"});
  for(const char* command : {"map", "texture"}) { // as find -print0 writes lists
    write_text(scratch / "list.txt", a + '\0' + b + '\0');
    const Process_result run = run_tool({command, "--list", scratch / "list.txt", "-o", out});
    CAPTURE(run.out, run.err);
    CHECK(run.exit_code == 1);
    CHECK(run.err.find("list.txt: has a zero byte") != std::string::npos);
    CHECK_FALSE(fs::exists(out));
  }

  SECTION("meshes that differ in their extensions keep them")
  {
    fs::copy(a, scratch / "in/a/w.off");
    REQUIRE(run_tool({"map", a, "-o", scratch / "in/a/x.obj"}).exit_code == 0);
    CHECK(written({scratch / "in/a"}) == Names{"w.ply", "x.obj.ply", "x.off.ply"});
  }
  SECTION("a folder that is not there, by a name without a root")
  {
    Process_options here;
    here.directory = scratch.folder();
    write_text(scratch / "in/a/x.ply", "not ours");
    const Process_result run = run_tool({"map", "in/a/x.off", "missing/y.off", "in/b/x.off", "-o", "out"}, here);
    CAPTURE(run.out, run.err);
    CHECK(run.exit_code == 1);
    CHECK(run.out.find("missing/y.off: does not exist") != std::string::npos);
    CHECK(files_in(out).count("in/a/x.ply") + files_in(out).count("in/b/x.ply") == 2);
    CHECK(text_of(scratch / "in/a/x.ply") == "not ours");
    for(const char* folder : {"in/../in", "missing/../in", "in/missing/.."})
      CHECK(run_tool({"map", "in", "-o", folder, "--format", "off"}, here).err.find("is the folder of the meshes") !=
            std::string::npos);
  }
  SECTION("surfaces of FreeSurfer have no extension")
  {
    REQUIRE(run_tool({"map", a, "-o", scratch / "lh.pial"}).exit_code == 0);
    CHECK(written({scratch / "lh.pial", a}) == Names{"in/a/x.ply", "lh.pial.ply"});
  }
  SECTION("an output folder in the folder of the meshes is not looked into")
  {
    CHECK(run_tool({"map", scratch / "in", "-o", scratch / "in/out"}).exit_code == 0);
    const Process_result run = run_tool({"map", scratch / "in", "-o", scratch / "in/out"});
    CHECK(lines_of(run.out).back() == scratch / "in/out: 3 meshes, 0 refused, 3 done by an earlier run");
  }
  SECTION("neither are spheres that are there")
  {
    const std::string spheres = scratch / "in/spheres";
    REQUIRE(run_tool({"map", scratch / "in", "-o", spheres}).exit_code == 0);
    CHECK(run_tool({"segment", scratch / "in", "-o", out, "--sphere", spheres}).exit_code == 0);
    CHECK(files_in(out).size() == 3);
  }
  SECTION("one mesh, and a folder with a slash")
  {
    CHECK(run_tool({"map", a, "-o", out + "/"}).exit_code == 0);
    CHECK(files_in(out).count("x.ply") == 1);
  }
}

TEST_CASE("many: wrong usage is said before any work", "[tool][many]")
{
  Scratch scratch;
  const std::string folder = make_folder(scratch, 1), out = scratch / "out";
  const auto check = [&](const std::vector<std::string>& arguments, const std::string& word) {
    const auto before = files_in(scratch.folder());
    const Process_result run = run_tool(arguments);
    CAPTURE(arguments, run.err);
    CHECK(run.exit_code == 2);
    CHECK(run.err.find(word) != std::string::npos);
    CHECK(run.out.empty());
    CHECK(files_in(scratch.folder()) == before);
  };
  check({"map", folder, "-o", folder}, "is the folder of the meshes");
  check({"map", folder, "-o", scratch / "sphere.off"}, "is a folder");
  write_text(scratch / "file", "old");
  check({"map", folder, "-o", scratch / "file"}, "is a file");
  check({"map", folder, "-o", out, "--format", "stl"}, "--format");
  check({"map", folder, "-o", out, "--report", out + "/report.json"}, "'/'");
  check({"map", folder, "-o", out, "--report", "ply"}, "would overwrite an output for");
  write_off(folder + "/meshes.off", icosphere(1));
  check({"prepare", folder, "-o", out, "--vertex-map", "db"}, "would overwrite the results of the run");
  fs::remove(folder + "/meshes.off");
  check({"map", folder + "/0.off", folder + "/1.off", "-o", folder + "/", "--format", "off"},
        "would overwrite the mesh");
  check({"map", "--list", scratch / "file", "-o"}, "--output");
  check({"map", "-o", out}, "IN or --list");
  check({"map", "-", folder, "-o", out}, "IN: the standard input is one mesh");
  fs::create_directories(folder + "/x.ply");
  write_off(folder + "/x.off", icosphere(0));
  write_off(folder + "/x.ply/y.off", icosphere(0));
  check({"map", folder, "-o", out}, "/x.ply/y.ply' would be in ");
  fs::remove_all(folder + "/x.ply");
  write_off(folder + "/meshes.db-wal.off", icosphere(0));
  check({"map", folder, "-o", out, "--format", "freesurfer"}, "would overwrite the results of the run");
  fs::remove(folder + "/meshes.db-wal.off");
  check({"map", "-", "-o", out + "/"}, "IN: the standard input is one mesh");
  for(const char* option : {"--fixed", "--density", "--data"})
    check({"map", folder, "-o", out, option, "-"}, std::string(option) + ": is read for each mesh");
  check({"map", folder, "-o", "-"}, "--output: is the standard output");
  check({"map", folder, "-o", out, "--report", "-"}, "--report: is the standard output");
  check({"segment", folder, "-o", out, "--sphere", folder}, "is the folder of the meshes");
  check({"map", folder, "-o", out, "--spring-exponent", "1"}, "--spring-exponent");
  check({"map", folder, "-o", out, "-j", "0"}, "--jobs");
  fs::create_directories(scratch / "empty");
  CHECK(run_tool({"map", scratch / "empty", "-o", out}).exit_code == 1);
  CHECK(run_tool({"segment", folder, "-o", out, "--sphere", scratch / "none"}).exit_code == 1);
  const std::vector<std::vector<std::string>> with_one_file_for_all = {
    {"texture", folder, "-o", out, "--image", scratch / "none.png"},
    {"map", folder, "-o", out, "--fixed", scratch / "none.txt"}};
  for(const auto& arguments : with_one_file_for_all) {
    const Process_result run = run_tool(arguments);
    CAPTURE(run.err);
    CHECK(run.exit_code == 1);
    CHECK(is_one_line(run.err));
    CHECK(run.err.find("does not exist") != std::string::npos);
    CHECK(run.out.empty());
  }
  CHECK_FALSE(fs::exists(out));
}

TEST_CASE("many: what is wrong with the outputs ends the run", "[tool][many]")
{
  Scratch scratch;
  const std::string folder = make_folder(scratch), out = scratch / "out";
  const std::vector<std::string> command = {"map", folder, "-o", out, "-j", "1"};
  std::string word = "written";
  Process_options options;
  SECTION("no space for a sphere") { options.largest_file = 40000; }
  SECTION("a folder in the place of a sphere") { fs::create_directories(out + "/more/1.ply"); }
  SECTION("a file in the place of a folder")
  {
    fs::create_directories(out);
    write_text(out + "/more", "");
    word = "created";
  }
  SECTION("another file in the place of the database")
  {
    fs::create_directories(out);
    write_text(out + "/meshes.db", "my diary");
    word = "no database";
  }
  const Process_result run = run_tool(command, options);
  CAPTURE(run.out, run.err);
  CHECK(run.exit_code == 1);
  CHECK(is_one_line(run.err));
  CHECK(run.err.find(word) != std::string::npos);
  for(const auto& [file, text] : files_in(out))
    CHECK(file.find(".part") == std::string::npos);
  fs::remove_all(out + "/more");
  if(word == "no database")
    fs::remove(out + "/meshes.db");
  CHECK(lines_of(run_tool(command).out).size() == 15);
}

TEST_CASE("many: a link that leads nowhere is a mesh that is missing", "[tool][many]")
{
  Scratch scratch;
  fs::create_directories(scratch / "in");
  write_off(scratch / "in/a.off", icosphere(1));
  fs::create_symlink("nowhere", scratch / "in/b.off");
  const Process_result run = run_tool({"map", scratch / "in", "-o", scratch / "out"});
  CAPTURE(run.out, run.err);
  CHECK(run.exit_code == 1);
  CHECK(run.out.find("b.off: does not exist") != std::string::npos);
  CHECK(fs::exists(scratch / "out/a.ply"));
}

TEST_CASE("many: one run at a time writes a folder", "[tool][many]")
{
  Scratch scratch;
  const std::string folder = make_folder(scratch, 4), out = scratch / "out";
  Process_options options;
  options.meanwhile = [&](int pid) {
    wait_for_rows(out, 2);
    kill(pid, SIGSTOP);
    const Process_result second = run_tool({"segment", folder, "-o", out});
    CHECK(second.exit_code == 1);
    CHECK(is_one_line(second.err));
    CHECK(second.err.find("in use") != std::string::npos);
    kill(pid, SIGCONT);
  };
  CHECK(lines_of(run_tool({"map", folder, "-o", out, "-j", "1"}, options).out).size() == 15);
}

TEST_CASE("many: what another command has written in the folder is not taken for its own", "[tool][many]")
{
  Scratch scratch;
  const std::string folder = make_folder(scratch, 2), out = scratch / "out";
  REQUIRE(run_many({"map"}, folder, out).exit_code == 1);
  const auto spheres = files_in(out);
  REQUIRE(run_many({"segment"}, folder, out).exit_code == 1);
  CHECK(files_in(out) != spheres);
  const Process_result run = run_many({"map"}, folder, out);
  CHECK_FALSE(says(run, "earlier"));
  CHECK(files_in(out) == spheres);
}

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
TEST_CASE("many: several meshes at the same time on an OpenCL device", "[tool][many]")
{
  if(!some_policy<CGAL::Spherical_parameterization::OpenCL_device>()) {
    std::cout << "SKIPPED: no OpenCL device" << std::endl;
    return;
  }
  Scratch scratch;
  fs::create_directories(scratch / "meshes");
  for(int i = 0; i < 6; ++i) // devices are not used for less
    write_off(scratch / ("meshes/" + std::to_string(i) + ".off"), spiky_star(5, 1 + 0.1 * i));
  const Process_result host = run_many({"map"}, scratch / "meshes", scratch / "host");
  const Process_result device =
    run_many({"map", "--policy", "opencl", "-j", "3"}, scratch / "meshes", scratch / "device");
  CAPTURE(device.out, device.err);
  CHECK(device.exit_code == 0);
  CHECK(mesh_lines(host) == mesh_lines(device));
  CHECK(files_in(scratch / "host") == files_in(scratch / "device"));
}
#endif
