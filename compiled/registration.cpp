// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include <CGAL/Spherical_parameterization/internal/correspondence/refine_impl.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/register_surfaces_impl.h>
#include <CGAL/Spherical_parameterization/internal/moebius/Centring_impl.h>
