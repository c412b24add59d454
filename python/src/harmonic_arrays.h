// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// Coefficients are arrays ((L + 1)^2, d): a row for every l and m, a column for every function.

#ifndef SPHERICAL_PARAMETERIZATION_PYTHON_HARMONIC_ARRAYS_H
#define SPHERICAL_PARAMETERIZATION_PYTHON_HARMONIC_ARRAYS_H

#include "arrays.h"

#include <CGAL/Spherical_parameterization/values/Harmonic_coefficients.h>

#include <cmath>

/// Of the array that begins at `first`.
inline SP::Harmonic_coefficients harmonics_at(const double* first, int rows, int columns)
{
  SP::Harmonic_coefficients c(static_cast<int>(std::lround(std::sqrt(rows))) - 1, columns);
  for(int i = 0; i < rows; ++i)
    for(int k = 0; k < columns; ++k)
      c.field_begin(k)[i] = first[i * columns + k];
  return c;
}

inline void write_harmonics(const SP::Harmonic_coefficients& c, double* out)
{
  for(int i = 0; i < c.size(); ++i)
    for(int k = 0; k < c.number_of_fields(); ++k)
      *out++ = c.field_begin(k)[i];
}

#endif // SPHERICAL_PARAMETERIZATION_PYTHON_HARMONIC_ARRAYS_H
