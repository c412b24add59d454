// SPDX-License-Identifier: GPL-3.0-or-later
// The command-line tool, run as a program: what it writes, and how it refuses.

#include "helpers/certificate.h"
#include "helpers/check.h"
#include "helpers/meshes.h"
#include "helpers/tool.h"

#include <CGAL/IO/polygon_soup_io.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

using namespace test;
namespace fs = std::filesystem;

TEST_CASE("map: the sphere has the vertices and faces of the input, in their order", "[tool]")
{
  Scratch scratch;
  std::vector<std::size_t> order;
  const Soup soup = renumbered(bumpy_sphere(3), 1, order);
  const std::string input = write_off(scratch / "in.off", soup);
  const std::string format = GENERATE("off", "obj", "ply");
  const std::string output = scratch / ("out." + format);
  const Process_result run = run_tool({"map", input, "-o", output});
  CAPTURE(run.out, run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(run.err.empty()); // no progress bar into a file
  const Soup sphere = read(output);
  CHECK(sphere.faces == soup.faces);
  CHECK(count_flipped_faces(soup, sphere.points) == 0);
  CHECK(degree(soup, sphere.points) == 1);
  Settings settings;
  settings.weights = Weights::CONFORMAL; // the default
  CHECK(distance(sphere.points, solve_or_throw(soup, settings)) < 1e-7);
  CHECK(count_vertices_off_sphere(sphere.points) == 0); // which takes all digits
}

TEST_CASE("map: reads all formats", "[tool]")
{
  Scratch scratch;
  const Soup soup = bumpy_sphere(2);
  const std::string off = write_off(scratch / "in.off", soup);
  const std::string format = GENERATE("obj", "ply", "stl");
  const std::string input = scratch / ("in." + format);
  REQUIRE(CGAL::IO::write_polygon_soup(input, soup.points, soup.faces, CGAL::parameters::stream_precision(17)));
  const Process_result run = run_tool({"map", input, "-o", scratch / "out.off"});
  CAPTURE(format, run.err);
  REQUIRE(run.exit_code == 0);
  const Soup sphere = read(scratch / "out.off");
  CHECK(sphere.points.size() == soup.points.size());
  CHECK(sphere.faces.size() == soup.faces.size());
  CHECK(count_flipped_faces(sphere, sphere.points) == 0);
  if(format != "stl") // which holds floats and no numbers
    CHECK(sphere.faces == soup.faces);
}

TEST_CASE("map: weights and methods are those of the library", "[tool]")
{
  Scratch scratch;
  const Soup soup = bumpy_sphere(2);
  const std::string input = write_off(scratch / "in.off", soup), output = scratch / "out.off";
  Settings settings;
  std::vector<std::string> arguments = {"map", input, "-o", output, "--policy", "sequential"};
  const auto weights = [&](const std::string& name, Weights chosen) {
    arguments.insert(arguments.end(), {"--method", "balanced", "--weights", name});
    settings.weights = chosen;
  };
  SECTION("barycentric") { weights("barycentric", Weights::BARYCENTRIC); }
  SECTION("clamped") { weights("clamped", Weights::CLAMPED); }
  SECTION("conformal") { weights("conformal", Weights::CONFORMAL); }
  SECTION("mean value") { weights("mean-value", Weights::MEAN_VALUE); }
  SECTION("the default: automatic, conformal")
  {
    settings.weights = Weights::CONFORMAL;
    settings.method = SP::Automatic();
  }
  SECTION("published method, twelve vertices fixed")
  {
    const Sphere natural = solve_or_throw(soup);
    std::ofstream fixed(scratch / "fixed.txt");
    fixed.precision(17);
    for(std::size_t i = 0; i < 12; ++i) {
      settings.fixed[i] = natural[i];
      fixed << i << ' ' << natural[i] << '\n';
    }
    arguments.insert(arguments.end(),
                     {"--weights", "clamped", "--method", "saddle-point", "--fixed", scratch / "fixed.txt"});
    settings.method = SP::Saddle_point();
    settings.accuracy = SP::Saddle_point::default_accuracy;
    settings.number_of_iterations = SP::Saddle_point::default_number_of_iterations;
  }
  const Process_result run = run_tool(arguments);
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(distance(read(output).points, solve_or_throw(soup, settings)) < 1e-7);
}

TEST_CASE("map: where the file holds floats, all figures are those of the file", "[tool]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", bumpy_sphere(3));
  const auto report_of = [&](const std::vector<std::string>& command) {
    std::vector<std::string> with_report = command;
    with_report.insert(with_report.end(), {"--report", scratch / "report.json"});
    REQUIRE(run_tool(with_report).exit_code == 0);
    return nlohmann::json::parse(text_of(scratch / "report.json"));
  };
  for(const char* name : {"out.off", "out.gii", "lh.sphere", "out.glb"}) {
    CAPTURE(name);
    const auto mapped = report_of({"map", input, "-o", scratch / name});
    CHECK(mapped.at("residual").is_null() == (name != std::string("out.off")));
    CHECK(mapped.at("energy").is_null() == mapped.at("residual").is_null());
    if(name != std::string("out.glb")) // in which vertices come in another order
      CHECK(mapped.at("distortion") == report_of({"certify", input, scratch / name}).at("distortion"));
  }
  CHECK(run_tool({"map", input, "-o", scratch / "out.gii"}).out.find("rounded to floats") != std::string::npos);
}

