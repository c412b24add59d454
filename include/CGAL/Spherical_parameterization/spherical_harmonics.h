// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SPHERICAL_HARMONICS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SPHERICAL_HARMONICS_H

#include <CGAL/Spherical_parameterization/internal/algebra/pi.h>
#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/values/Harmonic_coefficients.h>
#include <CGAL/Spherical_parameterization/values/harmonics_methods.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/api/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/algebra/rotations.h>
#include <CGAL/Spherical_parameterization/internal/distortion/Face_measures.h>
#include <CGAL/Spherical_parameterization/internal/distortion/Mapped_faces.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/analysis.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/ellipsoid.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/rotation.h>

#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationHarmonics
/// @{

/// What `harmonic_analysis()` has found.
struct Harmonic_analysis {
  Harmonic_coefficients coefficients; ///< of the data
  bool has_converged = true;          ///< whether least squares came to their accuracy in the iterations they had
  int iterations = 0;                 ///< of least squares
};

namespace internal {

/// The values of a vertex map, numbers or vectors, as one or three fields.
template <class TriangleMesh, class VertexMap>
Sampled_fields read_fields(const TriangleMesh& mesh, VertexMap map)
{
  typedef typename boost::property_traits<VertexMap>::value_type Value;
  Sampled_fields result;
  if constexpr(std::is_arithmetic_v<Value>) {
    result.number_of_fields = 1;
    for(auto v : vertices(mesh))
      result.value.push_back(static_cast<double>(get(map, v)));
  } else {
    result.number_of_fields = 3;
    const Host_array<vec3> rows = read_vectors(mesh, map);
    result.value.resize(3 * rows.size());
    for(std::size_t i = 0; i < rows.size(); ++i) {
      result.value[i] = rows[i].x;
      result.value[rows.size() + i] = rows[i].y;
      result.value[2 * rows.size() + i] = rows[i].z;
    }
  }
  return result;
}

/// Throws Error for what is not finite, and directions of length 0.
inline void check_harmonics_data(const Host_array<vec3>& directions, const Sampled_fields& fields)
{
  for(std::size_t i = 0; i < directions.size(); ++i)
    if(const double square = inner(directions[i], directions[i]); !(square > 0) || !std::isfinite(square))
      throw Input_error(Error_code::NON_FINITE_COORDINATE, "no direction at vertex " + std::to_string(i));
  for(std::size_t i = 0; i < fields.value.size(); ++i)
    if(!std::isfinite(fields.value[i]))
      throw Input_error(Error_code::NON_FINITE_COORDINATE,
                        "the value of vertex " + std::to_string(i % directions.size()));
}

/// Every vertex's third of the areas of its faces.
template <class Loop, class Area>
Host_array<double> vertex_areas(const Loop& loop, const Mapped_faces& map, Area area_of_face)
{
  Host_array<double> area(map.face.size());
  for_each_index(loop, map.number_of_faces(), [&](int f) { area[f] = area_of_face(f); });
  Host_array<double> result(map.image.size(), 0.);
  for(int f = 0; f < map.number_of_faces(); ++f)
    for(int v : map.face[f])
      result[v] += area[f] / 3;
  return result;
}

template <class Loop, class TriangleMesh, class NamedParameters>
Harmonic_analysis analyze_fields(const Loop& loop, const TriangleMesh& mesh, const Mapped_faces& map,
                                 Sampled_fields fields, int degree, const Least_squares& method,
                                 const NamedParameters& np)
{
  CGAL_SP_PRECONDITION(method.accuracy >= 0, "the accuracy of least squares must not be negative");
  CGAL_SP_PRECONDITION(method.iterations >= 0, "the number of iterations must not be negative");
  CGAL_SP_PRECONDITION(static_cast<std::size_t>(degree + 1) * static_cast<std::size_t>(degree + 1) <= map.image.size(),
                       "least squares need (degree + 1)^2 vertices or more: take a smaller degree, or Integration");
  CGAL_SP_PRECONDITION(2 * degree <= largest_harmonic_degree, "the degree of least squares is at most 8191");
  Host_array<double> weights;
  if(method.weights == Vertex_weights::SPHERE_AREA)
    weights = vertex_areas(loop, map, [&](int f) {
      const auto [a, b, c] = map.on_sphere(f);
      return (std::max)(0., spherical_area(a, b, c));
    });
  else if(method.weights == Vertex_weights::SURFACE_AREA) {
    Vertices<TriangleMesh> vertex;
    weights = read_surface(mesh, vertex_points(mesh, np), Reading::UNCHECKED, loop, vertex).vertex_area(loop);
  } else
    weights.assign(map.image.size(), 1.);
  Fit fit = fit_harmonics(loop, map.image, fields, weights, degree, method);
  return {std::move(fit.coefficients), fit.has_converged, fit.iterations};
}

template <class Loop, class TriangleMesh, class NamedParameters>
Harmonic_analysis analyze_fields(const Loop& loop, const TriangleMesh&, const Mapped_faces& map, Sampled_fields fields,
                                 int degree, const Integration& method, const NamedParameters&)
{
  CGAL_SP_PRECONDITION(method.accuracy > 0, "the accuracy of a quadrature is positive");
  return {integrate_harmonics(loop, map, fields, degree, method.accuracy), true, 0};
}

} // namespace internal

