// SPDX-License-Identifier: GPL-3.0-or-later
// The command prepare, and the option --prepare: every defect by itself, generated, is found, mended and mapped.

#include "helpers/certificate.h"
#include "helpers/meshes.h"
#include "helpers/tool.h"

#include <CGAL/Spherical_parameterization/preparation/prepare.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <sstream>

using namespace test;
namespace fs = std::filesystem;

namespace {

typedef std::vector<int> Numbers;

Numbers numbers_in(const std::string& file)
{
  std::istringstream in(text_of(file));
  return Numbers((std::istream_iterator<int>(in)), std::istream_iterator<int>());
}

std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more)
{
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// Runs `prepare` with all that it writes.
struct Prepared {
  Process_result run;
  Soup out;
  Numbers vertex_map, face_map;
  nlohmann::json report;

  Prepared(const Scratch& scratch, const Soup& in, const std::vector<std::string>& options = {})
  {
    run = run_tool(
      with({"prepare", write_off(scratch / "in.off", in), "-o", scratch / "out.off", "--vertex-map",
            scratch / "vertices.txt", "--face-map", scratch / "faces.txt", "--report", scratch / "report.json"},
           options));
    CAPTURE(run.err);
    REQUIRE(run.exit_code == 0);
    out = read(scratch / "out.off");
    vertex_map = numbers_in(scratch / "vertices.txt");
    face_map = numbers_in(scratch / "faces.txt");
    report = nlohmann::json::parse(text_of(scratch / "report.json"));
    CHECK(report["error_code"] == "OK");
  }

  double distance() const
  {
    return std::max(report["distance_from_output_to_input"][1].get<double>(),
                    report["distance_from_input_to_output"][1].get<double>());
  }
};

std::set<Point> corners(const Soup& soup, std::size_t face)
{
  std::set<Point> result;
  for(const std::size_t v : soup.faces[face])
    result.insert(soup.points[v]);
  return result;
}

/// Old vertices and faces are where the maps say, and in their order.
void check_maps(const Soup& in, const Prepared& prepared)
{
  REQUIRE(prepared.vertex_map.size() == prepared.out.points.size());
  REQUIRE(prepared.face_map.size() == prepared.out.faces.size());
  for(std::size_t v = 0; v < prepared.vertex_map.size(); ++v)
    if(prepared.vertex_map[v] >= 0)
      CHECK(prepared.out.points[v] == in.points.at(std::size_t(prepared.vertex_map[v])));
  const bool has_triangles =
    std::all_of(in.faces.begin(), in.faces.end(), [](const auto& face) { return face.size() == 3; });
  if(!has_triangles || prepared.report["preparation"]["split_edges"] != 0)
    return;
  for(std::size_t f = 0; f < prepared.face_map.size(); ++f)
    if(prepared.face_map[f] >= 0)
      CHECK(corners(prepared.out, f) == corners(in, std::size_t(prepared.face_map[f])));
}

void check_mapped(const Scratch& scratch)
{
  const Process_result run =
    run_tool({"map", scratch / "out.off", "-o", scratch / "sphere.off", "--method", "automatic"});
  CAPTURE(run.err);
  CHECK(run.exit_code == 0);
}

/// Every face with vertices of its own.
Soup exploded(const Soup& soup)
{
  Soup result;
  for(const auto& face : soup.faces) {
    result.faces.emplace_back();
    for(const std::size_t i : face) {
      result.faces.back().push_back(result.points.size());
      result.points.push_back(soup.points[i]);
    }
  }
  return result;
}

/// The boundary of unit cubes, whose vertices are shared by place.
Soup voxels(const std::set<std::array<int, 3>>& cells)
{
  Soup soup;
  std::map<std::array<int, 3>, std::size_t> number;
  const auto vertex = [&](const std::array<int, 3>& c) {
    const auto [entry, is_new] = number.emplace(c, soup.points.size());
    if(is_new)
      soup.points.emplace_back(c[0], c[1], c[2]);
    return entry->second;
  };
  for(const auto& cell : cells)
    for(std::size_t k = 0; k < 3; ++k)
      for(const int step : {-1, 1}) {
        std::array<int, 3> neighbour = cell, a = cell;
        neighbour[k] += step;
        if(cells.count(neighbour) > 0)
          continue;
        a[k] += step > 0 ? 1 : 0;
        std::array<int, 3> b = a, c = a, d = a;
        for(auto* const corner : {&b, &c})
          ++(*corner)[(k + 1) % 3];
        for(auto* const corner : {&c, &d})
          ++(*corner)[(k + 2) % 3];
        if(step < 0)
          std::swap(b, d);
        soup.faces.push_back({vertex(a), vertex(b), vertex(c)});
        soup.faces.push_back({vertex(a), vertex(c), vertex(d)});
      }
  return soup;
}

/// Vertices at the same place become one.
Soup welded(const Soup& soup)
{
  Soup result;
  std::map<Point, std::size_t> number;
  for(const auto& face : soup.faces) {
    result.faces.emplace_back();
    for(const std::size_t i : face) {
      const auto [place, is_new] = number.emplace(soup.points[i], number.size());
      if(is_new)
        result.points.push_back(soup.points[i]);
      result.faces.back().push_back(place->second);
    }
  }
  return result;
}

/// Two cubes of which an edge is the same.
Soup cubes_at_an_edge()
{
  double low = 0, high = 0;
  for(const Point& p : cube().points) {
    low = std::min(low, p.x());
    high = std::max(high, p.x());
  }
  return welded(joined(cube(), cube(), Vector(high - low, high - low, 0)));
}

/// A strip of `n` quadrangles, turned over once.
Soup moebius(int n)
{
  Soup soup;
  const double pi = std::acos(-1.);
  for(int i = 0; i < n; ++i)
    for(int side : {-1, 1}) {
      const double u = 2 * pi * i / n, r = 3 + side * std::cos(u / 2);
      soup.points.emplace_back(r * std::cos(u), r * std::sin(u), side * std::sin(u / 2));
    }
  for(std::size_t i = 0; i < std::size_t(n); ++i) {
    const bool is_last = i + 1 == std::size_t(n);
    const std::size_t a = 2 * i, b = 2 * i + 1, c = is_last ? 0 : 2 * i + 3, d = is_last ? 1 : 2 * i + 2;
    soup.faces.insert(soup.faces.end(), {{a, b, c}, {a, c, d}});
  }
  return soup;
}

/// The faces of one half have others on the sides of which they have vertices.
Soup refined_by_halves(const Soup& soup, std::size_t pieces)
{
  Soup result = soup;
  result.faces.clear();
  for(const auto& face : soup.faces) {
    if(soup.points[face[0]].x() > 0) {
      result.faces.push_back(face);
      continue;
    }
    const std::size_t first = result.points.size();
    for(std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = face[k], b = face[(k + 1) % 3];
      result.points.push_back(soup.points[a]);
      for(std::size_t i = 1; i < pieces; ++i) { // counted from the same end on both sides
        const double share = double(a < b ? i : pieces - i) / double(pieces);
        result.points.push_back(soup.points[std::min(a, b)] +
                                share * (soup.points[std::max(a, b)] - soup.points[std::min(a, b)]));
      }
    }
    result.points.push_back(CGAL::centroid(soup.points[face[0]], soup.points[face[1]], soup.points[face[2]]));
    for(std::size_t i = 0; i < 3 * pieces; ++i)
      result.faces.push_back({first + i, first + (i + 1) % (3 * pieces), result.points.size() - 1});
  }
  return result;
}

struct Broken {
  std::string name;
  Soup soup;
  std::string sentence; ///< what `prepare` has to say of it
  bool keeps_shape;     ///< nothing is cut, filled or left out
};

std::vector<Broken> broken_meshes()
{
  std::vector<Broken> all;
  const Soup ball = bumpy_sphere(2);
  const auto add = [&all](const std::string& name, const Soup& soup, const std::string& sentence, bool keeps_shape) {
    all.push_back({name, soup, sentence, keeps_shape});
  };
  Soup soup = ball;
  soup.points.insert(soup.points.begin(), Point(7, 7, 7));
  for(auto& face : soup.faces)
    for(std::size_t& i : face)
      ++i;
  add("isolated vertex", soup, "removed 1 isolated vertex (vertex 0)", true);
  soup = ball;
  soup.faces.push_back(soup.faces[5]);
  soup.faces.push_back({soup.faces[9][1], soup.faces[9][0], soup.faces[9][2]});
  add("repeated faces", soup, "removed 2 repeated faces (first: face 320)", true);
  soup = ball;
  soup.faces.insert(soup.faces.begin(), {3, 8, 3});
  add("repeated corner", soup, "removed 1 face with two corners at one vertex (face 0)", true);
  soup.points.push_back(Point(7, 7, 7));
  soup.faces[0][1] = ball.points.size();
  add("vertex of a face that is removed", soup, "removed 1 isolated vertex (vertex 162)", true);
  soup = ball;
  for(std::size_t f = 0; f < soup.faces.size(); f += 3)
    std::swap(soup.faces[f][0], soup.faces[f][1]);
  add("reversed faces", soup, "reversed 107 faces that did not agree", true);
  add("inside out", inside_out(ball), "turned all faces to the outside", true);
  add("vertices of every face by themselves", exploded(ball), "merged 798 vertices at boundaries", true);
  add("two balls that share a vertex", make_soup(hourglass()), "kept the largest of 2 components", false);
  add("a vertex glued to another", make_soup(pinched_sphere()), "made 1 copy of non-manifold vertices", true);
  add("two cubes at an edge", cubes_at_an_edge(), "glued the faces in pairs at 1 non-manifold edge", false);
  add("sides with vertices of others", refined_by_halves(ball, 2), " slits along sides on which other faces", true);
  add("sides with many vertices of others", refined_by_halves(ball, 5), " slits along sides on which other faces",
      true);
  add("hole", open_sphere(2), "filled 1 hole (", false);
  soup = ball;
  soup.faces.erase(soup.faces.begin() + 100, soup.faces.begin() + 103);
  soup.faces.erase(soup.faces.begin());
  add("holes", soup, "filled ", false);
  add("one triangle", {{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)}, {{0, 1, 2}}}, "filled 1 hole (3 edges", false);
  add("two components", two_spheres(), "kept the largest of 2 components", false);
  add("handle", torus(16, 8), "cut 1 handle along shortest loops (8 edges, length 6.12", false);
  add("two handles", double_torus(), "cut 2 handles along shortest loops (first: ", false);
  add("quadrangles", quad_cube(), "triangulated 6 polygons", true);
  add("one side only", moebius(20), "cut a surface that has one side only, at ", false);
  soup = cubes_at_an_edge();
  soup = welded(
    joined(joined(exploded(torus(9, 6)), exploded(open_sphere(1)), Vector(9, 0, 0)), exploded(soup), Vector(0, 9, 0)));
  std::swap(soup.faces[3][0], soup.faces[3][1]);
  soup.points.emplace_back(0, 0, 0);
  add("much at once", soup, "cut 1 handle", false);
  return all;
}

} // namespace