TEST_CASE("map: the report says what was done and how good the map is", "[tool]")
{
  Scratch scratch;
  const Soup soup = bumpy_sphere(3);
  const std::string input = write_off(scratch / "in.off", soup);
  REQUIRE(run_tool({"map", input, "-o", scratch / "out.off", "--report", scratch / "report.json", "--accuracy", "1e-9",
                    "--weights", "barycentric", "--policy", "sequential"})
            .exit_code == 0);
  const auto report = nlohmann::json::parse(text_of(scratch / "report.json"));
  CHECK(run_tool({"--version"}).out.find(report.at("version").get<std::string>()) != std::string::npos);
  CHECK(report.at("input") == input);
  CHECK(report.at("vertices") == soup.points.size());
  CHECK(report.at("faces") == soup.faces.size());
  CHECK(report.at("weights") == "barycentric");
  CHECK(report.at("method") == "automatic");
  CHECK(report.at("method_used") == "balanced");
  CHECK(report.at("moved_vertices") == 0);
  CHECK(report.at("policy") == "sequential");
  CHECK(report.at("device") == "one core");
  CHECK(report.at("iterations") > 0);
  CHECK(report.at("residual") <= 1e-9);
  CHECK(report.at("residual") > 1e-14); // the accuracy asked for is not the default one
  const double spring_energy = energy(make_springs(soup, Weights::BARYCENTRIC), read(scratch / "out.off").points);
  CHECK(report.at("energy").get<double>() == Approx(spring_energy).epsilon(1e-10));
  CHECK(report.at("flipped_faces") == 0);
  CHECK(report.at("degree") == 1);
  CHECK(report.at("error").is_null());
  const auto& energies = report.at("distortion").at("symmetric_dirichlet");
  CHECK(energies.at("min") >= 4);
  CHECK(energies.at("median") <= energies.at("percentile_95"));
  CHECK(report.at("distortion").at("degenerate_faces") == 0);
  CHECK(report.at("peak_memory_bytes") > 1000 * 1000);
  double sum = 0;
  for(const char* phase : {"read", "weights", "start_map", "solve", "certify", "measure", "write"}) {
    CHECK(report.at("seconds").at(phase) >= 0);
    sum += report.at("seconds").at(phase).get<double>();
  }
  CHECK(report.at("seconds").at("total").get<double>() >= 0.99 * sum);
}

