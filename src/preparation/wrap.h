// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_WRAP_H
#define SPHERICAL_PARAMETERIZATION_TOOL_WRAP_H

#include "input/mesh_readers.h"

namespace tool {

/// A closed surface around triangles of any kind, at a distance of `offset`; what a ball of radius `alpha` cannot enter
/// is filled (C. Portaneri, M. Rouxel-Labbe, M. Hemmer, D. Cohen-Steiner, P. Alliez, "Alpha wrapping with an offset",
/// 2022; CGAL's alpha_wrap_3).
Soup wrap(const Soup& soup, double alpha, double offset);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_WRAP_H
