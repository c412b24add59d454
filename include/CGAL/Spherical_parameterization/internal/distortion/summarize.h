// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DISTORTION_SUMMARIZE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DISTORTION_SUMMARIZE_H

#include <CGAL/Spherical_parameterization/internal/distortion/Face_measures.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/surface/Mapped_surface.h>
#include <CGAL/Spherical_parameterization/values/Distortion_summary.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// How values are spread that count with their weights; those without weight do not count. Sums are taken part by part:
/// the result does not depend on the number of threads.
///
/// Values of a sample cut all others into buckets, of which those are sorted where a quantile lies: W. D. Frazer,
/// A. C. McKellar, "Samplesort: a sampling approach to minimal storage tree sorting", Journal of the ACM 17 (1970).
/// O(n) time, and O(n log n) where the sample is not like the others.
CGAL_SP_INLINE Distribution distribution(const Host_loop& loop, const Host_array<double>& value,
                                         const Host_array<double>& weight)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr int buckets = 128, most_samples = 32 * buckets; // the first one is a power of 2
  const int n = static_cast<int>(value.size());
  struct Sums {
    double weight = 0, product = 0, min = infinity, max = -infinity;
  } all;
  for(const Sums& part : results_of_parts(loop, n, [&](int begin, int end) {
        Sums sums;
        for(int i = begin; i < end; ++i)
          if(weight[i] > 0) {
            sums.weight += weight[i];
            sums.product += weight[i] * value[i];
            sums.min = (std::min)(sums.min, value[i]);
            sums.max = (std::max)(sums.max, value[i]);
          }
        return sums;
      })) {
    all.weight += part.weight;
    all.product += part.product;
    all.min = (std::min)(all.min, part.min);
    all.max = (std::max)(all.max, part.max);
  }
  Distribution d;
  if(!(all.weight > 0))
    return d;
  d.mean = all.product / all.weight;
  d.min = all.min;
  d.max = all.max;

  std::vector<double> sample;
  for(int i = 0; i < n; i += 1 + n / most_samples)
    if(weight[i] > 0 && !std::isnan(value[i]))
      sample.push_back(value[i]);
  if(sample.empty())
    sample.push_back(d.min);
  std::sort(sample.begin(), sample.end());
  std::array<double, buckets - 1> bound; // bound[k] is the smallest value of bucket k + 1
  for(std::size_t k = 0; k < bound.size(); ++k)
    bound[k] = sample[(k + 1) * sample.size() / buckets];
  // by bisection without branches, since they would be taken wrongly half of the time
  const auto bucket_of = [&](double x) {
    int bucket = 0;
    for(int step = buckets / 2; step > 0; step /= 2)
      bucket += step * static_cast<int>(x >= bound[bucket + step - 1]);
    return bucket;
  };
  struct Bucket_sums {
    double squares = 0;
    std::array<double, buckets> weight = {};
  } of_buckets;
  for(const Bucket_sums& part : results_of_parts(loop, n, [&](int begin, int end) {
        Bucket_sums sums;
        for(int i = begin; i < end; ++i)
          if(weight[i] > 0) {
            sums.squares += weight[i] * (value[i] - d.mean) * (value[i] - d.mean);
            sums.weight[bucket_of(value[i])] += weight[i];
          }
        return sums;
      })) {
    of_buckets.squares += part.squares;
    for(int k = 0; k < buckets; ++k)
      of_buckets.weight[k] += part.weight[k];
  }
  d.deviation = std::isinf(d.mean) ? infinity : std::sqrt(of_buckets.squares / all.weight);

  typedef std::vector<std::pair<double, double>> Sorted; // values and their weights
  const auto contents = [&](int bucket) {
    const bool is_first = bucket == 0, is_last = bucket == buckets - 1;
    const double low = is_first ? -infinity : bound[bucket - 1], high = is_last ? infinity : bound[bucket];
    Sorted result;
    for(const Sorted& part : results_of_parts(loop, n, [&](int begin, int end) {
          Sorted values;
          for(int i = begin; i < end; ++i) {
            const int is_above = value[i] >= low, is_below = (value[i] < high) | is_last;
            if((is_above & is_below) != 0 && weight[i] > 0) // one branch: which of the two fails is a matter of chance
              values.emplace_back(value[i], weight[i]);
          }
          return values;
        }))
      result.insert(result.end(), part.begin(), part.end());
    std::sort(result.begin(), result.end());
    return result;
  };
  int bucket = 0;
  double below = 0; // the weight of the buckets before this one
  for(const auto& [share, quantile] :
      {std::pair(0.01, &d.percentile_1), std::pair(0.05, &d.percentile_5), std::pair(0.5, &d.median),
       std::pair(0.95, &d.percentile_95), std::pair(0.99, &d.percentile_99)}) {
    const double goal = share * all.weight;
    const auto is_before = [&](double of_next) { return of_next == 0 || below + of_next < goal; };
    while(bucket + 1 < buckets && is_before(of_buckets.weight[bucket])) // the last one has the largest bound
      below += of_buckets.weight[bucket++];
    double sum = below;
    for(const auto& [its_value, its_weight] : contents(bucket)) {
      *quantile = its_value;
      sum += its_weight;
      if(sum >= goal)
        break;
    }
  }
  return d;
}