TEST_CASE("map: the report has all settings, given or default", "[tool]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", icosphere(2));
  const auto settings = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"map", input, "-o", scratch / "out.off", "--report", scratch / "report.json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    run_tool(arguments); // the settings are there whether there is a map or not
    return nlohmann::json::parse(text_of(scratch / "report.json")).at("settings");
  };
  const auto of_automatic = settings({});
  CHECK(of_automatic.at("weights") == "conformal");
  CHECK(of_automatic.count("min_angle") == 0);
  CHECK(of_automatic.at("method") == "automatic");
  CHECK(of_automatic.at("largest_shrinkage") == SP::Automatic().largest_shrinkage);
  CHECK(settings({"--largest-shrinkage", "1e6"}).at("largest_shrinkage") == 1e6);

  const auto of_balanced =
    settings({"--method", "balanced", "--weights", "clamped", "--min-angle", "7", "--policy", "sequential"});
  CHECK(of_balanced.at("weights") == "clamped");
  CHECK(of_balanced.at("min_angle") == 7);
  CHECK(of_balanced.at("max_angle") == 85);
  CHECK(of_balanced.at("method") == "balanced");
  CHECK(of_balanced.at("spring_exponent") == SP::Balanced().spring_exponent);
  CHECK(of_balanced.at("accuracy") == SP::Balanced::default_accuracy);
  CHECK(of_balanced.at("iterations") == SP::Balanced::default_number_of_iterations);
  CHECK(of_balanced.at("max_time").is_null());
  CHECK(of_balanced.at("fixed").is_null());
  CHECK(of_balanced.at("policy") == "sequential");
  CHECK(of_balanced.at("triangulate") == false);

  const auto of_saddle_point = settings({"--method", "saddle-point", "--start", "harmonic", "--iterations", "3",
                                         "--accuracy", "1e-30", "--weights", "mean-value"});
  CHECK(of_saddle_point.at("weights") == "mean-value");
  CHECK(of_saddle_point.count("min_angle") == 0);
  CHECK(of_saddle_point.at("splitting") == "jacobi");
  CHECK(of_saddle_point.at("start") == "harmonic");
  CHECK(of_saddle_point.at("relaxation") == SP::Saddle_point().relaxation);
  CHECK(of_saddle_point.at("iterations") == 3);
  CHECK(settings({"--method", "isometric", "--area-exponent", "2", "--max-time", "1e-9"}).at("area_exponent") == 2);
}

TEST_CASE("map: a map that leaves nothing of a limb is passed over, and the reason is said", "[tool]")
{
  Scratch scratch;
  const std::string tube = write_off(scratch / "tube.off", capsule(6, 24));
  const auto map = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"map", tube, "-o", scratch / "out.off", "--report", scratch / "report.json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Process_result run = run_tool(arguments);
    CAPTURE(run.err);
    REQUIRE(run.exit_code == 0);
    return std::pair(run.out, nlohmann::json::parse(text_of(scratch / "report.json")));
  };
  const auto [words, report] = map({});
  CHECK(report.at("method_used") == "isometric");
  const std::string reason = report.at("fallback_reason");
  CHECK(reason.find("lengths shrink more than 1e+04 times") != std::string::npos);
  CHECK(words.find(reason) != std::string::npos);
  CHECK(report.at("settings").at("method") == "automatic"); // and the others are those of the map
  CHECK(report.at("settings").at("accuracy") == SP::Isometric::default_accuracy);
  CHECK(report.at("settings").at("iterations") == SP::Isometric::default_number_of_iterations);
  CHECK(report.count("termination") == 1);
  for(const auto& attempt : report.at("attempts"))
    CHECK(attempt.count("termination") == 1);
  const std::string more = map({"-v"}).first;
  CHECK(more.find(reason, more.find(reason) + 1) == std::string::npos);
  CHECK(map({"--largest-shrinkage", "1e30"}).second.at("method_used") == "balanced");
}

TEST_CASE("map: the report of a refusal says why", "[tool]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", torus(12, 8));
  CHECK(run_tool({"map", input, "-o", scratch / "out.off", "--report", scratch / "report.json"}).exit_code == 1);
  const auto report = nlohmann::json::parse(text_of(scratch / "report.json"));
  CHECK(report.at("error").get<std::string>().find("genus") != std::string::npos);
  CHECK(report.at("error").get<std::string>().find("the command 'prepare' does it") != std::string::npos);
  CHECK_FALSE(fs::exists(scratch / "out.off"));
}

TEST_CASE("map: the picture-ready PLY is the input with colours", "[tool]")
{
  Scratch scratch;
  const Soup soup = spiky_star(3, 1.5);
  const std::string input = write_off(scratch / "in.off", soup);
  REQUIRE(run_tool({"map", input, "-o", scratch / "out.off", "--stretch-ply", scratch / "stretch.ply"}).exit_code == 0);
  std::vector<CGAL::IO::Color> colours;
  Soup coloured;
  std::vector<CGAL::IO::Color> face_colours;
  std::ifstream in(scratch / "stretch.ply", std::ios::binary);
  REQUIRE(CGAL::IO::read_PLY(in, coloured.points, coloured.faces, face_colours, colours));
  CHECK(coloured.faces == soup.faces);
  CHECK(distance(coloured.points, soup.points) < 1e-5);
  REQUIRE(colours.size() == soup.points.size());
  std::set<std::array<int, 3>> different;
  for(const auto& c : colours)
    different.insert({c.red(), c.green(), c.blue()});
  CHECK(different.size() > 10);
}

