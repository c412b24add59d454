// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

// Spherical harmonics: transforms, rotations, files.
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/analysis.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/coefficient_files.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/rotation.h>

namespace CGAL::Spherical_parameterization::internal {

typedef Watched_loop<Host_loop> Loop;

template Harmonic_analysis analyze_vertices(const Loop&, Mapped_surface, Sampled_fields, int, const Least_squares&);
template Harmonic_analysis analyze_vertices(const Loop&, Mapped_surface, Sampled_fields, int, const Integration&);
template Host_array<double> evaluate_harmonics(const Loop&, const Harmonic_coefficients&, const Host_array<vec3>&);
template Host_array<double> synthesize_on_rows(const Loop&, const Harmonic_coefficients&, const Latitude_rows&);
template Harmonic_coefficients analyze_rows(const Loop&, const Latitude_rows&, const Sampled_fields&, int);
template Harmonic_coefficients rotated_harmonics(const Loop&, const Harmonic_coefficients&, const Rotation&);
template std::vector<Correlation> best_correlations(const Loop&, const Harmonic_coefficients&,
                                                    const Harmonic_coefficients&);
template First_order_ellipsoid ellipsoid_of(const Host_loop&, const Harmonic_coefficients&);
template Shape_alignment best_motion(const Loop&, const Harmonic_coefficients&, const Harmonic_coefficients&);

} // namespace CGAL::Spherical_parameterization::internal
