// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HARMONIC_FILES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_HARMONIC_FILES_H

#include <CGAL/Spherical_parameterization/values/Harmonic_coefficients.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/coefficient_files.h>

#include <istream>
#include <iterator>
#include <ostream>
#include <string>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationHarmonics
/// @{

/// File formats of coefficients.
enum class Coefficient_format {
  CSV,       ///< a header, then a line `l,m,c,...` for every coefficient, in the order of `Harmonic_coefficients`
  JSON,      ///< an object with `degree`, `functions`, and `coefficients`, an array for every function
  SPHARM_PDM ///< the `.coef` of SPHARM-PDM, of three functions, in its own harmonics
};

/// Writes coefficients with all their digits.
/// \param out           where
/// \param coefficients  of one function or more; of three for `SPHARM_PDM`
/// \param format        of the text
/// \throws Error  `NON_FINITE_COORDINATE`
/// \throws std::runtime_error  if the format is for three functions, and the number is not three
CGAL_SP_INLINE void write_coefficients(std::ostream& out, const Harmonic_coefficients& coefficients,
                                       Coefficient_format format)
{
  CGAL_SP_PRECONDITION(coefficients.number_of_fields() > 0, "there are coefficients of a function");
  internal::check_finite(coefficients);
  out << (format == Coefficient_format::CSV    ? internal::csv_of(coefficients)
          : format == Coefficient_format::JSON ? internal::json_of(coefficients)
                                               : internal::spharm_pdm_of(coefficients));
}

/// Reads coefficients that `write_coefficients()` or SPHARM-PDM has written.
/// \param in      read to its end
/// \param format  of the text
/// \return the coefficients; from CSV and JSON the same bits
/// \throws std::runtime_error  if the text is not of this format: the message says what is wrong and where
CGAL_SP_INLINE Harmonic_coefficients read_coefficients(std::istream& in, Coefficient_format format)
{
  const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  return format == Coefficient_format::CSV    ? internal::coefficients_of_csv(text)
         : format == Coefficient_format::JSON ? internal::coefficients_of_json(text)
                                              : internal::coefficients_of_spharm_pdm(text);
}

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HARMONIC_FILES_H
