// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SHAPE_STATISTICS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SHAPE_STATISTICS_H

#include <CGAL/Spherical_parameterization/values/Harmonic_coefficients.h>
#include <CGAL/Spherical_parameterization/values/Shape_statistics.h>
#include <CGAL/Spherical_parameterization/internal/api/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/context/make_monitor.h>
#include <CGAL/Spherical_parameterization/internal/statistics/procrustes.h>
#include <CGAL/Spherical_parameterization/internal/statistics/shapes.h>
#include <CGAL/Spherical_parameterization/internal/statistics/specificity.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationStatistics
///
/// These functions work on corresponding shapes: vertex i of all shapes corresponds (`resample()` of registered maps),
/// or coefficient i belongs to the same function on the sphere. A shape is `Shape_points` or `Harmonic_coefficients` of
/// three functions. Means over vertices are weighted, means of coefficients are means over the sphere: so distances and
/// deviations are lengths in the unit of the coordinates in both cases.
/// @{

/// Generalized Procrustes alignment: minimizes the sum of the squared distances of shapes from their mean. Centres
/// are moved to the origin; `method` says whether shapes are also rotated and scaled. The first shape keeps its
/// rotation.
///
/// J. C. Gower, "Generalized Procrustes analysis", Psychometrika 40 (1975). Mean and rotations are computed
/// alternately, and the sum falls in every step. Nearly equal shapes are aligned from any initial orientations.
/// \param shapes   `std::vector` of `Shape_points` with the same number of vertices, or of `Harmonic_coefficients` with
///                 three functions of the same degree; moved in place
/// \param method   what to remove
/// \param weights  weights of the vertices, 0 or more; empty: equal weights. Empty for coefficients.
/// \param policy,np  see \ref pd_calls
/// \return the motions, and the deviation of the shapes from their mean
/// \throws Error  `NON_FINITE_COORDINATE`; `INTERRUPTED` before they are moved
/// \pre at least one shape; shapes and weights have matching sizes
///
/// Complexity: O(n V) per step for n shapes of V vertices; 10 to 50 steps.
template <class ExecutionPolicy, class Shape, class CGAL_NP_TEMPLATE_PARAMETERS,
          internal::If_policy<ExecutionPolicy> = 0>
Procrustes_alignment align_shapes(const ExecutionPolicy& policy, std::vector<Shape>& shapes,
                                  const Procrustes& method = Procrustes(), const std::vector<double>& weights = {},
                                  const CGAL_NP_CLASS& np = parameters::default_values())
{
  CGAL_SP_PRECONDITION(method.accuracy >= 0, "the accuracy of rotations must not be negative");
  CGAL_SP_PRECONDITION(method.iterations >= 0, "the number of iterations must not be negative");
  internal::Monitor monitor = internal::make_monitor(np);
  const internal::Watched_loop loop(internal::host_loop(policy), monitor);
  const std::vector<double> share = internal::checked_weights(shapes, weights);
  std::vector<Shape> moved = shapes;
  std::vector<std::array<double, 3>> centre(shapes.size());
  loop.for_each(static_cast<int>(moved.size()), [&](int i) { centre[i] = internal::centred(moved[i], share); });
  Procrustes_alignment result = internal::superimpose(loop, internal::shape_set<double>(moved, share), method);
  for(std::size_t i = 0; i < shapes.size(); ++i) {
    Similarity& motion = result.motions[i];
    for(std::size_t a = 0; a < 3; ++a)
      for(std::size_t b = 0; b < 3; ++b)
        motion.translation[a] -= motion.scale * motion.rotation[a][b] * centre[i][b];
  }
  shapes = std::move(moved);
  return result;
}
CGAL_SP_ON_ONE_CORE(align_shapes)

/// Mean and principal components of shapes. Call `align_shapes()` first. Components below 1e-10 of the largest
/// deviation are rounding errors, and are left out: n shapes have at most n - 1 components.
/// \param shapes   as above
/// \param weights  as above
/// \param modes    maximum number, by default all
/// \param policy,np  see \ref pd_calls
/// \return mean, modes, variances and scores. The sign of a mode is that for which its longest score is positive.
/// \throws Error  `NON_FINITE_COORDINATE`; `INTERRUPTED`
/// \pre at least one shape; shapes and weights have matching sizes
///
/// Singular value decomposition of the triangle of a QR decomposition (`Principal_components`); to rounding of the
/// largest deviation. Complexity: O(V n^2 + n^3) for n shapes of V vertices; memory besides the shapes: the modes.
template <class ExecutionPolicy, class Shape, class CGAL_NP_TEMPLATE_PARAMETERS,
          internal::If_policy<ExecutionPolicy> = 0>
