// SPDX-License-Identifier: GPL-3.0-or-later
// The sub-commands of the tool that use a map: texture, resample, harmonics, segment, view; and --sphere, which they
// share.

#include "helpers/certificate.h"
#include "helpers/meshes.h"
#include "helpers/solve.h"
#include "helpers/tool.h"

#include <CGAL/Spherical_parameterization/harmonic_files.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

using namespace test;
namespace fs = std::filesystem;

namespace {

/// What an OBJ file with texture coordinates has; all indices from 0 on.
struct Textured {
  std::string material;
  std::vector<Point> points;
  std::vector<std::array<float, 2>> uv; ///< as a viewer reads them
  std::vector<std::array<std::size_t, 3>> vertex, texture;
};

Textured read_textured(const std::string& file)
{
  Textured result;
  std::ifstream in(file);
  for(std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if(word == "mtllib")
      words >> result.material;
    else if(word == "v") {
      double x, y, z;
      words >> x >> y >> z;
      result.points.emplace_back(x, y, z);
    } else if(word == "vt") {
      result.uv.emplace_back();
      words >> result.uv.back()[0] >> result.uv.back()[1];
    } else if(word == "f") {
      result.vertex.emplace_back();
      result.texture.emplace_back();
      for(std::size_t k = 0; k < 3; ++k) {
        char slash = ' ';
        words >> result.vertex.back()[k] >> slash >> result.texture.back()[k];
        CHECK(slash == '/');
        --result.vertex.back()[k];
        --result.texture.back()[k];
      }
    }
    CHECK_FALSE(words.fail());
  }
  return result;
}

/// The text of an element of a page.
std::string content(const std::string& page, const std::string& id)
{
  const std::string start = "id=\"" + id + "\">";
  const std::size_t begin = page.find(start) + start.size();
  return page.substr(begin, page.find("</script>", begin) - begin);
}

/// Arguments that make every command write what it writes.
std::vector<std::string> command_line(const std::string& command, const std::string& input, const Scratch& scratch)
{
  const std::string output = command == "texture"   ? "out.obj"
                             : command == "segment" ? "out.ply"
                             : command == "view"    ? "out.html"
                                                    : "out.off";
  return {command, input, "-o", scratch / output};
}

std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more)
{
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

void check_exit(const Process_result& run, const std::string& word)
{
  CAPTURE(run.err, word);
  CHECK(run.exit_code == 1);
  CHECK(is_one_line(run.err));
  CHECK(run.err.find(word) != std::string::npos);
}

} // namespace

TEST_CASE("texture: every face has a counter-clockwise triangle of floats", "[tool]")
{
  Scratch scratch;
  const Soup soup = spiky_star(4, 2);
  const std::string input = write_off(scratch / "in.off", soup);
  const std::string chart = GENERATE("latitude-longitude", "octahedral");
  const Process_result run =
    run_tool(with(command_line("texture", input, scratch), {"--chart", chart, "--policy", "sequential"}));
  CAPTURE(run.out, run.err);
  REQUIRE(run.exit_code == 0);
  const Textured t = read_textured(scratch / "out.obj");
  CHECK(t.points == soup.points);
  REQUIRE(t.vertex.size() == soup.faces.size());
  CHECK(t.uv.size() >= soup.points.size());
  CHECK(t.uv.size() < 1.2 * double(soup.points.size()) + 100); // shared but for seams
  std::size_t flipped = 0;
  for(std::size_t f = 0; f < soup.faces.size(); ++f) {
    std::array<Kernel::Point_2, 3> uv;
    std::set<std::size_t> corners;
    for(std::size_t k = 0; k < 3; ++k) {
      const auto& p = t.uv.at(t.texture[f][k]);
      uv[k] = Kernel::Point_2(double(p[0]), double(p[1]));
      corners.insert(t.vertex[f][k]);
    }
    flipped += exact_orientation(uv[0], uv[1], uv[2]) != CGAL::LEFT_TURN;
    CHECK(corners == std::set<std::size_t>(soup.faces[f].begin(), soup.faces[f].end()));
  }
  CHECK(flipped == 0);

  CHECK(t.material == "out.mtl");
  CHECK(text_of(scratch / "out.mtl").find("map_Kd out.png\n") != std::string::npos);
  const std::string png = text_of(scratch / "out.png");
  CHECK(png.substr(0, 8) == "\x89PNG\r\n\x1a\n");
  CHECK(png.size() > 1000);
  CHECK(scratch.number_of_files() == 4);
}

TEST_CASE("texture: another image, and a pole where the user wants it", "[tool]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", bumpy_sphere(2));
  write_text(scratch / "earth.png", "not looked at");
  const Process_result run = run_tool(
    with(command_line("texture", input, scratch), {"--image", scratch / "earth.png", "--north", "0", "0", "2"}));
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(text_of(scratch / "out.mtl").find("map_Kd earth.png\n") != std::string::npos);
  CHECK_FALSE(fs::exists(scratch / "out.png"));
  CHECK(run.out.find("north pole at 0 0 2") != std::string::npos);

  // the name of the image leads from the material to it, whatever the way to the output
  fs::create_directories(scratch / "a/b");
  fs::create_directory_symlink("a/b", scratch / "link");
  write_text(scratch / "a/pic.png", "not looked at");
  Process_options from_a;
  from_a.directory = scratch / "a";
  for(const auto& [folder, place] : {std::pair("..", "a/pic.png"), {"../link", "../pic.png"}, {".", "pic.png"}}) {
    REQUIRE(run_tool({"texture", "../in.off", "-o", std::string(folder) + "/x.obj", "--image", "pic.png"}, from_a)
              .exit_code == 0);
    CHECK(text_of(scratch / ("a/" + std::string(folder) + "/x.mtl")).find("map_Kd " + std::string(place) + '\n') !=
          std::string::npos);
  }
}

