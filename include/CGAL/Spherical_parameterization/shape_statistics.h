// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SHAPE_STATISTICS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SHAPE_STATISTICS_H

#include <CGAL/Spherical_parameterization/internal/algebra/pi.h>
#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/values/Harmonic_coefficients.h>
#include <CGAL/Spherical_parameterization/values/Procrustes.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_numbering.h>
#include <CGAL/Spherical_parameterization/internal/distortion/Mapped_faces.h>
#include <CGAL/Spherical_parameterization/internal/algebra/point_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/statistics/Shape_set.h>
#include <CGAL/Spherical_parameterization/internal/statistics/principal_components.h>
#include <CGAL/Spherical_parameterization/internal/statistics/procrustes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationStatistics
///
/// A set of shapes that correspond: vertex i of all of them is the same place (`resample()` of registered maps), or
/// coefficient i belongs to the same function on the sphere. A shape is `Shape_points` or `Harmonic_coefficients` of
/// three functions. The mean over vertices is the weighted one, the mean over coefficients that over the sphere: so
/// distances and deviations are lengths, in the unit of the coordinates, in either space.
/// @{

/// The vertices of a shape.
typedef std::vector<std::array<double, 3>> Shape_points;

/// Mean and principal components of a set of shapes: a point distribution model (T. F. Cootes, C. J. Taylor,
/// D. H. Cooper, J. Graham, "Active shape models: their training and application", 1995). Shape i is the mean plus the
/// sum over k of scores[i][k] times modes[k].
template <class Shape>
struct Shape_statistics {
  Shape mean;                              ///< of the shapes as they stand
  std::vector<Shape> modes;                ///< principal components: orthonormal, root mean square 1
  std::vector<double> variances;           ///< by mode, largest first: of its scores, with n - 1 for n shapes
  std::vector<std::vector<double>> scores; ///< by shape, then by mode
  double total_variance = 0;               ///< of all modes, also of those that were not asked for
};

