// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include <CGAL/Spherical_parameterization/internal/driver/write_solution_impl.h>
#include <CGAL/Spherical_parameterization/internal/mesh/check_soup.h>
#include <CGAL/Spherical_parameterization/internal/predicates/orientation_impl.h>
#include <CGAL/Spherical_parameterization/internal/problem/Solution_impl.h>

namespace CGAL::Spherical_parameterization::internal {

template Soup_trouble check_soup(const Host_loop&, Corner_table&, int, Host_array<int>&,
                                 const std::function<std::size_t()>&);

} // namespace CGAL::Spherical_parameterization::internal
