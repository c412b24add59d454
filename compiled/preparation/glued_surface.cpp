// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include <CGAL/Spherical_parameterization/preparation/glued_surface.h>

#include "preparation/points.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace CGAL::Spherical_parameterization::preparation {
namespace {

/// Cuts the face of a side in two, from the middle of the side to the opposite corner. The side keeps its first half,
/// the second is returned. \pre the side is glued to nothing
int split_face(Glued_surface& surface, int side, int middle)
{
  const int face = side / 3, next = Glued_surface::next(side), before = surface.twin_of(next);
  const int b = surface.target(side), c = surface.target(next);
  const int added = surface.add_face({middle, b, c}, surface.old_face[place(face)]);
  surface.faces[place(face)][place(next % 3)] = middle;
  surface.twin[place(next)] = Glued_surface::none;
  if(before != Glued_surface::none)
    surface.glue(3 * added + 1, before);
  surface.glue(3 * added + 2, next);
  return 3 * added;
}

/// Not where a face is glued to itself: that face has a side with one end vertex, and comes apart when this is split.
void split_edge(Glued_surface& surface, int side)
{
  if(surface.twin_of(side) / 3 == side / 3 && surface.twin_of(side) != Glued_surface::none)
    return;
  const Glued_surface::Point a = surface.point(surface.origin(side)), b = surface.point(surface.target(side));
  const int middle = surface.add_vertex({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2});
  const int twin = surface.twin_of(side);
  if(twin == Glued_surface::none) {
    split_face(surface, side, middle);
    return;
  }
  surface.unglue(side);
  const int second = split_face(surface, side, middle);
  const int second_of_twin = split_face(surface, twin, middle);
  surface.glue(side, second_of_twin);
  surface.glue(second, twin);
}

} // namespace

double Glued_surface::length(int side) const { return norm(minus(point(target(side)), point(origin(side)))); }

double Glued_surface::area(int face) const
{
  const auto& [a, b, c] = faces[place(face)];
  return norm(cross(minus(point(b), point(a)), minus(point(c), point(a)))) / 2;
}

void Glued_surface::glue(int side, int other)
{
  twin[place(side)] = other;
  twin[place(other)] = side;
}

void Glued_surface::unglue(int side)
{
  twin[place(twin_of(side))] = none;
  twin[place(side)] = none;
}

int Glued_surface::add_vertex(const Point& point)
{
  points.push_back(point);
  old_vertex.push_back(none);
  return number_of_vertices() - 1;
}

int Glued_surface::add_face(const std::array<int, 3>& corners, int its_old_face)
{
  faces.push_back(corners);
  twin.insert(twin.end(), 3, none);
  old_face.push_back(its_old_face);
  return number_of_faces() - 1;
}

namespace {

/// The places of elements in the order of those of the file, given by number; copies and what is new come last.
std::vector<int> places_in_order(std::vector<int> old)
{
  std::vector<bool> is_known(old.empty() ? 0 : place(*std::max_element(old.begin(), old.end()) + 1));
  for(int& number : old)
    if(number == Glued_surface::none || is_known[place(number)])
      number = (std::numeric_limits<int>::max)();
    else
      is_known[place(number)] = true;
  std::vector<int> order(old.size()), places(old.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&old](int a, int b) { return old[place(a)] < old[place(b)]; });
  for(std::size_t i = 0; i < order.size(); ++i)
    places[place(order[i])] = static_cast<int>(i);
  return places;
}

} // namespace