/// \cond SKIP_IN_MANUAL
namespace internal {

inline const double* first_coordinate(const Shape_points& shape) { return shape.empty() ? nullptr : shape[0].data(); }
inline const double* first_coordinate(const Harmonic_coefficients& shape) { return shape.values().data(); }

inline int entries_of(const Shape_points& shape) { return static_cast<int>(shape.size()); }
inline int entries_of(const Harmonic_coefficients& shape) { return shape.size(); }

/// All zero, for as many entries.
inline Shape_points zero_shape(const Shape_points& like) { return Shape_points(like.size(), {0, 0, 0}); }
inline Harmonic_coefficients zero_shape(const Harmonic_coefficients& like)
{
  return Harmonic_coefficients(like.degree(), like.number_of_fields());
}

/// Calls `f` with every coordinate of every entry of a shape that is to be changed, and that of another one.
template <class F>
void for_each_coordinate(Shape_points& to, const Shape_points& from, F f)
{
  for(std::size_t j = 0; j < to.size(); ++j)
    for(std::size_t c = 0; c < 3; ++c)
      f(to[j][c], from[j][c]);
}
template <class F>
void for_each_coordinate(Harmonic_coefficients& to, const Harmonic_coefficients& from, F f)
{
  for(std::size_t j = 0; j < to.values().size(); ++j)
    f(to.values()[j], from.values()[j]);
}

/// What each vertex counts: their sum is 1. Throws Error for what is not finite, and the precondition for sizes that do
/// not fit.
inline std::vector<double> checked_weights(const std::vector<Shape_points>& shapes, std::vector<double> weights)
{
  CGAL_SP_PRECONDITION(!shapes.empty() && !shapes[0].empty(), "statistics need a shape that has vertices");
  for(std::size_t i = 0; i < shapes.size(); ++i) {
    CGAL_SP_PRECONDITION(shapes[i].size() == shapes[0].size(), "shapes that correspond have as many vertices each");
    for(std::size_t j = 0; j < shapes[i].size(); ++j)
      if(const auto& [x, y, z] = shapes[i][j]; !std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
        throw Input_error(Error_code::NON_FINITE_COORDINATE,
                          "vertex " + std::to_string(j) + " of shape " + std::to_string(i));
  }
  CGAL_SP_PRECONDITION(shapes[0].size() <= static_cast<std::size_t>((std::numeric_limits<int>::max)()) / 3,
                       "shapes have fewer than 2^31 / 3 vertices");
  if(weights.empty())
    return {1. / static_cast<double>(shapes[0].size())};
  CGAL_SP_PRECONDITION(weights.size() == shapes[0].size(), "there is a weight for every vertex");
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.);
  CGAL_SP_PRECONDITION(sum > 0 && std::isfinite(sum) && *std::min_element(weights.begin(), weights.end()) >= 0,
                       "weights of vertices are finite and not negative, and their sum is positive");
  for(double& weight : weights)
    weight /= sum;
  return weights;
}

/// The mean over the sphere of the square of a function is the sum of those of its coefficients over 4 pi.
inline std::vector<double> checked_weights(const std::vector<Harmonic_coefficients>& shapes,
                                           const std::vector<double>& weights)
{
  CGAL_SP_PRECONDITION(weights.empty(), "coefficients have no weights: their mean is that over the sphere");
  CGAL_SP_PRECONDITION(!shapes.empty(), "statistics need a shape");
  for(std::size_t i = 0; i < shapes.size(); ++i) {
    CGAL_SP_PRECONDITION(shapes[i].number_of_fields() == 3 && shapes[i].degree() == shapes[0].degree() &&
                           shapes[i].degree() >= 0,
                         "shapes that correspond are three functions each, all of the same degree");
    for(double c : shapes[i].values())
      if(!std::isfinite(c))
        throw Input_error(Error_code::NON_FINITE_COORDINATE, "a coefficient of shape " + std::to_string(i));
  }
  return {1 / (4 * internal::pi)};
}

/// The shapes as arrays: `Number` is double for those that are to be changed, else const double.
template <class Number, class Shape>
Shape_set<Number> shape_set(const std::vector<Shape>& shapes, const std::vector<double>& weights)
{
  constexpr bool are_points = std::is_same_v<Shape, Shape_points>;
  std::vector<Number*> first;
  for(const Shape& shape : shapes)
    if constexpr(std::is_const_v<Number>)
      first.push_back(first_coordinate(shape));
    else
      first.push_back(const_cast<double*>(first_coordinate(shape))); // of a vector that the caller may change
  const int entries = entries_of(shapes[0]);
  return {std::move(first), entries, are_points ? 3 : 1, are_points ? 1 : entries, weights};
}

/// Moves the centre of a shape to the origin. Returns where it was.
inline std::array<double, 3> centred(Shape_points& shape, const std::vector<double>& weights)
{
  std::array<double, 3> centre = {0, 0, 0};
  for(std::size_t c = 0; c < 3; ++c) {
    for(std::size_t j = 0; j < shape.size(); ++j)
      centre[c] += weights[weights.size() == 1 ? 0 : j] * shape[j][c];
    for(auto& point : shape)
      point[c] -= centre[c];
  }
  return centre;
}

inline std::array<double, 3> centred(Harmonic_coefficients& shape, const std::vector<double>&)
{
  std::array<double, 3> centre;
  for(int c = 0; c < 3; ++c) {
    centre[c] = shape(0, 0, c) / std::sqrt(4 * internal::pi);
    shape(0, 0, c) = 0;
  }
  return centre;
}

} // namespace internal
/// \endcond

/// Generalized Procrustes alignment: moves shapes to where the sum of the squares of their distances from their mean is
/// least: centres to the origin, and rotations and sizes as `method` says. What is then different is shape. The first
/// one keeps its rotation.
///
/// J. C. Gower, "Generalized Procrustes analysis", Psychometrika 40 (1975). By turns the mean, and all rotations: the
/// sum falls in every step. Shapes that are nearly the same in poses far apart come together wherever they start.
/// \param policy   `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param shapes   `std::vector` of `Shape_points` with as many vertices each, or of `Harmonic_coefficients` with three
///                 functions of the same degree; they are moved
/// \param method   what to take away
/// \param weights  what each vertex counts, 0 or more; empty: all alike. Of coefficients empty.
/// \return the motions, and how far the shapes are from their mean
/// \throws Error  `NON_FINITE_COORDINATE`
/// \pre one shape or more, which fit each other and the weights
///
/// Complexity: O(n V) per step for n shapes of V vertices; 10 to 50 steps.
template <class ExecutionPolicy, class Shape>
Procrustes_alignment align_shapes(const ExecutionPolicy& policy, std::vector<Shape>& shapes,
                                  const Procrustes& method = Procrustes(), const std::vector<double>& weights = {})
{
  CGAL_SP_PRECONDITION(method.accuracy >= 0, "the accuracy of rotations must not be negative");
  CGAL_SP_PRECONDITION(method.iterations >= 0, "the number of iterations must not be negative");
  const auto loop = internal::host_loop(policy);
  const std::vector<double> share = internal::checked_weights(shapes, weights);
  std::vector<std::array<double, 3>> centre(shapes.size());
  loop.for_each(static_cast<int>(shapes.size()), [&](int i) { centre[i] = internal::centred(shapes[i], share); });
  Procrustes_alignment result = internal::superimpose(loop, internal::shape_set<double>(shapes, share), method);
  for(std::size_t i = 0; i < shapes.size(); ++i) {
    Similarity& motion = result.motions[i];
    for(std::size_t a = 0; a < 3; ++a)
      for(std::size_t b = 0; b < 3; ++b)
        motion.translation[a] -= motion.scale * motion.rotation[a][b] * centre[i][b];
  }
  return result;
}

