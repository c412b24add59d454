// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STATISTICS_PRINCIPAL_COMPONENTS_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STATISTICS_PRINCIPAL_COMPONENTS_IMPL_H

#include <CGAL/Spherical_parameterization/internal/algebra/dense_matrices.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/statistics/principal_components.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

namespace CGAL::Spherical_parameterization::internal {

/// R of the QR decomposition: at most as many rows as columns.
template <class Matrix>
Matrix triangle_of(const Matrix& matrix)
{
  const Eigen::Index rows = (std::min)(matrix.rows(), matrix.cols());
  return Eigen::HouseholderQR<Matrix>(matrix).matrixQR().topRows(rows).template triangularView<Eigen::Upper>();
}

/// Distances of the shapes from their mean.
template <class Matrix>
struct Deviations {
  Matrix triangle;     ///< whose columns have the same inner products, weighted
  double rounding = 0; ///< what singular values have to exceed in any case
};

template <class Loop>
auto deviations_of(const Loop& loop, const Shape_set<const double>& shapes)
{
  typedef typename Dense<Loop>::Matrix Matrix;
  const int n = shapes.size(), entries_of_block = (std::max)(256, 2 * n); // six rows for every column
  const int blocks = (shapes.entries() + entries_of_block - 1) / entries_of_block;
  std::vector<Matrix> triangle(static_cast<std::size_t>(blocks));
  std::vector<double> square(triangle.size());
  const auto triangle_of_block = [&](int block) {
    const int begin = block * entries_of_block, end = (std::min)(begin + entries_of_block, shapes.entries());
    Matrix rows(3 * (end - begin), n);
    for(int j = begin; j < end; ++j) {
      const double factor = std::sqrt(shapes.weight(j));
      for(int i = 0; i < n; ++i)
        for(int c = 0; c < 3; ++c)
          rows(3 * (j - begin) + c, i) = factor * shapes(i, j, c);
    }
    square[block] = rows.squaredNorm();
    const typename Dense<Loop>::Vector mean = rows.rowwise().mean();
    rows.colwise() -= mean;
    return triangle_of(rows);
  };
  // So many blocks at a time that every core has some: their order decides the bits, and is always the same.
  constexpr int at_a_time = 16;
  Matrix all(0, n);
  for(int first = 0; first < blocks; first += at_a_time) {
    const int last = (std::min)(first + at_a_time, blocks);
    loop.for_each(last - first, [&](int k) { triangle[first + k] = triangle_of_block(first + k); });
    for(int block = first; block < last; ++block) {
      Matrix both(all.rows() + triangle[block].rows(), n);
      both << all, triangle[block];
      all = triangle_of(both);
      triangle[block].resize(0, 0);
    }
  }
  const double size = std::sqrt(std::accumulate(square.begin(), square.end(), 0.));
  return Deviations<Matrix>{all, 4 * std::numeric_limits<double>::epsilon() * size};
}

/// How many singular values, largest first, are more than rounding.
template <class Vector>
Eigen::Index rank_of(const Vector& values, double rounding)
{
  const auto is_rounding = [&](double value) { return value <= (std::max)(smallest_deviation * values[0], rounding); };
  return std::find_if(values.data(), values.data() + values.size(), is_rounding) - values.data();
}

template <class Loop>
Principal_components principal_components(const Loop& loop, const Shape_set<const double>& shapes)
{
  const int n = shapes.size();
  const auto deviations = deviations_of(loop, shapes);
  const Eigen::BDCSVD<typename Dense<Loop>::Matrix> svd(deviations.triangle, Eigen::ComputeThinV);
  const typename Dense<Loop>::Vector& values = svd.singularValues();
  const Eigen::Index rank = (std::min)(rank_of(values, deviations.rounding), Eigen::Index(n - 1));
  Principal_components result;
  result.square_sum = deviations.triangle.squaredNorm();
  result.deviation.assign(values.data(), values.data() + rank);
  result.combination.resize(static_cast<std::size_t>(n));
  for(int i = 0; i < n; ++i)
    for(std::size_t k = 0; k < result.deviation.size(); ++k)
      result.combination[i].push_back(svd.matrixV()(i, static_cast<Eigen::Index>(k)) / result.deviation[k]);
  for(std::size_t k = 0; k < result.deviation.size(); ++k) {
    double longest = 0;
    for(const auto& row : result.combination)
      if(std::abs(row[k]) > std::abs(longest) * (1 + 1e-9)) // of equal ones the first, whatever the rounding
        longest = row[k];
    for(auto& row : result.combination)
      row[k] *= longest < 0 ? -1 : 1;
  }
  return result;
}

template <class Loop>
void write_components(const Loop& loop, const Shape_set<const double>& shapes, const Principal_components& components,
                      const Shape_set<double>& mean_and_modes)
{
  constexpr int at_a_time = 256;
  const int n = shapes.size(), modes = mean_and_modes.size() - 1;
  for_each_index<at_a_time>(loop, shapes.entries(), [&](int j) {
    for(int c = 0; c < 3; ++c) {
      double& mean = mean_and_modes(0, j, c);
      for(int i = 0; i < n; ++i)
        mean += shapes(i, j, c) / n;
      for(int k = 0; k < modes; ++k) {
        double& mode = mean_and_modes(k + 1, j, c);
        for(int i = 0; i < n; ++i)
          mode += components.combination[i][k] * (shapes(i, j, c) - mean);
      }
    }
  });
}

template <class Loop>
std::vector<double> errors_of_left_out(const Loop& loop, const Shape_set<const double>& shapes, int groups)
{
  const int n = shapes.size();
  const auto deviations = deviations_of(loop, shapes);
  typedef typename Dense<Loop>::Matrix Matrix;
  typedef typename Dense<Loop>::Vector Vector;
  const Matrix& r = deviations.triangle;
  const int most = n - (n + groups - 1) / groups; // shapes outside of the largest group, and so components and mean
  std::vector<std::vector<double>> square(static_cast<std::size_t>(groups));
  std::vector<Eigen::Index> ranks(square.size());
  loop.for_each(groups, [&](int group) {
    const int inside = (n - group + groups - 1) / groups;
    Matrix others(r.rows(), n - inside), left_out(r.rows(), inside);
    for(int i = 0, in = 0, out = 0; i < n; ++i) {
      if(i % groups == group)
        left_out.col(in++) = r.col(i);
      else
        others.col(out++) = r.col(i);
    }
    const Vector mean = others.rowwise().mean();
    others.colwise() -= mean;
    left_out.colwise() -= mean;
    const Eigen::BDCSVD<Matrix> svd(others, Eigen::ComputeThinU);
    square[group].push_back(left_out.squaredNorm());
    const Eigen::Index rank = ranks[group] = rank_of(svd.singularValues(), deviations.rounding);
    for(Eigen::Index k = 0; k + 1 < most; ++k) {
      if(k < rank) {
        const Vector u = svd.matrixU().col(k);
        left_out -= u * (u.transpose() * left_out);
      }
      square[group].push_back(left_out.squaredNorm());
    }
  });
  std::vector<double> errors(std::min<std::size_t>(most, 1 + *std::max_element(ranks.begin(), ranks.end())));
  for(std::size_t k = 0; k < errors.size(); ++k) {
    double sum = 0;
    for(const std::vector<double>& of_group : square)
      sum += of_group[k];
    errors[k] = std::sqrt(sum / n);
  }
  return errors;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STATISTICS_PRINCIPAL_COMPONENTS_IMPL_H
