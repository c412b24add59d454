// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_VERSION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_VERSION_H

/// \addtogroup PkgSphericalParameterizationVersion
/// @{

/// The version of this package; the build reads it here, too.
#define CGAL_SPHERICAL_PARAMETERIZATION_VERSION "0.1.0"

/// The same as one number, 10000 major + 100 minor + patch, for the preprocessor.
#define CGAL_SPHERICAL_PARAMETERIZATION_VERSION_NR 100

/// @}

#endif // CGAL_SPHERICAL_PARAMETERIZATION_VERSION_H