/// Mean and principal components of shapes as they stand: `align_shapes()` comes before. Components with less than
/// 1e-10 of the largest deviation are rounding and left out, so that there are n - 1 of n shapes or fewer.
/// \param policy   `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param shapes   as above
/// \param weights  as above
/// \param modes    at most so many, by default all
/// \return mean, modes, variances and scores. The sign of a mode is that for which its longest score is positive.
/// \throws Error  `NON_FINITE_COORDINATE`
/// \pre one shape or more, which fit each other and the weights
///
/// By the singular value decomposition of the triangle of a QR decomposition (`Principal_components`), to rounding of
/// the largest deviation. Complexity: O(V n^2 + n^3) for n shapes of V vertices; memory besides the shapes: the modes.
template <class ExecutionPolicy, class Shape>
Shape_statistics<Shape> shape_statistics(const ExecutionPolicy& policy, const std::vector<Shape>& shapes,
                                         const std::vector<double>& weights = {},
                                         int modes = (std::numeric_limits<int>::max)())
{
  CGAL_SP_PRECONDITION(modes >= 0, "the number of modes must not be negative");
  const auto loop = internal::host_loop(policy);
  const std::vector<double> share = internal::checked_weights(shapes, weights);
  const double n = static_cast<double>(shapes.size());
  const internal::Principal_components found =
    internal::principal_components(loop, internal::shape_set<const double>(shapes, share));
  const std::size_t count = (std::min)(found.deviation.size(), static_cast<std::size_t>(modes));

  Shape_statistics<Shape> result;
  result.mean = internal::zero_shape(shapes[0]);
  for(const Shape& shape : shapes)
    internal::for_each_coordinate(result.mean, shape, [&](double& to, double from) { to += from / n; });
  if(shapes.size() > 1)
    result.total_variance = found.square_sum / (n - 1);
  result.modes.resize(count);
  result.scores.assign(shapes.size(), std::vector<double>(count));
  std::vector<double> sign(count, 1);
  for(std::size_t k = 0; k < count; ++k) {
    const double deviation = found.deviation[k];
    result.variances.push_back(deviation * deviation / (n - 1));
    double longest = 0;
    for(const auto& row : found.combination)
      if(std::abs(row[k]) > std::abs(longest) * (1 + 1e-9)) // of equal ones the first, whatever the rounding
        longest = row[k];
    sign[k] = longest < 0 ? -1 : 1;
    for(std::size_t i = 0; i < shapes.size(); ++i)
      result.scores[i][k] = sign[k] * found.combination[i][k] * deviation * deviation;
  }
  loop.for_each(static_cast<int>(count), [&](int k) {
    Shape mode = internal::zero_shape(shapes[0]);
    double sum = 0;
    for(std::size_t i = 0; i < shapes.size(); ++i) {
      const double factor = sign[k] * found.combination[i][k];
      sum += factor;
      internal::for_each_coordinate(mode, shapes[i], [&](double& to, double from) { to += factor * from; });
    }
    internal::for_each_coordinate(mode, result.mean, [&](double& to, double from) { to -= sum * from; });
    result.modes[k] = std::move(mode);
  });
  return result;
}

/// The shape with these scores: the mean plus the sum of scores times modes.
/// \param statistics  of a set of shapes
/// \param scores      as many as there are modes, or fewer, the first ones
/// \return the shape
/// \pre not more scores than modes
///
/// Complexity: O(V) per score.
template <class Shape>
Shape shape_of_scores(const Shape_statistics<Shape>& statistics, const std::vector<double>& scores)
{
  CGAL_SP_PRECONDITION(scores.size() <= statistics.modes.size(), "there is a mode for every score");
  Shape shape = statistics.mean;
  for(std::size_t k = 0; k < scores.size(); ++k)
    internal::for_each_coordinate(shape, statistics.modes[k], [&](double& to, double from) { to += scores[k] * from; });
  return shape;
}

