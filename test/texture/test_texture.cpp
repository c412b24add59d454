// SPDX-License-Identifier: GPL-3.0-or-later
// texture_coordinates.h: every face of every valid map has its place in the texture.

#include "helpers/hard_maps.h"
#include "helpers/meshes.h"
#include "helpers/property_maps.h"
#include "helpers/solve.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Spherical_parameterization/texture_coordinates.h>
#include <CGAL/boost/graph/Seam_mesh.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <string>

using namespace test;
using SP::Texture_chart;
using SP::Texture_options;

namespace {

using Point_2 = Kernel::Point_2;
using Halfedge = Mesh::Halfedge_index;
using Triangle = std::array<Point_2, 3>;

const double pi = std::acos(-1.);

/// The texture of a map: one triangle per face, its corners in the order of the soup.
struct Texture {
  SP::Texture_report report;
  std::vector<Triangle> triangles;
};

Texture texture(const Mapped_soup& map, const Texture_options& options)
{
  const Mesh mesh = make_mesh(map.soup);
  std::map<Halfedge, Point_2> uv;
  Texture result;
  result.report =
    SP::texture_coordinates(mesh, Readable_map<Mesh::Vertex_index, Point>{[&](auto v) { return map.sphere[v]; }},
                            Writable_map<Halfedge, Point_2>{&uv}, options);
  CHECK(uv.size() == 3 * map.soup.faces.size());
  for(std::size_t f = 0; f < map.soup.faces.size(); ++f) {
    Halfedge h = mesh.halfedge(Mesh::Face_index(Mesh::size_type(f)));
    while(mesh.target(h) != Mesh::Vertex_index(Mesh::size_type(map.soup.faces[f][0])))
      h = mesh.next(h);
    result.triangles.push_back({uv.at(h), uv.at(mesh.next(h)), uv.at(mesh.prev(h))});
  }
  return result;
}

Texture_options options(Texture_chart chart, int bits = 52)
{
  Texture_options o;
  o.chart = chart;
  o.bits = bits;
  return o;
}

SP::Texture_axes axes(const Vector& north, const Vector& meridian)
{
  return {{north.x(), north.y(), north.z()}, {meridian.x(), meridian.y(), meridian.z()}};
}

/// Whether the point is in the triangle, its border included.
bool contains(const Triangle& t, const Point_2& p)
{
  return exact_orientation(t[0], t[1], p) != CGAL::RIGHT_TURN && exact_orientation(t[1], t[2], p) != CGAL::RIGHT_TURN &&
         exact_orientation(t[2], t[0], p) != CGAL::RIGHT_TURN;
}

/// u and v of a point of the sphere.
Point_2 latitude_longitude(const SP::Texture_axes& a, const Point& p)
{
  const Vector north(a.north[0], a.north[1], a.north[2]), meridian(a.meridian[0], a.meridian[1], a.meridian[2]);
  const Vector z = north / std::sqrt(north.squared_length()), off = meridian - (meridian * z) * z;
  const Vector x = off / std::sqrt(off.squared_length()), y = CGAL::cross_product(z, x), q = p - CGAL::ORIGIN;
  const double u = std::atan2(q * y, q * x) / (2 * pi);
  return Point_2(u - std::floor(u), 0.5 + std::atan2(q * z, std::hypot(q * x, q * y)) / pi);
}

double distance_modulo_turns(const Point_2& a, const Point_2& b)
{
  const double u = a.x() - b.x();
  return std::hypot(u - std::nearbyint(u), a.y() - b.y());
}

} // namespace

