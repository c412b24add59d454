// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

// Spherical harmonics: transforms, rotations, files.
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/analysis.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/coefficient_files.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/ellipsoid.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/rotation.h>

namespace CGAL::Spherical_parameterization::internal {

template Fit fit_harmonics(const Host_loop&, const Host_array<vec3>&, const Sampled_fields&, const Host_array<double>&,
                           int, const Least_squares&);
template Harmonic_coefficients integrate_harmonics(const Host_loop&, const Mapped_faces&, const Sampled_fields&, int,
                                                   double);
template Host_array<double> evaluate_harmonics(const Host_loop&, const Harmonic_coefficients&, const Host_array<vec3>&);
template Host_array<double> synthesize_on_rows(const Host_loop&, const Harmonic_coefficients&, const Latitude_rows&);
template Harmonic_coefficients analyze_rows(const Host_loop&, const Latitude_rows&, const Sampled_fields&, int);
template std::vector<Correlation> best_correlations(const Host_loop&, const Harmonic_coefficients&,
                                                    const Harmonic_coefficients&);
template Motion best_motion(const Host_loop&, const Harmonic_coefficients&, const Harmonic_coefficients&);

} // namespace CGAL::Spherical_parameterization::internal
