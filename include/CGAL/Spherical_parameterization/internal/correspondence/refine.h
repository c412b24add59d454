// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_REFINE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_REFINE_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/context/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/Registered_surface.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>

#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// \file
/// Non-rigid registration of two maps. A map x of the surface A to the sphere and the map of B make a correspondence
/// from A to B. What is minimized over x is
///   the mean symmetric Dirichlet energy of x, from the map that A came with: 4 where nothing is bent, infinite where a
///   face flips
///   + the mean squared differences of features over the surface of A, those of B being looked up at x
///   + how much the surface of A is stretched onto that of B (Carried_face)
///   + springs between landmarks.
/// Features are linear between the vertices. Coarse features first, then finer ones, as B. Fischl, M. Sereno, A. Dale,
/// "Cortical surface-based analysis II", 1999, and B. Yeo et al., "Spherical demons", 2010; the barrier in place of
/// their checks.

/// How far it came.
struct Refinement_report {
  int iterations = 0;
  bool has_converged = false;
  double energy_before = 0, energy = 0;
  double mismatch = 0;   ///< the part of the features
  double stretching = 0; ///< of surface A onto surface B: 4 where there is none
  double distortion = 0; ///< the part of the symmetric Dirichlet energy
};

/// What a surface looks like at a scale, given as a length on the surface of area 4 pi: the logarithm of its area by
/// that on the sphere, and its mean curvature at that scale and at half of it, all smoothed by the heat flow of the
/// surface. They do not change where a surface is bent without stretching, but for curvature at the joints. If the
/// monitor says no they are less smooth. `own` fields follow, at that scale, too. All but the first one have mean 0 and
/// variance 1 before they are bounded.
CGAL_SP_CORE std::vector<Host_array<double>> shape_features(const Host_loop& loop, const Registered_surface& surface,
                                                            std::vector<Host_array<double>> own,
                                                            double scale_of_details, Monitor& monitor);

/// Moves x, the images of the vertices of A, which are without flips and stay so: Newton's method, with line searches.
/// No step lets a face shrink to less than a twentieth. Where rounding has flipped faces already, the energy is
/// infinite, and nothing is moved. Landmarks that are in place stay there.
CGAL_SP_CORE Refinement_report refine(const Host_loop& loop, const Registered_surface& a, const Registered_surface& b,
                                      const Registration_features& features,
                                      const std::vector<Registration_landmark>& landmarks, const Refinement& settings,
                                      Monitor& monitor, Host_array<vec3>& x);

} // namespace CGAL::Spherical_parameterization::internal

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_COMPILED
#include <CGAL/Spherical_parameterization/internal/correspondence/refine_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_REFINE_H