TEST_CASE("every face has a counter-clockwise uv triangle", "[texture]")
{
  const auto chart = GENERATE(Texture_chart::LATITUDE_LONGITUDE, Texture_chart::OCTAHEDRAL);
  const int bits = GENERATE(52, 23, 8);
  for(const Mapped_soup& map : hard_maps())
    for(unsigned seed = 0; seed < 8; ++seed) {
      Texture_options o = options(chart, bits);
      if(seed > 0) {
        const auto rows = random_rotation(seed);
        o.axes = axes(rows[0], rows[1]);
      }
      const Texture t = texture(map, o);
      CAPTURE(map.name, bits, seed, t.report.moved_faces, t.report.largest_move);
      std::size_t flipped = 0, outside = 0, off_grid = 0, across = 0;
      for(const Triangle& uv : t.triangles) {
        flipped += exact_orientation(uv[0], uv[1], uv[2]) != CGAL::LEFT_TURN;
        across += std::any_of(uv.begin(), uv.end(), [](const Point_2& p) {
          return (std::min)(p.x(), p.y()) < 0 || (std::max)(p.x(), p.y()) > 1;
        });
        for(const Point_2& p : uv) {
          const bool is_inside = chart == Texture_chart::LATITUDE_LONGITUDE
                                   ? p.x() >= 0 && p.x() < 2 && p.y() >= 0 && p.y() <= 1
                                   : p.x() > -1 && p.x() < 2 && p.y() > -1 && p.y() < 2;
          outside += !is_inside;
          for(const double x : {p.x(), p.y()})
            off_grid +=
              std::ldexp(x, bits) != std::nearbyint(std::ldexp(x, bits)) || (bits <= 23 && double(float(x)) != x);
        }
      }
      CHECK(flipped == 0);
      CHECK(outside == 0);
      CHECK(off_grid == 0);
      CHECK(across == t.report.seam_faces);
    }
}

TEST_CASE("uv are longitude and latitude, but for the corners that the report counts", "[texture]")
{
  for(const Mapped_soup& map : hard_maps()) {
    const auto rows = random_rotation(9);
    Texture_options o = options(Texture_chart::LATITUDE_LONGITUDE);
    o.axes = axes(rows[0], rows[1]);
    const Texture t = texture(map, o);
    std::size_t moved = 0;
    double largest = 0;
    for(std::size_t f = 0; f < t.triangles.size(); ++f) {
      double distance = 0;
      for(std::size_t k = 0; k < 3; ++k)
        distance =
          std::max(distance, distance_modulo_turns(t.triangles[f][k],
                                                   latitude_longitude(*o.axes, map.sphere[map.soup.faces[f][k]])));
      moved += distance > 1e-13;
      largest = std::max(largest, distance);
    }
    CAPTURE(map.name);
    CHECK(moved <= t.report.moved_faces);
    CHECK(largest <= t.report.largest_move + 1e-13);
  }
}

TEST_CASE("nothing is moved where nothing has to be", "[texture]")
{
  const auto chart = GENERATE(Texture_chart::LATITUDE_LONGITUDE, Texture_chart::OCTAHEDRAL);
  for(unsigned seed = 0; seed < 5; ++seed) {
    const auto rows = random_rotation(seed);
    Texture_options o = options(chart, 23);
    o.axes = axes(rows[0], rows[1]);
    CHECK(texture({"", icosphere(4), icosphere(4).points}, o).report.moved_faces == 0);
  }
}

TEST_CASE("the texture covers the square once", "[texture]")
{
  // Neighbours have the very same coordinates along their edge, modulo whole turns: without moved corners, and away
  // from the poles, every point is in one triangle.
  const Soup soup = bumpy_sphere(3);
  Settings settings;
  const Mapped_soup map = {"bumpy", soup, solve_or_throw(soup, settings)};
  std::mt19937 random(1);
  std::uniform_real_distribution<double> u(0, 1), v(0.1, 0.9);
  for(unsigned seed = 0; seed < 3; ++seed) {
    Texture_options o = options(Texture_chart::LATITUDE_LONGITUDE);
    const auto rows = random_rotation(seed);
    o.axes = axes(rows[0], rows[1]);
    const Texture t = texture(map, o);
    REQUIRE(t.report.moved_faces == 0);
    CHECK(t.report.seam_faces > 10);
    for(int k = 0; k < 300; ++k) {
      const double x = u(random), y = v(random);
      int covered = 0;
      for(const Triangle& uv : t.triangles)
        covered += contains(uv, Point_2(x, y)) || contains(uv, Point_2(x + 1, y));
      CHECK(covered == 1);
    }
  }
}

