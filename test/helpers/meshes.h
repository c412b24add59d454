// SPDX-License-Identifier: GPL-3.0-or-later
// The named meshes of the tests, all generated. Faces are counterclockwise seen from outside.

#ifndef TEST_HELPERS_MESHES_H
#define TEST_HELPERS_MESHES_H

#include "helpers/soup.h"

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace test {

/// \name Closed triangle meshes of genus 0
/// @{
Soup tetrahedron();
Soup icosphere(int level);       ///< 10 * 4^level + 2 vertices, all at distance 1
Soup flat_octahedron(int level); ///< unprojected, so that all coordinates are dyadic
Soup ellipsoid(double a, double b, double c, int level);
Soup bumpy_sphere(int level);              ///< without symmetry: every face has an area of its own
Soup dumbbell(int level);                  ///< two unequal bells and a thin bar
Soup spiky_star(int level, double height); ///< seven spikes of different heights
Soup cube();                               ///< 8 vertices
Soup cross();                              ///< seven cubes
/// A tube with two half-sphere caps; `ratio` is the length of the tube over its circumference, `n_around` a multiple
/// of four. A conformal map shrinks the middle by exp(-pi ratio).
Soup capsule(double ratio, int n_around);
/// A tube along a helix of so many turns, eight times as wide as the tube, with caps that are cones.
Soup spiral(int turns, int n_around);
Soup comb(int teeth, int length); ///< cubes: teeth of width 1 along a bar
Soup tree(int depth);             ///< cubes: an H-tree, each branch ending in two; depth at most 6
Soup bipyramid(int n);            ///< two vertices of degree n, n of degree 4
/// Every third face of an icosphere cut in three, close to one of its corners: edges `epsilon` times as long as others.
Soup needles(int level, double epsilon);
/// @}

/// \name Bodies with limbs
/// @{
/// A tube with a round end that stands on the unit sphere.
struct Limb {
  Vector direction;
  double reach;  ///< angle between its direction and its root, below pi/2: its radius is the sine of it
  double length; ///< from the plane of the root to the round end
};
struct Body_with_limbs {
  Soup soup;
  std::vector<std::size_t> part; ///< of each face: 0 for the body, k for the k-th limb, from 1 on
};
/// An icosphere of level `level` of which the caps of the limbs, which must not overlap, have been drawn out.
Body_with_limbs body_with_limbs(const std::vector<Limb>& limbs, int level);
/// Six directions, none of which is an axis of symmetry: room for as many limbs of reach 0.5.
const std::vector<Vector>& six_directions();
/// @}

/// \name Meshes that have to be refused
/// @{
Soup torus(int n, int m);    ///< genus 1
Soup double_torus();         ///< genus 2
Soup open_sphere(int level); ///< an icosphere without the five faces round vertex 0
Soup two_spheres();          ///< two components
Soup isolated_vertex();      ///< the last vertex has no face
Soup quad_cube();            ///< six quadrangles
Soup nan_coordinate();       ///< in vertex 5
Soup infinite_coordinate();  ///< in vertex 7
Mesh hourglass();            ///< two icospheres that share a vertex
Mesh pinched_sphere();       ///< an icosphere with two vertices glued to one
/// @}

/// \name Zero-area faces: refused or not, that depends on the weights
/// @{
Soup collinear_face();                  ///< one face with three points exactly on a line
Soup coincident_points();               ///< two faces with two equal points
Soup many_coincident_points(int level); ///< every fifth vertex at the place of a neighbour
Soup one_point(int level);              ///< all vertices at the same place
/// @}

/// \name The same mesh in another way
/// @{
Soup transformed(Soup soup, const std::function<Point(const Point&)>& f);
Soup joined(Soup soup, const Soup& other, const Vector& shift); ///< both, the other one moved
Soup inside_out(Soup soup);                                     ///< all faces turned over
/// `order[i]` is the old number of the new vertex i. Faces are shuffled too, and start at another corner.
Soup renumbered(const Soup& soup, unsigned seed, std::vector<std::size_t>& order);
/// A rotation matrix, by rows, drawn from `seed`.
std::array<Vector, 3> random_rotation(unsigned seed);
Point apply(const std::array<Vector, 3>& rows, const Point& p);
/// @}

} // namespace test

#endif // TEST_HELPERS_MESHES_H