TEST_CASE("texture: an image that cannot be read is refused before the work", "[tool]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", bumpy_sphere(2));
  fs::create_directory(scratch / "folder.png");
  write_text(scratch / "empty.png", "");
  const std::size_t files = scratch.number_of_files();
  for(const std::string image : {"nothere.png", "folder.png", "empty.png"}) {
    check_exit(run_tool(with(command_line("texture", input, scratch), {"--image", scratch / image})), image);
    CHECK(scratch.number_of_files() == files);
  }
}

TEST_CASE("resample: vertices and faces of an icosphere, points of the shape", "[tool]")
{
  Scratch scratch;
  const Soup soup = ellipsoid(1, 2, 3, 4);
  const std::string input = write_off(scratch / "in.off", soup);
  const std::string format = GENERATE("off", "obj", "ply");
  const std::string output = scratch / ("out." + format), sphere_output = scratch / ("sphere." + format);
  const Process_result run =
    run_tool({"resample", input, "-o", output, "--output-sphere", sphere_output, "--level", "4"});
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  const Soup out = read(output), sphere = read(sphere_output);
  CHECK(out.points.size() == 2562);
  CHECK(out.faces.size() == 5120);
  CHECK(out.faces == sphere.faces);
  CHECK(count_flipped_faces(sphere, sphere.points) == 0);
  CHECK(degree(sphere, sphere.points) == 1);
  for(const Point& p : out.points) {
    const double radius = p.x() * p.x() + p.y() * p.y() / 4 + p.z() * p.z() / 9;
    CHECK(radius == Approx(1).margin(0.02)); // flat faces between points of the ellipsoid
  }
}

TEST_CASE("resample: to the vertices of any sphere", "[tool]")
{
  Scratch scratch;
  const Soup soup = ellipsoid(1, 2, 3, 4);
  const std::string input = write_off(scratch / "in.off", soup);
  const auto resample = [&](const std::string& output, const std::vector<std::string>& options) {
    std::vector<std::string> command = {"resample", input, "-o", scratch / output};
    command.insert(command.end(), options.begin(), options.end());
    return run_tool(command);
  };
  REQUIRE(resample("level.off", {"--level", "3", "--output-sphere", scratch / "sphere.off"}).exit_code == 0);
  REQUIRE(
    resample("to_sphere.off", {"--to-sphere", scratch / "sphere.off", "--report", scratch / "r.json"}).exit_code == 0);
  CHECK(text_of(scratch / "to_sphere.off") == text_of(scratch / "level.off"));
  const auto report = nlohmann::json::parse(text_of(scratch / "r.json"));
  CHECK(report["resample"]["level"].is_null());
  CHECK(report["resample"]["to_sphere"] == scratch / "sphere.off");
  CHECK(report["resample"]["vertices"] == 642);

  // of radius 100, in floats
  REQUIRE(resample("level.off", {"--level", "3", "--output-sphere", scratch / "lh.sphere"}).exit_code == 0);
  REQUIRE(resample("to_sphere.off", {"--to-sphere", scratch / "lh.sphere"}).exit_code == 0);
  const Soup exact = read(scratch / "level.off"), from_floats = read(scratch / "to_sphere.off");
  CHECK(exact.faces == from_floats.faces);
  for(std::size_t v = 0; v < exact.points.size(); ++v)
    CHECK((exact.points[v] - from_floats.points[v]).squared_length() < 1e-10);

  const std::size_t files = scratch.number_of_files();
  const Process_result refused = resample("out.off", {"--to-sphere", input});
  CHECK(refused.exit_code == 1);
  CHECK(refused.err.find("in.off") != std::string::npos);
  CHECK(is_one_line(refused.err));
  CHECK(scratch.number_of_files() == files);
}

TEST_CASE("resample: no limb is lost by default, and what is lost otherwise is said", "[tool]")
{
  Scratch scratch;
  const Soup soup = body_with_limbs({{Vector(0, 0, 1), 0.3, 4}}, 4).soup;
  const std::string input = write_off(scratch / "in.off", soup), output = scratch / "out.off";
  const auto length = [](const Soup& s) {
    const auto [low, high] = std::minmax_element(s.points.begin(), s.points.end(),
                                                 [](const Point& a, const Point& b) { return a.z() < b.z(); });
    return high->z() - low->z();
  };
  const Process_result good = run_tool({"resample", input, "-o", output, "--level", "5"});
  CAPTURE(good.out, good.err);
  REQUIRE(good.exit_code == 0);
  CHECK(good.err.empty());
  CHECK(good.out.find("isometric map; 99 % of the shape is within ") != std::string::npos);
  CHECK(length(read(output)) > 0.97 * length(soup));

  const Process_result bad = run_tool({"resample", input, "-o", output, "--level", "3", "--method", "balanced"});
  CAPTURE(bad.out, bad.err);
  REQUIRE(bad.exit_code == 0);
  CHECK(bad.out.find("parts that are small on the sphere are lost") != std::string::npos);
  CHECK(bad.out.find("balanced map") != std::string::npos);
}

