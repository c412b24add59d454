// SPDX-License-Identifier: GPL-3.0-or-later
// Where memory runs out, the caller gets std::bad_alloc, nothing is lost, and the next call works. This program has
// operators new and delete of its own, which count, and fail when they are told to.

#include "helpers/meshes.h"
#include "helpers/solve.h"

#include <CGAL/Spherical_parameterization/locate.h>
#include <CGAL/Spherical_parameterization/segmentation.h>
#include <CGAL/Spherical_parameterization/shape_signature.h>
#include <CGAL/Spherical_parameterization/texture_coordinates.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <limits>
#include <new>
#include <string>

namespace {

constexpr long never = std::numeric_limits<long>::max();
std::atomic<long> allocations(0); ///< so far
std::atomic<long> alive(0);       ///< of these not yet freed
std::atomic<long> first_failure(never), last_failure(never);

void* allocate(std::size_t size, std::size_t alignment)
{
  const long k = allocations++;
  void* const memory = k >= first_failure && k <= last_failure ? nullptr
                       : alignment > alignof(std::max_align_t)
                         ? std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment)
                         : std::malloc(size > 0 ? size : 1);
  if(!memory)
    throw std::bad_alloc();
  ++alive;
  return memory;
}

void release(void* memory) noexcept
{
  if(memory)
    --alive;
  std::free(memory);
}

} // namespace

void* operator new(std::size_t size) { return allocate(size, 0); }
void* operator new[](std::size_t size) { return allocate(size, 0); }
void* operator new(std::size_t size, std::align_val_t alignment) { return allocate(size, std::size_t(alignment)); }
void* operator new[](std::size_t size, std::align_val_t alignment) { return allocate(size, std::size_t(alignment)); }
void operator delete(void* memory) noexcept { release(memory); }
void operator delete[](void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete[](void* memory, std::size_t) noexcept { release(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }

using namespace test;

namespace {

/// Lets `work` fail at its k-th allocation, once and from there on, for at most so many k all over it.
void check_every_failure(const std::function<void()>& work, long most = 300)
{
  work(); // what is made once and kept
  const long begin = allocations;
  work();
  const long count = allocations - begin;
  REQUIRE(count > 0);
  const long step = std::max(1l, count / most);
  long failures = 0, kept = 0;
  std::string other;
  for(const bool is_once : {false, true})
    for(long k = 0; k < count; k += step) {
      const long alive_before = alive;
      first_failure = allocations + k;
      last_failure = is_once ? first_failure.load() : never;
      bool has_failed = false;
      try {
        work();
      } catch(const std::bad_alloc&) {
        has_failed = true;
      } catch(const std::exception& e) {
        first_failure = never;
        other = e.what();
      }
      first_failure = never;
      failures += has_failed;
      kept += alive - alive_before;
    }
  CAPTURE(count, failures, other);
  CHECK(other.empty());
  CHECK(failures > 0);
  CHECK(kept == 0);
  CHECK_NOTHROW(work());
}

} // namespace

TEST_CASE("memory: parameterize() hands std::bad_alloc on and loses nothing", "[memory]")
{
  Settings settings;
  const auto method = GENERATE(0, 1, 2, 3, 4);
  settings.number_of_iterations = 5;
  switch(method) {
  case 0: break;
  case 1: settings.method = SP::Balanced{3}; break;
  case 2: settings.method = SP::Saddle_point(); break;
  case 3: settings.method = SP::Isometric(); break;
  case 4: settings.method = SP::Automatic(); break;
  }
  CAPTURE(method);
  const Mesh mesh = make_mesh(method == 4 ? capsule(20, 8) : bumpy_sphere(3));
  Sphere sphere(mesh.number_of_vertices(), Point(0, 0, 0));
  check_every_failure([&] { solve(mesh, sphere, settings); }, method == 4 ? 50 : 300); // the last one takes long
}

TEST_CASE("memory: what is done with maps hands std::bad_alloc on and loses nothing", "[memory]")
{
  const Soup soup = spiky_star(2, 1);
  Mesh mesh = make_mesh(soup);
  const Sphere sphere = solve_or_throw(soup);
  const auto map = boost::make_iterator_property_map(sphere.begin(), get(boost::vertex_index, mesh));
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const auto segment = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  SECTION("texture")
  {
    check_every_failure([&] { SP::texture_coordinates(mesh, map, uv); });
  }
  SECTION("segmentation")
  {
    check_every_failure([&] { SP::segmentation_via_area_stretch(mesh, map, segment); });
  }
  SECTION("inverse map")
  {
    check_every_failure([&] { SP::Spherical_locator<Mesh>(mesh, map).locate(Point(1, 2, 3)); });
  }
  SECTION("signature")
  {
    check_every_failure([&] { SP::shape_signature(mesh, map); });
  }
}
