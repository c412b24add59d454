// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_RESAMPLING_WEIGHTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_RESAMPLING_WEIGHTS_H

#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>
#include <CGAL/Spherical_parameterization/locate.h>
#include <CGAL/Spherical_parameterization/transfer_properties.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationInverse
/// @{

/// Weights for resampling values from the vertices of one mesh to those of another: a sparse matrix. Row i has the
/// weights (positive, sum 1) of the old vertices for the new vertex i, in the order of their indices. Vertices are
/// numbered in the order of `vertices(mesh)`.
struct Resampling_weights {
  std::vector<std::size_t> begin = {0}; ///< of each row, and the end of the last one
  std::vector<int> vertex;              ///< of the other mesh
  std::vector<double> weight;           ///< of that vertex

  /// \return of vertices that get values
  std::size_t size() const { return begin.size() - 1; }

  /// \param values  of the vertices of the other mesh
  /// \return their weighted means, each between the smallest and the largest value of its row: constants stay constant
  /// \pre there is a value for every vertex of the other mesh
  std::vector<double> means(const std::vector<double>& values) const
  {
    return by_row<double>(values.size(), [&](std::size_t first, std::size_t last) {
      double sum = 0, least = values[vertex[first]], largest = least;
      for(std::size_t k = first; k < last; ++k) {
        const double value = values[vertex[k]];
        sum += weight[k] * value;
        least = (std::min)(least, value);
        largest = (std::max)(largest, value);
      }
      return std::clamp(sum, least, largest);
    });
  }

  /// \param labels  of the vertices of the other mesh
  /// \return the labels with the largest sums of weights; if several are equal, the first
  /// \pre as for `means()`
  template <class Label>
  std::vector<Label> majorities(const std::vector<Label>& labels) const
  {
    std::vector<std::pair<std::size_t, double>> sums; // where each label of a row is first, and its weights so far
    return by_row<Label>(labels.size(), [&](std::size_t first, std::size_t last) {
      sums.clear();
      for(std::size_t k = first; k < last; ++k) {
        auto of_label = std::find_if(sums.begin(), sums.end(),
                                     [&](const auto& sum) { return labels[vertex[sum.first]] == labels[vertex[k]]; });
        if(of_label == sums.end())
          of_label = sums.insert(sums.end(), {k, 0.});
        of_label->second += weight[k];
      }
      std::pair<std::size_t, double> best = {first, 0.};
      for(const auto& sum : sums)
        if(sum.second > best.second + rounding)
          best = sum;
      return labels[vertex[best.first]];
    });
  }

  /// \param labels  of the vertices of the other mesh
  /// \return the labels of the vertices with the largest weights; if several are equal, the first
  /// \pre as for `means()`
  template <class Label>
  std::vector<Label> nearest(const std::vector<Label>& labels) const
  {
    return by_row<Label>(labels.size(), [&](std::size_t first, std::size_t last) {
      std::size_t best = first;
      for(std::size_t k = first; k < last; ++k)
        best = weight[k] > weight[best] + rounding ? k : best;
      return labels[vertex[best]];
    });
  }

private:
  static constexpr double rounding = 1e-12; ///< of weights

  /// \param count  of the values
  template <class Value, class F>
  std::vector<Value> by_row(std::size_t count, F f) const
  {
    CGAL_SP_PRECONDITION(
      std::all_of(vertex.begin(), vertex.end(), [&](int v) { return v >= 0 && static_cast<std::size_t>(v) < count; }),
      "there is a value for every vertex of the other mesh");
    std::vector<Value> result;
    result.reserve(size());
    for(std::size_t i = 0; i < size(); ++i)
      result.push_back(f(begin[i], begin[i + 1]));
    return result;
  }
};

/// \cond SKIP_IN_MANUAL
namespace internal {

typedef std::vector<std::vector<std::pair<int, double>>> Weight_rows; ///< vertices in their order, and weights

/// Barycentric weights at directions; those that are rounding are left out.
template <class Loop, class TriangleMesh>
Weight_rows weight_rows(const Loop& loop, const Spherical_locator<TriangleMesh>& from,
                        const Host_array<vec3>& directions)
{
  constexpr double accuracy = 1e-12; // of the weights
  const Vertex_numbering<TriangleMesh> number(vertices(from.mesh()));
  const auto place = locate_all(loop, from, directions);
  Weight_rows rows(place.size());
  for_each_index(loop, static_cast<int>(rows.size()), [&](int i) {
    const auto corner = corners_of_face(from.mesh(), number, place[i].first);
    for(std::size_t k = 0; k < 3; ++k)
      if(place[i].second[k] > accuracy)
        rows[i].emplace_back(corner[k], place[i].second[k]);
    std::sort(rows[i].begin(), rows[i].end());
  });
  return rows;
}

inline Resampling_weights resampling_weights_of(const Weight_rows& rows)
{
  Resampling_weights result;
  for(const auto& row : rows) {
    for(const auto& [v, w] : row) {
      result.vertex.push_back(v);
      result.weight.push_back(w);
    }
    result.begin.push_back(result.vertex.size());
  }
  return result;
}

} // namespace internal
/// \endcond

