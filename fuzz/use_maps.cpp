// SPDX-License-Identifier: GPL-3.0-or-later

#include "test/helpers/certificate.h"
#include "any_map.h"
#include "any_mesh.h"
#include "targets.h"

#include <CGAL/assertions_behaviour.h>
#include <CGAL/exceptions.h>
#include <CGAL/Spherical_parameterization/distortion_summary.h>
#include <CGAL/Spherical_parameterization/locate.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>
#include <CGAL/Spherical_parameterization/resample.h>
#include <CGAL/Spherical_parameterization/segmentation.h>
#include <CGAL/Spherical_parameterization/shape_signature.h>
#include <CGAL/Spherical_parameterization/texture_coordinates.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace fuzz {
namespace {

namespace SP = CGAL::Spherical_parameterization;
using test::Mesh;
using test::Point;
typedef test::Kernel::Point_2 Point_2;

void check_texture(Bytes& in, const Mesh& mesh, Sphere_map sphere)
{
  SP::Texture_options options;
  options.chart = in.below(2) == 0 ? SP::Texture_chart::LATITUDE_LONGITUDE : SP::Texture_chart::OCTAHEDRAL;
  options.bits = in.below(2) == 0 ? 52 : 1 + static_cast<int>(in.below(52));
  if(in.below(2) == 0)
    options.axes = SP::Texture_axes{{in.number(), in.number(), in.number()}, {in.small(), in.small(), in.small()}};
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {}); // axes may be any numbers
  std::vector<Point_2> uv(mesh.number_of_halfedges());
  const auto uv_map = boost::make_iterator_property_map(uv.begin(), get(boost::halfedge_index, mesh));
  try {
    SP::texture_coordinates(mesh, sphere, uv_map, options);
  } catch(const CGAL::Precondition_exception&) {
    promise(options.axes.has_value(), "the texture of a valid map was refused");
    return;
  } catch(const SP::Error&) { // whose points choose the poles
    promise(!options.axes && !is_finite(mesh), "the texture of a valid map was refused");
    return;
  }
  for(const Mesh::Face_index f : mesh.faces()) {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    const std::array<Point_2, 3> corner = {uv[h], uv[mesh.next(h)], uv[mesh.prev(h)]};
    for(const Point_2& p : corner)
      promise(p.x() >= -1 && p.x() <= 2 && p.y() >= -1 && p.y() <= 2, "a corner outside of the texture");
    promise(test::exact_orientation(corner[0], corner[1], corner[2]) == CGAL::COUNTERCLOCKWISE,
            "a flipped or degenerate face in the texture");
  }
}

template <class Method>
void check_segments(const Mesh& mesh, Sphere_map sphere, const Method& method)
{
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> segment(mesh.number_of_faces(), none);
  const auto result = SP::segmentation_via_area_stretch(
    mesh, sphere, boost::make_iterator_property_map(segment.begin(), get(boost::face_index, mesh)), method);
  if(!result) {
    promise(!result.detail.empty(), "a segmentation that failed without a reason");
    promise(result.error == (is_finite(mesh) ? SP::Error_code::DEGENERATE_FACE : SP::Error_code::NON_FINITE_COORDINATE),
            "no segments: " + result.detail);
    return;
  }
  std::vector<bool> is_used(result.number_of_segments, false);
  for(const std::size_t s : segment) {
    promise(s < result.number_of_segments, "a face without segment");
    is_used[s] = true;
  }
  promise(std::find(is_used.begin(), is_used.end(), false) == is_used.end(), "a segment without faces");
}

void check_segmentation(Bytes& in, const Mesh& mesh, Sphere_map sphere)
{
  SP::Segment_limits limits;
  limits.minimum_area = in.byte() / 255.;
  limits.number_of_segments = in.below(8);
  check_segments(mesh, sphere, SP::Majority_vote{limits});
  check_segments(mesh, sphere, SP::Girth_profiles{limits});
  check_segments(mesh, sphere, SP::Region_growing{limits, in.byte() / 32.});
}