TEST_CASE("the octahedral square is covered once, and areas differ by little", "[texture]")
{
  const Soup soup = icosphere(4);
  const Mapped_soup map = {"icosphere", soup, soup.points};
  Texture_options o = options(Texture_chart::OCTAHEDRAL);
  const auto rows = random_rotation(3);
  o.axes = axes(rows[0], rows[1]);
  const Texture t = texture(map, o);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> inside(0.05, 0.95);
  int wrong = 0;
  for(int k = 0; k < 300; ++k) {
    const Point_2 p(inside(random), inside(random));
    int covered = 0;
    for(const Triangle& uv : t.triangles)
      covered += contains(uv, p);
    wrong += covered != 1;
  }
  CHECK(wrong <= 6); // faces across a bend of the octahedron overlap, or leave gaps, of second order
  double smallest = 1, largest = 0;
  for(const Triangle& uv : t.triangles) {
    const double area = CGAL::area(uv[0], uv[1], uv[2]);
    smallest = std::min(smallest, area);
    largest = std::max(largest, area);
  }
  CHECK(largest < 8 * smallest); // 3 sqrt(3) by the projection, the rest by the icosphere
}

TEST_CASE("poles in a vertex, on an edge, in a face; the seam through vertices", "[texture]")
{
  const Soup soup = flat_octahedron(2);
  Mapped_soup map = {"octahedron", soup, soup.points};
  for(Point& p : map.sphere) {
    const double length = std::sqrt((p - CGAL::ORIGIN).squared_length());
    p = Point(p.x() / length, p.y() / length, p.z() / length);
  }
  const Vector north =
    GENERATE(values<Vector>({Vector(0, 0, 1), Vector(0, 0, -5), Vector(1, 0, 0), Vector(1, 1, 0), Vector(0, -1, 1),
                             Vector(1, 1, 1), Vector(-1, 1, -1), Vector(0.1, 0.2, 0.3)}));
  for(const Vector& meridian : {Vector(1, 2, 0), Vector(0, 1, 2), Vector(1, 0, 3)}) {
    Texture_options o = options(Texture_chart::LATITUDE_LONGITUDE, 23);
    o.axes = axes(north, meridian);
    const Texture t = texture(map, o);
    CAPTURE(north, meridian);
    CHECK(t.report.pole_faces >= 2);
    for(const Triangle& uv : t.triangles)
      CHECK(exact_orientation(uv[0], uv[1], uv[2]) == CGAL::LEFT_TURN);
  }
}

TEST_CASE("a corner at a pole has the mean u of its face", "[texture]")
{
  const Mapped_soup map = {"octahedron", flat_octahedron(0), flat_octahedron(0).points};
  Texture_options o = options(Texture_chart::LATITUDE_LONGITUDE);
  o.axes = axes(Vector(0, 0, 1), Vector(1, 1, 0));
  const Texture t = texture(map, o);
  CHECK(t.report.pole_faces == 8);
  CHECK(t.report.moved_faces == 0);
  CHECK(t.report.seam_faces == 2);
  double area = 0;
  for(const Triangle& uv : t.triangles) {
    std::array<double, 3> u = {uv[0].x(), uv[1].x(), uv[2].x()};
    std::sort(u.begin(), u.end());
    CHECK(u[1] == Approx((u[0] + u[2]) / 2).epsilon(1e-14));
    CHECK(u[2] - u[0] == Approx(0.25).epsilon(1e-14));
    area += CGAL::area(uv[0], uv[1], uv[2]);
  }
  CHECK(area == Approx(0.5).epsilon(1e-14));
}

