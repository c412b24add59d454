// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "input/soup_checks.h"

#include "system/error_code_names.h"
#include "system/refusal.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tool {
namespace {

std::string counted(std::size_t count, const std::string& singular, const std::string& plural)
{
  return std::to_string(count) + ' ' + (count == 1 ? singular : plural);
}

/// What is wrong with a soup. The first trouble found gives the advice and the code.
class Troubles {
public:
  void add(Error_code code, const std::string& wrong, const std::string& remedy)
  {
    if(wrong_.empty()) {
      code_ = code;
      remedy_ = remedy;
    } else
      wrong_ += ", ";
    wrong_ += wrong;
  }

  bool none() const { return wrong_.empty(); }

  void refuse_if_any(const std::string& file) const
  {
    if(!none())
      throw Refusal(name(code_), file, "has " + wrong_, remedy_);
  }

private:
  Error_code code_ = Error_code::OK;
  std::string wrong_;
  std::string remedy_;
};

void check_faces(const Polygon_soup& soup, Troubles& troubles)
{
  std::size_t polygons = 0;
  std::size_t repeating = 0;
  std::size_t first_polygon = 0;
  std::size_t first_repeating = 0;
  for(std::size_t f = soup.polygons.size(); f-- > 0;) {
    const Polygon& p = soup.polygons[f];
    if(p.size() > 3) {
      ++polygons;
      first_polygon = f;
    } else if(p[0] == p[1] || p[1] == p[2] || p[2] == p[0]) {
      ++repeating;
      first_repeating = f;
    }
  }
  if(polygons > 0)
    troubles.add(Error_code::NOT_TRIANGULAR,
                 counted(polygons, "face that is not a triangle", "faces that are not triangles") + " (first: face " +
                   std::to_string(first_polygon) + " with " + std::to_string(soup.polygons[first_polygon].size()) +
                   " vertices)",
                 "triangulate the mesh, or use --triangulate");
  if(repeating > 0)
    troubles.add(Error_code::DEGENERATE_FACE,
                 counted(repeating, "face that has a vertex twice", "faces that have a vertex twice") +
                   " (first: face " + std::to_string(first_repeating) + ")",
                 "remove the degenerate faces");
}

/// Returns how many there are.
std::size_t check_isolated_vertices(const Polygon_soup& soup, Troubles& troubles)
{
  std::vector<bool> is_used(soup.points.size(), false);
  for(const Polygon& p : soup.polygons)
    for(std::uint32_t v : p)
      is_used[v] = true;
  const auto isolated = static_cast<std::size_t>(std::count(is_used.begin(), is_used.end(), false));
  if(isolated > 0)
    troubles.add(Error_code::ISOLATED_VERTEX,
                 counted(isolated, "isolated vertex", "isolated vertices") + " without faces (first: vertex " +
                   std::to_string(std::find(is_used.begin(), is_used.end(), false) - is_used.begin()) + ")",
                 "remove the unreferenced vertices");
  return isolated;
}

std::size_t number_of_different_points(std::vector<Point> points)
{
  std::sort(points.begin(), points.end());
  return static_cast<std::size_t>(std::unique(points.begin(), points.end()) - points.begin());
}

void add_boundary(const std::string& edges, const Polygon_soup& soup, Troubles& troubles)
{
  // holes between vertices at the same place: a set of single triangles, or a seam, rather than an open surface
  const std::size_t different = number_of_different_points(soup.points);
  if(different < soup.points.size())
    troubles.add(Error_code::BOUNDARY,
                 edges + " and only " + std::to_string(different) + " distinct points for " +
                   std::to_string(soup.points.size()) + " vertices",
                 "merge the vertices with equal coordinates, then close the remaining holes");
  else
    troubles.add(Error_code::BOUNDARY, edges, "close the holes: only closed surfaces can be mapped to the sphere");
}

/// Counts the edges by the number and the directions of their faces. Sorted 64-bit words instead of a hash map, since
/// this decides how much memory reading takes. Returns whether the surface is closed and oriented.
bool check_edges(const Polygon_soup& soup, Troubles& troubles)
{
  std::vector<std::uint64_t> half_edges; // smaller end, larger end, and one bit for the direction
  half_edges.reserve(3 * soup.polygons.size());
  for(const Polygon& p : soup.polygons)
    for(std::size_t i = 0; i < 3; ++i) {
      const std::uint64_t a = p[i];
      const std::uint64_t b = p[(i + 1) % 3];
      half_edges.push_back(a < b ? (a << 32 | b << 1) : (b << 32 | a << 1 | 1));
    }
  std::sort(half_edges.begin(), half_edges.end());

  std::size_t crowded = 0;
  std::size_t opposed = 0;
  std::size_t boundary = 0;
  std::uint64_t first_crowded = 0;
  std::uint64_t first_opposed = 0;
  std::uint64_t first_boundary = 0;
  const auto count = [](std::size_t& counter, std::uint64_t& first, std::uint64_t edge) {
    if(counter++ == 0)
      first = edge;
  };
  for(std::size_t begin = 0, end = 0; begin < half_edges.size(); begin = end) {
    const std::uint64_t edge = half_edges[begin] >> 1;
    while(end < half_edges.size() && half_edges[end] >> 1 == edge)
      ++end;
    if(end - begin > 2)
      count(crowded, first_crowded, edge);
    else if(end - begin == 1)
      count(boundary, first_boundary, edge);
    else if(half_edges[begin] == half_edges[begin + 1])
      count(opposed, first_opposed, edge);
  }

  const auto first = [](std::uint64_t edge) {
    return " (first: between vertices " + std::to_string(edge >> 31) + " and " +
           std::to_string(edge & ((std::uint64_t(1) << 31) - 1)) + ")";
  };
  if(crowded > 0)
    troubles.add(Error_code::NON_MANIFOLD,
                 counted(crowded, "edge", "edges") + " with more than two faces" + first(first_crowded),
                 "repair the mesh so that every edge has two faces");
  if(opposed > 0)
    troubles.add(Error_code::INCONSISTENT_ORIENTATION,
                 counted(opposed, "edge", "edges") + " between faces of opposite orientation" + first(first_opposed),
                 "orient the faces consistently, if the surface is orientable");
  if(boundary > 0)
    add_boundary(counted(boundary, "boundary edge", "boundary edges") + first(first_boundary), soup, troubles);
  return crowded == 0 && opposed == 0 && boundary == 0;
}

/// The faces round a vertex of a closed oriented surface form one cycle; returns whether they do.
bool check_vertices(const Polygon_soup& soup, Troubles& troubles)
{
  using Arc = std::pair<std::uint32_t, std::uint32_t>; // of the link of a vertex: the two other vertices of a face
  std::vector<std::uint32_t> begin(soup.points.size() + 1, 0);
  for(const Polygon& p : soup.polygons)
    for(std::uint32_t v : p)
      ++begin[v];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Arc> arcs(3 * soup.polygons.size());
  for(const Polygon& p : soup.polygons)
    for(std::size_t i = 0; i < 3; ++i)
      arcs[--begin[p[i]]] = Arc(p[(i + 1) % 3], p[(i + 2) % 3]);

  std::size_t pinched = 0;
  std::size_t first_pinched = 0;
  for(std::size_t v = soup.points.size(); v-- > 0;) {
    const auto first = arcs.begin() + begin[v];
    const auto last = arcs.begin() + begin[v + 1];
    std::sort(first, last);
    if(first == last)
      continue;
    std::ptrdiff_t length = 1;
    for(auto arc = first; arc->second != first->first; ++length)
      arc = std::lower_bound(first, last, Arc(arc->second, 0));
    if(length < last - first) {
      ++pinched;
      first_pinched = v;
    }
  }
  if(pinched > 0)
    troubles.add(Error_code::NON_MANIFOLD,
                 counted(pinched, "non-manifold vertex", "non-manifold vertices") + ", where parts of the surface " +
                   "touch in a point only (first: vertex " + std::to_string(first_pinched) + ")",
                 "split these vertices");
  return pinched == 0;
}

std::size_t number_of_components(const Polygon_soup& soup)
{
  std::vector<std::uint32_t> parent(soup.points.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&parent](std::uint32_t v) {
    while(parent[v] != v)
      v = parent[v] = parent[parent[v]];
    return v;
  };
  std::size_t components = soup.points.size();
  for(const Polygon& p : soup.polygons)
    for(std::size_t i = 1; i < 3; ++i) {
      const std::uint32_t a = root(p[0]);
      const std::uint32_t b = root(p[i]);
      if(a != b) {
        parent[a] = b;
        --components;
      }
    }
  return components;
}

/// Returns the genus of a closed connected manifold: V - E + F = 2 - 2 genus, where E = 3/2 F.
std::size_t genus(std::size_t vertices, std::size_t faces) { return (faces / 2 + 2 - vertices) / 2; }

} // namespace

void check_triangulated_sphere(const std::string& file, const Polygon_soup& soup)
{
  Troubles troubles;
  if(soup.polygons.empty())
    troubles.add(Error_code::EMPTY_MESH, "no faces", "check that the mesh was exported");
  check_faces(soup, troubles);
  troubles.refuse_if_any(file); // the rest presumes triangles

  const std::size_t isolated = check_isolated_vertices(soup, troubles);
  bool is_manifold = check_edges(soup, troubles);
  is_manifold = is_manifold && check_vertices(soup, troubles);

  const std::size_t components = number_of_components(soup) - isolated;
  if(components > 1)
    troubles.add(Error_code::SEVERAL_COMPONENTS, std::to_string(components) + " connected components",
                 "write each component to its own file and map it");
  else if(is_manifold && genus(soup.points.size() - isolated, soup.polygons.size()) > 0)
    troubles.add(Error_code::WRONG_GENUS,
                 "genus " + std::to_string(genus(soup.points.size() - isolated, soup.polygons.size())),
                 "cut and fill the handles: only surfaces of genus 0 can be mapped to the sphere");
  troubles.refuse_if_any(file);
}

} // namespace tool