Glued_surface joined(const std::vector<Glued_surface>& parts)
{
  if(parts.size() == 1)
    return parts.front();
  std::vector<int> old_vertex, old_face;
  for(const Glued_surface& part : parts) {
    old_vertex.insert(old_vertex.end(), part.old_vertex.begin(), part.old_vertex.end());
    old_face.insert(old_face.end(), part.old_face.begin(), part.old_face.end());
  }
  const std::vector<int> vertex = places_in_order(old_vertex), face = places_in_order(old_face);
  Glued_surface all;
  all.points.resize(vertex.size());
  all.old_vertex.resize(vertex.size());
  all.faces.resize(face.size());
  all.old_face.resize(face.size());
  all.twin.assign(3 * face.size(), Glued_surface::none);
  std::size_t first_vertex = 0, first_face = 0;
  for(const Glued_surface& part : parts) {
    const auto vertex_of = [&](int v) { return place(vertex[first_vertex + place(v)]); };
    const auto face_of = [&](int f) { return face[first_face + place(f)]; };
    for(int v = 0; v < part.number_of_vertices(); ++v) {
      all.points[vertex_of(v)] = part.points[place(v)];
      all.old_vertex[vertex_of(v)] = part.old_vertex[place(v)];
    }
    for(int f = 0; f < part.number_of_faces(); ++f) {
      for(int k = 0; k < 3; ++k) {
        all.faces[place(face_of(f))][place(k)] = static_cast<int>(vertex_of(part.faces[place(f)][place(k)]));
        if(const int twin = part.twin_of(3 * f + k); twin != Glued_surface::none)
          all.twin[place(3 * face_of(f) + k)] = 3 * face_of(twin / 3) + twin % 3;
      }
      all.old_face[place(face_of(f))] = part.old_face[place(f)];
    }
    first_vertex += part.points.size();
    first_face += part.faces.size();
  }
  return all;
}

void derive_vertices(Glued_surface& surface)
{
  // corners that are one vertex: the smallest of them stands for all
  std::vector<int> first_of(surface.twin.size(), Glued_surface::none);
  for(int first = 0; first < surface.number_of_sides(); ++first) {
    int corner = first;
    for(; corner != Glued_surface::none && first_of[place(corner)] == Glued_surface::none;
        corner = surface.twin_of(Glued_surface::previous(corner)))
      first_of[place(corner)] = first;
    if(corner == Glued_surface::none) // at a boundary: others are beyond the side that begins at the first
      for(int twin = surface.twin_of(first); twin != Glued_surface::none;
          twin = surface.twin_of(Glued_surface::next(twin)))
        first_of[place(Glued_surface::next(twin))] = first;
  }

  // every class takes the first of its vertices; the first class that does so keeps it, others get copies
  std::vector<int> vertex_of_class(surface.twin.size(), Glued_surface::none);
  for(int c = 0; c < surface.number_of_sides(); ++c) {
    int& vertex = vertex_of_class[place(first_of[place(c)])];
    vertex = vertex == Glued_surface::none ? surface.origin(c) : std::min(vertex, surface.origin(c));
  }
  std::vector<bool> is_taken(surface.points.size(), false);
  for(int c = 0; c < surface.number_of_sides(); ++c) {
    if(first_of[place(c)] != c)
      continue;
    const int vertex = vertex_of_class[place(c)];
    if(is_taken[place(vertex)]) {
      vertex_of_class[place(c)] = surface.add_vertex(Glued_surface::Point(surface.point(vertex)));
      surface.old_vertex.back() = surface.old_vertex[place(vertex)];
    } else
      is_taken[place(vertex)] = true;
  }
  is_taken.resize(surface.points.size(), true);

  std::vector<int> number(surface.points.size(), Glued_surface::none);
  int count = 0;
  for(int v = 0; v < surface.number_of_vertices(); ++v)
    if(is_taken[place(v)]) {
      surface.points[place(count)] = Glued_surface::Point(surface.point(v));
      surface.old_vertex[place(count)] = surface.old_vertex[place(v)];
      number[place(v)] = count++;
    }
  surface.points.resize(place(count));
  surface.old_vertex.resize(place(count));
  for(int c = 0; c < surface.number_of_sides(); ++c)
    surface.faces[place(c / 3)][place(c % 3)] = number[place(vertex_of_class[place(first_of[place(c)])])];
}

