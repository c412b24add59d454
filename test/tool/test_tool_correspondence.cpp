// SPDX-License-Identifier: GPL-3.0-or-later
// The command register with --correspondence: the places on B of the vertices of A, by the files.

#include "helpers/meshes.h"
#include "helpers/tool.h"

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace test;
namespace fs = std::filesystem;

namespace {

struct Place {
  int face = -1;
  std::array<double, 3> weights = {0, 0, 0};

  Point on(const Soup& soup) const
  {
    const auto& corners = soup.faces.at(std::size_t(face));
    Vector sum(0, 0, 0);
    for(std::size_t k = 0; k < 3; ++k)
      sum = sum + weights[k] * (soup.points[corners[k]] - CGAL::ORIGIN);
    return CGAL::ORIGIN + sum;
  }
};

/// Reads a correspondence, and checks what holds for every one: a row for every vertex of A, faces of B, and weights.
std::vector<Place> read_places(const std::string& file, const Soup& a, const Soup& b)
{
  const std::vector<std::string> lines = lines_of(text_of(file));
  REQUIRE(lines.size() == a.points.size() + 1);
  CHECK(lines[0] == "vertex,face,w0,w1,w2");
  std::vector<Place> places;
  for(std::size_t v = 0; v < a.points.size(); ++v) {
    CAPTURE(lines[v + 1]);
    std::string line = lines[v + 1];
    CHECK(std::count(line.begin(), line.end(), ',') == 4);
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream words(line);
    std::size_t vertex = 0;
    Place place;
    words >> vertex >> place.face;
    for(double& weight : place.weights) {
      std::string word;
      words >> word;
      weight = std::strtod(word.c_str(), nullptr);
      CHECK((weight >= 0 && weight <= 1));
    }
    CHECK(vertex == v);
    CHECK((place.face >= -1 && place.face < int(b.faces.size())));
    const double sum = place.weights[0] + place.weights[1] + place.weights[2];
    CHECK(std::abs(sum - (place.face < 0 ? 0 : 1)) < 1e-14);
    places.push_back(place);
  }
  return places;
}

double distance(const Point& p, const Point& q) { return std::sqrt((p - q).squared_length()); }

double size_of(const Soup& soup)
{
  double size = 0;
  for(const Point& p : soup.points)
    size = std::max(size, distance(p, CGAL::ORIGIN));
  return size;
}

Point turned(const Point& p) { return Point(p.y(), p.z(), p.x()); }

double distance_to(const Soup& soup, const Point& p)
{
  double least = 1e300;
  for(const auto& face : soup.faces)
    if(const CGAL::Triangle_3<Kernel> t(soup.points[face[0]], soup.points[face[1]], soup.points[face[2]]);
       !t.is_degenerate())
      least = std::min(least, CGAL::to_double(CGAL::squared_distance(p, t)));
  return std::sqrt(least);
}

/// Registers `a` to `b` with --prepare. Returns the places, and the mesh that is written.
struct Prepared_pair {
  Process_result run;
  std::vector<Place> places;
  Soup out;

  Prepared_pair(const Scratch& scratch, const Soup& a, const Soup& b, const std::vector<std::string>& options = {})
  {
    std::vector<std::string> command = {"register",
                                        write_off(scratch / "a.off", a),
                                        write_off(scratch / "b.off", b),
                                        "--prepare",
                                        "-o",
                                        scratch / "out.off",
                                        "--correspondence",
                                        scratch / "places.csv"};
    command.insert(command.end(), options.begin(), options.end());
    run = run_tool(command);
    CAPTURE(run.err);
    REQUIRE(run.exit_code == 0);
    places = read_places(scratch / "places.csv", a, b);
    out = read(scratch / "out.off");
  }
};

Soup with_isolated_vertex(Soup soup)
{
  soup.points.insert(soup.points.begin(), Point(7, 7, 7));
  for(auto& face : soup.faces)
    for(std::size_t& i : face)
      ++i;
  return soup;
}

} // namespace

