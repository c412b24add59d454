// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_RIGID_PATH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_RIGID_PATH_H

#include <CGAL/Spherical_parameterization/internal/algebra/dense_matrices.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationInverse
///
/// \brief The path of points from one place to another one, such as the vertices of a mesh that takes the shape of
/// another mesh. The best rigid motion between both (S. Umeyama, "Least-squares estimation of transformation parameters
/// between two point patterns", 1991) is made at an even speed, and the rest is linear, so that a shape that only turns
/// does not shrink on the way.
///
/// \param start,end  both places: contiguous ranges of `std::array<double, 3>`
/// \return a function of a time from 0 (the start) to 1 (the end, both to the last bit): the points as a
///   `std::vector<std::array<double, 3>>`
/// \pre there are as many points here as there, at least one, and all are finite
template <class Points>
auto rigid_path(const Points& start, const Points& end)
{
  typedef typename internal::Dense<Points>::Matrix_3 Matrix_3;
  typedef typename internal::Dense<Points>::Vector_3 Vector;
  typedef Eigen::Matrix<typename Vector::Scalar, 3, Eigen::Dynamic> Matrix;
  typedef Eigen::AngleAxis<typename Vector::Scalar> Turn;
  CGAL_SP_PRECONDITION(start.size() > 0 && start.size() == end.size(), "both ends of a path have the same points");
  const auto by_columns = [](const Points& points) -> Matrix {
    return Eigen::Map<const Matrix>(points.begin()->data(), 3, static_cast<Eigen::Index>(points.size()));
  };
  Matrix from = by_columns(start), to = by_columns(end);
  CGAL_SP_PRECONDITION(from.allFinite() && to.allFinite(), "both ends of a path are finite");
  const double size = (std::max)(from.cwiseAbs().maxCoeff(), to.cwiseAbs().maxCoeff());
  const int exponent = size > 0 ? std::ilogb(size) : 0;
  const auto scaled = [](const Matrix& places, int by) -> Matrix { // changes no digit, and sums do not overflow
    return places.unaryExpr([by](double x) { return std::ldexp(x, by); });
  };
  from = scaled(from, -exponent);
  to = scaled(to, -exponent);
  const Vector from_centre = from.rowwise().mean(), to_centre = to.rowwise().mean();
  from.colwise() -= from_centre;
  to.colwise() -= to_centre;
  const auto in_unit = [&scaled](const Matrix& places) { // where squares neither overflow nor vanish
    const double largest = places.cwiseAbs().maxCoeff();
    return scaled(places, largest > 0 ? -std::ilogb(largest) : 0);
  };
  const Turn turn(Matrix_3(Eigen::umeyama(in_unit(from), in_unit(to), false).template topLeftCorner<3, 3>()));
  to = turn.inverse().toRotationMatrix() * to; // turned back
  typedef std::vector<std::array<double, 3>> Places;
  return [=, first = Places(start.begin(), start.end()), last = Places(end.begin(), end.end())](double t) {
    if(t <= 0 || t >= 1)
      return t <= 0 ? first : last;
    const Matrix_3 part = Turn(t * turn.angle(), turn.axis()).toRotationMatrix();
    const Matrix all =
      scaled((part * ((1 - t) * from + t * to)).colwise() + ((1 - t) * from_centre + t * to_centre), exponent);
    Places points;
    for(Eigen::Index v = 0; v < all.cols(); ++v)
      points.push_back({all(0, v), all(1, v), all(2, v)});
    return points;
  };
}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_RIGID_PATH_H