TEST_CASE("prepare: a mesh without defects is not changed", "[tool]")
{
  Scratch scratch;
  std::vector<std::size_t> order;
  const Soup soup = renumbered(bumpy_sphere(2), 1, order);
  const Prepared prepared(scratch, soup);
  CHECK(prepared.run.out.find("nothing to repair") != std::string::npos);
  CHECK(prepared.out.points == soup.points);
  CHECK(prepared.out.faces == soup.faces);
  CHECK(prepared.distance() == 0);
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    CHECK(prepared.vertex_map[v] == int(v));
}

TEST_CASE("prepare: every defect is named and mended, and what comes out is mapped", "[tool]")
{
  for(const Broken& broken : broken_meshes())
    DYNAMIC_SECTION(broken.name)
    {
      Scratch scratch;
      const Prepared prepared(scratch, broken.soup);
      CAPTURE(prepared.run.out);
      CHECK(prepared.run.out.find(broken.sentence) != std::string::npos);
      CHECK(prepared.run.out.find("a closed surface of genus 0") != std::string::npos);
      check_maps(broken.soup, prepared);
      check_mapped(scratch);
      const bool is_at_0 = prepared.distance() <= 2e-4 * prepared.report["diagonal"].get<double>();
      CHECK((is_at_0 || !broken.keeps_shape));

      // and again there is nothing to do
      const Process_result again = run_tool({"prepare", scratch / "out.off"});
      CHECK(again.exit_code == 0);
      CHECK(again.out.find("nothing to repair") != std::string::npos);
    }
}

TEST_CASE("prepare --steps merge,orient and map --prepare change no shape", "[tool]")
{
  for(const Broken& broken : broken_meshes())
    DYNAMIC_SECTION(broken.name)
    {
      Scratch scratch;
      const Prepared prepared(scratch, broken.soup, {"--steps", "merge,orient"});
      CHECK(prepared.distance() <= 2e-4 * prepared.report["diagonal"].get<double>());
      const std::string in = scratch / "in.off";
      const Process_result mapped = run_tool({"map", in, "-o", scratch / "sphere.off", "--prepare"});
      CAPTURE(mapped.out, mapped.err);
      CHECK(mapped.exit_code == (broken.keeps_shape ? 0 : 1));
      if(broken.keeps_shape) {
        CHECK((mapped.out.find("prepare --steps merge,orient") != std::string::npos || broken.name == "quadrangles"));
        const Soup sphere = read(scratch / "sphere.off");
        CHECK(sphere.faces == prepared.out.faces);
        CHECK(count_flipped_faces(sphere, sphere.points) == 0);
        CHECK(run_tool({"certify", scratch / "out.off", scratch / "sphere.off"}).exit_code == 0);
      } else {
        CHECK(is_one_line(mapped.err));
        CHECK(mapped.err.find("; the command 'prepare' repairs that, too\n") != std::string::npos);
      }
    }
}