TEST_CASE("map: meshes that are no triangulated spheres are refused", "[tool]")
{
  Scratch scratch;
  check_refused(scratch, write_off(scratch / "open.off", open_sphere(2)), "5");
  check_refused(scratch, write_off(scratch / "torus.off", torus(12, 8)), "genus");
  check_refused(scratch, write_off(scratch / "two.off", two_spheres()), "component");
  check_refused(scratch, write_off(scratch / "isolated.off", isolated_vertex()), "isolated");
  check_refused(scratch, write_off(scratch / "empty.off", Soup()), "");
  check_refused(scratch, write_off(scratch / "hourglass.off", make_soup(hourglass())), "manifold");

  Soup three_at_an_edge = icosphere(1);
  three_at_an_edge.points.emplace_back(2, 2, 2);
  const auto& f = three_at_an_edge.faces[0];
  three_at_an_edge.faces.push_back({f[0], f[1], three_at_an_edge.points.size() - 1});
  check_refused(scratch, write_off(scratch / "fin.off", three_at_an_edge), "edge");

  Soup one_reversed = icosphere(1);
  std::swap(one_reversed.faces[3][0], one_reversed.faces[3][1]);
  check_refused(scratch, write_off(scratch / "reversed.off", one_reversed), "orient");
}

TEST_CASE("map: inconsistent orientation has its own code in the report", "[tool]")
{
  Scratch scratch;
  Soup one_reversed = icosphere(1);
  std::swap(one_reversed.faces[3][0], one_reversed.faces[3][1]);
  const std::string input = write_off(scratch / "in.off", one_reversed);
  run_tool({"map", input, "-o", scratch / "out.off", "--report", scratch / "report.json"});
  const auto report = nlohmann::json::parse(text_of(scratch / "report.json"));
  CHECK(report.at("error_code") == "INCONSISTENT_ORIENTATION");
}

TEST_CASE("map: polygons are triangulated only if asked for", "[tool]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "quads.off", quad_cube());
  check_refused(scratch, input, "--triangulate");
  const Process_result run =
    run_tool({"map", input, "-o", scratch / "out.off", "--triangulate", "--weights", "barycentric"});
  CAPTURE(run.err);
  CHECK(run.exit_code == 0);
  const Soup sphere = read(scratch / "out.off");
  CHECK(sphere.points.size() == 8);
  CHECK(sphere.faces.size() == 12);
  CHECK(count_flipped_faces(sphere, sphere.points) == 0);
}

