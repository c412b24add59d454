// SPDX-License-Identifier: GPL-3.0-or-later
// Every closed triangle mesh of genus 0 with 100 vertices or more among the data files of CGAL (Debian package
// libcgal-demo), with all weights: valid. The files are found at run time; which of them count is decided here, from
// their faces alone.

#include "helpers/check.h"

#include <CGAL/IO/polygon_soup_io.h>

#include <catch2/catch.hpp>

#include <filesystem>
#include <iostream>
#include <map>
#include <numeric>

using namespace test;

namespace {

/// All faces triangles, every edge shared by two of them in opposite senses, one disk of faces round every vertex, one
/// component, Euler characteristic 2.
bool is_triangulated_sphere(const Soup& soup)
{
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> next; // directed edge (v, a): the corner after v, a
  for(const auto& f : soup.faces) {
    if(f.size() != 3)
      return false;
    for(std::size_t k = 0; k < 3; ++k)
      if(f[k] == f[(k + 1) % 3] || !next.emplace(std::pair(f[k], f[(k + 1) % 3]), f[(k + 2) % 3]).second)
        return false;
  }
  std::vector<std::size_t> degree(soup.points.size(), 0), some_neighbour(soup.points.size()), component(degree.size());
  std::iota(component.begin(), component.end(), 0);
  auto root = [&](std::size_t i) {
    while(component[i] != i)
      i = component[i] = component[component[i]];
    return i;
  };
  for(const auto& [edge, corner] : next) {
    if(next.count({edge.second, edge.first}) == 0)
      return false;
    ++degree[edge.first];
    some_neighbour[edge.first] = edge.second;
    component[root(edge.first)] = root(edge.second);
  }
  for(std::size_t v = 0; v < soup.points.size(); ++v) {
    if(degree[v] == 0 || root(v) != root(0))
      return false;
    std::size_t walked = 0, a = some_neighbour[v];
    do {
      a = next.at({v, a});
      ++walked;
    } while(a != some_neighbour[v]);
    if(walked != degree[v])
      return false;
  }
  return soup.points.size() + soup.faces.size() == next.size() / 2 + 2;
}

struct Named_soup {
  std::string name;
  Soup soup;
};

std::vector<Named_soup> demo_meshes()
{
  std::vector<Named_soup> meshes;
  std::error_code no_folder;
  for(const auto& file : std::filesystem::directory_iterator(CGAL_DEMO_MESHES, no_folder)) {
    Named_soup mesh;
    mesh.name = file.path().filename().string();
    if(CGAL::IO::read_polygon_soup(file.path().string(), mesh.soup.points, mesh.soup.faces) &&
       mesh.soup.points.size() >= 100 && is_triangulated_sphere(mesh.soup))
      meshes.push_back(std::move(mesh));
  }
  std::sort(meshes.begin(), meshes.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return meshes;
}

void check_all(Weights weights)
{
  const std::vector<Named_soup> meshes = demo_meshes();
  if(meshes.empty()) {
    std::cout << "SKIPPED: no meshes in '" << CGAL_DEMO_MESHES
              << "'; install the Debian package libcgal-demo and configure again" << std::endl;
    return;
  }
  CHECK(meshes.size() >= 30); // 34 in CGAL 5.5
  Settings settings;
  settings.weights = weights;
  for(const auto& [name, soup] : meshes) {
    Sphere sphere;
    const Result result = solve(soup, sphere, settings);
    CAPTURE(name, soup.points.size(), result);
    CHECK(result);
    CHECK(count_flipped_faces(soup, sphere) == 0);
    CHECK(degree(soup, sphere) == 1);
    if(weights != Weights::CONFORMAL) // whose springs the checks do not know
      check_certificate(result, soup, sphere, settings);
  }
}

} // namespace

TEST_CASE("all closed genus-0 meshes of libcgal-demo, barycentric weights", "[demo_meshes]")
{
  check_all(Weights::BARYCENTRIC);
}

TEST_CASE("all closed genus-0 meshes of libcgal-demo, clamped weights", "[demo_meshes]")
{
  check_all(Weights::CLAMPED);
}

TEST_CASE("all closed genus-0 meshes of libcgal-demo, conformal weights", "[demo_meshes]")
{
  check_all(Weights::CONFORMAL);
}