CGAL_SP_INLINE Distortion_summary summarize(const Host_loop& loop, const Mapped_surface& map)
{
  const Face_measures measures(map, loop);
  const int n = measures.number_of_faces();
  std::array<Host_array<double>, 5> value;
  Host_array<double> weight(n);
  for(Host_array<double>& values : value)
    values.resize(n);
  measures.for_each_face(loop, [&](int f, const Face_measures::Values& of_face) {
    value[0][f] = of_face.log_area_stretch;
    value[1][f] = of_face.angle_distortion;
    value[2][f] = of_face.dilatation;
    value[3][f] = of_face.flat_symmetric_dirichlet;
    value[4][f] = of_face.spherical_symmetric_dirichlet;
    weight[f] = measures.source_area(f);
  });
  Distortion_summary summary;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const Distribution unknown = {none, none, none, none, none, none, none, none, none};
  const bool is_flipped = first_index(loop, n, [&](int f) { return measures.is_flipped(f); }) < n;
  summary.log_area_stretch = is_flipped ? unknown : distribution(loop, value[0], weight);
  summary.angle_distortion = distribution(loop, value[1], weight);
  summary.dilatation = distribution(loop, value[2], weight);
  summary.symmetric_dirichlet = distribution(loop, value[3], weight);
  summary.spherical_symmetric_dirichlet = is_flipped ? unknown : distribution(loop, value[4], weight);
  summary.degenerate_faces =
    static_cast<std::size_t>(std::count_if(weight.begin(), weight.end(), [](double w) { return !(w > 0); }));
  return summary;
}

/// Of every face: max(sigma_1, 1 / sigma_2) of the affine map to its image, which need not be on a sphere, after both
/// surfaces have been scaled to the same area; 1 if the face has no area.
CGAL_SP_INLINE Host_array<double> length_changes(const Host_loop& loop, const Mapped_surface& map)
{
  const Host_array<double>& area = map.face_area(loop);
  const auto image_area = [&](int f) { return flat_area(map.of_image(f)); };
  const double scale = sum_by_parts(loop, map.number_of_faces(), [&](int f) { return area[f]; }) /
                       sum_by_parts(loop, map.number_of_faces(), image_area); // of squared lengths
  Host_array<double> change(map.face.size());
  for_each_index(loop, map.number_of_faces(), [&](int f) {
    change[f] = 1;
    if(!(area[f] > 0))
      return;
    const double half = scale * squared_singular_values(map.in_source(f), area[f], map.of_image(f)) / 2;
    const double product = scale * image_area(f) / area[f]; // of both singular values
    const double larger = half + std::sqrt((std::max)(0., (half - product) * (half + product))); // the square of one
    change[f] = product > 0 ? std::sqrt((std::max)({1., larger, larger / product / product}))
                            : std::numeric_limits<double>::infinity();
  });
  return change;
}

/// How they are spread over the surface.
CGAL_SP_INLINE Length_changes summarize_length_changes(const Host_loop& loop, const Host_array<double>& area,
                                                       const Host_array<double>& change)
{
  Length_changes result;
  result.factor = distribution(loop, change, area);
  const int n = static_cast<int>(area.size());
  const double whole = sum_by_parts(loop, n, [&](int f) { return area[f]; });
  const double large = sum_by_parts(loop, n, [&](int f) { return change[f] > Length_changes::large ? area[f] : 0; });
  result.share_of_large = large / whole;
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DISTORTION_SUMMARIZE_H
