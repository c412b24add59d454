// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"
#include "measure/measure.h"
#include "tables/table.h"

#include "collections/shape_index.h"
#include "system/refusal.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <functional>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace benchmark {
namespace {

namespace fs = std::filesystem;
using tool::Shape_signature;

/// Of a shape that does not exist: girths round a mean one, and up to eight limbs.
Shape_signature signature_of(std::uint64_t number)
{
  std::mt19937_64 engine(number);
  const auto random = [&engine] { return std::ldexp(static_cast<double>(engine() >> 11), -53); };
  Shape_signature signature;
  auto* value = signature.values.begin();
  const double middle = 0.2 + 0.6 * random(), width = 0.03 + 0.2 * random();
  for(const std::size_t bins : {Shape_signature::coarse_bins, Shape_signature::fine_bins}) {
    auto* const end = value + bins;
    double sum = 0;
    for(std::size_t i = 0; i < bins; ++i) {
      const double x = ((static_cast<double>(i) + 0.5) / static_cast<double>(bins) - middle) / width;
      sum += value[i] = std::exp(-x * x / 2) * (0.8 + 0.4 * random());
    }
    for(; value != end; ++value)
      *value /= 2 * sum;
  }
  const auto limbs = static_cast<std::size_t>(random() * (Shape_signature::limbs + 1));
  for(int kind = 0; kind < 2; ++kind, value += Shape_signature::limbs) { // lengths, areas
    std::generate_n(value, limbs, [&] { return -0.3 * std::log(1 - random()); });
    std::sort(value, value + Shape_signature::limbs, std::greater<>());
  }
  return signature;
}

std::string name_of(std::uint64_t number) { return "shape " + std::to_string(number); }

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

} // namespace

void tabulate_index(const Options& options)
{
  constexpr std::uint64_t queries = 20;
  constexpr std::size_t neighbours = 10;
  Table table(
    options.output, "index", "The index of signatures: rows that are put in one by one, and searched",
    {"signatures of shapes that do not exist; search: the 10 nearest of 20 others, the first of which are compared "
     "with those of a search through all",
     "CPU s: of one core"},
    {"rows", "bytes per row", "inserts per s", "inserts per CPU s", "first search s", "search s", "search CPU s",
     "exact"});
  fs::create_directories(options.output);
  const std::string file = (fs::path(options.output) / "index_of_benchmark.db").string();
  fs::remove(file);
  const auto rows = static_cast<std::uint64_t>(options.rows);
  try {
    const Stopwatch watch;
    const double start = cpu_seconds();
    {
      tool::Shape_index index(file, tool::Database::Access::WRITE);
      for(std::uint64_t i = 0; i < rows; ++i) {
        tool::Signature_row row;
        row.name = name_of(i);
        row.vertices = 1000;
        row.status = "OK";
        row.map = "clamped";
        row.signature = signature_of(i);
        index.put(row);
      }
    }
    const double insertion = watch.seconds(), cpu_insertion = cpu_seconds() - start;

    const tool::Shape_index index(file, tool::Database::Access::READ);
    double first = 0;
    const Stopwatch searching;
    double search_start = cpu_seconds();
    std::set<std::pair<double, std::string>> found;
    for(std::uint64_t i = 0; i < queries; ++i) {
      const auto nearest = index.nearest(signature_of(rows + i), neighbours);
      if(i == 0) {
        found = nearest;
        first = searching.seconds();
        search_start = cpu_seconds();
      }
    }
    const double search = (searching.seconds() - first) / (queries - 1);
    const double cpu_search = (cpu_seconds() - search_start) / (queries - 1);

    std::set<std::pair<double, std::string>> expected;
    const Shape_signature query = signature_of(rows);
    for(std::uint64_t i = 0; i < rows; ++i) {
      expected.emplace(distance(query, signature_of(i)), name_of(i));
      if(expected.size() > neighbours)
        expected.erase(std::prev(expected.end()));
    }
    const double count = static_cast<double>(rows);
    table.add_row({rows, static_cast<double>(fs::file_size(file)) / count, count / insertion, count / cpu_insertion,
                   first, search, cpu_search, found == expected ? "yes" : "NO"});
  } catch(const tool::Refusal& refusal) {
    throw std::runtime_error(refusal.what());
  }
  fs::remove(file);
}

} // namespace benchmark