/// \name Analysis and Synthesis
/// @{

/// Analysis of data of the vertices in spherical harmonics: the coefficients of the function on the sphere that is what
/// the data are at the images of the vertices. Of a shape (SPHARM; C. Brechbuehler, G. Gerig, O. Kuebler,
/// "Parametrization of closed surfaces for 3-D shape description", 1995) these are three functions, the coordinates.
///
/// \param policy      `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param mesh        a closed triangle mesh, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors. Maps of low isometric distortion
/// (`Isometric`)
///                    need fewer degrees than conformal ones, which give limbs a tiny part of the sphere.
/// \param vertex_map  readable, key vertex_descriptor; value a number, or a point or vector of three coordinates
/// \param degree      of the coefficients, 0 to `largest_harmonic_degree`
/// \param method      `Least_squares` or `Integration`
/// \param np          optional named parameters: `vertex_point_map`, by default the mesh's own, for
///                    `Vertex_weights::SURFACE_AREA`
/// \return the coefficients of one or of three functions, and how least squares went
/// \throws Error  `NON_FINITE_COORDINATE` for an image that is no direction, or a value that is not finite
/// \pre for `Least_squares` there are (degree + 1)^2 vertices or more, and the degree is at most 8191
///
/// Complexity: O(n) and O(L^3) for every iteration, or O(L^3) and the number of quadrature points for integrals.
template <class ExecutionPolicy, class TriangleMesh, class VertexSphereMap, class VertexMap,
          class Method = Least_squares, class CGAL_NP_TEMPLATE_PARAMETERS, internal::If_policy<ExecutionPolicy> = 0>
Harmonic_analysis harmonic_analysis(const ExecutionPolicy& policy, const TriangleMesh& mesh, VertexSphereMap sphere_map,
                                    VertexMap vertex_map, int degree, const Method& method = Method(),
                                    const CGAL_NP_CLASS& np = parameters::default_values())
{
  static_cast<void>(Harmonic_coefficients(degree, 0)); // checks it
  const auto loop = internal::host_loop(policy);
  const internal::Mapped_faces map = internal::read_images(mesh, sphere_map, loop);
  internal::Sampled_fields fields = internal::read_fields(mesh, vertex_map);
  internal::check_harmonics_data(map.image, fields);
  return internal::analyze_fields(loop, mesh, map, std::move(fields), degree, method, np);
}

/// \overload
/// \param mesh,sphere_map,vertex_map,degree,method,np as above; on one core \return as above
template <class TriangleMesh, class VertexSphereMap, class VertexMap, class Method = Least_squares,
          class CGAL_NP_TEMPLATE_PARAMETERS, internal::If_no_policy<TriangleMesh> = 0>
Harmonic_analysis harmonic_analysis(const TriangleMesh& mesh, VertexSphereMap sphere_map, VertexMap vertex_map,
                                    int degree, const Method& method = Method(),
                                    const CGAL_NP_CLASS& np = parameters::default_values())
{
  return harmonic_analysis(CGAL::Sequential_tag(), mesh, sphere_map, vertex_map, degree, method, np);
}

