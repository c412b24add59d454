// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include <CGAL/Spherical_parameterization/preparation/prepare.h>

#include "preparation/mend.h"
#include "preparation/points.h"

#include <CGAL/Spherical_parameterization/internal/text/text.h>

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace CGAL::Spherical_parameterization::preparation {
namespace {

Loop loop_of(const Glued_surface& surface, const std::vector<int>& sides)
{
  Loop loop;
  loop.edges = sides.size();
  for(const int side : sides) {
    loop.length += surface.length(side);
    if(loop.vertex == Glued_surface::none)
      loop.vertex = surface.old_vertex[place(surface.origin(side))];
  }
  return loop;
}

void fill_holes(Glued_surface& surface, Preparation& preparation, const std::function<void()>& go_on)
{
  for(const std::vector<int>& boundary : boundary_cycles(surface)) {
    go_on();
    preparation.holes.push_back(loop_of(surface, boundary));
    fill_hole(surface, boundary);
  }
  derive_vertices(surface);
}

Glued_surface wrapped(const Triangle_soup& soup, Preparation& preparation, const std::function<void()>& go_on)
{
  const double size = diagonal(soup);
  auto& used = *preparation.wrap;
  used.alpha = used.alpha.value_or(size / 50);
  used.offset = used.offset.value_or(size / 1500);
  if(!(*used.offset > 0 && *used.alpha > 0)) // the defaults, of points that are all at the same place
    throw internal::Input_error(Error_code::EMPTY_MESH, "all points at the same place", "there is nothing to wrap");
  constexpr double largest_harmless = 1e100; // whose square is a number
  if(*used.offset > largest_harmless || *used.alpha > largest_harmless)
    throw internal::Input_error(Error_code::TOO_LARGE, "a size that is nothing to that alpha or offset",
                                "give smaller ones");
  Gluing_defects none;
  Glued_surface surface = glue(wrap(soup, *used.alpha, *used.offset, go_on), 0, none, go_on);
  std::fill(surface.old_vertex.begin(), surface.old_vertex.end(), Glued_surface::none);
  std::fill(surface.old_face.begin(), surface.old_face.end(), Glued_surface::none);
  return surface;
}

/// The components, the largest first.
std::vector<Piece> pieces_of(const Glued_surface& surface, std::vector<int>& piece_of)
{
  std::vector<int> component_of;
  const std::vector<Component> found = components(surface, component_of);
  std::vector<std::size_t> order(found.size()), rank(found.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&found](std::size_t a, std::size_t b) { return found[a].area > found[b].area; });
  double area = 0;
  for(const Component& component : found)
    area += component.area;
  std::vector<Piece> pieces;
  for(const std::size_t i : order) {
    rank[i] = pieces.size();
    Piece piece;
    piece.size = found[i];
    piece.share_of_area = area > 0 ? found[i].area / area : 1. / static_cast<double>(found.size());
    piece.vertex = surface.old_vertex[place(surface.faces[place(found[i].first_face)][0])];
    pieces.push_back(piece);
  }
  piece_of.clear();
  for(const int c : component_of)
    piece_of.push_back(static_cast<int>(rank[place(c)]));
  return pieces;
}

/// The pieces that are kept, each by itself. \pre the vertices are derived: each is of one piece
std::vector<Glued_surface> separated(const Glued_surface& surface, const std::vector<Piece>& pieces,
                                     const std::vector<int>& piece_of)
{
  std::size_t kept = 0;
  while(kept < pieces.size() && pieces[kept].is_kept)
    ++kept;
  std::vector<Glued_surface> parts(kept);
  std::vector<int> piece_of_vertex(surface.points.size(), 0), vertex(surface.points.size(), Glued_surface::none),
    face(surface.faces.size(), Glued_surface::none);
  const auto is_kept = [kept](int piece) { return place(piece) < kept; };
  for(int f = 0; f < surface.number_of_faces(); ++f)
    for(const int v : surface.faces[place(f)])
      piece_of_vertex[place(v)] = piece_of[place(f)];
  for(int v = 0; v < surface.number_of_vertices(); ++v)
    if(const int piece = piece_of_vertex[place(v)]; is_kept(piece)) {
      vertex[place(v)] = parts[place(piece)].add_vertex(surface.point(v));
      parts[place(piece)].old_vertex.back() = surface.old_vertex[place(v)];
    }
  for(int f = 0; f < surface.number_of_faces(); ++f)
    if(const int piece = piece_of[place(f)]; is_kept(piece)) {
      const auto& [a, b, c] = surface.faces[place(f)];
      face[place(f)] = parts[place(piece)].add_face({vertex[place(a)], vertex[place(b)], vertex[place(c)]},
                                                    surface.old_face[place(f)]);
    }
  for(int side = 0; side < surface.number_of_sides(); ++side)
    if(const int twin = surface.twin_of(side); face[place(side / 3)] != Glued_surface::none && twin > side)
      parts[place(piece_of[place(side / 3)])].glue(3 * face[place(side / 3)] + side % 3,
                                                   3 * face[place(twin / 3)] + twin % 3);
  return parts;
}

bool is_closed(const Glued_surface& surface)
{
  return std::none_of(surface.twin.begin(), surface.twin.end(), [](int side) { return side == Glued_surface::none; });
}

/// "1 hole", "3 holes"
std::string count(std::size_t n, const std::string& what)
{
  return internal::counted(n, what.c_str(), (what + 's').c_str());
}

std::string at(int vertex) { return vertex == Glued_surface::none ? "" : ", at vertex " + std::to_string(vertex); }

std::string largest(const std::vector<Loop>& loops, const std::string& superlative)
{
  const Loop& loop = loops.front();
  return (loops.size() == 1 ? " (" : " (" + superlative + ": ") + count(loop.edges, "edge") + ", length " +
         internal::to_string(loop.length) + at(loop.vertex) + ')';
}

/// "removed 3 isolated vertices (first: vertex 17)"
void add(std::vector<std::string>& lines, const Defect& defect, const std::string& before, const char* one,
         const char* many, const std::string& after, const std::string& where)
{
  if(defect.count > 0)
    lines.push_back(before + internal::counted(defect.count, one, many) + after +
                    (defect.first == Glued_surface::none ? "" // none of the file
                                                         : std::string(" (") + (defect.count == 1 ? "" : "first: ") +
                                                             where + ' ' + std::to_string(defect.first) + ')'));
}

/// Removes faces without area, and notes it.
void remove_degenerate_faces(Glued_surface& surface, Preparation& preparation)
{
  const std::vector<int> faces = degenerate_faces(surface);
  for(const int f : faces)
    preparation.degenerate_faces.add(surface.old_face[place(f)]);
  if(!faces.empty() && (!preparation::remove_degenerate_faces(surface) || !degenerate_faces(surface).empty()))
    preparation.has_degenerate_faces = true;
}

Preparation prepare_in_unit(const Triangle_soup& soup, const Preparation_settings& settings,
                            const std::function<void()>& go_on)
{
  using Components = Preparation_settings::Components;
  Preparation result;
  Glued_surface surface = glue(soup, settings.merge_distance, result.defects, go_on);
  result.merge_distance = settings.merge_distance.value_or(0);
  if(surface.faces.empty())
    throw internal::Input_error(Error_code::EMPTY_MESH,
                                "no face that can be used" +
                                  (soup.triangles.empty() ? "; reconstruct a surface from its points first"
                                                          : ": " + boost::algorithm::join(sentences(result), ", ")));
  go_on();

  if(settings.wrap) {
    result.wrap = settings.wrap;
    surface = wrapped(soup, result, go_on);
  }
  std::vector<int> piece_of;
  result.pieces = pieces_of(surface, piece_of);
  result.piece_of_face.assign(soup.triangles.size(), -1);
  for(std::size_t f = 0; f < piece_of.size(); ++f)
    if(surface.old_face[f] != Glued_surface::none)
      result.piece_of_face[place(surface.old_face[f])] = piece_of[f];
  if(settings.components == Components::LARGEST)
    for(std::size_t i = 1; i < result.pieces.size(); ++i)
      result.pieces[i].is_kept = false;
  const bool is_separated =
    settings.components != Components::TOGETHER || settings.cuts_handles; // handles are those of a connected surface
  if(!is_separated || result.pieces.size() == 1)
    result.parts.push_back(std::move(surface));
  else
    result.parts = separated(surface, result.pieces, piece_of);

  for(Glued_surface& part : result.parts) {
    go_on();
    if(settings.fills_holes) {
      fill_holes(part, result, go_on);
      result.is_filled = true;
    } else
      for(const std::vector<int>& boundary : boundary_cycles(part))
        result.holes.push_back(loop_of(part, boundary));
    if(settings.cuts_handles && is_closed(part)) {
      result.handles_cut_at_once += cut_handles(
        part, [&](const std::vector<int>& loop) { result.handles.push_back(loop_of(part, loop)); }, go_on);
      result.is_cut = true;
    }
    go_on();
    result.split_edges += split_parallel_edges(part);
    go_on();
    if(settings.removes_degenerate_faces)
      remove_degenerate_faces(part, result);
    std::vector<int> unused;
    const std::vector<Component> left = components(part, unused);
    if(left.size() == 1 && left[0].holes == 0 && left[0].volume < 0) { // of several, one may be the cavity of another
      turn_round(part, std::vector<bool>(part.faces.size(), true));
      ++result.turned_parts;
    }
  }
  std::stable_sort(result.holes.begin(), result.holes.end(),
                   [](const Loop& a, const Loop& b) { return a.length > b.length; });
  return result;
}

} // namespace

