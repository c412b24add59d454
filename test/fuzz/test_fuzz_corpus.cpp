// SPDX-License-Identifier: GPL-3.0-or-later
// The kept inputs of the fuzzers (fuzz/), among them all that ever failed, through the same functions.

#include "fuzz/targets.h"

#include <CGAL/assertions.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

void print_nothing(const char*, const char*, const char*, int, const char*) {}

void run_all(const std::string& target, void (*run)(const std::uint8_t*, std::size_t))
{
  CGAL::set_error_handler(print_nothing);
  std::vector<fs::path> files;
  for(const char* kind : {"corpus", "found"})
    if(fs::is_directory(fs::path(FUZZ_FOLDER) / kind / target))
      for(const auto& entry : fs::directory_iterator(fs::path(FUZZ_FOLDER) / kind / target))
        files.push_back(entry.path());
  REQUIRE(!files.empty());
  std::sort(files.begin(), files.end());
  for(const fs::path& file : files) {
    CAPTURE(file);
    std::ifstream in(file, std::ios::binary);
    const std::vector<char> text{std::istreambuf_iterator<char>(in), {}};
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    CHECK_NOTHROW(run(bytes.data(), bytes.size()));
  }
}

} // namespace

TEST_CASE("fuzz: files of meshes", "[fuzz]") { run_all("read_meshes", fuzz::read_meshes); }
TEST_CASE("fuzz: files of meshes in other formats", "[fuzz]") { run_all("read_formats", fuzz::read_formats); }
TEST_CASE("fuzz: values and labels at vertices", "[fuzz]") { run_all("read_data", fuzz::read_data); }
TEST_CASE("fuzz: indices of signatures", "[fuzz]") { run_all("read_indices", fuzz::read_indices); }
TEST_CASE("fuzz: maps of any mesh", "[fuzz]") { run_all("map_meshes", fuzz::map_meshes); }
TEST_CASE("fuzz: uses of any map", "[fuzz]") { run_all("use_maps", fuzz::use_maps); }
