// SPDX-License-Identifier: GPL-3.0-or-later

#include "mapping/prepared_mesh.h"

#include "preparation/points.h"
#include "system/refusal.h"

#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace tool {
namespace {

using Corners = std::array<Vector, 3>;

template <class Points>
Corners corners_of(const Points& points, const std::array<int, 3>& triangle)
{
  return {points[place(triangle[0])], points[place(triangle[1])], points[place(triangle[2])]};
}

/// The weights of the corners at the point of a triangle that is nearest to `p`. The triangle may have no area.
std::array<double, 3> weights_of_nearest(const Corners& corners, const Vector& p)
{
  std::array<double, 3> weights = {0, 0, 0};
  for(std::size_t k = 0; k < 3; ++k)
    if(corners[k] == p) {
      weights[k] = 1;
      return weights;
    }
  std::vector<Vector> from_p; // in a unit in which products are numbers
  for(const Vector& corner : corners)
    from_p.push_back(minus(corner, p));
  const double unit = unit_of(largest_coordinate(from_p));
  for(Vector& corner : from_p)
    for(double& x : corner)
      x /= unit;

  const Vector normal = cross(minus(from_p[1], from_p[0]), minus(from_p[2], from_p[0]));
  for(std::size_t k = 0; k < 3; ++k)
    weights[k] = dot(cross(from_p[(k + 1) % 3], from_p[(k + 2) % 3]), normal);
  const double sum = weights[0] + weights[1] + weights[2];
  if(sum > 0 && *std::min_element(weights.begin(), weights.end()) >= 0) { // the foot in the plane is inside
    for(double& w : weights)
      w /= sum;
    return weights;
  }
  double least = std::numeric_limits<double>::infinity();
  for(std::size_t k = 0; k < 3; ++k) {
    const Vector &a = from_p[k], &b = from_p[(k + 1) % 3], ab = minus(b, a);
    const double square = dot(ab, ab), t = square > 0 ? std::clamp(-dot(a, ab) / square, 0., 1.) : 0;
    const double distance = std::hypot(a[0] + t * ab[0], a[1] + t * ab[1], a[2] + t * ab[2]);
    if(distance < least) {
      least = distance;
      weights = {0, 0, 0};
      weights[k] = 1 - t;
      weights[(k + 1) % 3] = t;
    }
  }
  return weights;
}

} // namespace

Input_mesh read_prepared_mesh(const std::string& file, Prepare how, std::optional<Prepared_mesh>& prepared)
{
  prepared.emplace();
  // map refuses what is no shape; for the others the faces there are left out
  prepared->soup = read_triangles(file, how == Prepare::HARMLESS ? Coordinates::FINITE : Coordinates::ANY);
  prepared->preparation =
    prepare(file, prepared->soup, how == Prepare::HARMLESS ? Preparation_settings::harmless() : Preparation_settings());
  const Glued_surface& surface = prepared->preparation.parts.front();
  try {
    return {Mesh(CGAL::Parallel_if_available_tag(), surface.points, surface.faces), prepared->soup.polygons.size(),
            prepared->soup.annotations};
  } catch(const SP::Error& error) {
    throw Refusal(error.code(), file,
                  "has, after preparation without a change of shape, " + without_remedy(error.detail(), error.remedy()),
                  "the command 'prepare' repairs that, too");
  }
}

bool was_mended(const std::optional<Prepared_mesh>& prepared)
{
  return prepared && !sentences(prepared->preparation).empty();
}

std::string preparation_text(const std::string& file, const std::optional<Prepared_mesh>& prepared)
{
  std::string text;
  if(prepared)
    for(const std::string& sentence : sentences(prepared->preparation))
      text += file + ": " + sentence + '\n';
  return text;
}

