// SPDX-License-Identifier: GPL-3.0-or-later

#include "test/helpers/certificate.h"
#include "any_mesh.h"
#include "targets.h"

#include <CGAL/Spherical_parameterization/edge_weights.h>
#include <CGAL/Spherical_parameterization/parameterize.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <variant>
#include <vector>

namespace fuzz {
namespace {

namespace SP = CGAL::Spherical_parameterization;
using SP::Error_code;
using SP::Result;
using test::Mesh;
using test::Point;

typedef std::variant<SP::Balanced, SP::Saddle_point, SP::Isometric, SP::Automatic> Any_method;

Any_method any_method(Bytes& in)
{
  switch(in.below(8)) {
  case 0: return SP::Balanced();
  case 1: return SP::Balanced{2 + in.byte() / 32.};
  case 2:
  case 3: {
    SP::Saddle_point method;
    method.splitting =
      in.below(2) == 0 ? SP::Saddle_point::Splitting::JACOBI : SP::Saddle_point::Splitting::GAUSS_SEIDEL;
    method.start = static_cast<SP::Saddle_point::Start>(in.below(3));
    const double largest = method.splitting == SP::Saddle_point::Splitting::JACOBI ? 1 : 2;
    method.relaxation = largest * (1 + in.byte()) / 257;
    method.check_interval = 1 + in.below(100);
    return method;
  }
  case 4: return SP::Isometric();
  case 5: return SP::Isometric{in.byte() / 8.};
  case 6: return SP::Automatic();
  default: {
    const double spring_exponent = 2 + in.byte() / 64.;
    in.byte(); // was an option when the inputs that are kept were found
    return SP::Automatic{spring_exponent, in.byte() / 8.};
  }
  }
}

/// All weights are one map, so that everything is compiled once.
std::vector<double> any_weights(Bytes& in, const Mesh& mesh)
{
  std::vector<double> weights(mesh.num_edges());
  const std::size_t kind = in.below(8);
  const auto barycentric = SP::barycentric_weights(mesh);
  const auto clamped = SP::clamped_weights(mesh);
  const auto mean_value = SP::mean_value_weights(mesh);
  for(const Mesh::Edge_index e : mesh.edges()) {
    const bool is_inner = !mesh.is_border(e); // weights of angles need both faces
    double& w = weights[e.idx()];
    if(kind < 3 && is_inner)
      w = get(clamped, e);
    else if(kind == 4 && is_inner)
      w = get(mean_value, e);
    else if(kind == 5)
      w = 1 + in.byte();
    else if(kind == 6)
      w = std::pow(10., in.small());
    else if(kind == 7)
      w = in.number();
    else
      w = get(barycentric, e);
  }
  return weights;
}

bool is_unit(const Point& p)
{
  return std::abs(std::hypot(p.x(), p.y(), p.z()) - 1) <= 1e-12; // false for NaN
}

/// Fixed vertices and given start, as any vectors or as directions.
template <class Sphere_map, class Fixed_map>
std::size_t fix_any_vertices(Bytes& in, const Mesh& mesh, Sphere_map sphere, Fixed_map is_fixed)
{
  const std::size_t kind = in.below(4);
  std::size_t fixed = 0;
  for(const Mesh::Vertex_index v : mesh.vertices()) {
    if(kind == 1)
      sphere[v] = Point(in.number(), in.number(), in.number());
    else
      sphere[v] = Point(in.small(), in.small(), in.small());
    is_fixed[v] = kind > 1 && in.below(kind == 2 ? 3 : 16) == 0;
    fixed += is_fixed[v];
  }
  return fixed;
}

void check_map(const Mesh& mesh, const Result& result, const test::Sphere& sphere)
{
  std::ostringstream line;
  line << result;
  const auto expect = [&](bool is_kept, const char* what) { promise(is_kept, what + (": " + line.str())); };
  const bool has_map = result.degree != 0 || result.flipped_faces > 0;
  if(result) {
    const test::Soup soup = test::make_soup(mesh);
    expect(std::all_of(sphere.begin(), sphere.end(), is_unit), "a valid map that leaves the sphere");
    expect(test::count_flipped_faces(soup, sphere) == 0, "a valid map with flipped faces");
    expect(test::degree(soup, sphere) == 1, "a valid map of another degree");
    expect(result.flipped_faces == 0 && result.degree == 1 && result.detail.empty(), "a certificate that is none");
    expect(std::isfinite(result.residual) && result.energy >= 0, "figures that are no numbers");
  } else {
    expect(!result.detail.empty() && result.detail.find('\n') == std::string::npos,
           "an error without one line of detail");
    if(has_map) {
      expect(std::all_of(sphere.begin(), sphere.end(), is_unit), "a map that leaves the sphere");
      expect(test::count_flipped_faces(test::make_soup(mesh), sphere) == result.flipped_faces,
             "a wrong count of flipped faces");
    }
  }
}

} // namespace

void map_meshes(const std::uint8_t* data, std::size_t size)
{
  Bytes in(data, size);
  const Any_method method = any_method(in);
  const std::size_t effort = in.below(8);
  Mesh mesh = any_mesh(in);
  put_any_points(in, mesh);

  const auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point>("v:sphere").first;
  const auto is_fixed = mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_fixed", false).first;
  const auto weights = mesh.add_property_map<Mesh::Edge_index, double>("e:weight", 1).first;
  const std::size_t fixed = fix_any_vertices(in, mesh, sphere, is_fixed);
  const bool is_triangulated = CGAL::is_triangle_mesh(mesh);
  const std::vector<double> any = is_triangulated ? any_weights(in, mesh) : std::vector<double>(mesh.num_edges(), 1);
  bool are_good = true;
  for(const Mesh::Edge_index e : mesh.edges()) {
    weights[e] = any[e.idx()];
    are_good = are_good && weights[e] > 0 && std::isfinite(weights[e]);
  }

  constexpr std::size_t enough_calls = 2000; // of the published method, which may want millions of sweeps
  std::size_t calls_left = effort == 1                                        ? in.below(64)
                           : std::holds_alternative<SP::Saddle_point>(method) ? enough_calls
                                                                              : std::numeric_limits<std::size_t>::max();
  const Result result = std::visit(
    [&](const auto& chosen) {
      typedef std::decay_t<decltype(chosen)> Method;
      const bool is_published = std::is_same_v<Method, SP::Saddle_point>;
      const std::size_t iterations = is_published  ? 1 + in.below(8)
                                     : effort == 2 ? in.below(16)
                                                   : Method::default_number_of_iterations;
      const double accuracy = effort == 3 ? std::pow(10., -in.byte() / 16.) : Method::default_accuracy;
      return SP::parameterize(CGAL::Sequential_tag(), mesh, chosen, sphere,
                              CGAL::parameters::edge_weight_map(weights)
                                .vertex_is_constrained_map(is_fixed)
                                .number_of_iterations(iterations)
                                .accuracy(accuracy)
                                .callback([&](double share) {
                                  promise(share >= 0 && share <= 1, "progress out of range");
                                  return calls_left-- > 0;
                                }));
    },
    method);

  test::Sphere positions;
  for(const Mesh::Vertex_index v : mesh.vertices())
    positions.push_back(sphere[v]);
  check_map(mesh, result, positions);

  // what is promised in advance
  const bool is_sphere = is_triangulated && CGAL::is_closed(mesh) && result.error != Error_code::SEVERAL_COMPONENTS &&
                         result.error != Error_code::WRONG_GENUS && result.error != Error_code::NON_MANIFOLD &&
                         result.error != Error_code::ISOLATED_VERTEX && result.error != Error_code::EMPTY_MESH;
  const bool is_bijective_by_construction =
    std::holds_alternative<SP::Isometric>(method) || (std::holds_alternative<SP::Automatic>(method) && are_good);
  if(is_bijective_by_construction && is_sphere && is_simplicial(mesh) && is_finite(mesh) && fixed == 0 &&
     (effort == 0 || effort > 3)) {
    std::ostringstream line;
    line << result;
    promise(bool(result), "no map where there has to be one: " + line.str());
  }
}

} // namespace fuzz
