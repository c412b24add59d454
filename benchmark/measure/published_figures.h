// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// The tables of T. Athanasiadis and I. Fudos, "Parallel computation of spherical parameterizations for mesh analysis",
// Computers & Graphics 35 (SMI 2011), section 4. All rows of Tables 1 to 4 are here. Left out are Figure 1 (CPU against
// GPU, logarithmic) and Figure 2 (cache hit rates): they are diagrams without numbers.
//
// Hardware: an NVIDIA GTX 480 (Tables 1, 2, 3), an Intel Core i7-870 with 4, 2 and 1 of its cores (Table 3) and an
// Intel Core Duo E6600 (Table 4), all by OpenCL 1.1. Tables 1 and 2 give the L2 residual in units of 1e-8; an iteration
// is one saddle-point problem. The models are often other versions than ours: the number of vertices tells.

#ifndef BENCHMARK_PUBLISHED_FIGURES_H
#define BENCHMARK_PUBLISHED_FIGURES_H

#include "meshes/mesh.h"

#include <cctype>
#include <cmath>
#include <cstddef>
#include <string>

namespace benchmark::published {

constexpr Weights B = Weights::BARYCENTRIC;
constexpr Weights C = Weights::CONFORMAL;

/// Numerical results on the GPU.
struct Map_row {
  const char* model;
  Weights weights;
  std::size_t vertices, faces;
  int iterations;
  double residual_1e8;
  double seconds; ///< GTX 480
};
constexpr Map_row table_1[] = {{"suzanne", B, 7573, 15142, 4, 5, 0.575},   {"suzanne", C, 7573, 15142, 3, 5, 0.589},
                               {"gargoyle", B, 24990, 49976, 4, 2, 1.706}, {"gargoyle", C, 24990, 49976, 3, 6, 2.326},
                               {"igea", B, 25586, 51168, 3, 4, 0.908},     {"igea", C, 25586, 51168, 2, 3, 0.936},
                               {"lionvase", B, 38952, 77900, 3, 3, 1.567}, {"lionvase", C, 38952, 77900, 3, 3, 2.053},
                               {"homer", B, 78850, 157696, 3, 1, 4.923},   {"homer", C, 78850, 157696, 3, 4, 10.920},
                               {"buste", B, 183580, 367156, 3, 1, 13.759}, {"buste", C, 183580, 367156, 2, 1, 22.667}};

/// Levels of detail on the GPU, without and with vertex locality optimization.
struct Level_row {
  const char* model;
  Weights weights;
  std::size_t vertices, faces;
  int iterations;
  double residual_1e8;
  double seconds, optimized_seconds; ///< GTX 480
};
constexpr Level_row table_2[] = {{"homer", B, 5002, 10000, 4, 10, 0.577, 0.483},
                                 {"homer", B, 10002, 20000, 4, 2, 1.059, 0.725},
                                 {"homer", B, 20002, 40000, 4, 2, 1.961, 1.224},
                                 {"homer", B, 40002, 80000, 3, 2, 3.986, 2.178},
                                 {"homer", B, 78850, 157696, 3, 1, 4.923, 3.636}};

/// GPU, and CPU with different core configurations.
struct Device_row {
  const char* model;
  Weights weights;
  std::size_t vertices, faces;
  int iterations;
  double gtx_480, i7_4_cores, i7_2_cores, i7_1_core; ///< seconds
};
constexpr Device_row table_3[] = {{"gargoyle", B, 10002, 20000, 4, 0.946, 1.186, 1.950, 3.135},
                                  {"gargoyle", C, 10002, 20000, 4, 0.949, 1.045, 1.685, 2.714},
                                  {"torso", B, 11362, 22720, 4, 0.718, 1.107, 1.731, 2.808},
                                  {"torso", C, 11362, 22720, 3, 0.870, 1.123, 1.747, 2.745},
                                  {"skull", B, 20002, 40000, 3, 0.649, 1.076, 1.719, 2.904},
                                  {"skull", C, 20002, 40000, 2, 0.643, 0.920, 1.373, 2.230},
                                  {"bunny", B, 67038, 134074, 3, 1.217, 3.616, 6.635, 12.038},
                                  {"bunny", C, 67038, 134074, 2, 2.158, 3.778, 7.737, 14.118}};

/// The published method, and that of Saba et al. (2005), both on the E6600.
struct Comparison_row {
  const char* model;
  Weights weights;
  std::size_t vertices, faces;
  double saba_seconds, seconds;
};
constexpr Comparison_row table_4[] = {
  {"gargoyle", B, 10002, 20000, 23.58, 3.422}, {"gargoyle", C, 10002, 20000, 62.86, 2.734},
  {"torso", B, 11362, 22720, 26.50, 2.704},    {"torso", C, 11362, 22720, 84.49, 2.719},
  {"skull", B, 20002, 40000, 67.73, 2.828},    {"skull", C, 20002, 40000, 87.26, 2.469}};

/// The row for a model of our own, or null: its name has to start with the paper's ("homer_lod_5002" with "homer"), and
/// the number of vertices to be nearest, and at most twice or half as large.
template <class Row, std::size_t n>
const Row* find(const Row (&table)[n], const std::string& model, Weights weights, std::size_t vertices)
{
  std::string letters;
  for(unsigned char c : model)
    if(std::isalpha(c))
      letters += static_cast<char>(std::tolower(c));
  const auto distance = [&](const Row& row) { return std::abs(std::log(double(row.vertices) / double(vertices))); };
  const Row* best = nullptr;
  for(const Row& row : table)
    if(row.weights == weights && letters.rfind(row.model, 0) == 0 && distance(row) <= std::log(2.) &&
       (best == nullptr || distance(row) < distance(*best)))
      best = &row;
  return best;
}

} // namespace benchmark::published

#endif // BENCHMARK_PUBLISHED_FIGURES_H