std::vector<std::size_t> labels_of_file(const Prepared_mesh& prepared, const std::vector<std::size_t>& labels,
                                        std::size_t first_free)
{
  const Preparation& preparation = prepared.preparation;
  const Soup& soup = prepared.soup;
  const std::vector<int> nearest = nearest_faces(soup, preparation.parts.front());
  // at the corners of faces that were removed by themselves: the largest component with a vertex there
  std::map<Point, int> pieces_at;
  const auto for_each_corner = [&](bool was_removed, const auto& action) {
    for(std::size_t f = 0; f < soup.triangles.size(); ++f)
      if((preparation.piece_of_face[f] < 0) == was_removed && has_finite_corners(soup, soup.triangles[f]))
        for(const int v : soup.triangles[f])
          action(soup.points[place(v)], preparation.piece_of_face[f]);
  };
  const int none = std::numeric_limits<int>::max();
  for_each_corner(true, [&](const Point& p, int) { pieces_at.emplace(p, none); });
  if(!pieces_at.empty())
    for_each_corner(false, [&](const Point& p, int piece) {
      if(const auto found = pieces_at.find(p); found != pieces_at.end())
        found->second = std::min(found->second, piece);
    });
  std::vector<std::size_t> result;
  for(std::size_t f = 0; f < soup.triangles.size(); ++f) {
    int piece = preparation.piece_of_face[f];
    if(piece < 0 && has_finite_corners(soup, soup.triangles[f])) {
      // removed by itself: it is of the component, too, that has all of its corners
      const auto& [a, b, c] = soup.triangles[f];
      piece = pieces_at.at(soup.points[place(a)]);
      for(const int v : {b, c})
        if(pieces_at.at(soup.points[place(v)]) != piece)
          piece = -1;
    }
    const bool is_elsewhere = piece >= 0 && piece != none && !preparation.pieces[place(piece)].is_kept;
    result.push_back(is_elsewhere ? first_free + place(piece) : labels[place(nearest[f])]);
  }
  return result;
}

std::vector<std::size_t> labels_of_mended(const Prepared_mesh& prepared, const std::vector<std::size_t>& labels)
{
  std::vector<Place> centres;
  for(std::size_t f = 0; f < prepared.preparation.parts.front().faces.size(); ++f)
    centres.push_back({static_cast<int>(f), {1. / 3, 1. / 3, 1. / 3}});
  std::vector<std::size_t> result;
  for(const Place& old : places_of_file(prepared, centres))
    result.push_back(labels[place(old.face)]);
  return result;
}

std::vector<int> mended_vertices(const Prepared_mesh& prepared)
{
  const Soup& soup = prepared.soup;
  const Glued_surface& surface = prepared.preparation.parts.front();
  std::vector<int> result(soup.points.size(), Glued_surface::none);
  const auto set_first = [&result](int old, int v) {
    if(int& mended = result[place(old)]; mended == Glued_surface::none)
      mended = v;
  };
  for(int v = 0; v < surface.number_of_vertices(); ++v)
    if(const int old = surface.old_vertex[place(v)]; old != Glued_surface::none)
      set_first(old, v);
  // a vertex that was merged with another one is a corner of its faces, at the same place
  for(std::size_t f = 0; f < surface.faces.size(); ++f)
    if(const int old_face = surface.old_face[f]; old_face != Glued_surface::none)
      for(const int old : soup.triangles[place(old_face)])
        for(const int v : surface.faces[f])
          if(soup.points[place(old)] == surface.point(v))
            set_first(old, v);
  return result;
}