TEST_CASE("register --output-sphere: A is resampled to the vertices of B", "[tool]")
{
  Scratch scratch;
  const Soup a = bumpy_sphere(4), sphere = icosphere(4);
  std::vector<std::size_t> order;
  const Soup b = renumbered(transformed(a, turned), 3, order),
             sphere_of_b = renumbered(transformed(sphere, turned), 3, order);
  const std::string in_a = write_off(scratch / "a.off", a), to = write_off(scratch / "b_sphere.off", sphere_of_b);
  const std::string registered = scratch / "lh.sphere.reg"; // floats, of radius 100
  Process_result run =
    run_tool({"register", in_a, write_off(scratch / "b.off", b), "--sphere", write_off(scratch / "sphere.off", sphere),
              to, "-o", scratch / "out.off", "--output-sphere", registered});
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  run = run_tool({"resample", in_a, "--sphere", registered, "--to-sphere", to, "-o", scratch / "a_as_b.off"});
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  const Soup out = read(scratch / "a_as_b.off");
  CHECK(out.faces == b.faces);
  for(std::size_t v = 0; v < b.points.size(); ++v)
    CHECK(distance(turned(out.points[v]), b.points[v]) < 0.01);
}

TEST_CASE("register --correspondence: a mesh and itself, turned and renumbered", "[tool]")
{
  Scratch scratch;
  const Soup a = bumpy_sphere(3), sphere = icosphere(3);
  std::vector<std::size_t> order;
  const Soup b = renumbered(transformed(a, turned), 3, order),
             sphere_of_b = renumbered(transformed(sphere, turned), 3, order);
  const Process_result run =
    run_tool({"register", write_off(scratch / "a.off", a), write_off(scratch / "b.off", b), "--spheres",
              write_off(scratch / "sphere_a.off", sphere), write_off(scratch / "sphere_b.off", sphere_of_b), "-o",
              scratch / "out.off", "--correspondence", scratch / "places.csv"});
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  const std::vector<Place> places = read_places(scratch / "places.csv", a, b);
  const Soup out = read(scratch / "out.off");
  for(std::size_t v = 0; v < a.points.size(); ++v) {
    CHECK(distance(places[v].on(b), turned(a.points[v])) < 1e-3);
    CHECK(distance(places[v].on(b), out.points[v]) < 1e-12 * size_of(b));
  }
  // the corner that has the weight is the vertex
  std::vector<std::size_t> number(order.size());
  for(std::size_t i = 0; i < order.size(); ++i)
    number[order[i]] = i;
  for(std::size_t v = 0; v < a.points.size(); ++v) {
    const auto& weights = places[v].weights;
    const auto largest = std::size_t(std::max_element(weights.begin(), weights.end()) - weights.begin());
    CHECK(weights[largest] > 0.99);
    CHECK(b.faces[std::size_t(places[v].face)][largest] == number[v]);
  }
}

TEST_CASE("register --correspondence: two shapes, the same places as those of the output", "[tool]")
{
  Scratch scratch;
  const Soup a = ellipsoid(1, 1.3, 1.7, 3), b = bumpy_sphere(3);
  const std::vector<std::string> command = {"register", write_off(scratch / "a.off", a),
                                            write_off(scratch / "b.off", b), "--correspondence",
                                            scratch / "places.csv"};
  const Process_result alone = run_tool(command); // no --output
  CAPTURE(alone.err);
  REQUIRE(alone.exit_code == 0);
  CHECK(alone.out.find("places.csv: ") != std::string::npos);
  CHECK(scratch.number_of_files() == 3);
  const std::string before = text_of(scratch / "places.csv");
  std::vector<std::string> with_output = command;
  with_output.insert(with_output.end(), {"-o", scratch / "out.off"});
  REQUIRE(run_tool(with_output).exit_code == 0);
  CHECK(text_of(scratch / "places.csv") == before);
  const std::vector<Place> places = read_places(scratch / "places.csv", a, b);
  const Soup out = read(scratch / "out.off");
  for(std::size_t v = 0; v < a.points.size(); ++v)
    CHECK(distance(places[v].on(b), out.points[v]) < 1e-12 * size_of(b));
}