TEST_CASE("a vertex is at the pole also where roundings differ", "[texture]")
{
  const Soup soup = icosphere(2);
  const double length = GENERATE(1., 1 + 7e-16, 3., 1e-7, 1e200);
  Mapped_soup map = {"icosphere", soup, soup.points};
  const std::size_t pole = GENERATE(0, 5, 17, 100);
  for(Point& p : map.sphere)
    p = CGAL::ORIGIN + length * (p - CGAL::ORIGIN);
  Texture_options o = options(Texture_chart::LATITUDE_LONGITUDE);
  for(const double axis : {1., 3., 1 / length, -0.1}) {
    o.axes = axes(axis * (map.sphere[pole] - CGAL::ORIGIN), Vector(0.3, 0.8, -0.4));
    const Texture t = texture(map, o);
    CAPTURE(length, pole, axis);
    for(std::size_t f = 0; f < soup.faces.size(); ++f)
      for(std::size_t k = 0; k < 3; ++k)
        if(soup.faces[f][k] == pole) {
          const Triangle& uv = t.triangles[f];
          CHECK(uv[k].x() == Approx((uv[(k + 1) % 3].x() + uv[(k + 2) % 3].x()) / 2).margin(1e-12));
          CHECK(uv[k].y() == (axis > 0 ? 1 : 0));
        }
  }
}

TEST_CASE("by default the south pole is a vertex, and in the limb of a capsule", "[texture]")
{
  const Soup soup = capsule(4, 24);
  Settings settings;
  const Mapped_soup map = {"capsule", soup, solve_or_throw(soup, settings)};
  const Texture t = texture(map, options(Texture_chart::LATITUDE_LONGITUDE));
  const auto& north = t.report.axes.north;
  const Point south(-north[0], -north[1], -north[2]);
  const auto pole = std::find(map.sphere.begin(), map.sphere.end(), south);
  REQUIRE(pole != map.sphere.end());
  // the middle of a capsule is large on the sphere or small, its ends are what it is about: the axis is that of the
  // tube
  const Vector to_pole = soup.points[std::size_t(pole - map.sphere.begin())] - CGAL::ORIGIN;
  const double extent = std::max({std::abs(to_pole.x()), std::abs(to_pole.y()), std::abs(to_pole.z())});
  CHECK(extent / std::sqrt(to_pole.squared_length()) > 0.9); // on a cap
  CHECK(t.report.moved_faces == 0);
}

TEST_CASE("the same texture on a Polyhedron_3", "[texture]")
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  const Soup soup = icosphere(2);
  const Polyhedron polyhedron = make_graph<Polyhedron>(soup);
  std::map<boost::graph_traits<Polyhedron>::halfedge_descriptor, Point_2> uv;
  const auto points = get(CGAL::vertex_point, polyhedron);
  Texture_options o = options(Texture_chart::LATITUDE_LONGITUDE);
  const auto rows = random_rotation(4);
  o.axes = axes(rows[0], rows[1]);
  SP::texture_coordinates(polyhedron, points, boost::make_assoc_property_map(uv), o);
  const Texture t = texture({"", soup, soup.points}, o);
  std::size_t k = 0;
  for(auto f : faces(polyhedron)) {
    const Triangle& expected = t.triangles[k++];
    auto h = halfedge(f, polyhedron);
    for(int i = 0; i < 3; ++i, h = next(h, polyhedron))
      CHECK(std::find(expected.begin(), expected.end(), uv.at(h)) != expected.end());
  }
}

TEST_CASE("coordinates of floats are on a grid of floats", "[texture]")
{
  typedef CGAL::Simple_cartesian<float>::Point_2 Float_point;
  const Soup soup = capsule(12, 12);
  Settings settings;
  settings.weights = Weights::CONFORMAL;
  const Sphere sphere = solve_or_throw(soup, settings);
  const Mesh mesh = make_mesh(soup);
  const Readable_map<Mesh::Vertex_index, Point> map{[&](auto v) { return sphere[v]; }};
  for(const auto chart : {Texture_chart::LATITUDE_LONGITUDE, Texture_chart::OCTAHEDRAL}) {
    std::map<Halfedge, Float_point> uv;
    const SP::Texture_report report =
      SP::texture_coordinates(mesh, map, Writable_map<Halfedge, Float_point>{&uv}, options(chart));
    CHECK(report.unresolved_faces > 0);
    for(auto f : faces(mesh)) {
      const auto h = halfedge(f, mesh);
      const auto exact = [&uv](Halfedge corner) { return Point_2(uv.at(corner).x(), uv.at(corner).y()); };
      CHECK(exact_orientation(exact(h), exact(next(h, mesh)), exact(prev(h, mesh))) == CGAL::LEFT_TURN);
    }
  }
}

