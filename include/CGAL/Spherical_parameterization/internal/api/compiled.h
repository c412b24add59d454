// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_API_COMPILED_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_API_COMPILED_H

/// \file
/// The core, all that does not depend on the type of the mesh, comes in two forms of the same text:
/// - headers only, the default: every declaration of the core includes its X_impl.h. Functions are templates, of no
///   parameters: g++ compiles those only in files that call them, but inline functions wherever they are read;
/// - compiled: users of CGAL_Spherical_parameterization::Compiled have CGAL_SPHERICAL_PARAMETERIZATION_COMPILED
///   defined. They read declarations only; compiled/*.cpp holds the definitions.
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_COMPILED
#define CGAL_SP_CORE
#define CGAL_SP_INLINE inline
#else
#define CGAL_SP_CORE template <class...>
#define CGAL_SP_INLINE template <class...>
#endif
// Definitions of templates are read in the headers-only form, and by all of compiled/*.cpp. Those of functions are read
// in the headers-only form; of compiled/*.cpp one includes them.
#if !defined(CGAL_SPHERICAL_PARAMETERIZATION_COMPILED) || defined(CGAL_SPHERICAL_PARAMETERIZATION_COMPILES_CORE)
#define CGAL_SP_INCLUDE_CORE
#endif

// Results are the same bits everywhere only where the compiler keeps to IEEE 754.
#if defined(__FAST_MATH__)
#error "CGAL Spherical Parameterization cannot certify its maps under -ffast-math: compile without it"
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_API_COMPILED_H
