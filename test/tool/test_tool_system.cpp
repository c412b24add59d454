// SPDX-License-Identifier: GPL-3.0-or-later
// What the tool asks of the system: files that are complete or not there, threads, memory.

#include "helpers/tool.h"

#include "collections/compute_in_parallel.h"
#include "output/atomic_file.h"
#include "runner/page.h"
#include "system/refusal.h"

#include <catch2/catch.hpp>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <string>

#include <sys/syscall.h>
#include <unistd.h>

using namespace test;
namespace fs = std::filesystem;

namespace {

thread_local int allocations_left = -1; ///< on this thread, until one fails; below 0: none does
std::string awaited;                    ///< a file that must not have its name before it is on the disk
int times_on_disk = 0;

} // namespace

void* operator new(std::size_t size)
{
  if(allocations_left == 0) {
    allocations_left = -1;
    throw std::bad_alloc();
  }
  if(allocations_left > 0)
    --allocations_left;
  if(void* memory = std::malloc(size))
    return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

extern "C" int fsync(int file)
{
  times_on_disk += !awaited.empty() && !fs::exists(awaited);
  return static_cast<int>(syscall(SYS_fsync, file));
}

TEST_CASE("system: a file is on the disk before it gets its name", "[tool][system]")
{
  Scratch scratch;
  awaited = scratch / "out.txt";
  tool::Atomic_files files;
  files.open(awaited) << "all of it";
  files.commit();
  CHECK(times_on_disk == 1);
  CHECK(text_of(awaited) == "all of it");
  awaited.clear();
}

TEST_CASE("system: nobody can guess where the standard output is kept until it is complete", "[tool][system]")
{
  Scratch scratch;
  write_text(scratch / "mine", "stays");
  const auto folder = fs::temp_directory_path();
  const std::string name = folder / ("spherical-parameterization.part" + std::to_string(getpid()));
  fs::remove(name);
  fs::create_symlink(scratch / "mine", name);
  {
    tool::Atomic_file out("-");
    out.stream() << "data" << std::flush;
  }
  CHECK(text_of(scratch / "mine") == "stays");
  fs::remove(name);
}

TEST_CASE("system: a batch goes on without the threads for which there is no memory", "[tool][system]")
{
  for(int allocations = 0; allocations < 30; ++allocations) {
    CAPTURE(allocations);
    std::atomic<int> done{0};
    const std::function<tool::Store(std::size_t)> compute = [&done](std::size_t) -> tool::Store {
      ++done;
      return nullptr;
    };
    bool has_memory = true;
    allocations_left = allocations;
    try {
      tool::compute_in_parallel(20, 8, compute);
    } catch(const std::bad_alloc&) {
      has_memory = false;
    }
    allocations_left = -1;
    CHECK((done == 20 || !has_memory));
  }
}

TEST_CASE("system: a page has no room for more vertices than its numbers reach", "[tool][system]")
{
  CHECK_NOTHROW(tool::Page::check_size("in.ply", 16777216));
  CHECK_THROWS_WITH(tool::Page::check_size("in.ply", 16777217),
                    "in.ply: has 16777217 vertices, and a page holds 16777216; simplify the mesh");
}

TEST_CASE("system: of what the library says only its advice is left out", "[tool][system]")
{
  CHECK(tool::without_remedy("a; b; c", "c") == "a; b");
  CHECK(tool::without_remedy("a; b", "") == "a; b");
}