/// How well the components of a set describe shapes that are not in it: every shape is left out in turn, and
/// reconstructed by the mean of the others and their first components. (Generalization ability: R. H. Davies,
/// "Learning shape: optimal models for analysing natural variability", 2002.) All are compared as they stand: the
/// alignment of the set is not computed anew.
/// \param policy   `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param shapes   as above
/// \param weights  as above
/// \param groups   the shapes are left out in so many groups, i with group i mod groups; 0: one by one
/// \return by the number of components, from 0 on, as far as the others have them: the root mean square distance of the
///         left out from their reconstructions
/// \throws Error  `NON_FINITE_COORDINATE`
/// \pre two shapes or more, which fit each other and the weights; not 1 group, and not more groups than shapes
///
/// Complexity: O(V n^2 + groups n^3) for n shapes of V vertices.
template <class ExecutionPolicy, class Shape>
std::vector<double> left_out_errors(const ExecutionPolicy& policy, const std::vector<Shape>& shapes,
                                    const std::vector<double>& weights = {}, int groups = 0)
{
  const int n = static_cast<int>(shapes.size());
  CGAL_SP_PRECONDITION(n >= 2, "to leave shapes out there have to be two or more");
  CGAL_SP_PRECONDITION(groups == 0 || (groups >= 2 && groups <= n), "shapes are left out in 2 to n groups");
  const std::vector<double> share = internal::checked_weights(shapes, weights);
  return internal::errors_of_left_out(internal::host_loop(policy), internal::shape_set<const double>(shapes, share),
                                      groups == 0 ? n : groups);
}

/// The variance of every vertex: the sum of those of its three coordinates. The weighted mean over the vertices is
/// `Shape_statistics::total_variance`.
/// \param policy  `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param shapes  one or more, with as many vertices each, as they stand
/// \return by vertex; of one shape 0
/// \throws Error  `NON_FINITE_COORDINATE`
///
/// Complexity: O(n V).
template <class ExecutionPolicy>
std::vector<double> vertex_variances(const ExecutionPolicy& policy, const std::vector<Shape_points>& shapes)
{
  static_cast<void>(internal::checked_weights(shapes, {}));
  const double n = static_cast<double>(shapes.size());
  std::vector<double> variance(shapes[0].size(), 0);
  internal::for_each_index(internal::host_loop(policy), static_cast<int>(variance.size()), [&](int j) {
    for(std::size_t c = 0; c < 3; ++c) {
      double mean = 0;
      for(const Shape_points& shape : shapes)
        mean += shape[j][c] / n;
      for(const Shape_points& shape : shapes)
        variance[j] += (shape[j][c] - mean) * (shape[j][c] - mean) / (std::max)(n - 1, 1.);
    }
  });
  return variance;
}

/// What each vertex counts by the surface: a third of the areas of its faces, mean over the shapes. Samples that crowd,
/// as those of an icosphere do on limbs, so count no more than what they stand for.
/// \param policy  `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param mesh    whose vertices and faces the shapes have: a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param shapes  one or more; vertex i of each is the one that `vertices(mesh)` has as number i
/// \return by vertex, for the weights of the functions above
/// \throws Error  `NON_FINITE_COORDINATE`
/// \pre the shapes have the vertices of the mesh
///
/// Complexity: O(n V).
template <class ExecutionPolicy, class TriangleMesh>
std::vector<double> mean_vertex_areas(const ExecutionPolicy& policy, const TriangleMesh& mesh,
                                      const std::vector<Shape_points>& shapes)
{
  static_cast<void>(internal::checked_weights(shapes, {}));
  const auto loop = internal::host_loop(policy);
  const internal::Vertex_numbering<TriangleMesh> numbering(vertices(mesh));
  const auto face = internal::corners_of_faces(mesh, numbering, loop);
  CGAL_SP_PRECONDITION(shapes[0].size() == num_vertices(mesh), "the shapes have the vertices of the mesh");
  internal::Host_array<double> area(face.size());
  internal::for_each_index(loop, static_cast<int>(face.size()), [&](int f) {
    area[f] = 0;
    for(const Shape_points& shape : shapes) {
      const auto at = [&](int corner) { return internal::coordinates(shape[face[f][corner]]); };
      area[f] += internal::norm(internal::outer(internal::sub(at(1), at(0)), internal::sub(at(2), at(0)))) / 2;
    }
  });
  std::vector<double> result(shapes[0].size(), 0);
  for(std::size_t f = 0; f < face.size(); ++f)
    for(int v : face[f])
      result[v] += area[f] / 3 / static_cast<double>(shapes.size());
  return result;
}

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SHAPE_STATISTICS_H