TEST_CASE("prepare: a shortest loop of every handle", "[tool]")
{
  Scratch scratch;
  const double pi = std::acos(-1.);
  const Prepared prepared(scratch, torus(24, 6));
  const auto& loops = prepared.report["preparation"]["handle_loops"];
  REQUIRE(loops.size() == 1);
  CHECK(loops[0]["length"].get<double>() == Approx(12 * std::sin(pi / 6)));
  CHECK(loops[0]["edges"] == 6);

  const Prepared two(scratch, joined(double_torus(), double_torus(), Vector(0, 0, 0)));
  CHECK(two.report["preparation"]["components"][0]["handles"] == 2);
}

TEST_CASE("prepare: of many handles each loop is the shortest that the cuts have left", "[tool]")
{
  Scratch scratch;
  // square rings in a row, thin ones and thick ones, with a bar from each to the next: round a ring of thickness t
  // the shortest way is 4 t
  const std::vector<int> thickness = {2, 1, 3, 1};
  std::set<std::array<int, 3>> cells;
  int begin = 0;
  for(const int t : thickness) {
    const int size = 5 * t;
    for(int x = 0; x < size; ++x)
      for(int y = 0; y < size; ++y)
        for(int z = 0; z < t; ++z)
          if(std::min({x, y, size - 1 - x, size - 1 - y}) < t)
            cells.insert({begin + x, y, z});
    cells.insert({begin + size, 0, 0});
    begin += size + 1;
  }
  const Prepared prepared(scratch, voxels(cells));
  std::vector<double> lengths;
  for(const auto& loop : prepared.report["preparation"]["handle_loops"])
    lengths.push_back(loop["length"]);
  CHECK(lengths == std::vector<double>{4, 4, 8, 12});
  CHECK(prepared.run.out.find("a closed surface of genus 0") != std::string::npos);
  check_maps(voxels(cells), prepared);
  check_mapped(scratch);
}

TEST_CASE("prepare: distances where long faces run across each other", "[tool]")
{
  Scratch scratch;
  Soup soup = bumpy_sphere(3);
  for(std::size_t v = 0; v < soup.points.size(); v += 9) // many long faces
    soup.points[v] = soup.points[(v * 7 + 100) % soup.points.size()];
  soup.faces.pop_back();
  const Prepared prepared(scratch, soup);
  CHECK_FALSE(prepared.report["preparation"]["holes"].empty());
  const auto &low = prepared.report["distance_from_output_to_input"][0],
             &high = prepared.report["distance_from_output_to_input"][1];
  const double diagonal = prepared.report["diagonal"];
  CHECK(low.get<double>() <= high.get<double>());
  CHECK(high.get<double>() <= low.get<double>() + std::max(1e-4 * diagonal, 0.05 * low.get<double>()) * (1 + 1e-9));
  // the faces of the filling, sampled, against all faces of IN, one by one
  double sampled = 0;
  for(std::size_t f = 0; f < prepared.out.faces.size(); ++f) {
    if(prepared.face_map[f] >= 0)
      continue;
    const auto corner = [&](int k) { return prepared.out.points[prepared.out.faces[f][std::size_t(k)]]; };
    const int n = 12;
    for(int i = 0; i <= n; ++i)
      for(int j = 0; i + j <= n; ++j) {
        const Point p =
          corner(0) + (corner(1) - corner(0)) * (double(i) / n) + (corner(2) - corner(0)) * (double(j) / n);
        double nearest = 1e300;
        for(const auto& face : soup.faces) {
          const CGAL::Triangle_3<Kernel> t(soup.points[face[0]], soup.points[face[1]], soup.points[face[2]]);
          if(!t.is_degenerate())
            nearest = std::min(nearest, std::sqrt(CGAL::squared_distance(p, t)));
        }
        sampled = std::max(sampled, nearest);
      }
  }
  CHECK(sampled <= high.get<double>() + 1e-9);
  CHECK(sampled >= 0.8 * low.get<double>());
}

TEST_CASE("prepare: thousands of faces that lie across each other, or begin at the same vertex", "[tool]")
{
  Scratch scratch;
  Soup soup;
  const int n = 50'000;
  SECTION("a double cone with a hole")
  {
    const double pi = std::acos(-1.);
    soup.points = {Point(0, 0, 1), Point(0, 0, -1)};
    for(int i = 0; i < n; ++i)
      soup.points.emplace_back(std::cos(2 * pi * i / n), std::sin(2 * pi * i / n), 0);
    for(std::size_t i = 0; i < std::size_t(n); ++i)
      for(const std::size_t apex : {std::size_t(0), std::size_t(1)}) {
        const std::size_t a = 2 + i, b = 2 + (i + 1) % std::size_t(n);
        soup.faces.push_back({apex, apex == 0 ? a : b, apex == 0 ? b : a});
      }
    soup.faces.pop_back();
    CHECK(Prepared(scratch, soup).distance() < 3e-4);
  }
  SECTION("slivers along a line")
  {
    const std::size_t m = 5000;
    for(std::size_t i = 0; i < m; ++i)
      soup.points.emplace_back(double(i), 0, 0);
    soup.points.emplace_back(0, 1, 0);
    soup.points.emplace_back(0, -1, 0);
    for(std::size_t i = 0; i + 1 < m; ++i) {
      soup.faces.push_back({i, i + 1, m});
      soup.faces.push_back({0, i + 1, m + 1});
    }
    CHECK(Prepared(scratch, soup).distance() < 0.5);
  }
  SECTION("faces without area")
  {
    for(int i = 0; i < 30; ++i)
      soup.points.emplace_back(double(i), 0, 0);
    for(std::size_t i = 0; i < 30; ++i) // between three vertices each, far from each other on the line
      soup.faces.push_back({i, (7 * i + 11) % 30, (13 * i + 5) % 30});
    const Prepared prepared(scratch, soup);
    double end = 0;
    for(const Point& p : prepared.out.points)
      end = std::max(end, CGAL::to_double(p.x()));
    CHECK(prepared.distance() >= 29 - end);
  }
}