TEST_CASE("harmonics: coefficients, reconstruction and report of an ellipsoid", "[tool]")
{
  Scratch scratch;
  const Soup soup = ellipsoid(1, 2, 3, 3);
  const std::string input = write_off(scratch / "in.off", soup), round = write_off(scratch / "round.off", icosphere(3));
  const std::string format = GENERATE("csv", "json", "coef");
  const std::string fit = GENERATE("least-squares", "integrals");
  const std::string output = scratch / ("out." + format);
  const Process_result run =
    run_tool({"harmonics", input, "--sphere", round, "-o", output, "--degree", "9", "--fit", fit, "--reconstruct",
              scratch / "smooth.off", "--report", scratch / "report.json"});
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  std::ifstream in(output);
  const SP::Harmonic_coefficients c =
    SP::read_coefficients(in, format == "csv"    ? SP::Coefficient_format::CSV
                              : format == "json" ? SP::Coefficient_format::JSON
                                                 : SP::Coefficient_format::SPHARM_PDM);
  CHECK(c.degree() == 9);
  REQUIRE(c.number_of_fields() == 3);
  const double unit = std::sqrt(4 * std::acos(-1.) / 3), tolerance = fit == "integrals" ? 0.05 : 1e-8;
  CHECK(c(1, 1, 0) == Approx(unit).margin(tolerance));
  CHECK(c(1, -1, 1) == Approx(2 * unit).margin(tolerance));
  CHECK(c(1, 0, 2) == Approx(3 * unit).margin(tolerance));
  const Soup smooth = read(scratch / "smooth.off");
  CHECK(smooth.faces == soup.faces);
  for(std::size_t i = 0; i < soup.points.size(); ++i)
    CHECK(std::sqrt((smooth.points[i] - soup.points[i]).squared_length()) < tolerance);
  const auto report = nlohmann::json::parse(text_of(scratch / "report.json"))["harmonics"];
  CHECK(report["power_spectrum"].size() == 10);
  CHECK(report["ellipsoid"]["radii"][0].get<double>() == Approx(3).margin(tolerance));
  REQUIRE(report["errors"].size() == 5); // of degrees 1, 2, 4, 8, 9
  for(const auto& row : report["errors"]) {
    CHECK(row["hausdorff"].get<double>() <= row["largest"].get<double>() + 1e-12);
    CHECK(row["root_mean_square"].get<double>() <= row["largest"].get<double>());
  }
}

TEST_CASE("harmonics: the Hausdorff distance is that of the vertices from the faces", "[tool]")
{
  Scratch scratch;
  Soup shape = icosphere(2);
  for(Point& p : shape.points) // with a spike, and as flat as a pancake
    p = Point(p.x(), p.y() * (p.x() > 0.9 ? 3 : 1), 0.1 * p.z() + (p.y() > 0.8 ? 1 : 0));
  const std::string input = write_off(scratch / "in.off", shape),
                    round = write_off(scratch / "round.off", icosphere(2));
  const Process_result run =
    run_tool({"harmonics", input, "--sphere", round, "-o", scratch / "out.csv", "--degree", "5", "--reconstruct",
              scratch / "smooth.off", "--report", scratch / "report.json"});
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  Soup smooth = read(scratch / "smooth.off");
  double square = 0;
  for(const auto& [from, to] : {std::pair(&shape, &smooth), std::pair(&smooth, &shape)})
    for(const Point& p : from->points) {
      double nearest = 1e300;
      for(const auto& f : to->faces)
        nearest = (std::min)(
          nearest, CGAL::squared_distance(p, Kernel::Triangle_3(to->points[f[0]], to->points[f[1]], to->points[f[2]])));
      square = (std::max)(square, nearest);
    }
  const auto report = nlohmann::json::parse(text_of(scratch / "report.json"));
  const auto last = report["harmonics"]["errors"].back();
  CHECK(last["hausdorff"].get<double>() == Approx(std::sqrt(square)).epsilon(1e-9));
  CHECK(last["hausdorff"].get<double>() < 0.9 * last["largest"].get<double>()); // else the test could not tell
  CHECK(report["harmonics"]["seconds"]["errors"].get<double>() <= report["seconds"]["measure"].get<double>());
  CHECK(report["seconds"]["measure"].get<double>() <= report["seconds"]["total"].get<double>());
}

TEST_CASE("harmonics: aligned coefficients do not depend on the pose, and the map is isometric by default", "[tool]")
{
  Scratch scratch;
  Soup soup = bumpy_sphere(2);
  const std::string input = write_off(scratch / "in.off", soup), round = write_off(scratch / "round.off", icosphere(2));
  for(Point& p : soup.points)
    p = Point(p.z() + 5, p.x(), p.y());
  const std::string moved = write_off(scratch / "moved.off", soup);
  const auto coefficients = [&](const std::string& mesh) {
    const std::string output = scratch / "out.csv";
    REQUIRE(run_tool({"harmonics", mesh, "--sphere", round, "-o", output, "--degree", "6", "--align"}).exit_code == 0);
    std::ifstream in(output);
    return SP::read_coefficients(in, SP::Coefficient_format::CSV).values();
  };
  const std::vector<double> a = coefficients(input), b = coefficients(moved);
  REQUIRE(a.size() == b.size());
  for(std::size_t i = 0; i < a.size(); ++i)
    CHECK(a[i] == Approx(b[i]).margin(1e-8));
  REQUIRE(run_tool({"harmonics", moved, "--sphere", round, "-o", scratch / "out.csv", "--degree", "6", "--align",
                    "--reconstruct", scratch / "shape.off"})
            .exit_code == 0);
  double sum = 0; // the shape is where its coefficients are: not 5 beside the origin
  for(const Point& p : read(scratch / "shape.off").points)
    sum += p.x() / static_cast<double>(soup.points.size());
  CHECK(std::abs(sum) < 0.5);
  REQUIRE(run_tool({"harmonics", moved, "--sphere", round, "-o", scratch / "out.csv", "--degree", "6", "--reconstruct",
                    scratch / "there.off"})
            .exit_code == 0);
  const std::vector<Point> here = read(scratch / "shape.off").points, there = read(scratch / "there.off").points;
  for(std::size_t v = 1; v < here.size(); ++v) // and every vertex is where it is on the shape
    CHECK((here[v] - here[0]).squared_length() == Approx((there[v] - there[0]).squared_length()));
  const Process_result none = run_tool({"harmonics", input, "-o", scratch / "none.csv", "--degree", "0", "--align"});
  CHECK(none.exit_code == 2);
  CHECK(none.err.find("--align: requires --degree 1 or more") != std::string::npos);
  const std::string report = scratch / "report.json";
  REQUIRE(run_tool({"harmonics", input, "-o", scratch / "out.csv", "--degree", "3", "--report", report}).exit_code ==
          0);
  CHECK(nlohmann::json::parse(text_of(report))["method_used"] == "isometric");
}

