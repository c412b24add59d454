// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_CHECK_SOUP_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_CHECK_SOUP_IMPL_H

#include <CGAL/Spherical_parameterization/internal/text/text.h>
#include <CGAL/Spherical_parameterization/internal/surface/breadth_first.h>
#include <CGAL/Spherical_parameterization/internal/surface/check_soup.h>
#include <CGAL/Spherical_parameterization/internal/surface/match_halfedges.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/pending/disjoint_sets.hpp>

#include <array>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

CGAL_SP_INLINE void add_edge_troubles(Soup_trouble& trouble, const Matching_troubles& edges, int n,
                                      const std::function<std::size_t()>& number_of_different_points)
{
  const auto first = [](const Edge_trouble& t) {
    return " (first: between vertices " + std::to_string(t.first.first) + " and " + std::to_string(t.first.second) +
           ")";
  };
  if(edges.crowded.count > 0)
    trouble.add(Error_code::NON_MANIFOLD,
                counted(edges.crowded.count, "edge", "edges") + " with more than two faces" + first(edges.crowded),
                "repair the mesh so that every edge has two faces");
  if(edges.opposed.count > 0)
    trouble.add(Error_code::INCONSISTENT_ORIENTATION,
                counted(edges.opposed.count, "edge", "edges") + " between faces of opposite orientation" +
                  first(edges.opposed),
                "orient the faces consistently (if the surface has two sides)");
  if(edges.boundary.count > 0) {
    std::string wrong = counted(edges.boundary.count, "boundary edge", "boundary edges") + first(edges.boundary);
    std::string remedy = "close the holes: only closed surfaces can be mapped to the sphere";
    // holes between vertices at the same place: a set of single triangles, or a seam, rather than an open surface
    const std::size_t different = number_of_different_points();
    if(different < static_cast<std::size_t>(n)) {
      wrong += " and only " + std::to_string(different) + " different points for " + std::to_string(n) + " vertices";
      remedy = "merge the vertices that are at the same place, then close the holes that are left";
    }
    trouble.add(Error_code::BOUNDARY, wrong, remedy);
  }
}

CGAL_SP_INLINE std::size_t number_of_components(const Host_array<std::array<int, 3>>& face, int n)
{
  boost::disjoint_sets_with_storage<> sets(n);
  for(const std::array<int, 3>& f : face)
    for(int k : {1, 2})
      sets.union_set(f[0], f[k]);
  typedef boost::counting_iterator<std::size_t> Vertex;
  return static_cast<std::size_t>(sets.count_sets(Vertex(0), Vertex(n)));
}

CGAL_SP_CORE Checked_soup check_soup(const Host_loop& loop, Corner_table& table, int n,
                                     const std::function<std::size_t()>& number_of_different_points)
{
  Checked_soup result;
  Soup_trouble& trouble = result.trouble;
  const int m = static_cast<int>(table.face.size());
  if(m == 0) {
    trouble.add(Error_code::EMPTY_MESH, "no faces", "check that the mesh was exported");
    return result;
  }
  const auto repeats = [&](int f) {
    const auto [a, b, c] = table.face[f];
    return a == b || b == c || c == a;
  };
  const int first_repeating = first_index(loop, m, repeats);
  if(first_repeating < m) {
    std::size_t count = 0;
    for(int f = first_repeating; f < m; ++f)
      count += repeats(f);
    trouble.add(Error_code::DEGENERATE_FACE,
                counted(count, "face that has a vertex twice", "faces that have a vertex twice") + " (first: face " +
                  std::to_string(first_repeating) + ")",
                "remove the degenerate faces");
    return result; // the rest presumes triangles
  }

  Vertex_walks walks;
  const Matching_troubles found = match_halfedges(loop, table.face, n, table.twin, &walks);
  const std::size_t isolated = found.isolated.count;
  if(isolated > 0)
    trouble.add(Error_code::ISOLATED_VERTEX,
                counted(isolated, "isolated vertex", "isolated vertices") + " without faces (first: vertex " +
                  std::to_string(found.isolated.first) + ")",
                "remove the unreferenced vertices");
  add_edge_troubles(trouble, found, n, number_of_different_points);
  const bool is_pinched = !found.has_bad_edge() && found.pinched.count > 0;
  if(is_pinched)
    trouble.add(Error_code::NON_MANIFOLD,
                counted(found.pinched.count, "non-manifold vertex", "non-manifold vertices") +
                  ", where parts of the surface only touch (first: vertex " + std::to_string(found.pinched.first) + ")",
                "split such vertices");
  std::size_t components = 0;
  if(found.none())
    result.breadth_first = breadth_first_order(walks.neighbours, components);
  else
    components = number_of_components(table.face, n) - isolated;
  // V - E + F = 2 - 2 genus, and E = 3/2 F
  const std::size_t genus = (table.face.size() / 2 + 2 - (n - isolated)) / 2;
  if(components > 1)
    trouble.add(Error_code::SEVERAL_COMPONENTS, std::to_string(components) + " connected components",
                "map them one by one, each from a file of its own");
  else if(!found.has_bad_edge() && !is_pinched && genus > 0)
    trouble.add(Error_code::WRONG_GENUS, "genus " + std::to_string(genus),
                "only surfaces without handles (genus 0) can be mapped to the sphere: cut and fill the handles");
  result.last_corner = std::move(walks.last_corner);
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_CHECK_SOUP_IMPL_H