TEST_CASE("prepare: options restrict what is done", "[tool]")
{
  Scratch scratch;
  SECTION("holes")
  {
    const Soup soup = open_sphere(2);
    const Prepared prepared(scratch, soup, {"--steps", "merge,orient,largest,handles"});
    CHECK(prepared.out.faces == soup.faces);
    CHECK(prepared.run.out.find("has 1 hole (") != std::string::npos);
    const auto& holes = prepared.report["preparation"]["holes"];
    REQUIRE(holes.size() == 1);
    CHECK(holes[0]["edges"] == 5);
  }
  SECTION("handles")
  {
    const Soup soup = torus(9, 6);
    const Prepared prepared(scratch, soup, {"--steps", "merge,orient,largest,holes"});
    CHECK(prepared.out.faces == soup.faces);
    CHECK(prepared.run.out.find("has 1 handle") != std::string::npos);
  }
  SECTION("components in one file")
  {
    const Prepared prepared(scratch, two_spheres(), {"--steps", "merge,orient,holes,handles"});
    CHECK(prepared.out.faces.size() == two_spheres().faces.size());
    check_maps(two_spheres(), prepared);
    CHECK(prepared.distance() == 0);
  }
  SECTION("components in a file each")
  {
    const Process_result run = run_tool(
      {"prepare", write_off(scratch / "in.off", two_spheres()), "-o", scratch / "out.ply", "--steps", "merge,split"});
    REQUIRE(run.exit_code == 0);
    CHECK(read(scratch / "out_1.ply").faces.size() == icosphere(2).faces.size());
    CHECK(read(scratch / "out_2.ply").faces.size() == icosphere(1).faces.size());
    CHECK(scratch.number_of_files() == 3);
  }
  SECTION("vertices that are nearly at the same place")
  {
    Soup soup = exploded(icosphere(2));
    for(std::size_t i = 0; i < soup.points.size(); ++i)
      soup.points[i] = soup.points[i] + 1e-6 * Vector(double(i % 3), double(i % 5), double(i % 7));
    const Prepared prepared(scratch, soup, {"--merge-distance", "1e-4"});
    CHECK(prepared.out.points.size() == icosphere(2).points.size());
    CHECK(prepared.run.out.find(" with others up to 0.0001 apart") != std::string::npos);
    check_mapped(scratch);
    CHECK(prepared.distance() < 1e-3);
  }
  SECTION("a hole is no slit, however far from the origin")
  {
    Soup soup = transformed(flat_octahedron(0), [](const Point& p) {
      return Point(500000 + p.x() / 2, 4500000 + p.y() / 2, 100 + p.z() / 2);
    });
    soup.faces.pop_back();
    const Prepared prepared(scratch, soup, {"--steps", "merge,orient"});
    CHECK(prepared.out.faces.size() == 7);
    CHECK(prepared.run.out.find("1 hole") != std::string::npos);
  }
  SECTION("vertices at the same place")
  {
    const Soup soup = exploded(icosphere(1));
    const Prepared prepared(scratch, soup, {"--steps", "orient"});
    CHECK(prepared.out.points == soup.points);
    CHECK(prepared.out.faces == soup.faces);
    CHECK(prepared.run.out.find("has 80 components") != std::string::npos);
  }
  SECTION("faces without area")
  {
    const Soup whole = bumpy_sphere(2);
    Soup soup = whole;
    const auto a = soup.faces[7];
    const auto add_corner = [&](std::size_t f, const Point& p) { // the face becomes three
      const auto face = soup.faces[f];
      soup.points.push_back(p);
      const std::size_t n = soup.points.size() - 1;
      soup.faces[f] = {face[0], face[1], n};
      soup.faces.push_back({face[1], face[2], n});
      soup.faces.push_back({face[2], face[0], n});
    };
    add_corner(7, soup.points[a[0]]);
    add_corner(50, soup.points[soup.faces[50][1]]);
    CHECK(Prepared(scratch, soup).out.faces == soup.faces); // maps do not mind them

    const Prepared prepared(scratch, soup, {"--steps", "degenerate"});
    CHECK(prepared.run.out.find("removed 4 faces without area (first: face 7)") != std::string::npos);
    CHECK(prepared.report["preparation"]["degenerate_faces"]["count"] == 4);
    CHECK(prepared.report["preparation"]["degenerate_faces_removed"] == true);
    CHECK(prepared.out.points.size() == whole.points.size());
    CHECK(prepared.out.faces.size() == whole.faces.size());
    CHECK(prepared.distance() <= 1e-12);
    check_maps(soup, prepared);
    check_mapped(scratch);

    Soup line = whole; // nothing would be left
    for(Point& p : line.points)
      p = Point(p.x(), 0, 0);
    const Prepared of_line(scratch, line, {"--steps", "degenerate"});
    CHECK(of_line.run.out.find("did not remove all of 320 faces without area") != std::string::npos);
    CHECK(of_line.out.faces == line.faces);
  }
  SECTION("a surface around everything")
  {
    const Soup soup = joined(open_sphere(2), torus(9, 6), Vector(0.5, 0, 0));
    const Prepared prepared(scratch, soup, {"--wrap", "--alpha", "1", "--offset", "0.1"});
    CHECK(prepared.run.out.find("wrapped everything, alpha 1, offset 0.1") != std::string::npos);
    check_mapped(scratch);
    CHECK(*std::max_element(prepared.vertex_map.begin(), prepared.vertex_map.end()) == -1);
    CHECK(prepared.report["distance_from_output_to_input"][1].get<double>() > 0.05);
  }
  SECTION("nothing written without an output")
  {
    const Process_result run = run_tool({"prepare", write_off(scratch / "in.off", torus(9, 6))});
    CHECK(run.exit_code == 0);
    CHECK(run.out.find("cut 1 handle") != std::string::npos);
    CHECK(scratch.number_of_files() == 1);
  }
}

TEST_CASE("prepare --steps split: no other file has to go for a part", "[tool]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "scan_1.off", two_spheres()), before = text_of(input);
  const auto split = [&](const std::string& in, const std::string& out, const std::vector<std::string>& more = {}) {
    std::vector<std::string> command = {"prepare", in, "-o", scratch / out, "--steps", "merge,split"};
    command.insert(command.end(), more.begin(), more.end());
    return run_tool(command);
  };
  SECTION("IN has the name of a part")
  {
    const Process_result run = split(input, "scan.off");
    CHECK(run.exit_code == 2);
    CHECK(run.err.find("scan_1.off' exists") != std::string::npos);
  }
  SECTION("another file has")
  {
    write_text(scratch / "out_12.ply", "mine"); // of a run with more parts, or of the user
    CHECK(split(input, "out.ply").exit_code == 2);
    CHECK(text_of(scratch / "out_12.ply") == "mine");
    CHECK(scratch.number_of_files() == 2);
  }
  SECTION("the report would have")
  {
    CHECK(split(input, "out.ply", {"--report", scratch / "out_1.ply"}).exit_code == 2);
    CHECK(scratch.number_of_files() == 1);
  }
  SECTION("the number is before the extensions")
  {
    REQUIRE(split(input, "out.ply.gz").exit_code == 0);
    CHECK(run_tool({"map", scratch / "out_2.ply.gz", "-o", scratch / "sphere.ply"}).exit_code == 0);
    CHECK(fs::exists(scratch / "out_1.ply.gz"));
    REQUIRE(split(input, "lh.white").exit_code == 0); // which is no extension
    CHECK(fs::exists(scratch / "lh.white_2"));
  }
  CHECK(text_of(input) == before);
}

