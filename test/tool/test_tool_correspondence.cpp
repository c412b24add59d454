// SPDX-License-Identifier: GPL-3.0-or-later
// The command register with --correspondence: the places on B of the vertices of A, by the files.

#include "helpers/meshes.h"
#include "helpers/tool.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
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

} // namespace

TEST_CASE("register --correspondence: a mesh and itself, turned and renumbered", "[tool]")
{
  Scratch scratch;
  const Soup a = bumpy_sphere(3), sphere = icosphere(3);
  std::vector<std::size_t> order;
  const Soup b = renumbered(transformed(a, turned), 3, order),
             sphere_of_b = renumbered(transformed(sphere, turned), 3, order);
  const Process_result run = run_tool(
    {"register", write_off(scratch / "a.off", a), write_off(scratch / "b.off", b), "--spheres",
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
