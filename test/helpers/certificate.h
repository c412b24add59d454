// SPDX-License-Identifier: GPL-3.0-or-later
// What the package says about a map, computed again without the package.

#ifndef TEST_HELPERS_CERTIFICATE_H
#define TEST_HELPERS_CERTIFICATE_H

#include "helpers/soup.h"

#include <cstddef>
#include <vector>

namespace test {

enum class Weights { BARYCENTRIC, CLAMPED, MEAN_VALUE, CONFORMAL };

/// An edge as a spring.
struct Spring {
  std::size_t i, j;
  double weight;
  double length; ///< in the source mesh, after its area is scaled to 4 pi
};

/// One spring per edge. Clamped weights are 1/2 (cot alpha + cot beta) with both angles clamped to [5, 85] degrees.
/// Mean value weights are the mean of those of the two ends. The springs of conformal weights are no edges of the mesh.
std::vector<Spring> make_springs(const Soup& soup, Weights weights);

/// Faces (a, b, c) with orientation(O, a, b, c) <= 0, by an exact predicate.
std::size_t count_flipped_faces(const Soup& soup, const Sphere& sphere);

/// Signed number of faces over a generic direction, by exact predicates.
int degree(const Soup& soup, const Sphere& sphere);

/// Area of the smallest spherical triangle, without sign.
double smallest_area(const Soup& soup, const Sphere& sphere);

/// 1/p sum w l^2 (|v_i - v_j| / l)^p.
double energy(const std::vector<Spring>& springs, const Sphere& sphere, double exponent = 2);

/// L2 norm of v_i - s_i / |s_i|, s_i = sum_j w_ij v_j, over the vertices that are not fixed. For an exponent above 2
/// with the effective weights w (|v_i - v_j| / l)^(p - 2).
double residual(const std::vector<Spring>& springs, const Sphere& sphere, const std::vector<std::size_t>& fixed = {},
                double exponent = 2);

/// How far a map is from balanced: at a critical point of the energy under sum m_i v_i = 0, whatever the m_i, all
/// torques v_i x (Lv)_i / D_i are orthogonal to one vector. This is the L2 norm of their components along the vector
/// for which it is smallest.
double balanced_residual(const std::vector<Spring>& springs, const Sphere& sphere);

/// How many vertices are not at distance 1 (to 1e-15 times 4) from the origin.
std::size_t count_vertices_off_sphere(const Sphere& sphere);

/// Largest distance of two maps after the best rotation of the second one (a proper rotation, no reflection).
double distance_up_to_rotation(const Sphere& a, const Sphere& b);

/// Largest distance of two maps as they are.
double distance(const Sphere& a, const Sphere& b);

} // namespace test

#endif // TEST_HELPERS_CERTIFICATE_H