/// The values of the functions at directions, to 1e-12 of the root of their power.
/// \param policy        `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param coefficients  of the functions
/// \param directions    a range of vectors of any length but 0: with x(), y(), z() or operator[]
/// \return direction after direction, the values of all functions
/// \throws Error  `NON_FINITE_COORDINATE` for what is no direction
///
/// Complexity: O(L^3 + n).
template <class ExecutionPolicy, class DirectionRange>
std::vector<double> harmonic_values(const ExecutionPolicy& policy, const Harmonic_coefficients& coefficients,
                                    const DirectionRange& directions)
{
  internal::Host_array<internal::vec3> direction;
  for(const auto& d : directions)
    direction.push_back(internal::coordinates(d));
  internal::check_harmonics_data(direction, {});
  if(direction.empty() || coefficients.number_of_fields() == 0)
    return {};
  const auto by_field = internal::evaluate_harmonics(internal::host_loop(policy), coefficients, direction);
  const std::size_t n = direction.size(), fields = by_field.size() / n;
  std::vector<double> result(by_field.size());
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t k = 0; k < fields; ++k)
      result[i * fields + k] = by_field[k * n + i];
  return result;
}

/// Synthesis: gives every vertex the value at its image. With the mesh and the map that were analyzed it is a
/// reconstruction; with an icosphere (`make_icosphere()`) every shape gets the same vertices and faces.
/// \param policy        `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param coefficients  of one function if the values are numbers, of three if they are points
/// \param mesh          a model of `VertexListGraph`
/// \param sphere_map    readable, key vertex_descriptor, value vectors of any length but 0
/// \param vertex_map    writable, key vertex_descriptor; value a number, or constructible from three numbers
/// \throws Error  `NON_FINITE_COORDINATE` for an image that is no direction, before anything is written
/// \pre there are as many functions as the values have coordinates
///
/// Complexity: O(L^3 + n).
template <class ExecutionPolicy, class Mesh, class VertexSphereMap, class VertexMap>
void harmonic_synthesis(const ExecutionPolicy& policy, const Harmonic_coefficients& coefficients, const Mesh& mesh,
                        VertexSphereMap sphere_map, VertexMap vertex_map)
{
  typedef typename boost::property_traits<VertexMap>::value_type Value;
  constexpr int fields = std::is_arithmetic_v<Value> ? 1 : 3;
  CGAL_SP_PRECONDITION(coefficients.number_of_fields() == fields,
                       "numbers are synthesized from one function, points from three");
  const std::vector<double> value = harmonic_values(policy, coefficients, internal::read_vectors(mesh, sphere_map));
  const double* x = value.data();
  for(auto v : vertices(mesh)) {
    if constexpr(fields == 1)
      put(vertex_map, v, static_cast<Value>(*x));
    else
      put(vertex_map, v, Value{x[0], x[1], x[2]});
    x += fields;
  }
}

/// \overload
/// \param coefficients,mesh,sphere_map,vertex_map as above; on one core
template <class Mesh, class VertexSphereMap, class VertexMap>
void harmonic_synthesis(const Harmonic_coefficients& coefficients, const Mesh& mesh, VertexSphereMap sphere_map,
                        VertexMap vertex_map)
{
  harmonic_synthesis(CGAL::Sequential_tag(), coefficients, mesh, sphere_map, vertex_map);
}

/// @}
/// \name Grids
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
    const double longitude = 2 * internal::pi * column / columns();
    return {grid_.sin[row] * std::cos(longitude), grid_.sin[row] * std::sin(longitude), grid_.cos[row]};
  }

  /// \param row  0 to rows() - 1
  /// \return the area, in steradians, that each of its points stands for
  double weight(int row) const { return grid_.weight[row]; }

  /// \cond SKIP_IN_MANUAL
  const internal::Latitude_rows& internal_rows() const { return grid_; }
  /// \endcond

private:
  explicit Latitude_longitude_grid(internal::Latitude_rows grid) : grid_(std::move(grid)) {}

  internal::Latitude_rows grid_;
};