TEST_CASE("harmonics: a degree that the vertices do not determine is refused", "[tool]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", icosphere(1)); // 42 vertices
  check_exit(run_tool({"harmonics", input, "--sphere", input, "-o", scratch / "out.csv", "--degree", "6"}),
             "--degree 5 or less");
  CHECK(scratch.number_of_files() == 1);
  CHECK(
    run_tool({"harmonics", input, "--sphere", input, "-o", scratch / "out.csv", "--degree", "6", "--fit", "integrals"})
      .exit_code == 0);
}

TEST_CASE("register: one mesh in the shape of another, whose sphere is turned", "[tool]")
{
  Scratch scratch;
  const Soup a = bumpy_sphere(3), round = icosphere(3);
  const auto turn = [](const Point& p) { return Point(p.y(), p.z(), p.x()); };
  const std::string input = write_off(scratch / "a.off", a), sphere = write_off(scratch / "sphere.off", round);
  const std::string other = write_off(scratch / "b.off", transformed(a, [&](const Point& p) {
                                        const Point q = turn(p);
                                        return Point(2 * q.x() + 7, 2 * q.y(), 2 * q.z());
                                      }));
  const std::string turned = write_off(scratch / "turned.off", transformed(round, turn));
  const std::string motion = GENERATE("rotation", "moebius", "deformation");
  const Process_result run =
    run_tool({"register", input, other, "--spheres", sphere, turned, "--max-time", "1000", "--motion", motion, "-o",
              scratch / "out.off", "--output-sphere", scratch / "moved.off", "--report", scratch / "report.json"});
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  const Soup out = read(scratch / "out.off"), moved = read(scratch / "moved.off");
  CHECK(out.faces == a.faces);
  CHECK(moved.faces == a.faces);
  CHECK(count_flipped_faces(a, moved.points) == 0);
  for(std::size_t i = 0; i < a.points.size(); ++i) {
    const Point q = turn(a.points[i]);
    CHECK(std::sqrt((out.points[i] - Point(2 * q.x() + 7, 2 * q.y(), 2 * q.z())).squared_length()) < 0.1);
  }
  const auto report = nlohmann::json::parse(text_of(scratch / "report.json"));
  CHECK(report["motion"] == motion);
  for(const char* figure : {"mismatch", "stretching", "distortion"}) // computed only there
    CHECK(report[figure].is_null() == (motion != "deformation"));
  CHECK(report["flipped_faces"] == 0);
  CHECK(report["degree"] == 1);
}

TEST_CASE("register: landmarks are read, and wrong ones refused with their line", "[tool]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", bumpy_sphere(2));
  const std::string sphere = write_off(scratch / "sphere.off", icosphere(2));
  const auto run_with = [&](const std::string& text) {
    std::ofstream(scratch / "landmarks.txt") << text;
    return run_tool({"register", input, input, "--spheres", sphere, sphere, "--landmarks", scratch / "landmarks.txt",
                     "-o", scratch / "out.off"});
  };
  const Process_result run = run_with("# A B\n0 0\n50 50\n100 100\n");
  CHECK(run.exit_code == 0);
  CHECK(run.out.find("start by spectrum") != std::string::npos);
  std::filesystem::remove(scratch / "out.off");
  CHECK(run_process({"/bin/gzip", "-k", scratch / "landmarks.txt"}).exit_code == 0);
  CHECK(run_tool({"register", input, input, "--spheres", sphere, sphere, "--landmarks", scratch / "landmarks.txt.gz",
                  "-o", scratch / "out.off"})
          .exit_code == 0);
  std::filesystem::remove(scratch / "out.off");
  check_exit(run_with("0 0\n1 162\n"), "line 2: vertex 162 is not in 0..161 of B");
  check_exit(run_with("0 0\n1 0\n"), "line 2: vertex 0 of B is listed twice");
  check_exit(run_with("0\n"), "fewer than two vertices");
  check_exit(run_with("0 0 0\n"), "more than two values");
  check_exit(run_with("zero 0\n"), "'zero' is not a vertex index");
  check_exit(run_with("\n"), "has no landmark");
  CHECK(!std::filesystem::exists(scratch / "out.off"));
}

TEST_CASE("morph: from one mesh to the other, without shrinking on a turn", "[tool]")
{
  Scratch scratch;
  const Soup a = bumpy_sphere(2);
  const bool is_half = GENERATE(false, true); // by 180 degrees
  const auto turn = [is_half](const Point& p) {
    return is_half ? Point(-p.x(), -p.y(), p.z()) : Point(p.y(), p.z(), p.x());
  };
  const std::string input = write_off(scratch / "a.off", a), sphere = write_off(scratch / "sphere.off", icosphere(2));
  const std::string other = write_off(scratch / "b.off", transformed(a, turn));
  const std::string turned = write_off(scratch / "turned.off", transformed(icosphere(2), turn));
  const Process_result run = run_tool({"morph", input, other, "--spheres", sphere, turned, "-o", scratch / "way",
                                       "--steps", "2", "--format", "off", "--motion", "rotation"});
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  const Soup first = read(scratch / "way/step_0.off"), middle = read(scratch / "way/step_1.off"),
             last = read(scratch / "way/step_2.off");
  CHECK(first.points == a.points);
  for(std::size_t i = 0; i < a.points.size(); ++i) {
    CHECK(std::sqrt((last.points[i] - turn(a.points[i])).squared_length()) < 0.1);
    CHECK(std::sqrt((middle.points[i] - CGAL::ORIGIN).squared_length()) ==
          Approx(std::sqrt((a.points[i] - CGAL::ORIGIN).squared_length())).margin(0.15));
  }
  const std::string page = text_of(scratch / "way/morph.html");
  const nlohmann::json header = nlohmann::json::parse(content(page, "header"));
  CHECK(header["vertices"] == 162);
  CHECK(header["faces"] == 320);
  CHECK(header["registration"]["inputs"] == nlohmann::json({input, other}));
  const std::size_t shapes = 9;
  CHECK(header["coordinates"].size() == 3 * shapes);
  CHECK(content(page, "data").size() == (shapes * 6 * 162 + 9 * 320 + 2) / 3 * 4);
}

