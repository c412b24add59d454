// SPDX-License-Identifier: GPL-3.0-or-later
// The command atlas: maps, registration, statistics, resumption.

#include "helpers/meshes.h"
#include "helpers/tool.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <map>
#include <string>
#include <thread>
#include <vector>

using namespace test;
namespace fs = std::filesystem;

namespace {

constexpr int bodies = 5;

/// A body with limbs, stretched along x more and more, with one mesh that cannot be mapped beside them.
std::string make_folder(const Scratch& scratch)
{
  std::string folder = scratch / "meshes";
  fs::create_directories(folder + "/more");
  const auto& directions = six_directions();
  const Soup body =
    body_with_limbs({{directions[0], 0.4, 0.5}, {directions[1], 0.3, 0.8}, {directions[3], 0.35, 0.2}}, 3).soup;
  for(int i = 0; i < bodies; ++i)
    write_off(folder + (i == 3 ? "/more/" : "/") + "body" + std::to_string(i) + ".off",
              transformed(body, [i](const Point& p) { return Point((1 + 0.1 * i) * p.x(), p.y(), p.z()); }));
  write_off(folder + "/torus.off", torus(8, 8));
  return folder;
}

std::map<std::string, std::string> files_in(const std::string& folder)
{
  std::map<std::string, std::string> files;
  for(const auto& entry : fs::recursive_directory_iterator(folder))
    if(entry.is_regular_file() && entry.path().filename() != "meshes.db")
      files[entry.path().lexically_relative(folder).string()] = text_of(entry.path().string());
  return files;
}

} // namespace

TEST_CASE("atlas: a family with one degree of freedom has one mode; the same command again does nothing", "[tool]")
{
  Scratch scratch;
  const std::string folder = make_folder(scratch), out = scratch / "atlas";
  const std::vector<std::string> command = {"atlas", folder,    "-o",     out,       "--level",
                                            "3",     "--align", "centre", "--modes", "2"};
  const Process_result run = run_tool(command);
  CAPTURE(run.out, run.err);
  CHECK(run.exit_code == 1); // the torus
  CHECK(run.err.find("1 of 6 meshes were refused") != std::string::npos);
  CHECK(run.out.find("torus.off") != std::string::npos);

  const auto report = nlohmann::json::parse(text_of(out + "/report.json"));
  CHECK(report["shapes"] == bodies);
  CHECK(report["vertices"] == 642);
  CHECK(report["meshes"].size() == bodies + 1);
  CHECK(report["meshes"][bodies]["status"] == "WRONG_GENUS");
  REQUIRE(report["modes"].size() == 2);
  CHECK(report["modes"][0]["explained"] > 0.97);
  CHECK(report["left_out"]["root_mean_square_by_modes"].size() == bodies - 1);
  CHECK(report["left_out"]["root_mean_square_by_modes"][1] <
        0.25 * report["left_out"]["root_mean_square_by_modes"][0].get<double>());

  CHECK(report["compactness_by_modes"].back().get<double>() == Approx(report["total_variance"].get<double>()));
  const std::vector<std::string> quality = lines_of(text_of(out + "/quality.csv"));
  REQUIRE(quality.size() == bodies + 1);
  CHECK(quality[0] == "modes,compactness,generalization,specificity,specificity_error");
  for(std::size_t k = 0; k < bodies; ++k) {
    CHECK(std::count(quality[k + 1].begin(), quality[k + 1].end(), ',') == 4);
    CHECK(report["specificity"]["mean_by_modes"][k] > 0);
  }

  // the scores are the stretch, in the order of the meshes: body 3 is in another folder, and so the last one
  const std::vector<std::string> scores = lines_of(text_of(out + "/scores.csv"));
  REQUIRE(scores.size() == bodies + 1);
  CHECK(scores[0] == "name,score_1,score_2");
  std::map<std::string, double> score;
  for(std::size_t i = 1; i < scores.size(); ++i)
    score[scores[i].substr(0, scores[i].find(','))] = std::stod(scores[i].substr(scores[i].find(',') + 1));
  const double sign = score.at("body4") > score.at("body0") ? 1 : -1;
  double before = -1e9;
  for(const char* name : {"body0", "body1", "body2", "more/body3", "body4"}) {
    CHECK(sign * score.at(name) > before);
    before = sign * score.at(name);
  }

  // mean and modes: vertices on a line, so many deviations apart
  const Soup mean = read(out + "/mean.ply"), plus = read(out + "/modes/mode_1_plus.ply"),
             minus = read(out + "/modes/mode_1_minus.ply");
  REQUIRE(mean.points.size() == 642);
  REQUIRE(mean.faces.size() == 1280);
  for(std::size_t v = 0; v < mean.points.size(); ++v)
    CHECK((CGAL::midpoint(plus.points[v], minus.points[v]) - mean.points[v]).squared_length() < 1e-20);
  CHECK(text_of(out + "/variance.ply").find("property double standard_deviation") != std::string::npos);

  const auto files = files_in(out);
  const Process_result again = run_tool(command);
  CHECK(again.exit_code == 1);
  CHECK(again.out.find("6 meshes, 1 refused, 6 done by an earlier run") != std::string::npos);
  CHECK(again.out.find("5 meshes, 0 refused, 5 done by an earlier run") != std::string::npos);
  CHECK(files_in(out) == files);

  // what is missing is made again, the same; and modes of an earlier run do not stay
  fs::remove(out + "/spheres/body2.ply");
  fs::remove(out + "/registered/1/more/body3.ply");
  fs::remove(out + "/mean.ply");
  CHECK(run_tool(command).exit_code == 1);
  CHECK(files_in(out) == files);
  std::vector<std::string> fewer = command;
  fewer.back() = "1";
  CHECK(run_tool(fewer).out.find("5 done by an earlier run") != std::string::npos);
  CHECK(fs::exists(out + "/modes/mode_1_plus.ply"));
  CHECK_FALSE(fs::exists(out + "/modes/mode_2_plus.ply"));
  CHECK_FALSE(fs::exists(out + "/modes/mode_2_minus.ply"));
}