TEST_CASE("register --correspondence: wrong usage", "[tool]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", icosphere(1));
  write_text(scratch / "in.csv", "");
  for(const std::vector<std::string>& options :
      {std::vector<std::string>{"--correspondence", scratch / "places.txt"},
       {"--report", scratch / "report.json"}, // neither places nor --output
       {"--correspondence", scratch / "places.csv", "--report", scratch / "places.csv"},
       {"--correspondence", scratch / "in.csv", "--landmarks", scratch / "in.csv"}}) {
    std::vector<std::string> command = {"register", input, input};
    command.insert(command.end(), options.begin(), options.end());
    const Process_result run = run_tool(command);
    CAPTURE(options, run.err);
    CHECK(run.exit_code == 2);
    CHECK(scratch.number_of_files() == 2);
  }
}

TEST_CASE("register --prepare: an isolated vertex has no place, and the others have theirs", "[tool]")
{
  Scratch scratch;
  const Soup ball = bumpy_sphere(3), a = with_isolated_vertex(ball), b = transformed(a, turned);
  const Prepared_pair pair(scratch, a, b);
  CHECK(pair.run.out.find("a.off: removed 1 isolated vertex (vertex 0)") != std::string::npos);
  CHECK(pair.run.out.find("b.off: removed 1 isolated vertex (vertex 0)") != std::string::npos);
  CHECK(pair.places[0].face == -1);
  CHECK(pair.out.faces == ball.faces);
  for(std::size_t v = 1; v < a.points.size(); ++v) {
    CHECK(distance(pair.places[v].on(b), b.points[v]) < 1e-3);
    CHECK(distance(pair.places[v].on(b), pair.out.points[v - 1]) < 1e-12 * size_of(b));
  }
}

TEST_CASE("register --prepare: of two surfaces with a common vertex the vertices of one have places", "[tool]")
{
  Scratch scratch;
  const Soup a = make_soup(hourglass());
  const Prepared_pair pair(scratch, a, bumpy_sphere(2));
  std::size_t left_out = 0, whole_faces = 0;
  for(const Place& place : pair.places)
    left_out += place.face < 0 ? 1 : 0;
  for(const auto& face : a.faces)
    whole_faces +=
      std::all_of(face.begin(), face.end(), [&](std::size_t v) { return pair.places[v].face >= 0; }) ? 1 : 0;
  CHECK(left_out == a.points.size() - pair.out.points.size());
  CHECK(left_out > 0);
  CHECK(whole_faces == pair.out.faces.size());
}

TEST_CASE("register --prepare: a vertex of two sheets has the place of one, and one that is merged that of the other",
          "[tool]")
{
  Scratch scratch;
  Soup a = make_soup(pinched_sphere());
  a.points.push_back(a.points[a.faces[0][0]]);
  a.faces[0][0] = a.points.size() - 1;
  const Soup before = make_soup(pinched_sphere());
  const Prepared_pair pair(scratch, a, bumpy_sphere(3));
  CHECK(pair.run.out.find("merged 1 vertex") != std::string::npos);
  CHECK(pair.run.out.find("made 1 copy of non-manifold vertices") != std::string::npos);
  for(const Place& place : pair.places)
    CHECK(place.face >= 0);
  const Place &merged = pair.places.back(), &with = pair.places[before.faces[0][0]];
  CHECK(merged.face == with.face);
  CHECK(merged.weights == with.weights);
}

TEST_CASE("register --prepare: places on what was mended are the nearest ones on the file", "[tool]")
{
  Scratch scratch;
  Soup a = bumpy_sphere(3), b = transformed(a, turned);
  bool has_hole = false;
  SECTION("a hole")
  {
    b.faces.resize(b.faces.size() - 40);
    has_hole = true;
  }
  SECTION("inside out") { b = inside_out(b); }
  SECTION("some faces reversed")
  {
    for(std::size_t f = 0; f < b.faces.size(); f += 3)
      std::swap(b.faces[f][1], b.faces[f][2]);
  }
  SECTION("a handle") { a = b = torus(16, 8); }
  SECTION("a handle of few faces") { a = b = torus(3, 3); }
  SECTION("a triangle, of which sides are split")
  {
    b = {{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)}, {{0, 1, 2}}};
  }
  const Prepared_pair pair(scratch, a, b);
  std::size_t on_new_faces = 0;
  for(std::size_t v = 0; v < a.points.size(); ++v) {
    REQUIRE(pair.places[v].face >= 0);
    const double nearest = distance_to(b, pair.out.points[v]);
    CHECK(distance(pair.places[v].on(b), pair.out.points[v]) == Approx(nearest).margin(1e-12 * size_of(b)));
    on_new_faces += nearest > 1e-12 * size_of(b) ? 1 : 0;
  }
  if(has_hole)
    CHECK(on_new_faces > 5);
}

