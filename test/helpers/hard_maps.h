// SPDX-License-Identifier: GPL-3.0-or-later
// Valid spherical maps that are as hard on their users as valid maps can be.

#ifndef TEST_HELPERS_HARD_MAPS_H
#define TEST_HELPERS_HARD_MAPS_H

#include "helpers/soup.h"

#include <string>
#include <vector>

namespace test {

/// A mesh and its map, without flipped faces and of degree 1.
struct Mapped_soup {
  std::string name;
  Soup soup;
  Sphere sphere;
};

/// Two fans and between them a band of needles, `n` on either side, that are `half_width` times 2 thin and follow a
/// great circle: any chart that bends it by more flips the needles. In a random position.
Mapped_soup needles(int n, double half_width, unsigned seed);

/// A sphere with the star of one vertex `scale` times as large as it was. In a random position.
Mapped_soup small_star(double scale, unsigned seed);

/// Solved maps with limbs, solids of few faces, and the above.
std::vector<Mapped_soup> hard_maps();

} // namespace test

#endif // TEST_HELPERS_HARD_MAPS_H
