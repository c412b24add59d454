// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include <CGAL/Spherical_parameterization/internal/surface/check_soup_impl.h>
#include <CGAL/Spherical_parameterization/internal/predicates/orientation_impl.h>
#include <CGAL/Spherical_parameterization/internal/problem/Solution_impl.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/mend_impl.h>
