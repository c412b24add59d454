// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_STRETCH_HISTOGRAM_H
#define CGAL_SPHERICAL_PARAMETERIZATION_STRETCH_HISTOGRAM_H

#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/api/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/distortion/Face_measures.h>
#include <CGAL/Spherical_parameterization/internal/algebra/histogram.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationSearch
/// @{

/// Which histogram of the area stretch.
struct Stretch_histogram {
  /// How the surface is weighed. Every point has the stretch of the vertex in whose barycentric cell it lies.
  enum class Sampling {
    EXACT_AREAS, ///< no sampling: every vertex counts with the area of its cell
    UNIFORM,     ///< evenly spaced in the accumulated area of the faces
    RANDOM,      ///< independent points, uniformly distributed by area
    VERTICES     ///< no sampling, and every vertex counts alike: depends on the tessellation
  };
  /// What is counted.
  enum class Scale {
    LOGARITHMIC, ///< log of the stretch, which reaches 60 in limbs
    LINEAR       ///< the stretch itself
  };
  Sampling sampling = Sampling::EXACT_AREAS; ///< how the surface is weighed
  Scale scale = Scale::LOGARITHMIC;          ///< what is counted
  std::size_t bins = 32;                     ///< 2 or more
  double low = -4;                           ///< where the first bin begins, on the scale; what lies below counts there
  double high = 28;                          ///< where the last bin ends; what lies above counts there
  std::size_t number_of_samples = 4096;      ///< `UNIFORM` and `RANDOM`; fewer than about 4096 add noise
  std::uint32_t random_seed = 0;             ///< `RANDOM`
};

namespace internal {

/// How many area-uniform points lie in the barycentric cell of each vertex. `accumulated` has the areas of the faces,
/// added up in their order.
inline std::vector<double> sample_cells(const Stretch_histogram& options, const std::vector<double>& accumulated,
                                        const Host_array<std::array<int, 3>>& corners, std::size_t cells)
{
  std::vector<double> count(cells, 0);
  // At `position` in [0, 1) of all area; (s, t) in the unit square chooses a point of the face there.
  const auto add_point = [&](double position, double s, double t) {
    const auto it = std::upper_bound(accumulated.begin(), accumulated.end(), position * accumulated.back());
    const auto f = (std::min)(static_cast<std::size_t>(it - accumulated.begin()), corners.size() - 1);
    if(s + t > 1) { // folds the square on the triangle
      s = 1 - s;
      t = 1 - t;
    }
    const std::array<double, 3> barycentric = {s, t, 1 - s - t};
    ++count[corners[f][std::max_element(barycentric.begin(), barycentric.end()) - barycentric.begin()]];
  };
  const std::size_t n = options.number_of_samples;
  if(options.sampling == Stretch_histogram::Sampling::RANDOM) {
    std::mt19937 generator(options.random_seed);
    const auto uniform = [&] { return generator() * 0x1p-32; }; // the same numbers with every standard library
    for(std::size_t k = 0; k < n; ++k) {
      const double position = uniform(), s = uniform(), t = uniform();
      add_point(position, s, t);
    }
  } else {
    // M. Roberts' sequence: multiples of the inverse powers of the plastic number fill the unit square evenly.
    constexpr double plastic = 1.32471795724474602596;
    for(std::size_t k = 0; k < n; ++k) {
      const double s = std::fmod(0.5 + k / plastic, 1.), t = std::fmod(0.5 + k / (plastic * plastic), 1.);
      add_point((k + 0.5) / n, s, t);
    }
  }
  return count;
}

/// \param stretch  of the vertices
inline std::vector<double> stretch_histogram(const Face_measures& measures, const Host_array<double>& stretch,
                                             const Stretch_histogram& options)
{
  std::vector<double> accumulated, cell_area(stretch.size(), 0);
  double total = 0;
  for(int f = 0; f < measures.number_of_faces(); ++f) {
    const double area = measures.source_area(f);
    accumulated.push_back(total += area);
    for(int i : measures.faces().face[f])
      cell_area[i] += area / 3;
  }
  if(!(total > 0))
    throw Input_error(Error_code::DEGENERATE_FACE, "the mesh has no area");
  const std::vector<double> weight = options.sampling == Stretch_histogram::Sampling::EXACT_AREAS ? cell_area
                                     : options.sampling == Stretch_histogram::Sampling::VERTICES
                                       ? std::vector<double>(stretch.size(), 1)
                                       : sample_cells(options, accumulated, measures.faces().face, stretch.size());

  Histogram histogram(options.bins, options.low, options.high);
  for(std::size_t i = 0; i < stretch.size(); ++i)
    histogram.add(options.scale == Stretch_histogram::Scale::LINEAR ? std::exp(stretch[i]) : stretch[i], weight[i]);
  return histogram.shares();
}

} // namespace internal

/// The signature of the paper: the histogram of the area stretch factor of Definition 1, as
/// `vertex_log_area_stretch()` measures it. T. Athanasiadis and I. Fudos, SMI 2011, section 5.3. Shares, which add up
/// to 1. See `shape_signature()` for one that tells shapes apart better, and depends less on the tessellation.
///
/// \param policy      `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param mesh        a closed triangle mesh, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors
/// \param options     which histogram
/// \param np          optional named parameters: `vertex_point_map`, by default the mesh's own
/// \return one share for each bin
/// \pre options.bins >= 2, options.low < options.high, options.number_of_samples >= 1
/// \throws Error  `DEGENERATE_FACE` for a mesh without area, and what `vertex_log_area_stretch()` throws
///
/// Complexity: linear in the size of the mesh and the number of samples.
template <class ExecutionPolicy, class TriangleMesh, class VertexSphereMap, class CGAL_NP_TEMPLATE_PARAMETERS,
          internal::If_policy<ExecutionPolicy> = 0>
std::vector<double> stretch_histogram(const ExecutionPolicy& policy, const TriangleMesh& mesh,
                                      VertexSphereMap sphere_map, const Stretch_histogram& options = {},
                                      const CGAL_NP_CLASS& np = parameters::default_values())
{
  CGAL_SP_PRECONDITION(options.bins >= 2, "a histogram has two bins or more");
  CGAL_SP_PRECONDITION(options.low < options.high, "the first bin of a histogram begins below the end of the last one");
  CGAL_SP_PRECONDITION(options.number_of_samples >= 1, "a histogram has one sample or more");
  const auto loop = internal::host_loop(policy);
  const internal::Face_measures measures = internal::make_face_measures(mesh, sphere_map, np, loop);
  return internal::stretch_histogram(measures, internal::vertex_stretch(mesh, measures, loop), options);
}

/// \overload
/// \param mesh,sphere_map,options,np as above; on one core \return as above
template <class TriangleMesh, class VertexSphereMap, class CGAL_NP_TEMPLATE_PARAMETERS>
std::vector<double> stretch_histogram(const TriangleMesh& mesh, VertexSphereMap sphere_map,
                                      const Stretch_histogram& options = {},
                                      const CGAL_NP_CLASS& np = parameters::default_values())
{
  return stretch_histogram(CGAL::Sequential_tag(), mesh, sphere_map, options, np);
}

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_STRETCH_HISTOGRAM_H