Shape_statistics<Shape> shape_statistics(const ExecutionPolicy& policy, const std::vector<Shape>& shapes,
                                         const std::vector<double>& weights = {},
                                         int modes = (std::numeric_limits<int>::max)(),
                                         const CGAL_NP_CLASS& np = parameters::default_values())
{
  CGAL_SP_PRECONDITION(modes >= 0, "the number of modes must not be negative");
  internal::Monitor monitor = internal::make_monitor(np);
  const internal::Watched_loop loop(internal::host_loop(policy), monitor);
  const std::vector<double> share = internal::checked_weights(shapes, weights);
  const auto set = internal::shape_set<const double>(shapes, share);
  const internal::Principal_components found = internal::principal_components(loop, set);
  const std::size_t count = (std::min)(found.deviation.size(), static_cast<std::size_t>(modes));
  const double freedom = static_cast<double>(shapes.size()) - 1;

  Shape_statistics<Shape> result;
  std::vector<Shape> written(1 + count, internal::zero_shape(shapes[0])); // mean and modes
  internal::write_components(loop, set, found, internal::shape_set<double>(written, share));
  result.mean = std::move(written[0]);
  result.modes.assign(std::make_move_iterator(written.begin() + 1), std::make_move_iterator(written.end()));
  if(freedom > 0)
    result.total_variance = found.square_sum / freedom;
  result.scores.resize(shapes.size());
  for(std::size_t k = 0; k < count; ++k) {
    const double deviation = found.deviation[k];
    result.variances.push_back(deviation * deviation / freedom);
    for(std::size_t i = 0; i < shapes.size(); ++i)
      result.scores[i].push_back(found.combination[i][k] * deviation * deviation);
  }
  return result;
}
CGAL_SP_ON_ONE_CORE(shape_statistics)

/// The shape with these scores: the mean plus the sum of scores times modes.
/// \param statistics  of a set of shapes
/// \param scores      of all modes, or of the first ones
/// \return the shape
/// \pre not more scores than modes
///
/// Complexity: O(V) per score.
template <class Shape>
Shape shape_of_scores(const Shape_statistics<Shape>& statistics, const std::vector<double>& scores)
{
  CGAL_SP_PRECONDITION(scores.size() <= statistics.modes.size(), "there is a mode for every score");
  Shape shape = statistics.mean;
  double* const x = internal::first_coordinate(shape);
  for(std::size_t k = 0; k < scores.size(); ++k) {
    const double* const mode = internal::first_coordinate(statistics.modes[k]);
    for(std::size_t i = 0; i < internal::number_of_coordinates(shape); ++i)
      x[i] += scores[k] * mode[i];
  }
  return shape;
}

/// Leave-out errors, which say how well the components of a set describe new shapes: every shape is left out in turn,
/// and reconstructed by the mean of the others and their first components. (Generalization ability: R. H. Davies,
/// "Learning shape: optimal models for analysing natural variability", 2002.) The alignment of the set is not computed
/// again.
/// \param shapes   as above
/// \param weights  as above
/// \param groups   number of groups that are left out, shape i with group i mod groups; 0: one by one
/// \param policy,np  see \ref pd_calls
/// \return for each number of components, from 0 on: the root mean square distance of the left out shapes from their
///         reconstructions
/// \throws Error  `NON_FINITE_COORDINATE`; `INTERRUPTED`
/// \pre at least two shapes; shapes and weights have matching sizes; not 1 group, and not more groups than shapes
///
/// Complexity: O(V n^2 + groups n^3) for n shapes of V vertices.
template <class ExecutionPolicy, class Shape, class CGAL_NP_TEMPLATE_PARAMETERS,
          internal::If_policy<ExecutionPolicy> = 0>
std::vector<double> left_out_errors(const ExecutionPolicy& policy, const std::vector<Shape>& shapes,
                                    const std::vector<double>& weights = {}, int groups = 0,
                                    const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::Monitor monitor = internal::make_monitor(np);
  const internal::Watched_loop loop(internal::host_loop(policy), monitor);
  const std::vector<double> share = internal::checked_weights(shapes, weights);
  return internal::errors_of_left_out(loop, internal::shape_set<const double>(shapes, share),
                                      internal::checked_groups(shapes.size(), groups));
}
CGAL_SP_ON_ONE_CORE(left_out_errors)

/// Compactness, generalization and specificity of a set as a model. Random shapes are the mean plus modes with normally
/// distributed scores, whose variances are those of the modes. Shapes with more modes extend those with fewer.
/// \param shapes   as above
/// \param weights  as above
/// \param groups   as for `left_out_errors()`
/// \param samples  number of random shapes
/// \param seed     of the random numbers; the same seed gives the same bits
/// \param policy,np  see \ref pd_calls
/// \return all three for each number of modes; generalization for the numbers that the other shapes have
/// \throws Error  `NON_FINITE_COORDINATE`; `INTERRUPTED`
/// \pre as for `left_out_errors()`; two samples or more
///
/// Complexity: O(V n^2 + groups n^3 + samples n^2) for n shapes of V vertices.
template <class ExecutionPolicy, class Shape, class CGAL_NP_TEMPLATE_PARAMETERS,
          internal::If_policy<ExecutionPolicy> = 0>
