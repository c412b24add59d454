// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_COEFFICIENT_FILES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_COEFFICIENT_FILES_H

#include <CGAL/Spherical_parameterization/values/Harmonic_coefficients.h>
#include <CGAL/Spherical_parameterization/internal/api/compiled.h>

#include <string>

namespace CGAL::Spherical_parameterization::internal {

/// \name Coefficients as text
/// What is read throws std::runtime_error where the text is not of the format.
/// @{
CGAL_SP_CORE std::string csv_of(const Harmonic_coefficients& coefficients);
CGAL_SP_CORE std::string json_of(const Harmonic_coefficients& coefficients);
CGAL_SP_CORE std::string spharm_pdm_of(const Harmonic_coefficients& coefficients);
CGAL_SP_CORE Harmonic_coefficients coefficients_of_csv(const std::string& text);
CGAL_SP_CORE Harmonic_coefficients coefficients_of_json(const std::string& text);
CGAL_SP_CORE Harmonic_coefficients coefficients_of_spharm_pdm(const std::string& text);
/// @}

} // namespace CGAL::Spherical_parameterization::internal

#ifdef CGAL_SP_INCLUDE_CORE
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/coefficient_files_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_COEFFICIENT_FILES_H
