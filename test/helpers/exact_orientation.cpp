// SPDX-License-Identifier: GPL-3.0-or-later
// In a file of its own: the kernel is the largest header of the tests.

#include "helpers/soup.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace test {

using Exact_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

CGAL::Orientation exact_orientation(const Point& a, const Point& b, const Point& c, const Point& d)
{
  const auto exact = [](const Point& p) { return Exact_kernel::Point_3(p.x(), p.y(), p.z()); };
  return CGAL::orientation(exact(a), exact(b), exact(c), exact(d));
}

CGAL::Orientation exact_orientation(const Kernel::Point_2& a, const Kernel::Point_2& b, const Kernel::Point_2& c)
{
  const auto exact = [](const Kernel::Point_2& p) { return Exact_kernel::Point_2(p.x(), p.y()); };
  return CGAL::orientation(exact(a), exact(b), exact(c));
}

} // namespace test
