// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_DISTORTION_SUMMARY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_DISTORTION_SUMMARY_H

#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/base/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/distortion/Face_measures.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationMeasures
/// @{

/// How a measure is spread over the surface: every face counts with its source area.
struct Distribution {
  double mean = 0;          ///< weighted by area
  double deviation = 0;     ///< root of the mean square difference from the mean
  double min = 0;           ///< the smallest value
  double percentile_1 = 0;  ///< 1 % of the area have smaller values
  double percentile_5 = 0;  ///< 5 % of the area have smaller values
  double median = 0;        ///< half of the area has smaller values
  double percentile_95 = 0; ///< 5 % of the area have larger values
  double percentile_99 = 0; ///< 1 % of the area have larger values
  double max = 0;           ///< the largest value
};

/// The distortion of a map; see `measure_distortion.h` for the measures.
struct Distortion_summary {
  Distribution log_area_stretch;    ///< see `face_log_area_stretch()`
  Distribution angle_distortion;    ///< radians; see `face_angle_distortion()`
  Distribution dilatation;          ///< see `face_dilatation()`
  Distribution symmetric_dirichlet; ///< between flat triangles; 4 = isometric; see `face_symmetric_dirichlet()`
  /// With det(a, b, c) / 2 in place of the area of the flat triangle abc on the sphere: the inscribed polyhedron of a
  /// map may be far from the sphere, as with long edges along a tube, and the flat measure does not see it.
  Distribution spherical_symmetric_dirichlet;
  std::size_t degenerate_faces = 0; ///< source faces without area: they do not count
};

namespace internal {

/// `values` are pairs of value and weight; they get sorted.
inline Distribution distribution(std::vector<std::pair<double, double>>& values)
{
  Distribution d;
  if(values.empty())
    return d;
  std::sort(values.begin(), values.end());
  double total = 0, sum = 0;
  for(const auto& [value, weight] : values) {
    total += weight;
    sum += weight * value;
  }
  d.mean = sum / total;
  double squares = 0;
  for(const auto& [value, weight] : values)
    squares += weight * (value - d.mean) * (value - d.mean);
  d.deviation = std::sqrt(squares / total);
  d.min = values.front().first;
  d.max = values.back().first;

  double below = 0;
  auto it = values.begin();
  for(const auto& [share, quantile] :
      {std::pair(0.01, &d.percentile_1), std::pair(0.05, &d.percentile_5), std::pair(0.5, &d.median),
       std::pair(0.95, &d.percentile_95), std::pair(0.99, &d.percentile_99)}) {
    while(it + 1 != values.end() && below + it->second < share * total)
      below += (it++)->second;
    *quantile = it->first;
  }
  return d;
}

/// A measure each is summarized on a thread.
template <class Loop>
Distortion_summary summarize(const Loop& loop, const Face_measures& measures)
{
  const std::array<std::pair<double (Face_measures::*)(int) const, Distribution Distortion_summary::*>, 5> jobs = {
    {{&Face_measures::log_area_stretch, &Distortion_summary::log_area_stretch},
     {&Face_measures::angle_distortion, &Distortion_summary::angle_distortion},
     {&Face_measures::dilatation, &Distortion_summary::dilatation},
     {&Face_measures::flat_symmetric_dirichlet, &Distortion_summary::symmetric_dirichlet},
     {&Face_measures::spherical_symmetric_dirichlet, &Distortion_summary::spherical_symmetric_dirichlet}}};
  Distortion_summary summary;
  loop.for_each(static_cast<int>(jobs.size()), [&](int job) {
    const auto [measure, distribution_of_measure] = jobs[job];
    const Host_array<double> value = measures.values(loop, measure);
    std::vector<std::pair<double, double>> values;
    for(int f = 0; f < measures.number_of_faces(); ++f)
      if(measures.source_area(f) > 0)
        values.emplace_back(value[f], measures.source_area(f));
    summary.*distribution_of_measure = distribution(values);
  });
  for(int f = 0; f < measures.number_of_faces(); ++f)
    summary.degenerate_faces += !(measures.source_area(f) > 0);
  return summary;
}

} // namespace internal

/// The distortion of a valid map in figures: area, angle and quasi-conformal distortion, symmetric Dirichlet energy.
/// \param policy      `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param mesh        a closed triangle mesh, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors
/// \param np          optional named parameters: `vertex_point_map`, by default the mesh's own
/// \return how each measure is distributed over the source area
///
/// Complexity: O(n log n).
template <class ExecutionPolicy, class TriangleMesh, class VertexSphereMap, class CGAL_NP_TEMPLATE_PARAMETERS>
Distortion_summary distortion_summary(const ExecutionPolicy& policy, const TriangleMesh& mesh,
                                      VertexSphereMap sphere_map,
                                      const CGAL_NP_CLASS& np = parameters::default_values())
{
  const auto loop = internal::host_loop(policy);
  return internal::summarize(loop, internal::make_face_measures(mesh, sphere_map, np, loop));
}

/// \overload
/// \param mesh,sphere_map,np as above; on one core \return as above
template <class TriangleMesh, class VertexSphereMap, class CGAL_NP_TEMPLATE_PARAMETERS>
Distortion_summary distortion_summary(const TriangleMesh& mesh, VertexSphereMap sphere_map,
                                      const CGAL_NP_CLASS& np = parameters::default_values())
{
  return distortion_summary(CGAL::Sequential_tag(), mesh, sphere_map, np);
}

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_DISTORTION_SUMMARY_H
