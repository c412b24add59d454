// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COARSE_TO_FINE_PLANAR_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COARSE_TO_FINE_PLANAR_H

namespace CGAL::Spherical_parameterization::internal {

/// A vector in a tangent plane, or its product with tangents.
struct Planar {
  double s, t;
};

/// 2x2, by rows
struct Block {
  double ss, st, ts, tt;
};

inline Block transposed(const Block& b) { return {b.ss, b.ts, b.st, b.tt}; }

inline Block product(const Block& a, const Block& b)
{
  return {a.ss * b.ss + a.st * b.ts, a.ss * b.st + a.st * b.tt, a.ts * b.ss + a.tt * b.ts, a.ts * b.st + a.tt * b.tt};
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COARSE_TO_FINE_PLANAR_H