TEST_CASE("map: files that are broken are refused", "[tool]")
{
  Scratch scratch;
  const std::string good = off_text(icosphere(1));
  auto broken = [&](const std::string& name, const std::string& text) {
    write_text(scratch / name, text);
    return scratch / name;
  };
  check_refused(scratch, scratch / "not_there.off", "");
  check_refused(scratch, broken("empty_file.off", ""), "");
  check_refused(scratch, broken("cut.off", good.substr(0, good.size() / 2)), "");
  check_refused(scratch, broken("cut.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2"), "");
  check_refused(scratch, broken("index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
                "line 6: face 0 has the vertex '3', which is not in the range 0..2");
  check_refused(scratch, broken("negative_index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"), "-1");
  check_refused(scratch, broken("no_vertices.off", "OFF\n0 1 0\n3 0 1 2\n"), "0..-1");
  check_refused(scratch, broken("repeated.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 1\n3 0 1 2\n"), "");
  check_refused(scratch, broken("noise.ply", "ply\nformat binary_little_endian 1.0\n\1\2\3\xff"), "");
  check_refused(scratch,
                broken("index.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                                    "property float z\nelement face 1\nproperty list uchar ulong vertex_indices\n"
                                    "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 9223372036854775807\n"),
                "the vertex 9223372036854775808,"); // as a double
  check_refused(scratch, broken("text.stl", "solid nothing\nendsolid nothing\n"), "");
  check_refused(scratch, broken("unknown.xyz", good.substr(4)), "unknown extension");

  check_refused(scratch, broken("nan.off", off_text(nan_coordinate())), "finite");
  check_refused(scratch, broken("inf.off", off_text(infinite_coordinate())), "finite");
  check_refused(scratch, broken("windows.obj", "v 0 0 0\nv 1 0 0\nv 0 1 -1.#QNAN # none\nv 0 0 1\nf 1 2 3\n"),
                "'-1.#QNAN'");
}

TEST_CASE("map: a file is read as what it is where its extension says something else", "[tool]")
{
  Scratch scratch;
  const Soup soup = bumpy_sphere(2);
  const std::string format = GENERATE("ply", "off");
  const std::string good = scratch / ("in." + format);
  REQUIRE(CGAL::IO::write_polygon_soup(good, soup.points, soup.faces, CGAL::parameters::stream_precision(17)));
  REQUIRE(run_tool({"map", good, "-o", scratch / "expected.off"}).exit_code == 0);
  for(const char* extension : {"off", "obj", "ply", "stl"}) {
    const std::string input = scratch / ("other." + std::string(extension));
    fs::copy_file(good, input);
    const Process_result run = run_tool({"map", input, "-o", scratch / "out.off"});
    CAPTURE(format, extension, run.err);
    CHECK(run.exit_code == 0);
    CHECK((text_of(scratch / "out.off") == text_of(scratch / "expected.off")));
    fs::remove(scratch / "out.off");
  }
}

TEST_CASE("map: a header that promises too much costs no memory", "[tool]")
{
  Scratch scratch;
  for(const std::string counts : {"4000000000 1 0", "3 4000000000 0", "18446744073709551615 1 0", "-1 1 0"}) {
    const std::string input = scratch / "huge.off";
    write_text(input, "OFF\n" + counts + "\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    check_refused(scratch, input, "");
    CHECK(run_tool({"map", input, "-o", scratch / "out.off"}).peak_memory < 300 * 1000 * 1000);
  }
  const std::string input = scratch / "huge.ply";
  write_text(input, "ply\nformat ascii 1.0\nelement vertex 2000000000\nproperty float x\nproperty float y\n"
                    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n");
  check_refused(scratch, input, "");
  CHECK(run_tool({"map", input, "-o", scratch / "out.off"}).peak_memory < 300 * 1000 * 1000);
}

TEST_CASE("map: what stops early or does not converge leaves no file", "[tool]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", dumbbell(3));
  check_refused(scratch, input, "time", {"--max-time", "1e-9"});
  check_refused(scratch, input, "accuracy", {"--method", "balanced", "--accuracy", "1e-30"});
  const std::string tube = write_off(scratch / "tube.off", capsule(20, 12));
  check_refused(scratch, tube, "flipped", {"--method", "balanced"});
}

TEST_CASE("map: a refusal gives its advice once", "[tool]")
{
  Scratch scratch;
  const std::string tube = write_off(scratch / "tube.off", capsule(20, 12));
  const std::string text = run_tool({"map", tube, "-o", scratch / "out.off", "--method", "balanced"}).err;
  CAPTURE(text);
  const std::size_t first = text.find("automatic");
  REQUIRE(first != std::string::npos);
  CHECK(text.find("automatic", first + 1) == std::string::npos);
  CHECK(text.find("--method automatic") != std::string::npos);
}

TEST_CASE("map: a valid map that is not what was asked for is said to be that", "[tool]")
{
  Scratch scratch;
  const auto line = [&](const Soup& soup) {
    const std::string input = write_off(scratch / "in.off", soup);
    const Process_result run = run_tool({"map", input, "-o", scratch / "out.off", "--method", "balanced"});
    CAPTURE(run.err);
    REQUIRE(run.exit_code == 0);
    return run.out;
  };
  CHECK(line(spiky_star(4, 1)).find("valid, but") == std::string::npos);
  const Soup twisted = transformed(icosphere(3), [](const Point& p) { // slivers, some of which come out flipped
    const double c = std::cos(6 * p.z()), s = std::sin(6 * p.z());
    return Point(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z());
  });
  CHECK(line(twisted).find("vertices were moved off the solution so that their faces are valid") < std::string::npos);
}

TEST_CASE("map: SIGINT stops it in good order", "[tool]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", spiky_star(6, 1));
  Process_options options;
  options.interrupt_after = 1500;
  const Process_result run =
    run_tool({"map", input, "-o", scratch / "out.off", "--method", "saddle-point", "--accuracy", "1e-14"}, options);
  CAPTURE(run.err);
  CHECK(run.exit_code == 130); // of SIGINT, so that a loop of a shell ends, too
  CHECK(is_one_line(run.err));
  CHECK(run.err.find("interrupted") != std::string::npos);
  CHECK(scratch.number_of_files() == 1);
}

TEST_CASE("map: outputs that cannot be written are reported", "[tool]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", icosphere(1));
  for(const std::vector<std::string>& outputs :
      {std::vector<std::string>{"-o", scratch / "no folder/out.off"},
       {"-o", scratch / "out.off", "--report", scratch / "no folder/report.json"},
       {"-o", scratch / "out.off", "--stretch-ply", scratch / "no folder/stretch.ply"}}) {
    std::vector<std::string> arguments = {"map", input};
    arguments.insert(arguments.end(), outputs.begin(), outputs.end());
    const Process_result run = run_tool(arguments);
    CAPTURE(outputs, run.err);
    CHECK(run.exit_code == 1);
    CHECK(is_one_line(run.err));
  }
  CHECK(scratch.number_of_files() == 1);
}