TEST_CASE("prepare: an edge of so many faces that not all are compared is said to be one", "[tool]")
{
  Scratch scratch;
  Soup soup;
  soup.points = {Point(0, 0, 0), Point(0, 0, 1)};
  for(std::size_t i = 0; i < 202; ++i) {
    soup.points.emplace_back(std::cos(0.03 * double(i)), std::sin(0.03 * double(i)), 0.5);
    soup.faces.push_back({0, 1, i + 2});
  }
  const std::string input = write_off(scratch / "in.off", soup);
  CHECK(run_tool({"prepare", input, "--steps", "merge"}).out.find("1 edge of more than 200 faces") < std::string::npos);
  soup.faces.resize(200);
  write_off(input, soup);
  CHECK(run_tool({"prepare", input, "--steps", "merge"}).out.find("of more than 200 faces") == std::string::npos);
}

TEST_CASE("prepare: vertices that are at no place are left out, and the holes closed", "[tool]")
{
  Scratch scratch;
  const Soup ball = bumpy_sphere(2);
  const std::string places[] = {"nan 0 inf", "1 1e999 1"};
  const auto place = [&](std::size_t v) {
    std::ostringstream text;
    text.precision(17);
    if(v == 7 || v == 90)
      text << places[v == 90];
    else
      text << ball.points[v].x() << ' ' << ball.points[v].y() << ' ' << ball.points[v].z();
    return text.str();
  };
  const auto file = [&](const std::string& name, const std::string& header, const char* of_vertex, const char* of_face,
                        std::size_t first) {
    std::string text = header;
    for(std::size_t v = 0; v < ball.points.size(); ++v)
      text += of_vertex + place(v) + '\n';
    for(const auto& f : ball.faces)
      text += of_face + std::to_string(f[0] + first) + ' ' + std::to_string(f[1] + first) + ' ' +
              std::to_string(f[2] + first) + '\n';
    write_text(scratch / name, text);
    return scratch / name;
  };
  const std::string n = std::to_string(ball.points.size()), m = std::to_string(ball.faces.size());
  const std::string files[] = {file("in.off", "OFF\n" + n + ' ' + m + " 0\n", "", "3 ", 0),
                               file("in.obj", "", "v ", "f ", 1),
                               file("in.ply",
                                    "ply\nformat ascii 1.0\nelement vertex " + n +
                                      "\nproperty double x\nproperty double y\nproperty double z\nelement face " + m +
                                      "\nproperty list uchar int vertex_indices\nend_header\n",
                                    "", "3 ", 0)};
  for(const std::string& in : files) {
    CAPTURE(in);
    for(const std::string option : {"--ascii", "--prepare"}) {
      const Process_result refused = run_tool({"map", in, "-o", scratch / "sphere.off", option});
      CHECK(refused.exit_code == 1);
      CHECK(is_one_line(refused.err));
      CHECK(refused.err.find("vertex 7 has the coordinate") != std::string::npos);
    }
    const Process_result run =
      run_tool({"prepare", in, "-o", scratch / "out.off", "--vertex-map", scratch / "vertices.txt"});
    CAPTURE(run.out, run.err);
    REQUIRE(run.exit_code == 0);
    CHECK(run.out.find("removed 2 vertices whose coordinates are not finite, and all faces there (first: vertex 7)") !=
          std::string::npos);
    CHECK(run.out.find("filled 2 holes") != std::string::npos);
    for(const int v : numbers_in(scratch / "vertices.txt"))
      CHECK((v != 7 && v != 90));
    check_mapped(scratch);

    REQUIRE(run_tool({"segment", in, "-o", scratch / "segments.ply", "--labels", scratch / "labels.txt", "--prepare"})
              .exit_code == 0);
    CHECK(numbers_in(scratch / "labels.txt").size() == ball.faces.size());
  }
}

TEST_CASE("prepare: the size of the numbers makes no difference", "[tool]")
{
  Scratch scratch;
  Soup soup = torus(9, 6);
  soup.faces.erase(soup.faces.begin());
  soup = joined(joined(soup, open_sphere(2), Vector(9, 0, 0)), icosphere(1), Vector(0, 9, 0));
  const Prepared as_it_is(scratch, soup);
  for(const int power : {600, 300, -300, -600}) {
    Soup scaled = soup;
    for(Point& p : scaled.points)
      p = Point(std::ldexp(p.x(), power), std::ldexp(p.y(), power), std::ldexp(p.z(), power));
    const Prepared prepared(scratch, scaled);
    CHECK(prepared.out.faces == as_it_is.out.faces);
    CHECK(prepared.vertex_map == as_it_is.vertex_map);
    REQUIRE(prepared.out.points.size() == as_it_is.out.points.size());
    for(std::size_t v = 0; v < prepared.out.points.size(); ++v)
      for(int k = 0; k < 3; ++k)
        CHECK(prepared.out.points[v][k] == std::ldexp(as_it_is.out.points[v][k], power));
    CHECK(prepared.distance() == Approx(std::ldexp(as_it_is.distance(), power)));
    for(const char* loops : {"holes", "handle_loops"}) {
      const auto &before = as_it_is.report["preparation"][loops], &after = prepared.report["preparation"][loops];
      REQUIRE((before.size() == 1 && after.size() == 1));
      CHECK(after[0]["length"].get<double>() == Approx(std::ldexp(before[0]["length"].get<double>(), power)));
    }
  }
}

TEST_CASE("prepare: a vertex of no face has no say, however far away it is", "[tool]")
{
  Scratch scratch;
  const Soup soup = joined(icosphere(0), inside_out(open_sphere(2)), Vector(9, 0, 0));
  const Prepared without(scratch, soup);
  for(const double far : {1e60, 1e120, 1.7e308}) {
    Soup with_it = soup;
    with_it.points.emplace_back(far, far, far);
    const Prepared prepared(scratch, with_it);
    CHECK(prepared.out.points == without.out.points);
    CHECK(prepared.out.faces == without.out.faces);
    CHECK(prepared.distance() == without.distance());
    CHECK(prepared.report["preparation"]["components"] == without.report["preparation"]["components"]);
  }
}

TEST_CASE("prepare: what is kept has the order of the file, in several components, too", "[tool]")
{
  Scratch scratch;
  const Soup soup = joined(icosphere(1), icosphere(2), Vector(9, 0, 0)); // the largest is the second
  for(const char* steps : {"merge,orient", "merge,orient,handles", "merge,orient,holes,handles,degenerate"}) {
    const Prepared prepared(scratch, soup, {"--steps", steps});
    CHECK(prepared.out.points == soup.points);
    CHECK(prepared.out.faces == soup.faces);
  }
  const Soup open = joined(open_sphere(1), open_sphere(2), Vector(9, 0, 0));
  const Prepared prepared(scratch, open, {"--steps", "merge,orient,holes,handles"});
  check_maps(open, prepared);
  CHECK(std::vector(prepared.out.faces.begin(), prepared.out.faces.begin() + int(open.faces.size())) == open.faces);
}

