// SPDX-License-Identifier: GPL-3.0-or-later
// Prints all bits of a few maps. Compiled twice, for any processor and for this one: the same has to come out.

#include <CGAL/Spherical_parameterization/internal/surface/midpoint_refinement.h>
#include <CGAL/Spherical_parameterization/parameterize.h>

#include <array>
#include <cstdio>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

namespace {

template <class Method>
void print_map(const Method& method)
{
  SP::internal::Icosphere mesh(4);
  for(auto& p : mesh.points) // without symmetry
    p = {p.x * (1 + p.y / 3), p.y + p.x * p.x / 2, 1.7 * p.z + p.x * p.y * p.z};
  std::vector<std::array<double, 3>> sphere;
  const SP::Result result =
    SP::parameterize_triangle_soup(CGAL::Sequential_tag(), mesh.points, mesh.triangles, method, sphere);
  std::printf("%s %a\n", SP::get_error_message(result.error), result.residual);
  for(const auto& p : sphere)
    std::printf("%a %a %a\n", p[0], p[1], p[2]);
}

} // namespace

int main()
{
  print_map(SP::Balanced());
  print_map(SP::Balanced{3});
  print_map(SP::Isometric());
}
