// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "shapes/retrieval_measures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace benchmark {
namespace {

/// 1 for ranks 1 and 2, then falling
double discount(std::size_t rank) { return rank < 2 ? 1 : 1 / std::log2(static_cast<double>(rank)); }

/// Adds up the measures of one query; `is_hit` says by rank, from 0 on, whether the result is of the query's class.
void add(const std::vector<bool>& is_hit, Retrieval_measures& sum)
{
  constexpr std::size_t page = 32;
  const auto hits_among = [&](std::size_t n) {
    return static_cast<double>(std::count(is_hit.begin(), is_hit.begin() + std::min(n, is_hit.size()), true));
  };
  const auto members = static_cast<std::size_t>(hits_among(is_hit.size()));
  if(members == 0)
    return;
  ++sum.queries;
  sum.nearest_neighbour += is_hit[0];
  sum.first_tier += hits_among(members) / members;
  sum.second_tier += hits_among(2 * members) / members;
  // harmonic mean of hits / shown and hits / members
  sum.e_measure += 2 * hits_among(page) / (std::min(page, is_hit.size()) + members);
  double gain = 0, best = 0;
  for(std::size_t rank = 1; rank <= is_hit.size(); ++rank) {
    gain += is_hit[rank - 1] ? discount(rank) : 0;
    best += rank <= members ? discount(rank) : 0;
  }
  sum.discounted_gain += gain / best;
}

Retrieval_measures percent_of_queries(Retrieval_measures m)
{
  for(double* value : {&m.nearest_neighbour, &m.first_tier, &m.second_tier, &m.e_measure, &m.discounted_gain})
    *value *= 100. / std::max<std::size_t>(m.queries, 1);
  return m;
}

/// `skip`: the query itself, if it is one of the models
void search(const Labelled& query, const std::vector<Labelled>& models, const Labelled* skip, Retrieval_measures& sum)
{
  std::vector<std::pair<double, const Labelled*>> results;
  for(const Labelled& model : models)
    if(&model != skip)
      results.emplace_back(distance(query.values, model.values), &model);
  std::stable_sort(results.begin(), results.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<bool> is_hit;
  for(const auto& result : results)
    is_hit.push_back(result.second->label == query.label);
  add(is_hit, sum);
}

} // namespace

double distance(const Descriptor_values& a, const Descriptor_values& b)
{
  double sum = 0;
  for(std::size_t i = 0; i < a.size(); ++i)
    sum += std::abs(a[i] - b[i]);
  return sum;
}

Retrieval_measures measure_retrieval(const std::vector<Labelled>& models)
{
  Retrieval_measures sum;
  for(const Labelled& query : models)
    search(query, models, &query, sum);
  return percent_of_queries(sum);
}

Retrieval_measures measure_retrieval(const std::vector<Labelled>& queries, const std::vector<Labelled>& models)
{
  Retrieval_measures sum;
  for(const Labelled& query : queries)
    search(query, models, nullptr, sum);
  return percent_of_queries(sum);
}

} // namespace benchmark