TEST_CASE("map: a file that is replaced keeps its permissions, and what a link leads to stays", "[tool]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", icosphere(1)), output = scratch / "out.off";
  write_text(output, "old");
  fs::permissions(output, fs::perms::owner_read | fs::perms::owner_write);
  REQUIRE(run_tool({"map", input, "-o", output}).exit_code == 0);
  CHECK(read(output).faces.size() == icosphere(1).faces.size());
  CHECK(fs::status(output).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
  fs::create_directory(scratch / "folder");
  write_text(scratch / "other.off", "another");
  fs::create_symlink("../other.off", scratch / "folder/in.ply");
  REQUIRE(run_tool({"map", input, "-o", scratch / "folder/"}).exit_code == 0);
  CHECK(text_of(scratch / "other.off") == "another");
}

TEST_CASE("map: a name in brackets is a name", "[tool]")
{
  Scratch scratch;
  Process_options options;
  options.directory = scratch.folder();
  write_off(scratch / "[in.off]", icosphere(1));
  write_off(scratch / "in.off", icosphere(2));
  fs::create_directory(scratch / "[in]");
  write_off(scratch / "[in]/a.off", icosphere(1));
  REQUIRE(run_tool({"map", "[in.off]", "-o", "out.off", "--report=[report]"}, options).exit_code == 0);
  CHECK(fs::exists(scratch / "[report]"));
  CHECK(read(scratch / "out.off").faces.size() == icosphere(1).faces.size());
  REQUIRE(run_tool({"map", "[in]", "-o", "out"}, options).exit_code == 0);
  CHECK(fs::exists(scratch / "out/a.ply"));
}

TEST_CASE("map: names may be as long as the file system has them", "[tool]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", icosphere(0)), name = std::string(251, 'n') + ".off";
  const Process_result run = run_tool({"map", input, "-o", scratch / name});
  CAPTURE(run.err);
  CHECK(run.exit_code == 0);
  CHECK(std::filesystem::exists(scratch / name));
}

