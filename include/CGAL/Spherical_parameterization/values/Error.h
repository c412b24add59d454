// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_VALUES_ERROR_H
#define CGAL_SPHERICAL_PARAMETERIZATION_VALUES_ERROR_H

#include <stdexcept>
#include <string>

namespace CGAL::Spherical_parameterization {
/// \addtogroup PkgSphericalParameterizationMap
/// @{

/// What can be wrong with the input, or with the map that was found. Only `OK` stands for a certified spherical map.
enum class Error_code {
  OK = 0,                   ///< certified: no flipped face, degree 1, residual below the accuracy
  EMPTY_MESH,               ///< no face
  TOO_LARGE,                ///< 2^31 halfedges or more
  NOT_TRIANGULAR,           ///< a face that is not a triangle
  ISOLATED_VERTEX,          ///< a vertex without faces
  BOUNDARY,                 ///< border edges: the surface is not closed
  NON_MANIFOLD,             ///< a vertex or edge whose faces do not form a single disk
  INCONSISTENT_ORIENTATION, ///< neighbouring faces of opposite orientations (only in soups and files)
  SEVERAL_COMPONENTS,       ///< more than one connected component
  WRONG_GENUS,              ///< handles: not a topological sphere
  NON_FINITE_COORDINATE,    ///< NaN or infinity in a point
  DEGENERATE_FACE,          ///< a face without area, or an edge without length, where one is needed
  BAD_WEIGHT,               ///< an edge weight that is not positive and finite
  BAD_CONSTRAINTS, ///< fixed vertices: one or two, at equal positions, a zero vector; or the mesh is too coarse
  NOT_CONVERGED,   ///< the residual did not reach the accuracy
  INTERRUPTED,     ///< stopped by the callback or the time limit; the best map so far is stored
  NOT_BIJECTIVE,   ///< converged, but faces are flipped or the degree is not 1
  BAD_INDEX,       ///< a triangle that names a point that is not there (only in soups)
  BAD_DENSITY      ///< a density that is not positive and finite
};

/// The message of an error code, in words; `Result::detail` adds what exactly, and where.
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
  case Error_code::BAD_INDEX:                return "a triangle names a point that does not exist";
  case Error_code::NON_FINITE_COORDINATE:    return "a point has a coordinate that is not finite";
  case Error_code::DEGENERATE_FACE:          return "a degenerate face where an area is needed";
  case Error_code::BAD_WEIGHT:               return "an edge weight is not positive and finite";
  case Error_code::BAD_DENSITY:              return "a density is not positive and finite";
  case Error_code::BAD_CONSTRAINTS:          return "the fixed vertices do not determine a map";
  case Error_code::NOT_CONVERGED:            return "the solver did not reach the accuracy";
  case Error_code::INTERRUPTED:              return "the computation was interrupted";
  case Error_code::NOT_BIJECTIVE:            return "the map found is not bijective";
  }
  return "unknown error";
}
// clang-format on

/// Wrong data, thrown by functions that do not return a `Result`. Wrong arguments, such as a negative accuracy, are a
/// `CGAL::Precondition_exception` instead.
class Error : public std::invalid_argument {
public:
  /// \param code    what is wrong
  /// \param detail  where, and what to do about it
  Error(Error_code code, const std::string& detail)
    : std::invalid_argument(std::string(get_error_message(code)) + ": " + detail), code_(code), detail_(detail)
  {}

  /// \param code    what is wrong
  /// \param where   where
  /// \param remedy  what to do about it
  Error(Error_code code, const std::string& where, const std::string& remedy) : Error(code, where + "; " + remedy)
  {
    remedy_ = remedy;
  }

  /// \return what is wrong
  Error_code code() const { return code_; }
  /// \return where, and what to do about it
  const std::string& detail() const { return detail_; }
  /// \return what to do about it, with which `detail()` ends behind "; "; empty if it does not
  const std::string& remedy() const { return remedy_; }

private:
  Error_code code_;
  std::string detail_;
  std::string remedy_;
};

/// \cond SKIP_IN_MANUAL
namespace internal {
/// What this package throws itself. The functions that answer with a `Result` catch this only: an `Error` that comes
/// out of a callback or a property map goes through.
class Input_error : public Error {
public:
  using Error::Error;
};
} // namespace internal
/// \endcond

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_VALUES_ERROR_H