TEST_CASE("morph: no mesh has to go for a step, and no step of another run stays among them", "[tool]")
{
  Scratch scratch;
  fs::create_directory(scratch / "way");
  const std::string a = write_off(scratch / "way/step_10.off", bumpy_sphere(1)),
                    b = write_off(scratch / "b.off", ellipsoid(1, 1.2, 1.4, 1));
  const auto morph = [&](const std::string& from, const char* steps) {
    return run_tool({"morph", from, b, "-o", scratch / "way", "--format", "off", "--steps", steps});
  };
  const std::string before = text_of(a);
  CHECK(morph(a, "10").exit_code == 2);
  CHECK(text_of(a) == before);
  fs::rename(a, scratch / "a.off");
  CHECK(morph(scratch / "a.off", "2").exit_code == 0);
  CHECK(morph(scratch / "a.off", "2").exit_code == 0); // the same names again
  const Process_result run = morph(scratch / "a.off", "1");
  CHECK(run.exit_code == 2);
  CHECK(run.err.find("step_2.off' belongs to another run") != std::string::npos);
  CHECK(run_tool({"morph", scratch / "a.off", b, "-o", scratch / "new", "--max-time", "1e-9"}).exit_code == 1);
  CHECK_FALSE(fs::exists(scratch / "new")); // nothing got into it
}

TEST_CASE("segment: one label per face, and colours for them", "[tool]")
{
  Scratch scratch;
  const Soup soup = dumbbell(4);
  const std::string input = write_off(scratch / "in.off", soup);
  const Process_result run =
    run_tool(with(command_line("segment", input, scratch), {"--labels", scratch / "labels.txt"}));
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  std::istringstream in(text_of(scratch / "labels.txt"));
  const std::vector<int> labels((std::istream_iterator<int>(in)), std::istream_iterator<int>());
  CHECK(labels.size() == soup.faces.size());
  const std::set<int> different(labels.begin(), labels.end());
  CHECK(different.size() >= 2);
  CHECK(*different.begin() == 0);
  CHECK(*different.rbegin() == int(different.size()) - 1);

  std::vector<CGAL::IO::Color> face_colours, vertex_colours;
  Soup coloured;
  std::ifstream ply(scratch / "out.ply", std::ios::binary);
  REQUIRE(CGAL::IO::read_PLY(ply, coloured.points, coloured.faces, face_colours, vertex_colours));
  CHECK(coloured.faces == soup.faces);
  REQUIRE(face_colours.size() == labels.size());
  std::map<int, std::set<std::array<int, 3>>> colours;
  std::set<std::array<int, 3>> all;
  for(std::size_t f = 0; f < labels.size(); ++f) {
    const auto& c = face_colours[f];
    colours[labels[f]].insert({c.red(), c.green(), c.blue()});
    all.insert({c.red(), c.green(), c.blue()});
  }
  for(const auto& of_label : colours)
    CHECK(of_label.second.size() == 1);
  CHECK(all.size() == different.size());

  REQUIRE(run_tool(with(command_line("segment", input, scratch), {"--labels", scratch / "two.txt", "--segments", "1"}))
            .exit_code == 0);
  CHECK(text_of(scratch / "two.txt").find('1') == std::string::npos);
}

TEST_CASE("segment: where it takes another method, the settings in the report are of that one", "[tool]")
{
  Scratch scratch;
  REQUIRE(run_tool({"segment", write_off(scratch / "in.off", cube()), "-o", scratch / "out.ply", "--iterations", "3",
                    "--report", scratch / "report.json"})
            .exit_code == 0);
  const nlohmann::json report = nlohmann::json::parse(text_of(scratch / "report.json"));
  CHECK(report["method_used"] == "isometric");
  CHECK(report["settings"]["accuracy"] == SP::Isometric::default_accuracy);
  CHECK(report["settings"]["iterations"] == SP::Isometric::default_number_of_iterations);
}