double share_of_area_kept(const Preparation& preparation)
{
  double kept = 0;
  for(const Piece& piece : preparation.pieces)
    kept += piece.is_kept ? piece.share_of_area : 0;
  return kept;
}

double diagonal(const Triangle_soup& soup)
{
  constexpr double largest = std::numeric_limits<double>::infinity();
  Vector low = {largest, largest, largest}, high = {-largest, -largest, -largest};
  for(const auto& triangle : soup.triangles)
    if(is_face(soup, triangle))
      for(const int v : triangle)
        for(std::size_t k = 0; k < 3; ++k) {
          low[k] = std::min(low[k], soup.points[v][k]);
          high[k] = std::max(high[k], soup.points[v][k]);
        }
  return low[0] <= high[0] ? norm(minus(high, low)) : 0; // there may be no face
}

Preparation prepare(const Triangle_soup& soup, const Preparation_settings& settings, const std::function<void()>& go_on)
{
  // fourth powers of coordinates beyond these, as CGAL fills holes with, are no numbers
  constexpr double largest_harmless = 1e50;
  const double largest = largest_coordinate(soup);
  if(largest == 0 || (largest < largest_harmless && largest > 1 / largest_harmless))
    return prepare_in_unit(soup, settings, go_on);

  const int exponent = std::ilogb(largest);
  const auto scale = [](std::vector<Vector>& points, int power) {
    for(Vector& p : points)
      for(double& x : p) {
        constexpr double last = std::numeric_limits<double>::max(); // where points of no face stay finite
        x = std::isfinite(x) ? std::clamp(std::scalbn(x, power), -last, last) : x;
      }
  };
  std::vector<Vector> points(soup.points.begin(), soup.points.end());
  scale(points, -exponent);
  Triangle_soup scaled = soup;
  scaled.points = boost::make_iterator_range(points.data(), points.data() + points.size());
  Preparation_settings in_unit = settings;
  const auto scale_if_given = [](std::optional<double>& x, int power) {
    if(x)
      x = std::scalbn(*x, power);
  };
  scale_if_given(in_unit.merge_distance, -exponent);
  if(in_unit.wrap) {
    scale_if_given(in_unit.wrap->alpha, -exponent);
    scale_if_given(in_unit.wrap->offset, -exponent);
  }
  Preparation result = prepare_in_unit(scaled, in_unit, go_on);
  result.merge_distance = settings.merge_distance.value_or(0);
  for(Glued_surface& part : result.parts) {
    scale(part.points, exponent);
    for(std::size_t v = 0; v < part.points.size(); ++v) // digits may have been lost where numbers vanish
      if(const int old = part.old_vertex[v]; old != Glued_surface::none)
        part.points[v] = soup.points[old];
  }
  for(Piece& piece : result.pieces) {
    piece.size.area = std::scalbn(piece.size.area, 2 * exponent);
    piece.size.volume = std::scalbn(piece.size.volume, 3 * exponent);
  }
  for(std::vector<Loop>* loops : {&result.holes, &result.handles})
    for(Loop& loop : *loops)
      loop.length = std::scalbn(loop.length, exponent);
  if(result.wrap) {
    scale_if_given(result.wrap->alpha, exponent);
    scale_if_given(result.wrap->offset, exponent);
  }
  return result;
}

