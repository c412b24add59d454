// SPDX-License-Identifier: GPL-3.0-or-later
// Does not compile: face_density_map has to be a readable property map whose keys are faces
#include <CGAL/Spherical_parameterization/parameterize.h>

#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <vector>

using namespace CGAL::Spherical_parameterization;

void wrong(const Indexed_triangle_mesh& mesh, std::vector<std::array<double, 3>>& points)
{
  const internal::Range_map<std::vector<std::array<double, 3>>> sphere{&points};
  const auto density = boost::make_function_property_map<Indexed_triangle_mesh::Vertex_index>([](auto) { return 1.; });
  parameterize(mesh, Isometric(), sphere, CGAL::parameters::face_density_map(density));
}