TEST_CASE("segment --like: segments get the labels of the corresponding ones of another mesh", "[tool]")
{
  Scratch scratch;
  const auto& directions = six_directions();
  const std::vector<Limb> limbs = {{directions[0], 0.5, 1.5}, {directions[1], 0.4, 2.5}, {directions[2], 0.3, 4}};
  std::vector<Limb> others = limbs;
  others[1].length = 2.7;
  const Body_with_limbs a = body_with_limbs(limbs, 4), b = body_with_limbs(others, 4);
  fs::create_directory(scratch / "in");
  const std::string in_a = write_off(scratch / "in/a.off", a.soup);
  write_off(scratch / "in/b.off",
            transformed(b.soup, [](const Point& p) { return Point(p.y() + 5, -p.x(), 2 * p.z() - p.z()); }));
  const int names[] = {7, 3, 40, 5}; // of the parts
  {
    std::ofstream labels(scratch / "labels.txt");
    for(const std::size_t part : a.part)
      labels << names[part] << '\n';
  }
  const auto labels_in = [&](const std::string& file) {
    std::istringstream in(text_of(scratch / file));
    return std::vector<int>((std::istream_iterator<int>(in)), std::istream_iterator<int>());
  };
  Process_result run = run_tool({"segment", scratch / "in", "-o", scratch / "out", "--labels", "labels.txt", "--report",
                                 "report.json", "--like", in_a, "--like-labels", scratch / "labels.txt"});
  CAPTURE(run.out, run.err);
  REQUIRE(run.exit_code == 0);
  for(const auto& [name, body] : {std::pair("a", &a), std::pair("b", &b)}) {
    const std::vector<int> labels = labels_in(std::string("out/") + name + ".labels.txt");
    REQUIRE(labels.size() == body->part.size());
    std::size_t same = 0;
    for(std::size_t f = 0; f < labels.size(); ++f)
      same += labels[f] == names[body->part[f]];
    CHECK(double(same) > 0.9 * double(labels.size()));
    CHECK(std::set<int>(labels.begin(), labels.end()) == std::set<int>{3, 5, 7, 40});
    const nlohmann::json report =
      nlohmann::json::parse(text_of(scratch / (std::string("out/") + name + ".report.json")));
    CHECK(report["segments"] == 4);
    CHECK(report["like"]["mesh"] == in_a);
    CHECK(run.out.find(report["like"]["trust"]) != std::string::npos);
  }

  // without labels of its own the mesh has those of its segments
  REQUIRE(run_tool({"segment", in_a, "-o", scratch / "a.ply", "--labels", scratch / "a.txt"}).exit_code == 0);
  REQUIRE(
    run_tool({"segment", in_a, "-o", scratch / "a.ply", "--labels", scratch / "like.txt", "--like", in_a, "--prepare"})
      .exit_code == 0);
  CHECK(text_of(scratch / "a.txt") == text_of(scratch / "like.txt"));

  std::ofstream(scratch / "labels.txt", std::ios::app) << "1\n";
  run = run_tool({"segment", in_a, "-o", scratch / "b.ply", "--like", in_a, "--like-labels", scratch / "labels.txt"});
  CHECK(run.exit_code == 1);
  CHECK(run.err.find("labels, but the mesh has") != std::string::npos);
  CHECK(!fs::exists(scratch / "b.ply"));
  run = run_tool({"segment", in_a, "-o", scratch / "b.ply", "--like-labels", scratch / "labels.txt"});
  CHECK(run.exit_code == 2);
}

TEST_CASE("view: a page with everything in it", "[tool]")
{
  Scratch scratch;
  const Soup soup = dumbbell(2);
  const std::string input = write_off(scratch / "<in>.off", soup);
  const Process_result run = run_tool(command_line("view", input, scratch));
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  const std::string page = text_of(scratch / "out.html");
  for(const char* elsewhere : {"{HEADER}", "{DATA}", "src=\"", "<link rel=\"stylesheet"})
    CHECK(page.find(elsewhere) == std::string::npos);
  const nlohmann::json header = nlohmann::json::parse(content(page, "header"));
  CHECK(header["report"]["input"] == input);
  CHECK(header["report"]["flipped_faces"] == 0);
  CHECK(header["coordinates"].size() == 6);
  const std::size_t bytes = 12 * soup.points.size() + 15 * soup.faces.size();
  CHECK(content(page, "data").size() == (bytes + 2) / 3 * 4);

  Process_options in_scratch;
  in_scratch.directory = scratch.folder();
  REQUIRE(run_process({TOOL, "view", input}, in_scratch).exit_code == 0);
  CHECK(fs::exists(scratch / "<in>.html"));
}

TEST_CASE("segment: flipped tips are no harm, but a sphere that is mirrored is refused", "[tool]")
{
  Scratch scratch;
  const Soup soup = bumpy_sphere(3);
  const std::string input = write_off(scratch / "in.off", soup);
  Soup sphere = soup;
  sphere.points = solve_or_throw(soup, Settings());
  const auto segment = [&](const Soup& of) {
    return run_tool({"segment", input, "--sphere", write_off(scratch / "sphere.off", of), "-o", scratch / "out.ply"});
  };
  CHECK(segment(sphere).exit_code == 0);
  CHECK(run_tool({"segment", input, "-o", scratch / "out.ply", "-v"}).out.find("tried balanced for") !=
        std::string::npos);
  Soup flipped = sphere;
  std::swap(flipped.points[soup.faces[0][0]], flipped.points[soup.faces[0][1]]);
  CHECK(segment(flipped).exit_code == 0);
  const Process_result mirrored =
    segment(transformed(sphere, [](const Point& p) { return Point(-p.x(), p.y(), p.z()); }));
  CHECK(mirrored.exit_code == 1);
  CHECK(mirrored.err.find("the degree is -1; it is a mirror image: negate one coordinate") != std::string::npos);
}

TEST_CASE("option --sphere: the map of 'map' gives the same as mapping again", "[tool]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", bumpy_sphere(3));
  const std::string format = GENERATE("off", "obj", "ply");
  const std::string sphere = scratch / ("sphere." + format);
  const std::vector<std::string> how = {"--method", "balanced", "--weights", "clamped"};
  REQUIRE(run_tool(with({"map", input, "-o", sphere}, how)).exit_code == 0);
  for(const std::string command : {"texture", "resample", "segment"}) {
    const std::vector<std::string> arguments = command_line(command, input, scratch);
    REQUIRE(run_tool(with(arguments, how)).exit_code == 0);
    const std::string mapped = text_of(arguments.back());
    const Process_result run = run_tool(with(arguments, {"--sphere", sphere}));
    CAPTURE(run.err);
    REQUIRE(run.exit_code == 0);
    CHECK(text_of(arguments.back()) == mapped);
  }
}