std::vector<std::string> sentences(const Preparation& preparation)
{
  const Gluing_defects& defects = preparation.defects;
  std::vector<std::string> lines;
  add(lines, defects.non_finite_vertices, "removed ", "vertex", "vertices",
      " whose coordinates are not finite, and all faces there", "vertex");
  add(lines, defects.isolated_vertices, "removed ", "isolated vertex", "isolated vertices", "", "vertex");
  add(lines, defects.repeated_corners, "removed ", "face", "faces", " with two corners at one vertex", "face");
  add(lines, defects.repeated_faces, "removed ", "repeated face", "repeated faces", "", "face");
  const double distance = preparation.merge_distance;
  add(lines, defects.merged_vertices, "merged ", "vertex", "vertices",
      " at boundaries with others " +
        (distance > 0 ? "up to " + internal::to_string(distance) + " apart" : std::string("at the same place")),
      "vertex");
  add(lines, defects.non_manifold_edges, "glued the faces in pairs at ", "non-manifold edge", "non-manifold edges", "",
      "vertex");
  add(lines, defects.crowded_edges, "compared only faces near each other in the file at ", "edge", "edges",
      " of more than 200 faces", "vertex");
  add(lines, defects.non_manifold_vertices, "made ", "copy", "copies", " of non-manifold vertices", "vertex");
  add(lines, defects.slits, "closed ", "slit", "slits", " along sides on which other faces have vertices", "vertex");
  add(lines, defects.reversed_faces, "reversed ", "face", "faces", " that did not agree with their neighbours", "face");
  add(lines, defects.cut_edges, "cut a surface that has one side only, at ", "edge", "edges", "", "vertex");
  if(preparation.wrap)
    lines.push_back("wrapped everything, alpha " + internal::to_string(*preparation.wrap->alpha) + ", offset " +
                    internal::to_string(*preparation.wrap->offset));

  const auto& pieces = preparation.pieces;
  if(pieces.size() > 1) {
    if(pieces.back().is_kept)
      lines.push_back("has " + count(pieces.size(), "component"));
    else
      lines.push_back("kept the largest of " + count(pieces.size(), "component") + ", " +
                      internal::to_string(100 * share_of_area_kept(preparation)) + " % of the area" +
                      at(pieces.front().vertex));
  }
  if(!preparation.holes.empty())
    lines.push_back((preparation.is_filled ? "filled " : "has ") + count(preparation.holes.size(), "hole") +
                    largest(preparation.holes, "longest"));
  if(preparation.is_cut) {
    if(!preparation.handles.empty())
      lines.push_back("cut " + count(preparation.handles.size(), "handle") + " along shortest loops" +
                      largest(preparation.handles, "first"));
    if(preparation.handles_cut_at_once > 0)
      lines.push_back("cut " + count(static_cast<std::size_t>(preparation.handles_cut_at_once), "handle") +
                      " at once, too many to look for the shortest loops");
  } else {
    int handles = 0;
    for(const Piece& piece : pieces)
      handles += piece.is_kept ? piece.size.genus() : 0;
    if(handles > 0)
      lines.push_back("has " + count(static_cast<std::size_t>(handles), "handle"));
  }
  add(lines, preparation.degenerate_faces, preparation.has_degenerate_faces ? "did not remove all of " : "removed ",
      "face", "faces", " without area", "face");
  if(preparation.split_edges > 0)
    lines.push_back("split " + count(preparation.split_edges, "edge") + " that had the same ends as others");
  if(preparation.turned_parts > 0)
    lines.push_back("turned " +
                    (preparation.parts.size() == 1 ? "all faces" : count(preparation.turned_parts, "component")) +
                    " to the outside");
  return lines;
}

} // namespace CGAL::Spherical_parameterization::preparation