TEST_CASE("atlas: faces of a template that is not in the set; sizes are no difference if that is asked for", "[tool]")
{
  Scratch scratch;
  const Soup body = bumpy_sphere(2);
  std::vector<std::string> command = {"atlas"};
  for(const double size : {1., 2., 4.}) // powers of two, which change no rounding
    command.push_back(write_off(scratch / std::to_string(int(size)) + ".off", transformed(body, [=](const Point& p) {
                                  return Point(size * p.x(), size * p.y(), size * p.z());
                                })));
  const std::string standard = write_off(scratch / "standard.off", ellipsoid(1, 1.2, 1.5, 3));
  command.insert(command.end(), {"-o", scratch / "atlas", "--template", standard, "--faces", "template", "--rounds",
                                 "2", "--align", "similarity"});
  const Process_result run = run_tool(command);
  CAPTURE(run.out, run.err);
  REQUIRE(run.exit_code == 0);
  const auto report = nlohmann::json::parse(text_of(scratch / "atlas/report.json"));
  CHECK(report["shapes"] == 3);
  CHECK(read(scratch / "atlas/mean.ply").faces == read(standard).faces);
  CHECK(report["total_variance"] < 1e-8); // one shape, in three sizes
  CHECK(report["alignment"]["motions"][0]["scale"].get<double>() /
          report["alignment"]["motions"][2]["scale"].get<double>() ==
        Approx(4));
}