TEST_CASE("option --sphere: what is no map of the mesh is refused", "[tool]")
{
  Scratch scratch;
  const Soup soup = bumpy_sphere(2);
  const std::string input = write_off(scratch / "in.off", soup);
  const Soup good = icosphere(2);
  Soup bad = good;
  std::string word;
  SECTION("other numbers of vertices")
  {
    bad = icosphere(1);
    word = "42";
  }
  SECTION("faces in another order")
  {
    std::swap(bad.faces[7], bad.faces[9]);
    word = "face 7";
  }
  SECTION("a flipped face")
  {
    bad.points[5] = CGAL::ORIGIN - (bad.points[5] - CGAL::ORIGIN);
    word = "flipped";
  }
  SECTION("inside out")
  {
    for(Point& p : bad.points)
      p = CGAL::ORIGIN - (p - CGAL::ORIGIN);
    word = "flipped";
  }
  SECTION("not on the sphere")
  {
    bad.points[5] = Point(3, 2, 1);
    word = "at distances from 1 to 3.74";
  }
  SECTION("the mesh itself")
  {
    bad = soup;
    word = "no sphere round the origin";
  }
  const std::string sphere = write_off(scratch / "sphere.off", bad);
  check_exit(run_tool(with(command_line("texture", input, scratch), {"--sphere", sphere})), word);
  check_exit(run_tool(with(command_line("resample", input, scratch), {"--sphere", sphere})), "sphere.off");
  check_exit(run_tool(with(command_line("texture", input, scratch), {"--sphere", scratch / "none.off"})), "none.off");
  CHECK(scratch.number_of_files() == 2);
  for(const double radius : {1., 50.}) {
    const std::string good_sphere = write_off(scratch / "sphere.off", transformed(good, [radius](const Point& p) {
                                                return Point(radius * p.x(), radius * p.y(), radius * p.z());
                                              }));
    CHECK(run_tool(with(command_line("texture", input, scratch), {"--sphere", good_sphere})).exit_code == 0);
  }
}

TEST_CASE("option --sphere: few digits and corners in another order will do", "[tool]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", bumpy_sphere(2));
  Soup soup = icosphere(2);
  for(Point& p : soup.points)
    p = Point(double(float(p.x())), double(float(p.y())), double(float(p.z())));
  for(auto& f : soup.faces)
    std::rotate(f.begin(), f.begin() + 1, f.end());
  const std::string sphere = write_off(scratch / "sphere.off", soup);
  const Process_result run = run_tool(with(command_line("texture", input, scratch), {"--sphere", sphere}));
  CAPTURE(run.err);
  CHECK(run.exit_code == 0);
}

TEST_CASE("commands that use a map refuse what 'map' refuses, and write nothing", "[tool]")
{
  Scratch scratch;
  const std::string torus_file = write_off(scratch / "torus.off", torus(12, 8));
  const std::string tube = write_off(scratch / "tube.off", capsule(20, 12));
  for(const std::string command : {"texture", "resample", "segment", "view"}) {
    check_exit(run_tool(command_line(command, torus_file, scratch)), "genus");
    check_exit(run_tool(with(command_line(command, tube, scratch), {"--max-time", "1e-9"})), "time");
    if(command != "segment") // which needs no certified map
      check_exit(run_tool(with(command_line(command, tube, scratch), {"--method", "balanced"})), "flipped");
  }
  CHECK(scratch.number_of_files() == 2);
}

TEST_CASE("commands that use a map: wrong usage", "[tool]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", icosphere(1));
  const std::string mesh = write_off(scratch / "mesh.mtl", icosphere(1));
  for(const std::vector<std::string>& arguments :
      {std::vector<std::string>{"texture", input},
       {"texture", input, "-o", scratch / "out.ply"},
       {"texture", input, "-o", scratch / "out.obj", "--chart", "mercator"},
       {"texture", input, "-o", scratch / "out.obj", "--north", "0", "0", "0"},
       {"texture", input, "-o", scratch / "out.obj", "--north", "0", "1"},
       {"texture", input, "-o", scratch / "out.obj", "--image", "-"},
       {"resample", input, "-o", scratch / "out.off", "--to-sphere", "-"},
       {"search", "-", "--index", input, "--rerank", "1"},
       {"atlas", input, "-", "-o", scratch / "out"},
       {"texture", input, "-o", scratch / "mesh.obj", "--sphere", mesh}, // the material would overwrite the sphere
       {"resample", input, "-o", scratch / "out.off", "--level", "-1"},
       {"resample", input, "-o", scratch / "out.off", "--level", "13"},
       {"resample", input, "-o", scratch / "out.off", "--level", "3", "--to-sphere", input},
       {"resample", input, "-o", input, "--to-sphere", input},
       {"resample", input, "-o", mesh, "--to-sphere", mesh},
       {"resample", input, "-o", scratch / "out.off", "--output-sphere", scratch / "out.off"},
       {"harmonics", input, "-o", scratch / "out.txt"},
       {"harmonics", input, "-o", scratch / "out.csv", "--degree", "-1"},
       {"harmonics", input, "-o", scratch / "out.csv", "--fit", "lumped"},
       {"harmonics", input, "-o", scratch / "out.csv", "--reconstruct", scratch / "out.csv"},
       {"register", input, input, "-o", scratch / "out.txt"},
       {"register", input, input, "-o", input},
       {"register", input, input, "-o", scratch / "out.off", "--motion", "shear"},
       {"register", input, input, "-o", scratch / "out.off", "--curvature-weight", "-1"},
       {"register", input, input, "-o", scratch / "out.off", "--spheres", input},
       {"register", input, input, "-o", scratch / "out.off", "--spheres", input, input, "--weights", "conformal"},
       {"register", input, input, "-o", scratch / "out.off", "--fixed", input},
       {"register", input, input, "-o", scratch / "out.off", "--density", input},
       {"morph", input, input, "-o", scratch / "way", "--steps", "0"},
       {"morph", input, input, "-o", scratch / "way", "--format", "txt"},
       {"segment", input, "-o", scratch / "out.off"},
       {"segment", input, "-o", scratch / "out.ply", "--segments", "0"},
       {"segment", input, "-o", scratch / "out.ply", "--labels", input},
       {"segment", input, "-o", scratch / "out.ply", "--sphere", input, "--weights", "conformal"},
       {"view", input, "-o", scratch / "out.htm"},
       {"view", input, "-o", input},
       {"resample", input, "-o", scratch / "out.off", "--sphere", input, "--max-time", "3"}}) {
    const Process_result run = run_tool(arguments);
    CAPTURE(arguments, run.out, run.err);
    CHECK(run.exit_code == 2);
    CHECK(scratch.number_of_files() == 2);
  }
}