TEST_CASE("register --prepare: landmarks have the numbers of the files", "[tool]")
{
  Scratch scratch;
  const Soup ball = bumpy_sphere(3), a = with_isolated_vertex(ball), b = transformed(ball, turned);
  const std::string landmarks = scratch / "landmarks.txt";
  write_text(landmarks, "1 0\n301 300\n601 600\n");
  const Prepared_pair pair(scratch, a, b, {"--landmarks", landmarks});
  CHECK(pair.run.out.find("start by spectrum") != std::string::npos);
  for(const std::size_t v : {0, 300, 600})
    CHECK(distance(pair.places[v + 1].on(b), b.points[v]) < 1e-3);
  write_text(landmarks, "0 0\n");
  const Process_result run = run_tool({"register", scratch / "a.off", scratch / "b.off", "--prepare", "--landmarks",
                                       landmarks, "--correspondence", scratch / "others.csv"});
  CHECK(run.exit_code == 1);
  CHECK(run.err.find("vertex 0 of A was removed when the mesh was repaired") != std::string::npos);
  CHECK_FALSE(fs::exists(scratch / "others.csv"));
}

TEST_CASE("register: a mesh that is turned inside out is named, and --prepare turns it", "[tool]")
{
  Scratch scratch;
  const Soup soup = bumpy_sphere(2);
  const std::string a = write_off(scratch / "a.off", inside_out(soup)), b = write_off(scratch / "b.off", soup);
  const Process_result run = run_tool({"register", a, b, "-o", scratch / "out.off"});
  CAPTURE(run.out, run.err);
  CHECK(run.exit_code == 0);
  CHECK(run.out.find("a.off: its faces are turned inwards; --prepare turns them\n") != std::string::npos);
  CHECK(run.out.find("b.off: its faces") == std::string::npos);
  const Process_result prepared =
    run_tool({"register", a, b, "-o", scratch / "out.off", "--prepare", "--report", scratch / "report.json"});
  CHECK(prepared.exit_code == 0);
  CHECK(prepared.out.find("inwards") == std::string::npos);
  const auto done = nlohmann::json::parse(text_of(scratch / "report.json"))["preparation"];
  REQUIRE(done.size() == 2);
  CHECK(done[0].size() == 1);
  CHECK(done[1].empty());
}

TEST_CASE("register and morph: what is no sphere is refused, or mended with --prepare", "[tool]")
{
  Scratch scratch;
  const std::string closed = write_off(scratch / "closed.off", icosphere(2)),
                    open = write_off(scratch / "open.off", open_sphere(2));
  for(const auto& [a, b] : {std::pair(open, closed), std::pair(closed, open)})
    for(const std::vector<std::string>& outputs :
        {std::vector<std::string>{"register", "-o", scratch / "out.off", "--correspondence", scratch / "places.csv"},
         {"morph", "-o", scratch / "way", "--steps", "2", "--format", "off"}}) {
      std::vector<std::string> command = outputs;
      command.insert(command.end(), {a, b});
      const Process_result refused = run_tool(command);
      CAPTURE(command, refused.err);
      CHECK(refused.exit_code == 1);
      CHECK(is_one_line(refused.err));
      CHECK(refused.err.find("open.off: has 5 boundary edges") != std::string::npos);
      CHECK(refused.err.find("; --prepare does it\n") != std::string::npos);
      CHECK(scratch.number_of_files() == 2);
      command.emplace_back("--prepare");
      const Process_result run = run_tool(command);
      CAPTURE(run.err);
      CHECK(run.exit_code == 0);
      CHECK(run.out.find("open.off: filled 1 hole (5 edges") != std::string::npos);
      if(outputs[0] == "morph") { // the first step is the mended mesh
        REQUIRE(run_tool({"prepare", a, "-o", scratch / "mended.off"}).exit_code == 0);
        CHECK(text_of(scratch / "way/step_0.off") == text_of(scratch / "mended.off"));
      }
      for(const char* output : {"out.off", "places.csv", "way", "mended.off"})
        fs::remove_all(scratch / output);
    }
}