TEST_CASE("textures: wrong arguments", "[texture]")
{
  const Soup soup = icosphere(1);
  const Mapped_soup map = {"", soup, soup.points};
  Texture_options o;
  SECTION("bits") { o.bits = GENERATE(-1, 0, 53); }
  SECTION("parallel axes") { o.axes = axes(Vector(1, 2, 3), Vector(-2, -4, -6)); }
  SECTION("no axis") { o.axes = axes(Vector(0, 0, 0), Vector(1, 0, 0)); }
  SECTION("infinite axis") { o.axes = axes(Vector(0, 0, 1), Vector(std::numeric_limits<double>::infinity(), 0, 0)); }
  SECTION("NaN") { o.axes = axes(Vector(0, std::numeric_limits<double>::quiet_NaN(), 1), Vector(1, 0, 0)); }
  const Mesh mesh = make_mesh(soup);
  std::map<Halfedge, Point_2> uv;
  const Readable_map<Mesh::Vertex_index, Point> sphere{[&](auto v) { return map.sphere[v]; }};
  CHECK_THROWS_AS(SP::texture_coordinates(mesh, sphere, Writable_map<Halfedge, Point_2>{&uv}, o),
                  CGAL::Precondition_exception);
  CHECK(uv.empty());
}

TEST_CASE("textures: wrong meshes and maps", "[texture]")
{
  const auto axes_given = GENERATE(false, true);
  const auto check = [&](const Soup& soup, const Sphere& sphere, Error_code expected) {
    const Mesh mesh = make_mesh(soup);
    std::map<Halfedge, Point_2> uv;
    Texture_options o;
    if(axes_given)
      o.axes = axes(Vector(0, 0, 1), Vector(1, 0, 0));
    try {
      SP::texture_coordinates(mesh, Readable_map<Mesh::Vertex_index, Point>{[&](auto v) { return sphere[v]; }},
                              Writable_map<Halfedge, Point_2>{&uv}, o);
      FAIL("no error");
    } catch(const SP::Error& error) {
      CHECK(error.code() == expected);
    }
    CHECK(uv.empty());
  };
  check({}, {}, Error_code::EMPTY_MESH);
  Soup soup = icosphere(1);
  Sphere flipped = soup.points;
  flipped[3] = Point(-soup.points[3].x(), -soup.points[3].y(), -soup.points[3].z());
  check(soup, flipped, Error_code::NOT_BIJECTIVE);
  soup.points.emplace_back(0, 0, 1);
  check(soup, soup.points, Error_code::ISOLATED_VERTEX);
  const Soup fine = icosphere(4);
  const Sphere twice_round_the_axis = transformed(fine, [](const Point& p) {
                                        const double r = std::hypot(p.x(), p.y()), angle = 2 * std::atan2(p.y(), p.x());
                                        return Point(r * std::cos(angle), r * std::sin(angle), p.z());
                                      }).points;
  check(fine, twice_round_the_axis, Error_code::NOT_BIJECTIVE); // without flipped faces
}

