// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_MEND_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_MEND_H

#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/base/compiled.h>
#include <CGAL/Spherical_parameterization/internal/base/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/base/vec3.h>

#include <array>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// \file
/// A conformal map is a bijection of the intrinsic Delaunay triangles. The faces of the mesh are other triangles with
/// the same vertices: where they are bad, few of them may come out flipped, or far from conformal. What follows moves
/// the vertices of those, and no others.
///
/// `is_fixed` is empty, or says which vertices stay where they are; `is_moved` has an entry for every vertex, and is
/// set for those that are moved. The results are the same for any number of threads, and depend on the numbers of
/// vertices and faces by rounding only.

/// Mends a map that few flipped faces keep from being valid: their vertices, and those one edge away, move until no
/// face is flipped, down the gradient of an energy that tells flipped faces the way back (`Untangling_energy`), with
/// less and less regularization. Where that does not help, those two, four, eight edges away move, too. \param point
/// the mesh, whose shapes the faces that move are drawn to \return whether all faces are positively oriented now, by
/// the exact predicate; if not, v and is_moved are as they were
CGAL_SP_CORE bool untangle(const Host_loop& loop, const Host_array<std::array<int, 3>>& face,
                           const Host_array<vec3>& point, const std::vector<char>& is_fixed, Host_array<vec3>& v,
                           std::vector<char>& is_moved);

/// Makes the worst faces of a valid map more conformal: Newton's method for the energy MIPS, (s/t + t/s) / 2 of the
/// principal stretches s, t, at the vertices of faces where that is above 2. Valid maps stay valid.
/// \param point  the mesh
CGAL_SP_CORE void polish(const Host_loop& loop, const Host_array<std::array<int, 3>>& face,
                         const Host_array<vec3>& point, const std::vector<char>& is_fixed, Host_array<vec3>& v,
                         std::vector<char>& is_moved);

} // namespace CGAL::Spherical_parameterization::internal

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_COMPILED
#include <CGAL/Spherical_parameterization/internal/relaxation/mend_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_MEND_H