TEST_CASE("prepare: triangles back to back beside other components are no repeated faces", "[tool]")
{
  Scratch scratch;
  Soup soup = icosphere(1);
  soup.faces.push_back({soup.points.size(), soup.points.size() + 1, soup.points.size() + 2});
  for(const Point& p : {Point(9, 0, 0), Point(10, 0, 0), Point(9, 1, 0)})
    soup.points.push_back(p);
  const Prepared prepared(scratch, soup, {"--steps", "merge,orient,holes"});
  const Prepared again(scratch, prepared.out, {"--steps", "merge,orient,holes"});
  CHECK(again.out.faces == prepared.out.faces);
  CHECK(again.report["preparation"]["repeated_faces"]["count"] == 0);
}

TEST_CASE("prepare: faces of a hole's filling that have no area are none of the file", "[tool]")
{
  Scratch scratch;
  Soup soup; // a triangle, of which one side is cut in two
  soup.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}};
  soup.faces = {{0, 1, 3}, {1, 2, 3}};
  const Prepared prepared(scratch, soup);
  const auto& faces = prepared.report["preparation"]["degenerate_faces"];
  CHECK(faces["first"].is_null());
}

TEST_CASE("prepare: a hole of many edges", "[tool]")
{
  Scratch scratch;
  const int n = 3000;
  const double pi = std::acos(-1.);
  Soup soup; // a cone whose rim runs in and out
  soup.points.emplace_back(0, 0, 1);
  for(int i = 0; i < n; ++i) {
    const double angle = 2 * pi * i / n, radius = 1 + 0.1 * std::sin(10 * angle);
    soup.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    soup.faces.push_back({0, std::size_t(i + 1), std::size_t((i + 1) % n + 1)});
  }
  const Prepared prepared(scratch, soup);
  CHECK(prepared.report["preparation"]["holes"][0]["edges"] == n);
  double area = 0; // of the flat filling, which does not overlap
  for(std::size_t f = 0; f < prepared.out.faces.size(); ++f)
    if(prepared.face_map[f] < 0) {
      const auto& face = prepared.out.faces[f];
      const Vector normal = CGAL::cross_product(prepared.out.points[face[1]] - prepared.out.points[face[0]],
                                                prepared.out.points[face[2]] - prepared.out.points[face[0]]);
      area += std::sqrt(normal.squared_length()) / 2;
    }
  CHECK(area == Approx(pi * (1 + 0.1 * 0.1 / 2)).epsilon(1e-3));
  check_mapped(scratch);
}

TEST_CASE("prepare: a hole of fine edges is filled with no more than the mesh has, or 20,000 triangles", "[tool]")
{
  Scratch scratch;
  const int n = 1000;
  Soup soup; // a cylinder closed at one end
  soup.points.emplace_back(0, 0, 0);
  for(const double z : {0., 0.01})
    for(int i = 0; i < n; ++i)
      soup.points.emplace_back(std::cos(2 * std::acos(-1.) * i / n), std::sin(2 * std::acos(-1.) * i / n), z);
  for(int i = 0; i < n; ++i) {
    const auto a = std::size_t(i + 1), b = std::size_t((i + 1) % n + 1);
    soup.faces.insert(soup.faces.end(), {{0, b, a}, {a, b, a + n}, {b, b + n, a + n}});
  }
  const Prepared prepared(scratch, soup);
  CHECK(prepared.out.faces.size() > soup.faces.size() + 10000);
  CHECK(prepared.out.faces.size() < soup.faces.size() + 30000);
  check_mapped(scratch);
}

TEST_CASE("prepare: glTF cannot hold copies of vertices, and that is said", "[tool]")
{
  Scratch scratch;
  Soup pinched = icosphere(1); // two vertices are one
  for(auto& face : pinched.faces)
    std::replace(face.begin(), face.end(), std::size_t(11), std::size_t(0));
  const std::string in = write_off(scratch / "in.off", pinched);
  CHECK(run_tool({"prepare", in, "-o", scratch / "out.ply"}).out.find("which 'map' accepts") != std::string::npos);
  CHECK(run_tool({"prepare", in, "-o", scratch / "out.glb"}).out.find("name another format for 'map'") !=
        std::string::npos);
  CHECK(run_tool({"map", scratch / "out.ply", "-o", scratch / "sphere.ply"}).exit_code == 0);
  CHECK(run_tool({"map", scratch / "out.glb", "-o", scratch / "sphere.ply"}).exit_code != 0);
}

TEST_CASE("prepare: the distance is that of the file, also of floats", "[tool]")
{
  Scratch scratch;
  const std::string in =
    write_off(scratch / "in.off",
              transformed(icosphere(2), [](const Point& p) { return Point(1e7 + p.x(), 1e7 + p.y(), 1e7 + p.z()); }));
  for(const std::string name : {"out.ply", "out.gii", "lh.out"}) {
    const Process_result run = run_tool({"prepare", in, "-o", scratch / name, "--report", scratch / "report.json"});
    CAPTURE(name, run.out, run.err);
    REQUIRE(run.exit_code == 0);
    const auto report = nlohmann::json::parse(text_of(scratch / "report.json"));
    CHECK((report["distance_from_output_to_input"][1].get<double>() > 0.1) == (name != "out.ply"));
  }
}

TEST_CASE("prepare --merge-distance: what is at the same place becomes one, whatever is near it", "[tool]")
{
  Scratch scratch;
  Soup soup; // two triangles with an edge at the same place, of which a vertex is near one vertex each of two others
  soup.points = {{1.5, 0, 0}, {1, 0, 0},  {0.2, 0, 0}, {1, 0, 0},   {1, 0, 5},    {1, 0, 5},
                 {1, 5, 0},   {1, -5, 0}, {100, 0, 0}, {100, 9, 0}, {-100, 0, 0}, {-100, 9, 0}};
  soup.faces = {{1, 4, 6}, {5, 3, 7}, {0, 8, 9}, {2, 10, 11}};
  for(const char* distance : {"0", "1"}) {
    const Prepared prepared(scratch, soup, {"--steps", "merge,orient", "--merge-distance", distance});
    CAPTURE(distance);
    CHECK(prepared.report["preparation"]["components"].size() == 3);
  }
}

TEST_CASE("prepare: vertices at the same place that stay apart are not counted as merged", "[tool]")
{
  Scratch scratch;
  Soup soup; // two triangles that meet at a point
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {-1, 0, 0}, {0, -1, 0}};
  soup.faces = {{0, 1, 2}, {3, 4, 5}};
  const Prepared prepared(scratch, soup, {"--steps", "merge,orient"});
  CHECK(prepared.out.points.size() == 6);
  CHECK(prepared.report["preparation"]["done"].dump().find("merged") == std::string::npos);
}