/// Synthesis on a grid.
/// \param policy        `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param coefficients  of the functions
/// \param grid          where
/// \return function after function, row after row
///
/// Complexity: O(L^2) per row.
template <class ExecutionPolicy>
std::vector<double> harmonic_synthesis(const ExecutionPolicy& policy, const Harmonic_coefficients& coefficients,
                                       const Latitude_longitude_grid& grid)
{
  const auto value = internal::synthesize_on_rows(internal::host_loop(policy), coefficients, grid.internal_rows());
  return std::vector<double>(value.begin(), value.end());
}

/// Analysis of values on a grid, by its quadrature.
/// \param policy  `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param grid    where
/// \param values  function after function, row after row
/// \param degree  of the coefficients
/// \return the coefficients: to rounding those of the functions, if these are of the degree for which the grid is exact
/// \pre the number of values is a multiple of the size of the grid
///
/// Complexity: O(L^2) per row.
template <class ExecutionPolicy>
Harmonic_coefficients harmonic_analysis(const ExecutionPolicy& policy, const Latitude_longitude_grid& grid,
                                        const std::vector<double>& values, int degree)
{
  const std::size_t size = static_cast<std::size_t>(grid.rows()) * static_cast<std::size_t>(grid.columns());
  CGAL_SP_PRECONDITION(values.size() % size == 0, "there must be a value for every point of the grid");
  static_cast<void>(Harmonic_coefficients(degree, 0));
  return internal::analyze_rows(
    internal::host_loop(policy), grid.internal_rows(),
    {static_cast<int>(values.size() / size), internal::Host_array<double>(values.begin(), values.end())}, degree);
}

/// @}
/// \name What Coefficients Say
/// @{

/// The power of every degree: the sum of the squares of its coefficients over all functions. Rotating the sphere does
/// not change it, nor does rotating a shape in space; all of it together is the integral of the squares (Parseval).
/// \param coefficients  of the functions
/// \return for l = 0 ... degree
inline std::vector<double> power_spectrum(const Harmonic_coefficients& coefficients)
{
  std::vector<double> power(coefficients.degree() + 1, 0);
  for(int field = 0; field < coefficients.number_of_fields(); ++field)
    for(int l = 0; l <= coefficients.degree(); ++l)
      for(int m = -l; m <= l; ++m)
        power[l] += coefficients(l, m, field) * coefficients(l, m, field);
  return power;
}

/// The coefficients multiplied by a factor for every degree. Factors that fall smooth the functions: exp(-t l (l + 1))
/// is the heat flow of time t. Factors above 1 sharpen them. \param coefficients  of the functions \param factor called
/// with the degree l \return the coefficients of the filtered functions
template <class Factor>
Harmonic_coefficients filtered(Harmonic_coefficients coefficients, Factor factor)
{
  for(int l = 0; l <= coefficients.degree(); ++l) {
    const double f = factor(l);
    for(int field = 0; field < coefficients.number_of_fields(); ++field)
      for(int m = -l; m <= l; ++m)
        coefficients(l, m, field) *= f;
  }
  return coefficients;
}

/// The same functions with a smaller degree (a low-pass filter), or with a larger one and zeros.
/// \param coefficients  of the functions
/// \param degree        0 to `largest_harmonic_degree`
/// \return the coefficients
inline Harmonic_coefficients with_degree(const Harmonic_coefficients& coefficients, int degree)
{
  Harmonic_coefficients result(degree, coefficients.number_of_fields());
  for(int field = 0; field < result.number_of_fields(); ++field)
    std::copy_n(coefficients.field_begin(field), (std::min)(result.size(), coefficients.size()),
                result.field_begin(field));
  return result;
}

/// A rotation by its rows, orthonormal, determinant 1.
typedef std::array<std::array<double, 3>, 3> Rotation;

/// The functions turned: f(R^-1 x), by Wigner's matrices.
/// \param coefficients  of the functions f
/// \param rotation      R
/// \return the coefficients of the turned functions
///
/// Complexity: O(L^3); to 1e-12 for any degree.
inline Harmonic_coefficients rotated(const Harmonic_coefficients& coefficients, const Rotation& rotation)
{
  return internal::rotated_harmonics(coefficients, rotation);
}

