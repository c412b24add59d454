// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STATISTICS_PROCRUSTES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STATISTICS_PROCRUSTES_H

#include <CGAL/Spherical_parameterization/values/Shape_statistics.h>
#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/statistics/Shape_set.h>

namespace CGAL::Spherical_parameterization::internal {

/// Scales and turns shapes, whose centres are at the origin, to where the sum of the squares of their distances from
/// their mean is least: J. C. Gower, "Generalized Procrustes analysis", Psychometrika 40 (1975). By turns the mean for
/// the rotations, and every shape's rotation to the mean, all at once, so that the order of the shapes does not matter:
/// no step makes the sum larger. At the end all of them are turned together so that the first one is where it was.
/// Fills all but the translations.
///
/// O(n V) per step for n shapes of V entries.
template <class Loop>
Procrustes_alignment superimpose(const Loop& loop, const Shape_set<double>& shapes, const Procrustes& method);

} // namespace CGAL::Spherical_parameterization::internal

#ifdef CGAL_SP_INCLUDE_CORE
#include <CGAL/Spherical_parameterization/internal/statistics/procrustes_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STATISTICS_PROCRUSTES_H
