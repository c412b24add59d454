// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_RESULT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_RESULT_H

#include <cstddef>
#include <ostream>
#include <string>

namespace CGAL {
namespace Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationMap
/// @{

/// Everything that can be wrong with the input, or with the map that was found.
/// Only `OK` stands for a certified spherical map.
enum class Error_code {
  OK = 0,                   ///< certified: no flipped face, degree 1, residual below the accuracy
  EMPTY_MESH,               ///< no face
  TOO_LARGE,                ///< 2^31 halfedges or more
  NOT_TRIANGULAR,           ///< a face that is no triangle
  ISOLATED_VERTEX,          ///< a vertex without faces
  BOUNDARY,                 ///< border edges: the surface is not closed
  NON_MANIFOLD,             ///< a vertex or edge around which the faces form no single disk
  INCONSISTENT_ORIENTATION, ///< neighbouring faces listed in opposite senses (only in files)
  SEVERAL_COMPONENTS,       ///< more than one connected component
  WRONG_GENUS,              ///< handles: not a topological sphere
  NON_FINITE_COORDINATE,    ///< NaN or infinity in a point
  DEGENERATE_FACE,          ///< a face without area, or an edge without length, where one is needed
  BAD_WEIGHT,               ///< an edge weight that is not positive and finite
  BAD_CONSTRAINTS,          ///< one or two fixed vertices, coincident ones, no direction; or a method that keeps none
  NOT_CONVERGED,            ///< the residual did not reach the accuracy
  INTERRUPTED,              ///< stopped by the callback or the time limit; the best map so far is handed over
  NOT_BIJECTIVE             ///< converged, but faces are flipped or the degree is not 1
};

/// The sentence a user reads for an error; `Result::detail` adds what and where.
/// \param code  what is wrong, or `OK`
/// \return a string that is never freed, without full stop
// clang-format off
inline const char* get_error_message(Error_code code)
{
  switch(code) {
  case Error_code::OK:                       return "valid spherical map";
  case Error_code::EMPTY_MESH:               return "the mesh has no faces";
  case Error_code::TOO_LARGE:                return "the mesh is too large";
  case Error_code::NOT_TRIANGULAR:           return "the mesh has a face that is not a triangle";
  case Error_code::ISOLATED_VERTEX:          return "the mesh has a vertex without faces";
  case Error_code::BOUNDARY:                 return "the mesh is not closed";
  case Error_code::NON_MANIFOLD:             return "the mesh is not a 2-manifold";
  case Error_code::INCONSISTENT_ORIENTATION: return "the faces are not consistently oriented";
  case Error_code::SEVERAL_COMPONENTS:       return "the mesh has several connected components";
  case Error_code::WRONG_GENUS:              return "the mesh is not of genus 0";
  case Error_code::NON_FINITE_COORDINATE:    return "a point has a coordinate that is not finite";
  case Error_code::DEGENERATE_FACE:          return "a degenerate face where an area is needed";
  case Error_code::BAD_WEIGHT:               return "an edge weight is not positive and finite";
  case Error_code::BAD_CONSTRAINTS:          return "the fixed vertices do not determine a map";
  case Error_code::NOT_CONVERGED:            return "the solver did not reach the accuracy";
  case Error_code::INTERRUPTED:              return "the computation was interrupted";
  case Error_code::NOT_BIJECTIVE:            return "the map found is not bijective";
  }
  return "unknown error";
}
// clang-format on

/// What `parameterize()` did and how good the map is. Times are wall-clock seconds.
struct Result {
  Error_code error = Error_code::OK; ///< `OK` if and only if the map is certified
  std::string detail;                ///< what, where and what to do; empty if `OK`

  std::size_t number_of_vertices = 0; ///< of the mesh
  std::size_t number_of_faces = 0;    ///< of the mesh

  /// \name Certificate
  /// Counted with exact predicates on the double coordinates that were handed out.
  /// @{
  std::size_t flipped_faces = 0; ///< faces (a,b,c) with orientation(O,a,b,c) <= 0
  int degree = 0;                ///< how often the map covers the sphere; 1 for a valid one
  double residual = 0;           ///< L2 norm over the free vertices (not divided by their number) of the
                                 ///< stationarity the method claims, relative to the weight sum of a vertex;
                                 ///< `Isometric`: the share of the energy that the last step promised to gain
  double energy = 0;             ///< spring energy of the map, 1/p * sum over edges; `Isometric`: mean distortion;
                                 ///< infinite where doubles do not reach
  double smallest_area = 0;      ///< of all spherical triangles, without sign; from 1e-26 on rounding flips faces
  double smallest_edge = 0;      ///< length of the shortest chord, in units of 2^-52: how many roundings it is long
  /// @}

  /// \name Method
  /// @{
  std::string method;          ///< that found the map: "balanced", "balanced with exponent 3", "isometric", ...
  std::string fallback_reason; ///< `Automatic`: what was wrong with the maps before; empty if the first one was valid
  /// @}

  /// \name Work
  /// @{
  std::size_t start_iterations = 0; ///< of the start map, on all coarse levels together
  std::size_t iterations = 0;       ///< iterations of the method: descent steps, or saddle-point problems solved
  std::size_t sweeps = 0;           ///< Jacobi or Gauss-Seidel sweeps (saddle-point method; else 0)
  /// Wall-clock time of each phase, in seconds.
  struct Seconds {
    double read = 0;      ///< from the FaceGraph to arrays, with all checks of the input
    double start_map = 0; ///< set-up of the multigrid hierarchy, and the start map
    double solve = 0;     ///< from the start map to the result
    double certify = 0;   ///< certificate, residual, and writing the property map
    double total = 0;     ///< all of the call
  };
  Seconds seconds;    ///< how long it took
  std::string device; ///< what the policy ran on
  /// @}

  /// \return `true` iff the map is certified
  explicit operator bool() const { return error == Error_code::OK; }
};

/// One line for a log: the verdict and the figures behind it.
/// \param out  a stream
/// \param r    what to write
/// \return `out`
inline std::ostream& operator<<(std::ostream& out, const Result& r)
{
  out << get_error_message(r.error);
  if(!r.detail.empty())
    out << ": " << r.detail;
  if(r.degree != 0 || r.residual != 0)
    out << " (" << r.number_of_vertices << " vertices, " << r.flipped_faces << " flipped faces, degree " << r.degree
        << ", residual " << r.residual << ", " << r.start_iterations << " + " << r.iterations << " iterations, "
        << r.seconds.total << " s)";
  return out;
}

/// @}

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_RESULT_H