TEST_CASE("prepare: of several components those that are turned are counted", "[tool]")
{
  Scratch scratch;
  const Soup turned = inside_out(icosphere(1));
  const auto done = [&](const Soup& soup) {
    return Prepared(scratch, soup, {"--steps", "merge,orient,handles"}).report["preparation"]["done"].dump();
  };
  CHECK(done(turned).find("turned all faces to the outside") != std::string::npos);
  CHECK(done(joined(icosphere(1), turned, Vector(9, 0, 0))).find("turned 1 component to the outside") !=
        std::string::npos);
  const Soup hollow = joined(icosphere(2), turned, Vector(0, 0, 0)); // whose cavity stays one
  CHECK(Prepared(scratch, hollow, {"--steps", "merge,orient"}).out.faces == hollow.faces);
}

TEST_CASE("prepare: a hole whose corners are on a line", "[tool]")
{
  Scratch scratch;
  const int n = 20;
  Soup soup;
  soup.points.emplace_back(0, 0, 1);
  for(int i = 0; i < n; ++i) {
    soup.points.emplace_back(std::cos(2 * std::acos(-1.) * i / n + 0.1), 0, 0);
    soup.faces.push_back({0, std::size_t(i + 1), std::size_t((i + 1) % n + 1)});
  }
  const Prepared prepared(scratch, soup);
  CHECK(prepared.report["preparation"]["holes"][0]["edges"] == n);
  CHECK(prepared.out.faces.size() == 2 * n); // all corners of the hole with a point between them
  std::set<std::pair<std::size_t, std::size_t>> sides;
  for(const auto& face : prepared.out.faces)
    for(std::size_t k = 0; k < 3; ++k)
      CHECK(sides.emplace(face[k], face[(k + 1) % 3]).second); // neighbours are oriented alike
  check_mapped(scratch);
}

TEST_CASE("prepare: what is left of little is said to be little", "[tool]")
{
  Scratch scratch;
  Soup soup = exploded(icosphere(2)); // so that no two triangles meet
  for(std::size_t i = 0; i < soup.points.size(); ++i)
    soup.points[i] = soup.points[i] + 1e-6 * Vector(double(i % 3), double(i % 5), double(i % 7));
  const std::string advice = "most of the area was removed: --merge-distance";
  CHECK(Prepared(scratch, soup).run.out.find(advice) != std::string::npos);
  CHECK(Prepared(scratch, soup, {"--merge-distance", "1e-4"}).run.out.find(advice) == std::string::npos);
}

TEST_CASE("segment --prepare: a label for every face of the file", "[tool]")
{
  Scratch scratch;
  const Soup soups[] = {torus(24, 8), open_sphere(3), joined(dumbbell(3), icosphere(2), Vector(9, 0, 0)),
                        double_torus()};
  for(const Soup& soup : soups) {
    const Process_result run = run_tool({"segment", write_off(scratch / "in.off", soup), "-o", scratch / "out.ply",
                                         "--labels", scratch / "labels.txt", "--prepare", "--method", "automatic"});
    CAPTURE(run.out, run.err);
    REQUIRE(run.exit_code == 0);
    const Numbers labels = numbers_in(scratch / "labels.txt");
    REQUIRE(labels.size() == soup.faces.size());
    const std::set<int> different(labels.begin(), labels.end());
    CHECK(*different.begin() == 0);
    CHECK(*different.rbegin() == int(different.size()) - 1);
    CHECK(read(scratch / "out.ply").faces == soup.faces);
  }
  // faces that were removed by themselves have the label of their own component, though it was removed, too
  const Soup small = transformed(icosphere(1), [](const Point& p) { return CGAL::ORIGIN + 0.1 * (p - CGAL::ORIGIN); });
  Soup repeated = joined(dumbbell(3), small, Vector(9, 0, 0));
  const auto [a, b, c] = std::tuple(repeated.faces.back()[0], repeated.faces.back()[1], repeated.faces.back()[2]);
  const std::size_t last = repeated.faces.size() - 1;
  repeated.faces.insert(repeated.faces.end(), {{b, c, a}, {a, a, b}});
  REQUIRE(run_tool({"segment", write_off(scratch / "in.off", repeated), "-o", scratch / "out.ply", "--labels",
                    scratch / "labels.txt", "--prepare"})
            .exit_code == 0);
  const Numbers of_repeated = numbers_in(scratch / "labels.txt");
  CHECK(of_repeated.at(last + 1) == of_repeated[last]);
  CHECK(of_repeated.at(last + 2) == of_repeated[last]);
  CHECK(std::count(of_repeated.begin(), of_repeated.end(), of_repeated[last]) == 82); // 80 of an icosphere, and these

  write_text(scratch / "cube.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                                   "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  CHECK(run_tool({"segment", scratch / "cube.obj", "-o", scratch / "out.ply", "--triangulate"})
          .out.find("6 polygons were triangulated, so the faces that have segments are not those of ") == 0);

  // balanced has no answer, so the others are asked; not if the user insists
  const std::string wild = write_off(scratch / "in.off", torus(3, 3));
  const Process_result balanced =
    run_tool({"segment", wild, "-o", scratch / "wild.ply", "--prepare", "--method", "balanced"});
  CHECK(balanced.exit_code == 1);
  CHECK(is_one_line(balanced.err));
  const Process_result others = run_tool({"segment", wild, "-o", scratch / "wild.ply", "--prepare"});
  CHECK(others.exit_code == 0);
  CHECK(others.out.find("automatic: balanced: ") != std::string::npos);
  // the component that was left out is a segment by itself
  REQUIRE(run_tool({"segment", write_off(scratch / "in.off", soups[2]), "-o", scratch / "out.ply", "--labels",
                    scratch / "labels.txt", "--prepare"})
            .exit_code == 0);
  const Numbers labels = numbers_in(scratch / "labels.txt");
  const std::size_t n = dumbbell(3).faces.size();
  const std::set<int> first(labels.begin(), labels.begin() + std::ptrdiff_t(n));
  const std::set<int> second(labels.begin() + std::ptrdiff_t(n), labels.end());
  CHECK(second.size() == 1);
  CHECK(first.count(*second.begin()) == 0);
}

TEST_CASE("texture --prepare: coordinates for every face of the file", "[tool]")
{
  Scratch scratch;
  Soup soup = joined(torus(24, 8), icosphere(1), Vector(9, 0, 0));
  soup.points.push_back(Point(0, 0, std::numeric_limits<double>::quiet_NaN())); // its face is left out
  soup.faces.push_back({0, 1, soup.points.size() - 1});
  const Process_result run = run_tool(
    {"texture", write_off(scratch / "in.off", soup), "-o", scratch / "out.obj", "--prepare", "--method", "automatic"});
  CAPTURE(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(run.out.find("no face of the repaired mesh is flipped in the texture") != std::string::npos);
  std::size_t vertices = 0, faces = 0, coordinates = 0;
  for(const std::string& line : lines_of(text_of(scratch / "out.obj"))) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    vertices += word == "v";
    faces += word == "f";
    coordinates += word == "vt";
    if(word == "vt") {
      double u = 9, v = 9;
      words >> u >> v;
      CHECK((u > -1e-6 && u < 2 && v > -1e-6 && v < 1 + 1e-6));
    } else if(word == "f") {
      std::size_t i = 0, j = 0;
      char slash = 0;
      while(words >> i >> slash >> j)
        CHECK((slash == '/' && i >= 1 && i <= soup.points.size() && j >= 1 && j <= coordinates));
    }
  }
  CHECK(vertices == soup.points.size());
  CHECK(faces == soup.faces.size());
}

TEST_CASE("texture --prepare: a face whose sides were split has the coordinates of its corners", "[tool]")
{
  Scratch scratch;
  const std::string in = scratch / "in.off", repaired = scratch / "repaired.off";
  write_text(in, "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 1\n");
  const Process_result preparing = run_tool({"prepare", in, "-o", repaired});
  REQUIRE(preparing.exit_code == 0);
  REQUIRE(preparing.out.find("split") != std::string::npos);
  const auto coordinates = [](const std::string& file) { // of every vertex, but for turns round the axis
    std::vector<Vector> uv;
    std::map<std::size_t, std::set<std::pair<double, double>>> result;
    for(const std::string& line : lines_of(text_of(file))) {
      std::istringstream words(line);
      std::string word;
      words >> word;
      double u = 0, v = 0;
      std::size_t i = 0, j = 0;
      char slash = 0;
      if(word == "vt" && words >> u >> v)
        uv.emplace_back(u - std::floor(u), v, 0);
      while(word == "f" && words >> i >> slash >> j)
        result[i].emplace(std::round(1e6 * uv[j - 1].x()), std::round(1e6 * uv[j - 1].y()));
    }
    return result;
  };
  REQUIRE(run_tool({"texture", in, "-o", scratch / "in.obj", "--prepare"}).exit_code == 0);
  REQUIRE(run_tool({"texture", repaired, "-o", scratch / "repaired.obj"}).exit_code == 0);
  auto expected = coordinates(scratch / "repaired.obj");
  for(const auto& [vertex, of_file] : coordinates(scratch / "in.obj"))
    CHECK(of_file == expected[vertex]);
}

TEST_CASE("prepare --wrap: sizes beyond all reason are refused", "[tool]")
{
  Scratch scratch;
  const std::string in = write_off(scratch / "in.off", icosphere(1));
  for(const char* option : {"--alpha", "--offset"}) {
    const Process_result run = run_tool({"prepare", in, "-o", scratch / "out.off", "--wrap", option, "1e300"});
    CHECK(run.exit_code == 1);
    CHECK(run.err.find("in.off: has a size that is nothing to that alpha or offset; give smaller ones") !=
          std::string::npos);
  }
}

TEST_CASE("prepare: what has no surface is refused", "[tool]")
{
  Scratch scratch;
  const Soup nothing[] = {{{Point(0, 0, 0), Point(1, 0, 0)}, {}},
                          {{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)}, {{0, 1, 0}}}};
  for(const Soup& soup : nothing) {
    const std::string in = write_off(scratch / "in.off", soup);
    const Process_result run =
      run_tool({"prepare", in, "-o", scratch / "out.off", "--report", scratch / "report.json"});
    CHECK(run.exit_code == 1);
    CHECK(is_one_line(run.err));
    CHECK(run.err.find(soup.faces.empty() ? "reconstruct a surface" : "removed 1 face with two corners at") !=
          std::string::npos);
    CHECK_FALSE(fs::exists(scratch / "out.off"));
    CHECK(nlohmann::json::parse(text_of(scratch / "report.json"))["error_code"] != "OK");
  }
}

