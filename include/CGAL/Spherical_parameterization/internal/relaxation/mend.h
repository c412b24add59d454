// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_MEND_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_MEND_H

#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/context/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>

#include <array>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// How mending ended.
enum class Mending {
  DONE,    ///< all faces are positively oriented, by the exact predicate
  FAILED,  ///< too many are flipped, they are not known well enough, or some are flipped after many steps
  TOO_MUCH ///< those that are flipped have more vertices around them than may be moved
};

/// A conformal map is a bijection of the intrinsic Delaunay triangles. The faces of the mesh are other triangles with
/// the same vertices: where they are bad, few of them may come out flipped, or far from conformal. The vertices of
/// those are moved to the minimum of the energy MIPS, (s/t + t/s) / 2 of the principal stretches s, t, integrated over
/// their faces. No other vertices move, but for those around flipped faces that cannot be untangled without them.
///
/// 1. The bad faces are those that are flipped, and those with MIPS above `bound`. (So a face that rounding flips is
///    bad in any case.) What is connected of their vertices is a patch.
/// 2. A patch with flipped faces moves down an energy that tells them the way back (`Untangling_energy`), with less
///    and less regularization, until none is flipped. Where some stay, the vertices one, two, four ... edges around
///    these try again.
/// 3. All vertices that have tried move to the minimum. That does not depend on the way there: the map depends on the
///    mesh, and not on the numbers of its vertices and faces.
///
/// Time and memory are bounded: no more than a share of the vertices moves. Where the bad faces have more corners than
/// that (a surface with noise, all over it), the flipped ones are mended alone; where these have more, none are.
///
/// \param face       by vertices
/// \param point      the mesh
/// \param is_fixed   empty, or says which vertices stay where they are
/// \param bound      of MIPS; infinite: flipped faces are the only bad ones
/// \param resolution where a bad face is smaller on the sphere, positions are not known well enough to mend them: the
///                   result would depend on their errors. 0: whatever they are
/// \param monitor    is asked in every step of a patch
/// \param v          the map
/// \param is_moved   an entry for every vertex, which is set for those that are moved
/// \return how it ended; but for `DONE`, v and is_moved are as they were. The same bits for any number of threads.
CGAL_SP_CORE Mending mend(const Host_loop& loop, const Host_array<std::array<int, 3>>& face,
                          const Host_array<vec3>& point, const std::vector<char>& is_fixed, double bound,
                          double resolution, Monitor& monitor, Host_array<vec3>& v, std::vector<char>& is_moved);

} // namespace CGAL::Spherical_parameterization::internal

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_COMPILED
#include <CGAL/Spherical_parameterization/internal/relaxation/mend_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_MEND_H