TEST_CASE("atlas --prepare: a mesh with a hole, and a template with one, are mended first", "[tool]")
{
  Scratch scratch;
  const Soup body = bumpy_sphere(3);
  std::vector<std::string> command = {"atlas"};
  for(int i = 0; i < 3; ++i) {
    Soup soup = transformed(body, [i](const Point& p) { return Point((1 + 0.1 * i) * p.x(), p.y(), p.z()); });
    if(i != 1)
      soup.faces.pop_back(); // is filled with one face
    command.push_back(write_off(scratch / std::to_string(i) + ".off", soup));
  }
  const bool has_template_faces = GENERATE(false, true);
  command.insert(command.end(), {"-o", scratch / "atlas", "--template", command[1], "--rounds", "2", "--faces",
                                 has_template_faces ? "template" : "icosphere", "--level", "3"});
  const Process_result refused = run_tool(command);
  CHECK(refused.exit_code == 1);
  CHECK((refused.out + refused.err).find("; --prepare does it") != std::string::npos);
  command.emplace_back("--prepare");
  const Process_result run = run_tool(command);
  CAPTURE(run.out, run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(run.out.find("map, prepared") != std::string::npos);
  const auto report = nlohmann::json::parse(text_of(scratch / "atlas/report.json"));
  CHECK(report["shapes"] == 3);
  CHECK(report["faces"] == (has_template_faces ? body.faces.size() : 1280));
  CHECK(report["modes"][0]["explained"] > 0.95);
  CHECK(run_tool(command).out.find("3 done by an earlier run") != std::string::npos);
}

TEST_CASE("atlas: the template is not overwritten", "[tool]")
{
  Scratch scratch;
  fs::create_directory(scratch / "atlas");
  const std::string mean = write_off(scratch / "atlas/mean.ply", icosphere(1)), old = text_of(mean),
                    in = write_off(scratch / "in.off", icosphere(1));
  const Process_result run = run_tool({"atlas", in, "-o", scratch / "atlas", "--template", mean});
  CAPTURE(run.err);
  CHECK(run.exit_code == 2);
  CHECK(run.err.find("--output: is the same file as --template") != std::string::npos);
  CHECK(text_of(mean) == old);
}

TEST_CASE("atlas: in the folder of the meshes, as often as one likes, but not that folder itself", "[tool]")
{
  Scratch scratch;
  const std::string folder = scratch / "meshes";
  fs::create_directory(folder);
  write_off(folder + "/1.off", ellipsoid(1, 1, 2, 2));
  write_off(folder + "/2.off", ellipsoid(1, 1.5, 2, 2));
  const std::vector<std::string> command = {"atlas", folder, "-o", folder + "/atlas", "--level", "2"};
  CHECK(run_tool(command).exit_code == 0);
  const Process_result again = run_tool(command);
  CAPTURE(again.out, again.err);
  CHECK(again.exit_code == 0);
  CHECK(again.out.find("2 meshes, 0 refused, 2 done by an earlier run") != std::string::npos);

  const Process_result same = run_tool({"atlas", folder, "-o", folder});
  CAPTURE(same.err);
  CHECK(same.exit_code == 2);
  CHECK(same.err.find("is the folder of the meshes") != std::string::npos);
}

TEST_CASE("atlas: a mesh with its faces turned inwards is refused, and one of two names is one mesh", "[tool]")
{
  Scratch scratch;
  const Soup soup = bumpy_sphere(1);
  const std::string a = write_off(scratch / "a.off", soup), b = write_off(scratch / "b.off", inside_out(soup));
  const Process_result run = run_tool({"atlas", a, b, "-o", scratch / "atlas"});
  CHECK(run.exit_code == 1);
  CHECK((run.out + run.err).find("its faces are turned inwards") != std::string::npos);
  const Process_result turned = run_tool({"atlas", a, b, scratch / "./a.off", "-o", scratch / "atlas", "--prepare"});
  CAPTURE(turned.err);
  CHECK(turned.exit_code == 0);
  CHECK(lines_of(text_of(scratch / "atlas/scores.csv")).size() == 3); // with the line of names
}

TEST_CASE("atlas: where there is nothing to compare, nothing is written", "[tool]")
{
  Scratch scratch;
  const std::string one = write_off(scratch / "one.off", bumpy_sphere(1)),
                    bad = write_off(scratch / "bad.off", torus(6, 6));
  const std::string out = scratch / "atlas";
  fs::create_directories(out + "/spheres");
  write_off(out + "/spheres/bad.ply", bumpy_sphere(1)); // what has no row in the database is not a map of this mesh
  const Process_result run = run_tool({"atlas", one, bad, "-o", out});
  CHECK(run.exit_code == 1);
  CHECK(run.err.find("1 could be mapped") != std::string::npos);
  CHECK_FALSE(fs::exists(out + "/report.json"));
  const Process_result without_template = run_tool({"atlas", one, one, "-o", out, "--template", bad});
  CHECK(without_template.exit_code == 1);
  CHECK(without_template.err.find("is the template, and has no map") != std::string::npos);
  for(const std::vector<std::string>& wrong : {std::vector<std::string>{"atlas", one, "-o", one},
                                               {"atlas", "-o", out},
                                               {"atlas", one},
                                               {"atlas", one, "-o", out, "--rounds", "0"},
                                               {"atlas", one, "-o", out, "--align", "flat"},
                                               {"atlas", one, "-o", out, "--modes", "-1"}})
    CHECK(run_tool(wrong).exit_code == 2);
}

TEST_CASE("atlas: one run at a time writes a folder, and what a killed one has left goes", "[tool]")
{
  Scratch scratch;
  const std::string folder = make_folder(scratch), out = scratch / "atlas";
  fs::create_directories(out + "/modes");
  write_text(out + "/mean.ply.part123", "cut sho");
  write_text(out + "/modes/mode_1_plus.ply.part7", "cut sho");
  write_text(out + "/notes.part7", "not ours");
  Process_options options;
  options.meanwhile = [&](int pid) {
    for(int i = 0; i < 60000 && !fs::exists(out + "/registered/1/meshes.db"); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    kill(pid, SIGSTOP);
    const Process_result second = run_tool({"atlas", folder, "-o", out, "--method", "balanced"});
    CHECK(second.exit_code == 1);
    CHECK(second.err.find(out + ": is in use by another program") != std::string::npos);
    kill(pid, SIGCONT);
  };
  CHECK(run_tool({"atlas", folder, "-o", out, "--level", "3", "-j", "1"}, options).exit_code == 1); // the torus
  CHECK_FALSE(fs::exists(out + "/mean.ply.part123"));
  CHECK_FALSE(fs::exists(out + "/modes/mode_1_plus.ply.part7"));
  CHECK(fs::exists(out + "/notes.part7"));
}
