// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "mapping/prepared_mesh.h"

#include "preparation/surface_distance.h"
#include "preparation/points.h"
#include "system/refusal.h"

#include <CGAL/tags.h>

#include <algorithm>
#include <array>

namespace tool {
namespace {

/// The weights of the corners at the point of a triangle that is near to `p`: its foot in the plane, and for those
/// outside of the triangle what is left when negative weights are 0.
std::array<double, 3> weights_of_place(const std::array<Vector, 3>& corners, const Vector& p)
{
  for(std::size_t k = 0; k < 3; ++k)
    if(corners[k] == p) {
      std::array<double, 3> weights = {0, 0, 0};
      weights[k] = 1;
      return weights;
    }
  const Vector normal = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]));
  std::array<double, 3> weights;
  double sum = 0;
  for(std::size_t k = 0; k < 3; ++k) {
    const Vector &a = corners[(k + 1) % 3], &b = corners[(k + 2) % 3];
    weights[k] = std::max(0., dot(cross(minus(a, p), minus(b, p)), normal));
    sum += weights[k];
  }
  if(!(sum > 0))
    return {1. / 3, 1. / 3, 1. / 3};
  for(double& w : weights)
    w /= sum;
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
    return {Mesh(CGAL::Parallel_if_available_tag(), surface.points, surface.faces), prepared->soup.polygons,
            prepared->soup.annotations};
  } catch(const SP::Error& error) {
    throw Refusal(error.code(), file,
                  "has, prepared without a change of shape, " + without_remedy(error.detail(), error.remedy()),
                  "the command 'prepare' mends that, too");
  }
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
                                        std::size_t& number_of_labels)
{
  const Preparation& preparation = prepared.preparation;
  const std::vector<int> nearest = nearest_faces(prepared.soup, preparation.parts.front());
  const std::size_t of_pieces = labels.empty() ? 0 : *std::max_element(labels.begin(), labels.end()) + 1;
  std::vector<std::size_t> result;
  for(std::size_t f = 0; f < prepared.soup.triangles.size(); ++f) {
    const int piece = preparation.piece_of_face[f];
    const bool is_elsewhere = piece >= 0 && !preparation.pieces[place(piece)].is_kept;
    result.push_back(is_elsewhere ? of_pieces + place(piece) : labels[place(nearest[f])]);
  }
  // a label may be that of new faces only
  std::vector<std::size_t> used = result;
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for(std::size_t& label : result)
    label = static_cast<std::size_t>(std::lower_bound(used.begin(), used.end(), label) - used.begin());
  number_of_labels = used.size();
  return result;
}

std::vector<std::pair<double, double>> coordinates_of_file(const Prepared_mesh& prepared,
                                                           const std::vector<std::pair<double, double>>& coordinates)
{
  const Soup& soup = prepared.soup;
  const Glued_surface& surface = prepared.preparation.parts.front();
  const std::vector<int> nearest = nearest_faces(soup, surface);
  std::vector<std::pair<double, double>> result(3 * soup.triangles.size());
  for(std::size_t f = 0; f < soup.triangles.size(); ++f) {
    const std::size_t g = place(nearest[f]);
    std::array<Vector, 3> corners;
    for(std::size_t k = 0; k < 3; ++k)
      corners[k] = surface.point(surface.faces[g][k]);
    for(std::size_t k = 0; k < 3; ++k) {
      const std::array<double, 3> weights = weights_of_place(corners, soup.points[place(soup.triangles[f][k])]);
      auto& uv = result[3 * f + (k + 2) % 3]; // the halfedge that ends at corner k
      for(std::size_t i = 0; i < 3; ++i) {
        uv.first += weights[i] * coordinates[3 * g + (i + 2) % 3].first;
        uv.second += weights[i] * coordinates[3 * g + (i + 2) % 3].second;
      }
    }
  }
  return result;
}

} // namespace tool