/// The face that was found contains the direction, exactly.
void check_location(const Mesh& mesh, Sphere_map sphere, const SP::Spherical_locator<Mesh>& locator, const Point& q)
{
  const auto [f, weights] = locator.locate(q);
  const Mesh::Halfedge_index h = mesh.halfedge(f);
  const std::array<Point, 3> corner = {sphere[mesh.source(h)], sphere[mesh.target(h)],
                                       sphere[mesh.target(mesh.next(h))]};
  double sum = 0;
  for(std::size_t k = 0; k < 3; ++k) {
    promise(test::exact_orientation(Point(0, 0, 0), corner[k], corner[(k + 1) % 3], q) != CGAL::NEGATIVE,
            "the face that was found is not where the direction is");
    promise(weights[k] >= 0 && weights[k] <= 1, "a weight out of range");
    sum += weights[k];
  }
  promise(std::abs(sum - 1) < 1e-12, "weights that do not sum up to 1");
}

void check_inverse(Bytes& in, const Mesh& mesh, Sphere_map sphere)
{
  const SP::Spherical_locator<Mesh> locator(mesh, sphere);
  for(const Mesh::Vertex_index v : mesh.vertices())
    check_location(mesh, sphere, locator, sphere[v]);
  for(int i = 0; i < 4; ++i) {
    const Point q(in.number(), in.number(), in.number());
    const bool is_direction =
      std::isfinite(q.x()) && std::isfinite(q.y()) && std::isfinite(q.z()) && q != Point(0, 0, 0);
    try {
      check_location(mesh, sphere, locator, q);
      promise(is_direction, "located what is no direction");
    } catch(const std::invalid_argument&) {
      promise(!is_direction, "a direction was refused");
    }
  }
  if(is_finite(mesh)) {
    Mesh out;
    const Sphere_map directions = out.add_property_map<Mesh::Vertex_index, Point>("v:direction").first;
    SP::resample(locator, mesh.points(), 1, out, out.points(), directions);
    promise(is_finite(out), "a resampled point that is not finite");
  }
}

void check_measures(const Mesh& mesh, Sphere_map sphere)
{
  promise(SP::number_of_flipped_faces(mesh, sphere) == 0 && SP::degree_of_map(mesh, sphere) == 1,
          "a valid map was found invalid");
  const SP::Distortion_summary summary = SP::distortion_summary(mesh, sphere);
  if(is_finite(mesh) && summary.degenerate_faces < mesh.number_of_faces()) {
    promise(std::isfinite(summary.log_area_stretch.mean), "the mean stretch is no number");
    promise(std::isfinite(summary.angle_distortion.mean), "the mean angle distortion is no number");
    promise(!(summary.dilatation.min < 1 - 1e-6), "a dilatation below 1");
  }
}

void check_signature(const Mesh& mesh, Sphere_map sphere)
{
  try {
    for(const double x : SP::shape_signature(mesh, sphere).values)
      promise(std::isfinite(x) && x >= 0, "a signature that is no point");
  } catch(const std::invalid_argument&) { // of a mesh without area, or points that are not finite
  }
}

} // namespace

void use_maps(const std::uint8_t* data, std::size_t size)
{
  Bytes in(data, size);
  const std::size_t what = in.below(5);
  Mesh mesh = any_valid_map(in);
  const Sphere_map sphere = sphere_of(mesh);
  test::Sphere positions;
  for(const Mesh::Vertex_index v : mesh.vertices())
    positions.push_back(sphere[v]);
  if(test::degree(test::make_soup(mesh), positions) != 1) // moving a vertex may have wound the map once more
    return;
  put_any_points(in, mesh);
  switch(what) {
  case 0: check_texture(in, mesh, sphere); break;
  case 1: check_segmentation(in, mesh, sphere); break;
  case 2: check_inverse(in, mesh, sphere); break;
  case 3: check_measures(mesh, sphere); break;
  default: check_signature(mesh, sphere); break;
  }
}

} // namespace fuzz