TEST_CASE("prepare(): wrong arguments", "[tool]")
{
  namespace preparation = CGAL::Spherical_parameterization::preparation;
  const std::vector<std::array<double, 3>> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::vector<std::array<int, 3>> triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const auto prepared = [&](const preparation::Preparation_settings& settings = {}) {
    return preparation::prepare(preparation::Triangle_soup(points, triangles), settings);
  };
  CHECK(prepared().parts.size() == 1);
  for(const double wrong : {-1., std::nan("")}) {
    preparation::Preparation_settings settings;
    settings.merge_distance = wrong;
    CHECK_THROWS_AS(prepared(settings), CGAL::Precondition_exception);
    settings = {};
    settings.wrap.emplace().alpha = wrong;
    CHECK_THROWS_AS(prepared(settings), CGAL::Precondition_exception);
    settings.wrap.emplace().offset = wrong;
    CHECK_THROWS_AS(prepared(settings), CGAL::Precondition_exception);
  }
  preparation::Preparation_settings wrapping;
  wrapping.wrap.emplace().alpha = 0.01;
  int calls = 0;
  const auto limited = CGAL::parameters::callback([&calls](double) { return ++calls < 10; });
  CHECK_THROWS_AS(preparation::prepare(preparation::Triangle_soup(points, triangles), wrapping, limited),
                  CGAL::Spherical_parameterization::Error);
  CHECK(calls == 10); // in the middle of the wrapping
  for(const int wrong : {-1, 4}) {
    triangles[0][0] = wrong;
    CHECK_THROWS_AS(prepared(), CGAL::Precondition_exception);
  }
}

TEST_CASE("prepare: wrong usage", "[tool]")
{
  Scratch scratch;
  const std::string in = write_off(scratch / "in.off", icosphere(1)), out = scratch / "out.off";
  const std::vector<std::vector<std::string>> wrong = {{"-o", in},
                                                       {"-o", scratch / "out.stl"},
                                                       {"-o", scratch / "out.vtu"},
                                                       {"-o", out, "--alpha", "1"},
                                                       {"-o", out, "--wrap", "--offset", "0"},
                                                       {"-o", out, "--merge-distance", "-1"},
                                                       {"-o", out, "--steps", "some"},
                                                       {"-o", out, "--steps", "largest,split"},
                                                       {"-o", out, "--steps", "holes", "--merge-distance", "1"},
                                                       {"--steps", "split"},
                                                       {"-o", out, "--steps", "split", "--face-map", "f.txt"},
                                                       {"-o", scratch / "folder/", "--steps", "split"}};
  for(const auto& options : wrong) {
    const Process_result run = run_tool(with({"prepare", in}, options));
    CAPTURE(run.err, options.back());
    CHECK(run.exit_code == 2);
  }
  CHECK(scratch.number_of_files() == 1);
}