/// The ellipsoid that a shape is up to degree 1: the points centre + axes^T diag(radii) sphere_axes x of the unit
/// vectors x.
struct First_order_ellipsoid {
  std::array<double, 3> centre; ///< mean over the sphere
  std::array<double, 3> radii;  ///< largest first; the last one is negative if the map mirrors the shape
  Rotation axes;                ///< rows: the directions of the half axes in space
  Rotation sphere_axes;         ///< rows: the directions on the sphere that are mapped there
};

/// The first-order ellipsoid. The signs of the axes are chosen so that the shape reaches farther (the integral of the
/// cubes of the coordinates is positive) along the first and the second one: so shapes without symmetry have one
/// ellipsoid, whatever their pose.
/// \param shape  three functions of degree 1 or more
/// \return the ellipsoid
inline First_order_ellipsoid first_order_ellipsoid(const Harmonic_coefficients& shape)
{
  CGAL_SP_PRECONDITION(shape.number_of_fields() == 3 && shape.degree() >= 1,
                       "an ellipsoid needs three functions of degree 1 or more");
  const internal::Ellipsoid e = internal::ellipsoid_of(shape);
  return {e.centre, e.radii, e.axes, e.sphere_axes};
}

/// A shape in the position of its first-order ellipsoid: centre at the origin, half axes along x, y and z, the largest
/// along x, and the sphere turned so that these are the images of its axes. Shapes in any pose, with any rotation of
/// their maps, become comparable coefficient by coefficient.
/// \param shape  three functions of degree 1 or more
/// \return the coefficients of the moved shape
inline Harmonic_coefficients aligned_to_ellipsoid(const Harmonic_coefficients& shape)
{
  const First_order_ellipsoid ellipsoid = first_order_ellipsoid(shape);
  Harmonic_coefficients result(shape.degree(), 3);
  for(int i = 0; i < shape.size(); ++i)
    for(int k = 0; k < 3; ++k)
      for(int j = 0; j < 3 && i > 0; ++j)
        result.field_begin(k)[i] += ellipsoid.axes[k][j] * shape.field_begin(j)[i];
  return rotated(result, ellipsoid.sphere_axes);
}

/// The rotation R for which f and g turned by R (`rotated()`) are correlated best, of all rotations: that of the
/// largest integral of f(x) g(R^-1 x) over the sphere, summed over the functions. Constants (degree 0) do not matter.
///
/// The correlation is a trigonometric polynomial in Euler's angles, and so is known everywhere by Fourier transforms
/// (B. Kovacs, W. Wriggers, "Fast rotational matching", 2002; P. Kostelec, D. Rockmore, "FFTs on the rotation group",
/// 2008); Newton's method starts from the eight largest of its local maxima on a grid as fine as the degree asks for.
/// \param policy  `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param f,g     as many functions in each; of the larger degree, what the other one has not got does not count
/// \return R, to 1e-10 radians where the maximum is sharp
/// \pre as many functions in f as in g
///
/// Complexity: O(L^4); 25 ms for three functions of degree 31 on one core.
template <class ExecutionPolicy>
Rotation best_rotation(const ExecutionPolicy& policy, const Harmonic_coefficients& f, const Harmonic_coefficients& g)
{
  CGAL_SP_PRECONDITION(f.number_of_fields() == g.number_of_fields() && f.degree() >= 0 && g.degree() >= 0,
                       "functions to be correlated are as many on each side");
  const int degree = (std::min)(f.degree(), g.degree());
  return internal::best_correlations(internal::host_loop(policy), with_degree(f, degree), with_degree(g, degree))
    .front()
    .rotation;
}

/// How a shape g is brought to another one, f: space g(sphere^-1 x) is most like f(x).
struct Shape_alignment {
  Rotation space;     ///< turns the shape
  Rotation sphere;    ///< turns its map
  double correlation; ///< of f and the moved g, from -1 to 1, with both centres (degree 0) at the origin
};

