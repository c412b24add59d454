// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_FANS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_FANS_H

#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The corners at a vertex, in ascending order. Corner 3 f + k is vertex k of face f.
struct Fan {
  int vertex;
  int first; ///< how many corners there are at all smaller vertices together
  const int *begin_of_corners, *end_of_corners;

  const int* begin() const { return begin_of_corners; }
  const int* end() const { return end_of_corners; }
  bool empty() const { return begin_of_corners == end_of_corners; }
  int size() const { return static_cast<int>(end_of_corners - begin_of_corners); }
  int operator[](int i) const { return begin_of_corners[i]; }
};

struct Prefetch_nothing {
  void operator()(int) const {}
};

/// Calls visit(part, fan) for every vertex below n. The vertices are cut into blocks of consecutive ones, which are
/// visited in ascending order on one thread, and different blocks on different threads. Each block has a `Part` of its
/// own to note what it finds. Returns the parts, in the order of the blocks: they are the same for any number of
/// threads.
///
/// Arrays of corners are accessed in no order that the processor foresees: prefetch(corner) may ask for what `visit`
/// will need, and is called for every corner some fans ahead, but for the first ones of a block.
///
/// A counting sort in two steps. The first distributes the corners to the blocks, in parallel, since every part of the
/// faces knows where its corners go; the second one sorts a block in the cache of a core. O(n) time, and 4 bytes per
/// corner.
template <class Part, class Loop, class Visit, class Prefetch = Prefetch_nothing>
std::vector<Part> parts_of_fans(const Loop& loop, const Host_array<std::array<int, 3>>& face, int n, Visit visit,
                                Prefetch prefetch = {})
{
  constexpr int corners_ahead = 36;
  constexpr int smallest_block = 11, most_blocks = 1024, most_parts = 64; // the first one as a power of 2
  int shift = smallest_block;
  while((n >> shift) >= most_blocks)
    ++shift;
  const int blocks = (n >> shift) + 1;
  const auto m = static_cast<std::int64_t>(face.size());
  const int parts = static_cast<int>((std::min)(std::int64_t(most_parts), m / part_size + 1));
  const auto for_each_corner = [&](int part, auto f) {
    for(auto i = static_cast<int>(m * part / parts); i < static_cast<int>(m * (part + 1) / parts); ++i)
      for(int k = 0; k < 3; ++k)
        f(3 * i + k, face[i][k]);
  };

  std::vector<int> place(static_cast<std::size_t>(parts) * blocks, 0); // of the next corner, by part and block
  loop.for_each(parts, [&](int part) {
    int* const count = &place[static_cast<std::size_t>(part) * blocks];
    for_each_corner(part, [&](int, int v) { ++count[v >> shift]; });
  });
  std::vector<int> begin = {0}; // of the corners of a block
  for(int block = 0, sum = 0; block < blocks; ++block) {
    for(int part = 0; part < parts; ++part) {
      int& count = place[static_cast<std::size_t>(part) * blocks + block];
      sum += std::exchange(count, sum);
    }
    begin.push_back(sum);
  }
  Host_array<int> corner(3 * face.size());
  loop.for_each(parts, [&](int part) {
    int* const next = &place[static_cast<std::size_t>(part) * blocks];
    for_each_corner(part, [&](int c, int v) { corner[next[v >> shift]++] = c; });
  });

  std::vector<Part> results(blocks);
  loop.for_each(blocks, [&](int block) {
    const int first_vertex = block << shift, size = (std::min)(1 << shift, n - first_vertex);
    const int first = begin[block], count = begin[block + 1] - first;
    std::vector<int> offset(size + 1, 0), vertex(count), sorted(count);
    for(int i = 0; i < count; ++i) {
      const int c = corner[first + i];
      vertex[i] = face[c / 3][c % 3] - first_vertex;
      ++offset[vertex[i] + 1];
    }
    for(int v = 0; v < size; ++v)
      offset[v + 1] += offset[v];
    std::vector<int> next(offset.begin(), offset.end() - 1);
    for(int i = 0; i < count; ++i)
      sorted[next[vertex[i]]++] = corner[first + i];
    Part part = {};
    for(int v = 0; v < size; ++v) {
      for(int i = offset[v] + corners_ahead; i < (std::min)(offset[v + 1] + corners_ahead, count); ++i)
        prefetch(sorted[i]);
      visit(part, Fan{first_vertex + v, first + offset[v], sorted.data() + offset[v], sorted.data() + offset[v + 1]});
    }
    results[block] = std::move(part);
  });
  return results;
}

/// Calls visit(fan) for every vertex below n, in any order.
template <class Visit>
void for_each_fan(const Host_loop& loop, const Host_array<std::array<int, 3>>& face, int n, Visit visit)
{
  struct Nothing {};
  parts_of_fans<Nothing>(loop, face, n, [&](Nothing&, const Fan& fan) { visit(fan); });
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_FANS_H