Model_quality model_quality(const ExecutionPolicy& policy, const std::vector<Shape>& shapes,
                            const std::vector<double>& weights = {}, int groups = 0, int samples = 1000,
                            std::uint32_t seed = 1, const CGAL_NP_CLASS& np = parameters::default_values())
{
  CGAL_SP_PRECONDITION(samples >= 2, "specificity needs two samples or more");
  Model_quality result;
  internal::Monitor monitor = internal::make_monitor(np);
  const internal::Watched_loop loop(internal::host_loop(policy), monitor);
  const std::vector<double> share = internal::checked_weights(shapes, weights);
  const auto set = internal::shape_set<const double>(shapes, share);
  result.generalization = internal::errors_of_left_out(loop, set, internal::checked_groups(shapes.size(), groups));
  const internal::Principal_components found = internal::principal_components(loop, set);
  result.compactness.push_back(0);
  for(const double deviation : found.deviation)
    result.compactness.push_back(result.compactness.back() +
                                 deviation * deviation / (static_cast<double>(shapes.size()) - 1));
  std::tie(result.specificity, result.specificity_error) = internal::specificity(loop, found, samples, seed);
  return result;
}
CGAL_SP_ON_ONE_CORE(model_quality)

/// The variance of every vertex: the sum of those of its three coordinates. The weighted mean over the vertices is
/// `Shape_statistics::total_variance`.
/// \param shapes  one or more, with the same number of vertices
/// \param policy,np  see \ref pd_calls
/// \return by vertex; of one shape 0
/// \throws Error  `NON_FINITE_COORDINATE`; `INTERRUPTED`
///
/// Complexity: O(n V).
template <class ExecutionPolicy, class CGAL_NP_TEMPLATE_PARAMETERS, internal::If_policy<ExecutionPolicy> = 0>
std::vector<double> vertex_variances(const ExecutionPolicy& policy, const std::vector<Shape_points>& shapes,
                                     const CGAL_NP_CLASS& np = parameters::default_values())
{
  static_cast<void>(internal::checked_weights(shapes, {}));
  internal::Monitor monitor = internal::make_monitor(np);
  const internal::Watched_loop loop(internal::host_loop(policy), monitor);
  return internal::variances_of_vertices(loop, shapes);
}
CGAL_SP_ON_ONE_CORE(vertex_variances)

namespace internal {

/// See `mean_vertex_areas()`.
/// \param are_shares  shares of the areas of each shape, so that large ones do not decide alone
template <class ExecutionPolicy, class TriangleMesh, class NamedParameters>
std::vector<double> vertex_weights_of_shapes(const ExecutionPolicy& policy, const TriangleMesh& mesh,
                                             const std::vector<Shape_points>& shapes, bool are_shares,
                                             const NamedParameters& np)
{
  static_cast<void>(checked_weights(shapes, {}));
  Monitor monitor = make_monitor(np);
  const Watched_loop loop(host_loop(policy), monitor);
  Vertices<TriangleMesh> vertex;
  const auto face = read_faces(mesh, Reading::UNCHECKED, loop.bare(), vertex).face;
  CGAL_SP_PRECONDITION(shapes[0].size() == vertex.size(), "the shapes have the vertices of the mesh");
  return mean_areas_of_vertices(loop, face, shapes, are_shares);
}

} // namespace internal

/// Areas of the vertices, to be used as weights: a third of the areas of their faces, averaged over the shapes. So
/// dense samples, such as those of an icosphere on some parts of a shape, get small weights.
/// \param mesh    the mesh of the shapes, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param shapes  one or more; vertex i of each corresponds to vertex i of `vertices(mesh)`
/// \param policy,np  see \ref pd_calls
/// \return by vertex, for the weights of the functions above
/// \throws Error  `NON_FINITE_COORDINATE`; `INTERRUPTED`
/// \pre the shapes have the vertices of the mesh
///
/// Complexity: O(n V).
template <class ExecutionPolicy, class TriangleMesh, class CGAL_NP_TEMPLATE_PARAMETERS,
          internal::If_policy<ExecutionPolicy> = 0>
std::vector<double> mean_vertex_areas(const ExecutionPolicy& policy, const TriangleMesh& mesh,
                                      const std::vector<Shape_points>& shapes,
                                      const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::vertex_weights_of_shapes(policy, mesh, shapes, false, np);
}
CGAL_SP_ON_ONE_CORE(mean_vertex_areas)

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SHAPE_STATISTICS_H