namespace {

/// Runs `certify`, and reads its report.
struct Certified {
  Process_result run;
  nlohmann::json report;

  Certified(const Scratch& scratch, const Soup& mesh, const Soup& sphere)
  {
    run = run_tool({"certify", write_off(scratch / "mesh.off", mesh), write_off(scratch / "sphere.off", sphere),
                    "--report", scratch / "report.json"});
    report = nlohmann::json::parse(text_of(scratch / "report.json"));
  }
};

} // namespace

TEST_CASE("certify: spheres of any radius, with the line and the keys of map", "[tool]")
{
  Scratch scratch;
  const Soup mesh = bumpy_sphere(3);
  const Process_result mapped =
    run_tool({"map", write_off(scratch / "in.off", mesh), "-o", scratch / "out.off", "--report", scratch / "map.json"});
  REQUIRE(mapped.exit_code == 0);
  const nlohmann::json of_map = nlohmann::json::parse(text_of(scratch / "map.json"));
  const double radius = GENERATE(1., 100., 1e-3);
  const Soup sphere = transformed(read(scratch / "out.off"), [radius](const Point& p) {
    return Point(radius * p.x(), radius * p.y(), radius * p.z());
  });
  const Certified certified(scratch, mesh, sphere);
  CAPTURE(certified.run.err);
  REQUIRE(certified.run.exit_code == 0);
  const std::string line = "valid spherical map: 0 flipped faces, degree 1";
  CHECK(mapped.out.find(line) != std::string::npos);
  CHECK(certified.run.out.find('\n' + line + '\n') != std::string::npos);
  CHECK(certified.run.out.find("sphere.off: radius ") != std::string::npos);
  for(const auto& entry : of_map.items())
    CHECK(certified.report.contains(entry.key()));
  CHECK(certified.report.size() == of_map.size());
  CHECK(certified.report["degree"] == 1);
  CHECK(certified.report["weights"].is_null());
  const auto angle = [](const nlohmann::json& report) {
    return report["distortion"]["angle_distortion"]["mean"].get<double>();
  };
  CHECK(angle(certified.report) == Approx(angle(of_map)).epsilon(1e-9));
}

TEST_CASE("certify: what is no valid map is named", "[tool]")
{
  Scratch scratch;
  const Soup mesh = bumpy_sphere(3);
  Soup sphere = icosphere(3);
  std::string verdict, word;
  std::size_t flipped = 0;
  int degree = 1;
  SECTION("a mirror image")
  {
    for(Point& p : sphere.points)
      p = Point(p.x(), -p.y(), p.z());
    verdict = "mirrored spherical map";
    word = "mirror image, otherwise a valid";
    flipped = mesh.faces.size();
    degree = -1;
  }
  SECTION("a flipped face")
  {
    const auto& face = sphere.faces[17];
    sphere.points[face[0]] =
      CGAL::midpoint(sphere.points[face[1]], sphere.points[face[2]]) +
      0.1 * (CGAL::midpoint(sphere.points[face[1]], sphere.points[face[2]]) - sphere.points[face[0]]);
    verdict = "no valid spherical map";
    word = "flipped";
    flipped = count_flipped_faces(sphere, sphere.points);
    REQUIRE(flipped > 0);
  }
  SECTION("everything on one side")
  {
    for(Point& p : sphere.points)
      p = p + Vector(5, 0, 0);
    verdict = "distances from 4 to 6 of the origin";
    word = "the degree is 0";
    flipped = count_flipped_faces(sphere, sphere.points);
    degree = 0;
  }
  const Certified certified(scratch, mesh, sphere);
  CAPTURE(certified.run.out);
  check_exit(certified.run, word);
  CHECK(certified.run.out.find(verdict) != std::string::npos);
  CHECK(certified.report["flipped_faces"] == flipped);
  CHECK(certified.report["degree"] == degree);
  CHECK(certified.report["error_code"] == (degree == -1 ? "MIRRORED" : "NOT_BIJECTIVE"));
  // areas of flipped faces are negative; the mirror image has none
  CHECK(certified.report["distortion"]["log_area_stretch"]["mean"].is_null() == (degree != -1));
  CHECK(certified.report["distortion"]["angle_distortion"]["mean"].is_number());
}

TEST_CASE("certify: a point without direction is refused", "[tool]")
{
  Scratch scratch;
  Soup sphere = icosphere(1);
  sphere.points[7] = CGAL::ORIGIN;
  const Certified certified(scratch, bumpy_sphere(1), sphere);
  check_exit(certified.run, "vertex 7");
  CHECK(certified.report["degree"].is_null());
}