std::vector<std::vector<int>> boundary_cycles(const Glued_surface& surface)
{
  std::vector<std::vector<int>> cycles;
  std::vector<bool> is_done(surface.twin.size(), false);
  for(int first = 0; first < surface.number_of_sides(); ++first) {
    if(surface.twin_of(first) != Glued_surface::none || is_done[place(first)])
      continue;
    cycles.emplace_back();
    int side = first;
    do {
      is_done[place(side)] = true;
      cycles.back().push_back(side);
      side = Glued_surface::next(side);
      while(surface.twin_of(side) != Glued_surface::none)
        side = Glued_surface::next(surface.twin_of(side));
    } while(side != first);
  }
  return cycles;
}

std::vector<Component> components(const Glued_surface& surface, std::vector<int>& component_of)
{
  std::vector<Component> result;
  component_of.assign(surface.faces.size(), Glued_surface::none);
  std::vector<int> stack;
  for(int first = 0; first < surface.number_of_faces(); ++first) {
    if(component_of[place(first)] != Glued_surface::none)
      continue;
    const int number = static_cast<int>(result.size());
    Component component;
    component.first_face = first;
    const Glued_surface::Point centre = surface.point(surface.faces[place(first)][0]); // so that digits do not cancel
    stack.assign(1, first);
    component_of[place(first)] = number;
    while(!stack.empty()) {
      const int f = stack.back();
      stack.pop_back();
      ++component.faces;
      component.area += surface.area(f);
      const auto& [a, b, c] = surface.faces[place(f)];
      const Glued_surface::Point n = cross(minus(surface.point(a), centre), minus(surface.point(b), centre));
      const Glued_surface::Point p = minus(surface.point(c), centre);
      component.volume += dot(n, p) / 6;
      for(int side = 3 * f; side < 3 * f + 3; ++side) {
        const int twin = surface.twin_of(side);
        if(twin == Glued_surface::none || twin > side)
          --component.euler_characteristic; // an edge
        if(twin != Glued_surface::none && component_of[place(twin / 3)] == Glued_surface::none) {
          component_of[place(twin / 3)] = number;
          stack.push_back(twin / 3);
        }
      }
    }
    component.euler_characteristic += component.faces;
    result.push_back(component);
  }
  std::vector<int> component_of_vertex(surface.points.size(), Glued_surface::none);
  for(int f = 0; f < surface.number_of_faces(); ++f)
    for(const int v : surface.faces[place(f)])
      component_of_vertex[place(v)] = component_of[place(f)];
  for(const int c : component_of_vertex)
    if(c != Glued_surface::none)
      ++result[place(c)].euler_characteristic;
  for(const std::vector<int>& cycle : boundary_cycles(surface))
    ++result[place(component_of[place(cycle.front() / 3)])].holes;
  return result;
}

std::size_t split_parallel_edges(Glued_surface& surface)
{
  std::size_t split = 0;
  for(;;) {
    std::vector<std::pair<std::pair<int, int>, int>> edges; // end vertices, and a side
    for(int side = 0; side < surface.number_of_sides(); ++side)
      if(surface.twin_of(side) < side)
        edges.emplace_back(std::minmax(surface.origin(side), surface.target(side)), side);
    std::sort(edges.begin(), edges.end());
    std::vector<int> to_split;
    for(std::size_t i = 0; i < edges.size(); ++i) {
      const auto& [ends, side] = edges[i];
      if(ends.first == ends.second || (i > 0 && edges[i - 1].first == ends))
        to_split.push_back(side);
    }
    // two triangles back to back are no surface that can be told from its vertices
    const bool has_others = !to_split.empty();
    for(int f = 0; f < surface.number_of_faces() && !has_others; ++f)
      if(const int g = surface.twin_of(3 * f) / 3;
         f < g && surface.twin_of(3 * f + 1) / 3 == g && surface.twin_of(3 * f + 2) / 3 == g)
        to_split.push_back(3 * f);
    if(to_split.empty())
      return split;
    for(const int side : to_split)
      split_edge(surface, side);
    split += to_split.size();
  }
}

} // namespace CGAL::Spherical_parameterization::preparation