/// Registration of two shapes in any pose, with maps in any position: the rotations of space and of the sphere for
/// which they are correlated best. Where the shapes are, and their sizes, does not matter.
///
/// From the 24 ways to put the axes of the first-order ellipsoids onto each other the best rotation of the sphere, of
/// all (`best_rotation()`), and the best one of space (B. Horn, 1987) by turns: up to degree 4, the best of them up to
/// degree 8, and the best of these with all degrees, near what has been found. Shapes without symmetry, whose first
/// degrees are not too much alike, are brought together wherever they came from; a proof that no other motion is better
/// there is not.
/// \param policy  `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param f,g     three functions each; of the larger degree, what the other one has not got does not count
/// \return the rotations and the correlation
/// \pre three functions of degree 1 or more in both
///
/// Complexity: O(L^3) per step; 50 to 70 ms for degree 31 on one core.
template <class ExecutionPolicy>
Shape_alignment best_alignment(const ExecutionPolicy& policy, const Harmonic_coefficients& f,
                               const Harmonic_coefficients& g)
{
  CGAL_SP_PRECONDITION(f.number_of_fields() == 3 && g.number_of_fields() == 3 && f.degree() >= 1 && g.degree() >= 1,
                       "shapes to be aligned are three functions each, of degree 1 or more");
  const int degree = (std::min)(f.degree(), g.degree());
  const Harmonic_coefficients a = with_degree(f, degree), b = with_degree(g, degree);
  const internal::Motion motion = internal::best_motion(internal::host_loop(policy), a, b);
  const auto power = [](const Harmonic_coefficients& c) {
    const std::vector<double> of_degree = power_spectrum(c);
    return std::accumulate(of_degree.begin() + 1, of_degree.end(), 0.);
  };
  const double size = std::sqrt(power(a) * power(b));
  return {motion.space, motion.sphere, size > 0 ? motion.value / size : 0};
}

/// The mirror image in the plane z = 0, with the map mirrored, too, so that it is still one without flips: what
/// `best_alignment()` is to be asked for as well where left and right shapes are compared.
/// \param shape  three functions
/// \return the coefficients of the mirror image
inline Harmonic_coefficients mirrored(Harmonic_coefficients shape)
{
  CGAL_SP_PRECONDITION(shape.number_of_fields() == 3, "a shape is three functions");
  for(int field = 0; field < 3; ++field)
    for(int l = 0; l <= shape.degree(); ++l)
      for(int m = -l; m <= l; ++m)
        if(((l + m) % 2 != 0) != (field == 2))
          shape(l, m, field) *= -1;
  return shape;
}

/// How far a reconstructed shape is from the shape.
struct Reconstruction_error {
  double root_mean_square; ///< of the distances between corresponding vertices
  double relative;         ///< the same over the root mean square distance of the vertices from their mean
  double largest;          ///< of the distances; the Hausdorff distance of the two surfaces is not larger
};

/// Compares two positions of the vertices of a mesh.
/// \param mesh    a model of `VertexListGraph`
/// \param points  readable, key vertex_descriptor: the shape
/// \param others  readable, key vertex_descriptor: the reconstruction
/// \return the error; 0 for a mesh without vertices
template <class Mesh, class PointMap, class OtherPointMap>
Reconstruction_error reconstruction_error(const Mesh& mesh, PointMap points, OtherPointMap others)
{
  const auto p = internal::read_vectors(mesh, points), q = internal::read_vectors(mesh, others);
  const double n = static_cast<double>(p.size());
  internal::vec3 mean = {0, 0, 0};
  for(const internal::vec3& x : p)
    mean = internal::add_scaled(mean, 1 / n, x);
  double error = 0, size = 0, largest = 0;
  for(std::size_t i = 0; i < p.size(); ++i) {
    const internal::vec3 difference = internal::sub(p[i], q[i]), from_mean = internal::sub(p[i], mean);
    const double square = internal::inner(difference, difference);
    error += square / n;
    size += internal::inner(from_mean, from_mean) / n;
    largest = (std::max)(largest, square);
  }
  return {std::sqrt(error), size > 0 ? std::sqrt(error / size) : 0, std::sqrt(largest)};
}

/// @}

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SPHERICAL_HARMONICS_H
