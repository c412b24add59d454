// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes and numbers as the rooms have them, for tests of single rooms: these need neither CGAL's meshes nor the core.

#ifndef TEST_HELPERS_ARRAYS_H
#define TEST_HELPERS_ARRAYS_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace test {

namespace I = CGAL::Spherical_parameterization::internal;
using I::vec3;
typedef I::Host_array<std::array<int, 3>> Faces;
typedef I::Host_array<vec3> Positions;

class Random {
public:
  explicit Random(unsigned seed = 1) : generator_(seed) {}
  double number(double low = -1, double high = 1)
  {
    return low + (high - low) * (static_cast<double>(generator_()) / static_cast<double>(std::mt19937::max()));
  }
  vec3 vector() { return {number(), number(), number()}; }
  vec3 unit_vector() { return I::unit(vector()); }

private:
  std::mt19937 generator_;
};

struct Plain_mesh {
  Positions point;
  Faces face;

  std::vector<std::vector<int>> neighbours() const
  {
    std::vector<std::vector<int>> result(point.size());
    for(const std::array<int, 3>& f : face)
      for(int k = 0; k < 3; ++k)
        result[f[k]].push_back(f[(k + 1) % 3]);
    return result;
  }
};

/// An octahedron on the unit sphere, cut in four `level` times.
inline Plain_mesh octasphere(int level)
{
  Plain_mesh mesh = {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                     {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  for(; level > 0; --level) {
    std::map<std::pair<int, int>, int> middle;
    const auto between = [&](int i, int j) {
      const auto [at, is_new] = middle.try_emplace(std::minmax(i, j), static_cast<int>(mesh.point.size()));
      if(is_new)
        mesh.point.push_back(I::unit(I::add(mesh.point[i], mesh.point[j])));
      return at->second;
    };
    Faces finer;
    for(const auto& [i, j, k] : mesh.face) {
      const int a = between(i, j), b = between(j, k), c = between(k, i);
      for(const std::array<int, 3>& f : {std::array<int, 3>{i, a, c}, {a, j, b}, {c, b, k}, {a, b, c}})
        finer.push_back(f);
    }
    mesh.face = finer;
  }
  return mesh;
}

} // namespace test

#endif // TEST_HELPERS_ARRAYS_H
