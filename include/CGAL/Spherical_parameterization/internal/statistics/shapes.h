// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STATISTICS_SHAPES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STATISTICS_SHAPES_H

#include <CGAL/Spherical_parameterization/internal/algebra/point_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/values/Harmonic_coefficients.h>
#include <CGAL/Spherical_parameterization/values/Shape_statistics.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/statistics/Shape_set.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

inline const double* first_coordinate(const Shape_points& shape) { return shape.empty() ? nullptr : shape[0].data(); }
inline const double* first_coordinate(const Harmonic_coefficients& shape) { return shape.values().data(); }
template <class Shape>
double* first_coordinate(Shape& shape)
{
  return const_cast<double*>(first_coordinate(static_cast<const Shape&>(shape)));
}

inline std::size_t number_of_coordinates(const Shape_points& shape) { return 3 * shape.size(); }
inline std::size_t number_of_coordinates(const Harmonic_coefficients& shape) { return shape.values().size(); }

/// All zero, for as many entries.
inline Shape_points zero_shape(const Shape_points& like) { return Shape_points(like.size(), {0, 0, 0}); }
inline Harmonic_coefficients zero_shape(const Harmonic_coefficients& like)
{
  return Harmonic_coefficients(like.degree(), like.number_of_fields());
}

/// Throws Error for a shape whose largest coordinate has a square that is no number, or none of a few digits.
inline void check_size(std::size_t shape, double largest)
{
  if(largest > 0 && !(largest >= 1e-150 && largest <= 1e150))
    throw Input_error(Error_code::NON_FINITE_COORDINATE,
                      "the squares of the coordinates of shape " + std::to_string(shape) + " overflow or vanish",
                      "scale the shapes");
}

/// What each vertex counts: their sum is 1. Throws Error for what is not finite, and the precondition for sizes that do
/// not fit.
inline std::vector<double> checked_weights(const std::vector<Shape_points>& shapes, std::vector<double> weights)
{
  CGAL_SP_PRECONDITION(!shapes.empty() && !shapes[0].empty(), "statistics need a shape that has vertices");
  for(std::size_t i = 0; i < shapes.size(); ++i) {
    CGAL_SP_PRECONDITION(shapes[i].size() == shapes[0].size(), "shapes that correspond have as many vertices each");
    double largest = 0;
    for(std::size_t j = 0; j < shapes[i].size(); ++j) {
      const auto& [x, y, z] = shapes[i][j];
      if(!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
        throw Input_error(Error_code::NON_FINITE_COORDINATE,
                          "vertex " + std::to_string(j) + " of shape " + std::to_string(i));
      largest = (std::max)({largest, std::abs(x), std::abs(y), std::abs(z)});
    }
    check_size(i, largest);
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
    check_finite(shapes[i], " of shape " + std::to_string(i));
    double largest = 0;
    for(const double x : shapes[i].values())
      largest = (std::max)(largest, std::abs(x));
    check_size(i, largest);
  }
  return {1 / (4 * internal::pi)};
}

/// The number of groups in which shapes are left out; 0 stands for one by one.
inline int checked_groups(std::size_t number_of_shapes, int groups)
{
  const int n = static_cast<int>(number_of_shapes);
  CGAL_SP_PRECONDITION(n >= 2, "to leave shapes out there have to be two or more");
  CGAL_SP_PRECONDITION(groups == 0 || (groups >= 2 && groups <= n), "shapes are left out in 2 to n groups");
  return groups == 0 ? n : groups;
}

/// The shapes as arrays: `Number` is double for those that are to be changed, else const double.
template <class Number, class Shapes>
Shape_set<Number> shape_set(Shapes& shapes, const std::vector<double>& weights)
{
  constexpr bool are_points = std::is_same_v<typename Shapes::value_type, Shape_points>;
  std::vector<Number*> first;
  for(auto& shape : shapes)
    first.push_back(first_coordinate(shape));
  const int entries = static_cast<int>(shapes[0].size());
  return {std::move(first), entries, are_points ? 3 : 1, are_points ? 1 : entries, weights};
}

/// Moves the centre of a shape to the origin. Returns where it was. A coordinate that is the same everywhere becomes 0:
/// what rounding leaves of it has no size that another shape could be scaled to.
inline std::array<double, 3> centred(Shape_points& shape, const std::vector<double>& weights)
{
  constexpr double rounding = 1e-13;
  std::array<double, 3> centre = {0, 0, 0};
  for(std::size_t c = 0; c < 3; ++c) {
    for(std::size_t j = 0; j < shape.size(); ++j)
      centre[c] += weights[weights.size() == 1 ? 0 : j] * shape[j][c];
    double largest = 0;
    for(auto& point : shape)
      largest = (std::max)(largest, std::abs(point[c] -= centre[c]));
    if(largest <= rounding * std::abs(centre[c]))
      for(auto& point : shape)
        point[c] = 0;
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

/// The sum of the variances of the three coordinates, by vertex.
template <class Loop>
std::vector<double> variances_of_vertices(const Loop& loop, const std::vector<Shape_points>& shapes)
{
  const double n = static_cast<double>(shapes.size());
  std::vector<double> variance(shapes[0].size(), 0);
  for_each_index(loop, static_cast<int>(variance.size()), [&](int j) {
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

/// A third of the areas of its faces, mean over the shapes, by vertex.
/// \param are_shares  of the area of each shape
template <class Loop>
std::vector<double> mean_areas_of_vertices(const Loop& loop, const Host_array<std::array<int, 3>>& face,
                                           const std::vector<Shape_points>& shapes, bool are_shares)
{
  std::vector<double> factor; // of the points, a power of 2: products neither overflow nor vanish
  for(const Shape_points& shape : shapes) {
    double largest = 0;
    for(const auto& p : shape)
      largest = (std::max)({largest, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
    factor.push_back(largest > 0 ? std::ldexp(1., -(std::max)(std::ilogb(largest), -1000)) : 1);
  }
  const auto area_of = [&](std::size_t i, int f) {
    const auto at = [&](int corner) { return scale(factor[i], coordinates(shapes[i][face[f][corner]])); };
    return norm(outer(sub(at(1), at(0)), sub(at(2), at(0)))) / 2;
  };
  const int n = static_cast<int>(face.size());
  std::vector<double> whole(shapes.size(), 1);
  for(std::size_t i = 0; i < shapes.size() && are_shares; ++i)
    whole[i] = sum_by_parts(loop, n, [&](int f) { return area_of(i, f); });
  Host_array<double> area(face.size());
  for_each_index(loop, n, [&](int f) {
    area[f] = 0;
    for(std::size_t i = 0; i < shapes.size(); ++i)
      area[f] += are_shares ? (whole[i] > 0 ? area_of(i, f) / whole[i] : 0) : area_of(i, f) / factor[i] / factor[i];
  });
  std::vector<double> result(shapes[0].size(), 0);
  for(std::size_t f = 0; f < face.size(); ++f)
    for(int v : face[f])
      result[v] += area[f] / 3 / static_cast<double>(shapes.size());
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STATISTICS_SHAPES_H
