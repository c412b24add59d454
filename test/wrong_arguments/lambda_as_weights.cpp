// SPDX-License-Identifier: GPL-3.0-or-later
// Does not compile: edge_weight_map has to be Conformal_weights, or a readable property map
#include <CGAL/Spherical_parameterization/parameterize.h>

#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <vector>

using namespace CGAL::Spherical_parameterization;

void wrong(const Indexed_triangle_mesh& mesh, std::vector<std::array<double, 3>>& points)
{
  const internal::Range_map<std::vector<std::array<double, 3>>> sphere{&points};
  const auto f = [](Indexed_triangle_mesh::Face_index) { return std::array<double, 3>{0, 0, 1}; };
  (void)f;
  parameterize(mesh, sphere, CGAL::parameters::edge_weight_map([](int) { return 1.; }));
}
