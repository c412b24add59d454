// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef BENCHMARK_RETRIEVAL_MEASURES_H
#define BENCHMARK_RETRIEVAL_MEASURES_H

#include <string>
#include <vector>

namespace benchmark {

/// How well a search finds the other members of the query's class, means over all queries whose class has any, in
/// percent: P. Shilane, P. Min, M. Kazhdan, T. Funkhouser, "The Princeton Shape Benchmark", SMI 2004.
struct Retrieval_measures {
  std::size_t queries = 0;
  double nearest_neighbour = 0; ///< the first result is of the class
  double first_tier = 0;        ///< share of the class among the first k results, k being its size
  double second_tier = 0;       ///< among the first 2k
  double e_measure = 0;         ///< harmonic mean of precision and recall of the first 32
  double discounted_gain = 0;   ///< DCG: hits weighted with 1 / log2 of their rank, relative to the best possible
};

typedef std::vector<double> Descriptor_values;

/// L1
double distance(const Descriptor_values& a, const Descriptor_values& b);

/// Something that can be found, or searched for.
struct Labelled {
  std::string label; ///< its class
  Descriptor_values values;
};

/// Every model is a query among all others.
Retrieval_measures measure_retrieval(const std::vector<Labelled>& models);

/// Queries that are not among the models that are searched.
Retrieval_measures measure_retrieval(const std::vector<Labelled>& queries, const std::vector<Labelled>& models);

} // namespace benchmark

#endif // BENCHMARK_RETRIEVAL_MEASURES_H
