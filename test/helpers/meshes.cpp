// SPDX-License-Identifier: GPL-3.0-or-later

#include "helpers/meshes.h"

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <utility>

namespace test {
namespace {

using Edge = std::pair<std::size_t, std::size_t>;

constexpr double pi = 3.14159265358979323846;

Point normalized(const Point& p)
{
  const double length = std::sqrt(p.x() * p.x() + p.y() * p.y() + p.z() * p.z());
  return Point(p.x() / length, p.y() / length, p.z() / length);
}

Soup icosahedron()
{
  const double t = (1 + std::sqrt(5.)) / 2;
  Soup soup;
  soup.points = {{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                 {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
  soup.faces = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  return soup;
}

/// Every triangle in four, the new vertices in the middle of the edges.
Soup subdivided(const Soup& coarse)
{
  Soup fine;
  fine.points = coarse.points;
  std::map<Edge, std::size_t> middles;
  auto middle = [&](std::size_t i, std::size_t j) {
    const auto [it, is_new] = middles.emplace(std::minmax(i, j), fine.points.size());
    if(is_new)
      fine.points.push_back(CGAL::midpoint(coarse.points[i], coarse.points[j]));
    return it->second;
  };
  for(const auto& f : coarse.faces) {
    const std::size_t ab = middle(f[0], f[1]), bc = middle(f[1], f[2]), ca = middle(f[2], f[0]);
    fine.faces.insert(fine.faces.end(), {{f[0], ab, ca}, {f[1], bc, ab}, {f[2], ca, bc}, {ab, bc, ca}});
  }
  return fine;
}

/// The surface of a set of unit cubes, as quadrangles.
Soup cubes(const std::set<std::array<int, 3>>& cells)
{
  Soup soup;
  std::map<std::array<int, 3>, std::size_t> corners;
  auto corner = [&](std::array<int, 3> p) {
    const auto [it, is_new] = corners.emplace(p, soup.points.size());
    if(is_new)
      soup.points.emplace_back(p[0], p[1], p[2]);
    return it->second;
  };
  for(const auto& cell : cells)
    for(int axis = 0; axis < 3; ++axis)
      for(int side = 0; side < 2; ++side) {
        auto neighbour = cell;
        neighbour[axis] += side == 0 ? -1 : 1;
        if(cells.count(neighbour) != 0)
          continue;
        auto p = cell;
        p[axis] += side;
        auto q = p, r = p, s = p;
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        ++q[u];
        ++r[u], ++r[v];
        ++s[v];
        if(side == 0)
          std::swap(q, s);
        soup.faces.push_back({corner(p), corner(q), corner(r), corner(s)});
      }
  return soup;
}

Soup triangulated(const Soup& soup)
{
  Soup result;
  result.points = soup.points;
  for(const auto& f : soup.faces)
    for(std::size_t i = 2; i < f.size(); ++i)
      result.faces.push_back({f[0], f[i - 1], f[i]});
  return result;
}

/// Glues vertex `w` of the mesh to vertex `v`, which makes `v` non-manifold.
void glue(Mesh& mesh, Mesh::Vertex_index v, Mesh::Vertex_index w)
{
  std::vector<Mesh::Halfedge_index> into_w;
  for(auto h : CGAL::halfedges_around_target(w, mesh))
    into_w.push_back(h);
  for(auto h : into_w)
    mesh.set_target(h, v);
  mesh.remove_vertex(w);
  mesh.collect_garbage();
}

} // namespace

Soup tetrahedron()
{
  Soup soup;
  soup.points = {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}};
  soup.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return soup;
}

Soup icosphere(int level)
{
  Soup soup = icosahedron();
  for(int i = 0; i < level; ++i)
    soup = transformed(subdivided(soup), normalized);
  return transformed(soup, normalized);
}

Soup flat_octahedron(int level)
{
  Soup soup;
  soup.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  soup.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for(int i = 0; i < level; ++i)
    soup = subdivided(soup);
  return soup;
}

Soup ellipsoid(double a, double b, double c, int level)
{
  return transformed(icosphere(level), [=](const Point& p) { return Point(a * p.x(), b * p.y(), c * p.z()); });
}

Soup bumpy_sphere(int level)
{
  return transformed(icosphere(level), [](const Point& p) {
    const double r = 1 + 0.2 * std::sin(3 * p.x() + 1) * std::cos(4 * p.y()) + 0.15 * std::sin(5 * p.z() + 2 * p.x());
    return Point(r * p.x(), r * p.y(), r * p.z());
  });
}

Soup dumbbell(int level)
{
  return transformed(icosphere(level), [](const Point& p) {
    const double width = 0.3 + (p.z() > 0 ? 0.9 : 0.7) * p.z() * p.z() + 0.03 * std::sin(3 * p.x() + p.y());
    return Point(width * p.x(), width * p.y(), 2 * p.z());
  });
}

Soup spiky_star(int level, double height)
{
  std::vector<Vector> tips = {{1, .1, .2},  {-1, .2, .1}, {.2, 1, -.1}, {.1, -1, .3},
                              {-.1, .2, 1}, {.3, .1, -1}, {1, 1, 1}};
  for(Vector& tip : tips)
    tip /= std::sqrt(tip.squared_length());
  return transformed(icosphere(level), [=](const Point& p) {
    double r = 1;
    for(std::size_t i = 0; i < tips.size(); ++i)
      r += height * (1 + 0.1 * double(i)) * std::exp(-25 * (1 - (p - CGAL::ORIGIN) * tips[i]));
    return Point(r * p.x(), r * p.y(), r * p.z());
  });
}

Soup cube() { return triangulated(quad_cube()); }

Soup cross()
{
  return triangulated(cubes({{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}));
}

Soup capsule(double ratio, int n_around)
{
  const std::size_t n = std::size_t(n_around);
  const double step = 2 * pi / n_around, length = 2 * pi * ratio;
  const int tube_rings = std::max(1, int(std::lround(length / step))), cap_rings = n_around / 4;
  std::vector<std::pair<double, double>> rings; // radius, height
  for(int i = 1; i < cap_rings; ++i)
    rings.emplace_back(std::sin(i * step), -length / 2 - std::cos(i * step));
  for(int i = 0; i <= tube_rings; ++i)
    rings.emplace_back(1, length * i / tube_rings - length / 2);
  for(int i = cap_rings - 1; i > 0; --i)
    rings.emplace_back(std::sin(i * step), length / 2 + std::cos(i * step));

  Soup soup;
  for(std::size_t k = 0; k < rings.size(); ++k)
    for(std::size_t i = 0; i < n; ++i) {
      const double angle = step * (double(i) + 0.5 * double(k % 2));
      soup.points.emplace_back(rings[k].first * std::cos(angle), rings[k].first * std::sin(angle), rings[k].second);
    }
  const std::size_t south = soup.points.size(), north = south + 1, last = (rings.size() - 1) * n;
  soup.points.emplace_back(0, 0, -length / 2 - 1);
  soup.points.emplace_back(0, 0, length / 2 + 1);
  for(std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    soup.faces.push_back({south, j, i});
    for(std::size_t k = 0; k + 1 < rings.size(); ++k) {
      const std::size_t a = k * n + i, b = k * n + j, c = a + n, d = b + n;
      if(k % 2 == 0)
        soup.faces.insert(soup.faces.end(), {{a, b, c}, {b, d, c}});
      else
        soup.faces.insert(soup.faces.end(), {{a, b, d}, {a, d, c}});
    }
    soup.faces.push_back({last + i, last + j, north});
  }
  return soup;
}

Soup spiral(int turns, int n_around)
{
  const int n_along = 48 * turns;
  const std::size_t n = std::size_t(n_around), rings = std::size_t(n_along);
  Soup soup;
  auto frame = [&](double t, Vector& radial, Vector& binormal) {
    const double angle = 2 * pi * turns * t, radius = 8, rise = 4. * turns;
    const Vector tangent(-2 * pi * turns * radius * std::sin(angle), 2 * pi * turns * radius * std::cos(angle), rise);
    radial = Vector(std::cos(angle), std::sin(angle), 0);
    binormal = CGAL::cross_product(tangent, radial);
    binormal /= std::sqrt(binormal.squared_length());
    return Point(radius * std::cos(angle), radius * std::sin(angle), rise * t);
  };
  Vector radial, binormal;
  for(std::size_t k = 0; k < rings; ++k) {
    const Point centre = frame(double(k) / (n_along - 1), radial, binormal);
    for(std::size_t i = 0; i < n; ++i) {
      const double angle = 2 * pi * double(i) / n_around;
      soup.points.push_back(centre + std::cos(angle) * radial + std::sin(angle) * binormal);
    }
  }
  soup.points.push_back(frame(-1. / n_along, radial, binormal));
  soup.points.push_back(frame(1 + 1. / n_along, radial, binormal));
  const std::size_t first = soup.points.size() - 2, last = first + 1;
  for(std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    soup.faces.push_back({first, i, j});
    for(std::size_t k = 0; k + 1 < rings; ++k)
      soup.faces.insert(soup.faces.end(),
                        {{k * n + i, (k + 1) * n + i, k * n + j}, {k * n + j, (k + 1) * n + i, (k + 1) * n + j}});
    soup.faces.push_back({last, (rings - 1) * n + j, (rings - 1) * n + i});
  }
  return soup;
}

Soup comb(int teeth, int length)
{
  std::set<std::array<int, 3>> cells;
  for(int x = 0; x < 2 * teeth - 1; ++x)
    for(int y = 0; y <= (x % 2 == 0 ? length : 0); ++y)
      cells.insert({x, y, 0});
  return triangulated(cubes(cells));
}

Soup tree(int depth)
{
  std::set<std::array<int, 3>> cells;
  const std::function<void(std::array<int, 3>, int)> grow = [&](std::array<int, 3> root, int level) {
    if(level == depth)
      return;
    for(int sign : {-1, 1}) {
      std::array<int, 3> tip = root;
      for(int i = 0; i <= 4 << ((5 - level) / 2); ++i, tip[level % 2] += sign)
        cells.insert(tip);
      tip[level % 2] -= sign;
      grow(tip, level + 1);
    }
  };
  grow({0, 0, 0}, 0);
  return triangulated(cubes(cells));
}

Soup bipyramid(int n)
{
  const std::size_t un = std::size_t(n);
  Soup soup;
  for(int i = 0; i < n; ++i)
    soup.points.emplace_back(std::cos(2 * pi * i / n), std::sin(2 * pi * i / n), 0);
  soup.points.emplace_back(0, 0, 1);
  soup.points.emplace_back(0, 0, -1);
  for(std::size_t i = 0; i < un; ++i)
    soup.faces.insert(soup.faces.end(), {{i, (i + 1) % un, un}, {(i + 1) % un, i, un + 1}});
  return soup;
}

Soup needles(int level, double epsilon)
{
  const Soup coarse = bumpy_sphere(level);
  Soup soup;
  soup.points = coarse.points;
  for(std::size_t f = 0; f < coarse.faces.size(); ++f) {
    const auto& t = coarse.faces[f];
    if(f % 3 != 0) {
      soup.faces.push_back(t);
      continue;
    }
    const std::size_t m = soup.points.size();
    const Vector inwards = CGAL::midpoint(soup.points[t[1]], soup.points[t[2]]) - soup.points[t[0]];
    soup.points.push_back(soup.points[t[0]] + epsilon * inwards);
    soup.faces.insert(soup.faces.end(), {{t[0], t[1], m}, {t[1], t[2], m}, {t[2], t[0], m}});
  }
  return soup;
}

Body_with_limbs body_with_limbs(const std::vector<Limb>& limbs, int level)
{
  const auto unit = [](const Vector& v) { return v / std::sqrt(v.squared_length()); };
  const auto angle = [](const Vector& a, const Vector& b) { return std::acos(std::max(-1., std::min(1., a * b))); };
  const Soup sphere = icosphere(level);
  Body_with_limbs body;
  for(const auto& f : sphere.faces) {
    const Vector middle =
      unit(CGAL::centroid(sphere.points[f[0]], sphere.points[f[1]], sphere.points[f[2]]) - CGAL::ORIGIN);
    body.part.push_back(0);
    for(std::size_t k = 0; k < limbs.size(); ++k)
      if(angle(middle, unit(limbs[k].direction)) < limbs[k].reach)
        body.part.back() = k + 1;
  }
  body.soup = transformed(sphere, [&](const Point& p) {
    const Vector x = p - CGAL::ORIGIN;
    for(const Limb& limb : limbs) {
      const Vector d = unit(limb.direction);
      const double at = angle(x, d), radius = std::sin(limb.reach), root = std::cos(limb.reach);
      if(at >= limb.reach)
        continue;
      if(at == 0)
        return CGAL::ORIGIN + (root + limb.length + radius) * d;
      const Vector side = (x - (x * d) * d) / std::sin(at);
      const double end = radius * pi / 2, s = at / limb.reach * (end + limb.length); // along the profile, from the tip
      return s < end ? CGAL::ORIGIN + (root + limb.length + radius * std::cos(s / radius)) * d +
                         radius * std::sin(s / radius) * side
                     : CGAL::ORIGIN + (root + limb.length + end - s) * d + radius * side;
    }
    return p;
  });
  return body;
}

const std::vector<Vector>& six_directions()
{
  static const std::vector<Vector> all = {{1, 0.1, 0},  {-1, 0.1, 0.1}, {0, 1, 0.1},
                                          {0.1, -1, 0}, {0.1, 0, 1},    {0, 0.1, -1}};
  return all;
}

Soup torus(int n, int m)
{
  Soup soup;
  const std::size_t un = std::size_t(n), um = std::size_t(m);
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < m; ++j) {
      const double u = 2 * pi * i / n, v = 2 * pi * j / m, r = 2 + std::cos(v);
      soup.points.emplace_back(r * std::cos(u), r * std::sin(u), std::sin(v));
    }
  for(std::size_t i = 0; i < un; ++i)
    for(std::size_t j = 0; j < um; ++j) {
      const std::size_t i1 = (i + 1) % un, j1 = (j + 1) % um;
      const std::size_t a = i * um + j, b = i1 * um + j, c = i1 * um + j1, d = i * um + j1;
      soup.faces.insert(soup.faces.end(), {{a, b, c}, {a, c, d}});
    }
  return soup;
}

Soup double_torus()
{
  std::set<std::array<int, 3>> cells;
  for(int x = 0; x < 5; ++x)
    for(int y = 0; y < 3; ++y)
      if(y != 1 || x % 2 == 0)
        cells.insert({x, y, 0});
  return triangulated(cubes(cells));
}

Soup open_sphere(int level)
{
  Soup soup = icosphere(level);
  auto touches = [](const std::vector<std::size_t>& f) { return std::find(f.begin(), f.end(), 0) != f.end(); };
  soup.faces.erase(std::remove_if(soup.faces.begin(), soup.faces.end(), touches), soup.faces.end());
  for(auto& face : soup.faces)
    for(std::size_t& i : face)
      --i;
  soup.points.erase(soup.points.begin());
  return soup;
}

Soup inside_out(Soup soup)
{
  for(auto& face : soup.faces)
    std::swap(face[0], face[1]);
  return soup;
}

Soup joined(Soup soup, const Soup& other, const Vector& shift)
{
  const std::size_t n = soup.points.size();
  for(const Point& p : other.points)
    soup.points.push_back(p + shift);
  for(auto face : other.faces) {
    for(std::size_t& i : face)
      i += n;
    soup.faces.push_back(face);
  }
  return soup;
}

Soup two_spheres() { return joined(icosphere(1), icosphere(2), Vector(3, 0, 0)); }

Soup isolated_vertex()
{
  Soup soup = icosphere(1);
  soup.points.emplace_back(2, 0, 0);
  return soup;
}

Soup quad_cube() { return cubes({{0, 0, 0}}); }

Soup nan_coordinate()
{
  Soup soup = icosphere(1);
  soup.points[5] = Point(0, std::numeric_limits<double>::quiet_NaN(), 0);
  return soup;
}

Soup infinite_coordinate()
{
  Soup soup = icosphere(1);
  soup.points[7] = Point(0, 0, -std::numeric_limits<double>::infinity());
  return soup;
}

Mesh hourglass()
{
  Mesh mesh = make_mesh(two_spheres());
  glue(mesh, Mesh::Vertex_index(0), Mesh::Vertex_index(mesh.number_of_vertices() - 1));
  return mesh;
}

Mesh pinched_sphere()
{
  Mesh mesh = make_mesh(icosphere(2));
  glue(mesh, Mesh::Vertex_index(0), Mesh::Vertex_index(3)); // opposite ends of a diameter
  return mesh;
}

Soup collinear_face()
{
  Soup soup = flat_octahedron(3);
  const auto& f = soup.faces[0];
  soup.points[f[0]] = CGAL::midpoint(soup.points[f[1]], soup.points[f[2]]);
  return soup;
}

Soup coincident_points()
{
  Soup soup = flat_octahedron(3);
  const auto& f = soup.faces[0];
  soup.points[f[0]] = soup.points[f[1]];
  return soup;
}

Soup many_coincident_points(int level)
{
  Soup soup = bumpy_sphere(level);
  for(std::size_t f = 0; f < soup.faces.size(); f += 10)
    soup.points[soup.faces[f][0]] = soup.points[soup.faces[f][1]];
  return soup;
}

Soup one_point(int level)
{
  return transformed(icosphere(level), [](const Point&) { return Point(1, 2, 3); });
}

Soup transformed(Soup soup, const std::function<Point(const Point&)>& f)
{
  std::transform(soup.points.begin(), soup.points.end(), soup.points.begin(), f);
  return soup;
}

Soup renumbered(const Soup& soup, unsigned seed, std::vector<std::size_t>& order)
{
  std::mt19937 random(seed);
  order.resize(soup.points.size());
  for(std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  std::shuffle(order.begin(), order.end(), random);
  std::vector<std::size_t> new_number(order.size());
  Soup result;
  for(std::size_t i = 0; i < order.size(); ++i) {
    new_number[order[i]] = i;
    result.points.push_back(soup.points[order[i]]);
  }
  for(auto face : soup.faces) {
    for(std::size_t& i : face)
      i = new_number[i];
    std::rotate(face.begin(), face.begin() + std::ptrdiff_t(random() % face.size()), face.end());
    result.faces.push_back(face);
  }
  std::shuffle(result.faces.begin(), result.faces.end(), random);
  return result;
}

std::array<Vector, 3> random_rotation(unsigned seed)
{
  // a uniformly distributed unit quaternion
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  double q[4], square = 0;
  for(double& x : q) {
    x = normal(random);
    square += x * x;
  }
  for(double& x : q)
    x /= std::sqrt(square);
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  return {Vector(1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
          Vector(2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
          Vector(2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y))};
}

Point apply(const std::array<Vector, 3>& rows, const Point& p)
{
  const Vector v = p - CGAL::ORIGIN;
  return Point(rows[0] * v, rows[1] * v, rows[2] * v);
}

} // namespace test
