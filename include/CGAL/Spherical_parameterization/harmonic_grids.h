// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_HARMONIC_GRIDS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_HARMONIC_GRIDS_H

#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/values/Harmonic_coefficients.h>
#include <CGAL/Spherical_parameterization/internal/algebra/point_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/api/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/context/make_monitor.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/analysis.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationHarmonics
/// @{

/// A grid of latitudes and longitudes with a quadrature.
class Latitude_longitude_grid {
public:
  /// The smallest grid that is exact for products of functions of this degree: the degree + 1 rows of Gauss, and twice
  /// as many columns, or a few more that suit Fourier transforms.
  /// \param degree  0 to `largest_harmonic_degree`
  /// \return the grid
  static Latitude_longitude_grid gauss_legendre(int degree)
  {
    static_cast<void>(Harmonic_coefficients(degree, 0));
    return Latitude_longitude_grid(internal::gauss_legendre_rows(degree + 1, 2 * degree + 2));
  }

  /// Equidistant rows, of which the first and the last one are the poles, and columns. Exact for products of functions
  /// of a degree below rows / 2, if there are more columns than twice the degree.
  /// \param rows     2 or more
  /// \param columns  1 or more
  /// \return the grid
  static Latitude_longitude_grid equidistant(int rows, int columns)
  {
    CGAL_SP_PRECONDITION(rows >= 2 && columns >= 1, "a grid has two rows and one column, or more");
    return Latitude_longitude_grid(internal::equidistant_rows(rows, columns));
  }

  int rows() const { return static_cast<int>(grid_.cos.size()); } ///< \return the number of circles, north to south
  int columns() const { return grid_.columns; }                   ///< \return the number of longitudes, from 0 on

  /// \param row     0 to rows() - 1
  /// \param column  0 to columns() - 1; the longitude is 2 pi column / columns()
  /// \return the unit vector
  std::array<double, 3> direction(int row, int column) const
  {
    return internal::array_of(grid_.direction(row, column));
  }

  /// \param row  0 to rows() - 1
  /// \return the quadrature weight, in steradians, of each of its points
  double weight(int row) const { return grid_.weight[row]; }

  /// \cond SKIP_IN_MANUAL
  const internal::Latitude_rows& internal_rows() const { return grid_; }
  /// \endcond

private:
  explicit Latitude_longitude_grid(internal::Latitude_rows grid) : grid_(std::move(grid)) {}

  internal::Latitude_rows grid_;
};

/// The values of functions on a grid.
/// \param coefficients  of the functions
/// \param grid          where
/// \param policy,np  see \ref pd_calls
/// \return function after function, row after row
/// \throws Error  `NON_FINITE_COORDINATE` for coefficients that are not finite, and `INTERRUPTED`
///
/// Complexity: O(L^2) per row.
template <class ExecutionPolicy, class CGAL_NP_TEMPLATE_PARAMETERS, internal::If_policy<ExecutionPolicy> = 0>
std::vector<double> harmonic_grid_values(const ExecutionPolicy& policy, const Harmonic_coefficients& coefficients,
                                         const Latitude_longitude_grid& grid,
                                         const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::check_finite(coefficients);
  internal::Monitor monitor = internal::make_monitor(np);
  const auto value = internal::synthesize_on_rows(internal::Watched_loop(internal::host_loop(policy), monitor),
                                                  coefficients, grid.internal_rows());
  return std::vector<double>(value.begin(), value.end());
}
CGAL_SP_ON_ONE_CORE(harmonic_grid_values)

/// Analysis of values on a grid, by its quadrature.
/// \param grid    where
/// \param values  function after function, row after row
/// \param degree  of the coefficients
/// \param policy,np  see \ref pd_calls
/// \return the coefficients: to rounding those of the functions, if these are of the degree for which the grid is exact
/// \throws Error  `NON_FINITE_COORDINATE` for values that are not finite, and `INTERRUPTED`
/// \pre the number of values is a multiple of the size of the grid
///
/// Complexity: O(L^2) per row.
template <class ExecutionPolicy, class CGAL_NP_TEMPLATE_PARAMETERS, internal::If_policy<ExecutionPolicy> = 0>
Harmonic_coefficients harmonic_grid_analysis(const ExecutionPolicy& policy, const Latitude_longitude_grid& grid,
                                             const std::vector<double>& values, int degree,
                                             const CGAL_NP_CLASS& np = parameters::default_values())
{
  const std::size_t size = static_cast<std::size_t>(grid.rows()) * static_cast<std::size_t>(grid.columns());
  CGAL_SP_PRECONDITION(values.size() % size == 0, "there must be a value for every point of the grid");
  static_cast<void>(Harmonic_coefficients(degree, 0));
  for(std::size_t i = 0; i < values.size(); ++i)
    if(!std::isfinite(values[i]))
      throw internal::Input_error(Error_code::NON_FINITE_COORDINATE, "value " + std::to_string(i) + " on the grid");
  internal::Monitor monitor = internal::make_monitor(np);
  return internal::analyze_rows(
    internal::Watched_loop(internal::host_loop(policy), monitor), grid.internal_rows(),
    {static_cast<int>(values.size() / size), internal::Host_array<double>(values.begin(), values.end())}, degree);
}
CGAL_SP_ON_ONE_CORE(harmonic_grid_analysis)

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_HARMONIC_GRIDS_H