/// Linear interpolation: the barycentric weights in the face of `from` that contains the image of the vertex. The same
/// as `transfer_vertex_property()`, for any number of values.
/// \param policy     `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param from       the inverse of the map of the mesh that has the values
/// \param to_sphere  range of directions, in the same position as the map of `from`: of the vertices that get values
/// \return up to three weights for each of them
/// \throws Error  `NON_FINITE_COORDINATE` at an image that is no direction
///
/// Complexity: one query (`Spherical_locator::locate()`) for each of them.
template <class ExecutionPolicy, class FromMesh, class ToSphere, internal::If_policy<ExecutionPolicy> = 0>
Resampling_weights linear_resampling(const ExecutionPolicy& policy, const Spherical_locator<FromMesh>& from,
                                     const ToSphere& to_sphere)
{
  return internal::resampling_weights_of(
    internal::weight_rows(internal::host_loop(policy), from, internal::vectors_of(to_sphere)));
}
CGAL_SP_ON_ONE_CORE(linear_resampling)

/// Resampling that preserves areas and skips no vertex, even if the new mesh is coarser: the adaptive barycentric
/// method of the Human Connectome Project's `wb_command` (ADAP_BARY_AREA; M. Glasser et al., "The minimal preprocessing
/// pipelines for the Human Connectome Project", NeuroImage 80, 2013).
///
/// A new vertex takes linear weights, unless old vertices lie around it that these pass over: then it takes the weights
/// that it has in these, seen from them. Then what every old vertex gives away is made proportional to the areas of the
/// new ones and to its own, and every row is divided by its sum. Where that is 0 the weights stay linear.
/// \param policy       as above
/// \param from         the inverse of the map of the mesh that has the values
/// \param from_sphere  range of the images of its vertices, in the order of `vertices(mesh)`
/// \param from_areas   of its vertices on the surface
/// \param to           the inverse of the map of the mesh that gets them
/// \param to_sphere    range of the images of its vertices
/// \param to_areas     of its vertices on the surface
/// \return weights for every vertex of the second mesh
/// \throws Error  `NON_FINITE_COORDINATE` at an image that is no direction
/// \pre there is an image and an area for every vertex; areas are finite and not negative
///
/// Complexity: one query for each vertex of both.
template <class ExecutionPolicy, class FromMesh, class FromSphere, class ToMesh, class ToSphere,
          internal::If_policy<ExecutionPolicy> = 0>
Resampling_weights area_preserving_resampling(const ExecutionPolicy& policy, const Spherical_locator<FromMesh>& from,
                                              const FromSphere& from_sphere, const std::vector<double>& from_areas,
                                              const Spherical_locator<ToMesh>& to, const ToSphere& to_sphere,
                                              const std::vector<double>& to_areas)
{
  const auto loop = internal::host_loop(policy);
  const auto from_images = internal::vectors_of(from_sphere), to_images = internal::vectors_of(to_sphere);
  const auto is_area = [](double area) { return area >= 0 && std::isfinite(area); };
  const auto size = [](const auto& mesh) { // num_vertices() counts those that were removed, too
    return static_cast<std::size_t>(std::distance(vertices(mesh).begin(), vertices(mesh).end()));
  };
  CGAL_SP_PRECONDITION(from_areas.size() == size(from.mesh()) && from_areas.size() == from_images.size() &&
                         to_areas.size() == size(to.mesh()) && to_areas.size() == to_images.size() &&
                         std::all_of(from_areas.begin(), from_areas.end(), is_area) &&
                         std::all_of(to_areas.begin(), to_areas.end(), is_area),
                       "there is an image, and an area, finite and not negative, for every vertex");
  const internal::Weight_rows linear = internal::weight_rows(loop, from, to_images);
  const internal::Weight_rows given = internal::weight_rows(loop, to, from_images);
  internal::Weight_rows rows(linear.size());
  for(std::size_t v = 0; v < given.size(); ++v)
    for(const auto& [i, w] : given[v])
      rows[i].emplace_back(static_cast<int>(v), w);
  std::vector<double> sum(given.size(), 0); // of what each vertex gives away
  for(std::size_t i = 0; i < rows.size(); ++i) {
    const auto is_before = [](const auto& a, const auto& b) { return a.first < b.first; };
    if(std::includes(linear[i].begin(), linear[i].end(), rows[i].begin(), rows[i].end(), is_before))
      rows[i] = linear[i];
    for(auto& [v, w] : rows[i])
      sum[v] += w *= to_areas[i];
  }
  for(std::size_t i = 0; i < rows.size(); ++i) {
    double of_row = 0;
    for(auto& [v, w] : rows[i])
      of_row += w *= sum[v] > 0 ? from_areas[v] / sum[v] : 0;
    for(auto& [v, w] : rows[i])
      w /= of_row;
    rows[i].erase(std::remove_if(rows[i].begin(), rows[i].end(), [](const auto& entry) { return entry.second == 0; }),
                  rows[i].end()); // of vertices without area
    if(!(of_row > 0 && std::isfinite(of_row)))
      rows[i] = linear[i];
  }
  return internal::resampling_weights_of(rows);
}
CGAL_SP_ON_ONE_CORE(area_preserving_resampling)

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_RESAMPLING_WEIGHTS_H