TEST_CASE("cut open along its seams, a mesh has one pair of texture coordinates at every vertex", "[texture]")
{
  using Edge = Mesh::Edge_index;
  using Vertex = Mesh::Vertex_index;
  const auto chart = GENERATE(Texture_chart::LATITUDE_LONGITUDE, Texture_chart::OCTAHEDRAL);
  const int bits = GENERATE(52, 10); // with few bits, corners are moved, which opens more seams
  Mesh mesh = make_mesh(icosphere(3));
  Texture_options o = options(chart, bits);
  const auto rows = random_rotation(5);
  o.axes = axes(rows[0], rows[1]);
  const auto uv = mesh.add_property_map<Halfedge, Point_2>("h:uv").first;
  SP::texture_coordinates(mesh, mesh.points(), uv, o);
  const auto is_seam = mesh.add_property_map<Edge, bool>("e:seam").first;
  const auto on_seam = mesh.add_property_map<Vertex, bool>("v:seam").first;
  const std::size_t seams = SP::texture_seams(mesh, uv, is_seam, on_seam);
  CHECK(seams > 10);
  CHECK(seams < mesh.number_of_edges() / (bits == 52 ? 4 : 1));
  if(bits == 52) { // rounding opens none
    o.bits = 40;
    const auto rounded = mesh.add_property_map<Halfedge, Point_2>("h:rounded").first;
    SP::texture_coordinates(mesh, mesh.points(), rounded, o);
    CHECK(SP::texture_seams(mesh, rounded, is_seam, on_seam) == seams);
    SP::texture_seams(mesh, uv, is_seam, on_seam);
  }

  typedef CGAL::Seam_mesh<Mesh, Mesh::Property_map<Edge, bool>, Mesh::Property_map<Vertex, bool>> Seam_mesh;
  Seam_mesh cut(mesh, is_seam, on_seam);
  cut.set_seam_edges_number(seams);
  CHECK(cut.number_of_seam_edges() == seams);
  std::size_t several = 0, corners = 0;
  for(auto f : faces(cut))
    for(auto h : halfedges_around_face(halfedge(f, cut), cut)) {
      const auto v = target(h, cut); // one of the copies of a vertex on a seam
      several += uv[Halfedge(h)] != uv[Halfedge(halfedge(v, cut))];
      ++corners;
    }
  CHECK(corners == 3 * mesh.number_of_faces());
  CHECK(several == 0);
}

#ifdef CGAL_LINKED_WITH_TBB
TEST_CASE("textures are the same bits on several threads", "[texture]")
{
  const auto chart = GENERATE(Texture_chart::LATITUDE_LONGITUDE, Texture_chart::OCTAHEDRAL);
  const Soup soup = bumpy_sphere(6);
  const Mesh mesh = make_mesh(soup), round = make_mesh(icosphere(6));
  std::map<Halfedge, Point_2> one, several;
  const SP::Texture_report a =
    SP::texture_coordinates(mesh, round.points(), Writable_map<Halfedge, Point_2>{&one}, options(chart));
  const SP::Texture_report b = SP::texture_coordinates(CGAL::Parallel_tag(), mesh, round.points(),
                                                       Writable_map<Halfedge, Point_2>{&several}, options(chart));
  CHECK(one == several);
  CHECK(a.axes.north == b.axes.north);
  CHECK(a.seam_faces == b.seam_faces);
  CHECK(a.largest_move == b.largest_move);
}
#endif

TEST_CASE("texture coordinates: callback and time limit end them before anything is written", "[texture]")
{
  const Soup soup = icosphere(6);
  const Mesh mesh = make_mesh(soup);
  const auto call = [&](const auto& np) {
    std::map<Halfedge, Point_2> uv;
    std::string detail;
    try {
      SP::texture_coordinates(CGAL::Parallel_if_available_tag(), mesh,
                              Readable_map<Mesh::Vertex_index, Point>{[&](auto v) { return soup.points[v]; }},
                              Writable_map<Halfedge, Point_2>{&uv}, Texture_options(), np);
    } catch(const SP::Error& error) {
      CHECK(error.code() == SP::Error_code::INTERRUPTED);
      detail = error.detail();
    }
    CHECK(uv.empty() != detail.empty());
    return detail;
  };
  int calls = 0;
  CHECK(call(CGAL::parameters::callback([&](double) { return ++calls > 0; })).empty());
  CHECK(calls >= 3);
  for(const int most : {0, 1, 2}) {
    int left = most;
    CHECK(call(CGAL::parameters::callback([&](double) { return left-- > 0; })) == "stopped by the callback");
  }
  CHECK(call(CGAL::parameters::maximum_running_time(0)) == "the time limit was reached");
}