TEST_CASE("map: of a repaired mesh, fixed vertices and densities are those of the file", "[tool]")
{
  Scratch scratch;
  Soup soup =
    transformed(icosphere(2), [](const Point& p) { return Point(p.x(), 2 * p.y(), 3 * p.z() + p.x() * p.x()); });
  const std::string good = write_off(scratch / "good.off", soup);
  std::string fixed, fixed_after, densities;
  for(const std::size_t v : {0, 5, 9}) {
    const Point& p = icosphere(2).points[v];
    std::ostringstream direction;
    direction << ' ' << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    fixed += std::to_string(v) + direction.str();
    fixed_after += std::to_string(v + 1) + direction.str();
  }
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    densities += std::to_string(1 + v % 3) + '\n';
  write_text(scratch / "fixed.txt", fixed);
  write_text(scratch / "density.txt", densities);
  write_text(scratch / "fixed_after.txt", fixed_after);
  write_text(scratch / "density_after.txt", "7\n" + densities);
  soup.points.insert(soup.points.begin(), Point(0, 0, 0)); // without faces
  for(auto& face : soup.faces)
    for(std::size_t& v : face)
      ++v;
  const std::string bad = write_off(scratch / "bad.off", soup);
  const auto map = [&](const std::string& file, std::vector<std::string> options) {
    options.insert(options.begin(), {"map", file, "-o", scratch / "out.off", "--method", "isometric"});
    const Process_result run = run_tool(options);
    CAPTURE(run.err);
    CHECK(run.exit_code == 0);
    return text_of(scratch / "out.off");
  };
  CHECK(map(bad, {"--prepare", "--fixed", scratch / "fixed_after.txt"}) ==
        map(good, {"--fixed", scratch / "fixed.txt"}));
  CHECK(map(bad, {"--prepare", "--density", scratch / "density_after.txt"}) ==
        map(good, {"--density", scratch / "density.txt"}));
  const auto error = [&](const std::string& file, const char* option, const std::string& data) {
    write_text(scratch / "data.txt", data);
    return run_tool({"map", file, "-o", scratch / "none.off", "--method", "isometric", "--prepare", option,
                     scratch / "data.txt"})
      .err;
  };
  CHECK_THAT(error(bad, "--fixed", "0 0 0 1\n1 0 1 0\n2 1 0 0\n"), Catch::Contains("vertex 0 was removed when"));
  CHECK_THAT(error(bad, "--density", densities), Catch::Contains("the mesh has 163 vertices"));
  Soup open = icosphere(2);
  open.faces.erase(std::remove_if(open.faces.begin(), open.faces.end(),
                                  [](const auto& f) { return f[0] == 0 || f[1] == 0 || f[2] == 0; }),
                   open.faces.end());
  std::string of_faces;
  for(std::size_t f = 0; f < open.faces.size(); ++f)
    of_faces += "1\n";
  write_text(scratch / "data.txt", of_faces); // `map --prepare` fills no holes
  const Process_result filled = run_tool({"texture", write_off(scratch / "open.off", open), "-o", scratch / "none.obj",
                                          "--prepare", "--method", "isometric", "--density", scratch / "data.txt"});
  CHECK(filled.exit_code == 1);
  CHECK_THAT(filled.err, Catch::Contains("faces that were added"));
}

TEST_CASE("map: fixed vertices that do not fit are refused", "[tool]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", icosphere(1));
  for(const char* lines : {"0 1 0 0\n1 0 1 0\n", "0 1 0 0\n1 0 1 0\n42 0 0 1\n", "0 1 0 0\n1 0 1 0\n2 0 0\n",
                           "0 1 0 0\n1 0 1 0\n2 0 0 0\n", "0 1 0 0\n1 0 1 0\n1 0 0 1\n", "zero 1 0 0\n"}) {
    write_text(scratch / "fixed.txt", lines);
    const Process_result run = run_tool({"map", input, "-o", scratch / "out.off", "--fixed", scratch / "fixed.txt"});
    CAPTURE(lines, run.err);
    CHECK(run.exit_code == 1);
    CHECK(is_one_line(run.err));
    CHECK_FALSE(fs::exists(scratch / "out.off"));
  }
}