std::vector<Place> places_of_file(const Prepared_mesh& prepared, const std::vector<Place>& places)
{
  const Soup& soup = prepared.soup;
  const Glued_surface& surface = prepared.preparation.parts.front();
  const auto corners = [&surface](int face) { return corners_of(surface.points, surface.faces[place(face)]); };
  std::vector<Place> result = places;
  std::vector<std::size_t> in_new_faces;
  std::vector<Vector> points; // there
  for(std::size_t i = 0; i < places.size(); ++i)
    if(const auto& [face, w] = places[i]; surface.old_face[place(face)] == Glued_surface::none) {
      const auto [a, b, c] = corners(face);
      in_new_faces.push_back(i);
      points.emplace_back();
      for(std::size_t k = 0; k < 3; ++k)
        points.back()[k] = w[0] * a[k] + w[1] * b[k] + w[2] * c[k];
    }
  const std::vector<int> nearest = nearest_old_faces(points, surface);
  for(std::size_t i = 0; i < points.size(); ++i)
    result[in_new_faces[i]] = {nearest[i], weights_of_nearest(corners(nearest[i]), points[i])};

  for(auto& [face, weights] : result) {
    const int old_face = surface.old_face[place(face)];
    const Corners old_corners = corners_of(soup.points, soup.triangles[place(old_face)]);
    std::array<double, 3> old_weights = {0, 0, 0};
    for(std::size_t k = 0; k < 3;
        ++k) { // a corner of the mended face is one of the old face, or on a side that was split
      const std::array<double, 3> of_corner = weights_of_nearest(old_corners, corners(face)[k]);
      for(std::size_t i = 0; i < 3; ++i)
        old_weights[i] = std::min(1., old_weights[i] + weights[k] * of_corner[i]);
    }
    face = old_face;
    weights = old_weights;
  }
  return result;
}

std::vector<std::pair<double, double>> coordinates_of_file(const Prepared_mesh& prepared,
                                                           const std::vector<std::pair<double, double>>& coordinates)
{
  const Soup& soup = prepared.soup;
  const Glued_surface& surface = prepared.preparation.parts.front();
  const std::vector<int> nearest = nearest_faces(soup, surface);
  std::vector<std::vector<std::size_t>> parts; // of the faces of the file, where sides were split
  if(prepared.preparation.split_edges > 0) {
    parts.resize(soup.triangles.size());
    for(std::size_t g = 0; g < surface.faces.size(); ++g)
      if(const int f = surface.old_face[g]; f != Glued_surface::none)
        parts[place(f)].push_back(g);
  }

  const auto at = [&](std::size_t g, std::size_t corner) { // the halfedge that ends there
    return coordinates[3 * g + (corner + 2) % 3];
  };
  const auto turns = [&](std::size_t g, std::size_t part) { // by which part is beside g, where the chart goes round
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t j = 0; j < 3; ++j)
        if(surface.faces[g][i] == surface.faces[part][j])
          return std::round(at(g, i).first - at(part, j).first);
    return 0.;
  };
  std::vector<std::pair<double, double>> result(3 * soup.triangles.size());
  for(std::size_t f = 0; f < soup.triangles.size(); ++f) {
    const std::size_t g = place(nearest[f]);
    const Corners corners = corners_of(surface.points, surface.faces[g]);
    for(std::size_t k = 0; k < 3; ++k) {
      const Vector& p = soup.points[place(soup.triangles[f][k])];
      const std::array<double, 3> weights =
        is_finite(p) ? weights_of_nearest(corners, p) : std::array<double, 3>{1. / 3, 1. / 3, 1. / 3};
      auto& uv = result[3 * f + (k + 2) % 3];
      for(std::size_t i = 0; i < 3; ++i) {
        uv.first += weights[i] * at(g, i).first;
        uv.second += weights[i] * at(g, i).second;
      }
      const int owner = surface.old_face[g]; // f, or of a face that was removed the one beside it
      if(parts.empty() || owner == Glued_surface::none || std::find(corners.begin(), corners.end(), p) != corners.end())
        continue;
      for(const std::size_t part : parts[place(owner)])
        for(std::size_t i = 0; i < 3; ++i)
          if(surface.point(surface.faces[part][i]) == p)
            uv = {at(part, i).first + turns(g, part), at(part, i).second};
    }
  }
  return result;
}

} // namespace tool