TEST_CASE("map: densities of vertices or faces are followed and reported", "[tool]")
{
  Scratch scratch;
  const Soup soup = icosphere(3);
  const std::string input = write_off(scratch / "in.off", soup);
  const auto deviation = [&](std::size_t number, const std::vector<std::string>& options) {
    std::string text = "# one for each\n";
    for(std::size_t i = 0; i < number; ++i)
      text += i % 3 == 0 ? "2 " : "1.5e0\n";
    write_text(scratch / "density.txt", text);
    std::vector<std::string> arguments = {"map",       input,
                                          "-o",        scratch / "out.off",
                                          "--report",  scratch / "report.json",
                                          "--density", scratch / "density.txt"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Process_result run = run_tool(arguments);
    CAPTURE(run.err);
    REQUIRE(run.exit_code == 0);
    CHECK(run.out.find("root mean square of log(area / target area): ") != std::string::npos);
    const auto report = nlohmann::json::parse(text_of(scratch / "report.json"));
    CHECK(report.at("method_used") == "isometric");
    CHECK(report.at("settings").at("density") == scratch / "density.txt");
    return std::pair<double, double>(report.at("density_deviation"), report.at("settings").at("area_exponent"));
  };
  for(const std::size_t number : {soup.points.size(), soup.faces.size()}) {
    const auto [by_default, exponent] = deviation(number, {});
    CHECK(exponent == SP::Isometric::area_exponent_of_densities);
    CHECK(by_default > 0);
    CHECK(deviation(number, {"--method", "isometric", "--area-exponent", "1"}).first > by_default);
  }
}

TEST_CASE("map: densities that do not fit are refused", "[tool]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", icosphere(0)); // of 12 vertices, 20 faces
  const auto check = [&](const std::string& text, const std::string& reason) {
    write_text(scratch / "density.txt", text);
    const Process_result run =
      run_tool({"map", input, "-o", scratch / "out.off", "--density", scratch / "density.txt"});
    CAPTURE(text, run.err);
    CHECK(run.exit_code == 1);
    CHECK(is_one_line(run.err));
    CHECK(run.err.find(reason) != std::string::npos);
    CHECK_FALSE(fs::exists(scratch / "out.off"));
  };
  check("# nothing", "has 0 numbers, but the mesh has 12 vertices and 20 faces");
  check("1 2 3", "has 3 numbers");
  check("1\n2 0\n", "line 2: '0' is not a positive number");
  check("1 -1", "'-1' is not a positive number");
  check("nan", "'nan' is not a positive number");
  check("1e999", "'1e999' is not a positive number");
  check("heavy", "'heavy' is not a positive number");
}

TEST_CASE("wrong usage exits with 2", "[tool]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", icosphere(1)), output = scratch / "out.off";
  fs::create_directory(scratch / "folder.off");
  for(const std::vector<std::string>& arguments :
      {std::vector<std::string>{},
       {"no-such-command"},
       {"map"},
       {"map", input},
       {"map", input, "-o"},
       {"map", input, "-o", output, "--no-such-option"},
       {"map", input, "-o", output, "--weights", "heavy"},
       {"map", input, "-o", output, "--method", "guess"},
       {"map", input, "-o", output, "--method", "balanced", "--density", input},
       {"map", input, "-o", output, "--accuracy", "much"},
       {"map", input, "-o", output, "--accuracy", "-1"},
       {"map", input, "-o", output, "--policy", "abacus"},
       {"map", input, "-o", output, "--device", "0"},
       {"map", input, "-o", output, "--precision", "single"},
       {"map", input, "-o", output, "--max-time", "0"},
       {"map", input, "-o", scratch / "out.xyz"},
       {"map", input, "-o", ""},
       {"map", input, "-o", output, "--report", ""},
       {"map", input, "-o", output, "--triangulate=false"},
       {"map", input, "-o", input},
       {"map", input, "-o", scratch / "folder.off"}}) {
    const Process_result run = run_tool(arguments);
    CAPTURE(arguments, run.out, run.err);
    CHECK(run.exit_code == 2);
    CHECK_FALSE(run.err.empty());
    CHECK(scratch.number_of_files() == 2);
    CHECK(text_of(input) == off_text(icosphere(1)));
  }
}

TEST_CASE("help, version and devices exit with 0", "[tool]")
{
  for(const std::vector<std::string>& arguments :
      {std::vector<std::string>{"--help"}, {"map", "--help"}, {"--version"}, {"devices"}}) {
    const Process_result run = run_tool(arguments);
    CAPTURE(arguments, run.err);
    CHECK(run.exit_code == 0);
    CHECK_FALSE(run.out.empty());
    CHECK(run.err.empty());
  }
}

TEST_CASE("devices: every policy, and the default", "[tool]")
{
  const std::string out = run_tool({"devices"}).out;
  CAPTURE(out);
#ifdef CGAL_LINKED_WITH_TBB
  CHECK(out.find("sequential: one core\ntbb (default): ") == 0);
#else
  CHECK(out.find("sequential (default): one core\ntbb: not available") == 0);
#endif
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
  CHECK(out.find("\nopencl: ") != std::string::npos);
#else
  CHECK(out.find("\nopencl: not available") != std::string::npos);
#endif
}

TEST_CASE("map: relative names are relative to the working directory", "[tool]")
{
  Scratch scratch;
  write_off(scratch / "in.off", icosphere(1));
  Process_options options;
  options.directory = scratch.folder();
  CHECK(run_tool({"map", "in.off", "-o", "out.off"}, options).exit_code == 0);
  CHECK(fs::exists(scratch / "out.off"));
}
