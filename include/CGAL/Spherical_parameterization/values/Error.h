// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_VALUES_ERROR_H
#define CGAL_SPHERICAL_PARAMETERIZATION_VALUES_ERROR_H

#include <stdexcept>
#include <string>

// The one list of codes: the name, what get_error_message() says, and what the manual adds. Numbers follow the order.
// clang-format off
#define CGAL_SP_ERROR_CODES(CODE) \
  CODE(OK, "valid spherical map") /**< certified: no flipped face, degree 1; and the method has done what was asked for */ \
  CODE(EMPTY_MESH, "the mesh has no faces") /**< no face */ \
  CODE(TOO_LARGE, "the mesh is too large") /**< 2^31 halfedges or more */ \
  CODE(NOT_TRIANGULAR, "the mesh has a face that is not a triangle") /**< a face that is not a triangle */ \
  CODE(ISOLATED_VERTEX, "the mesh has a vertex without faces") /**< a vertex without faces */ \
  CODE(BOUNDARY, "the mesh is not closed") /**< border edges: the surface is not closed */ \
  CODE(NON_MANIFOLD, "the mesh is not a 2-manifold") /**< a vertex or edge whose faces do not form a single disk */ \
  CODE(INCONSISTENT_ORIENTATION, "the faces are not consistently oriented") \
    /**< neighbouring faces of opposite orientations (only in soups and files) */ \
  CODE(SEVERAL_COMPONENTS, "the mesh has several connected components") /**< more than one connected component */ \
  CODE(WRONG_GENUS, "the mesh is not of genus 0") /**< handles: not a topological sphere */ \
  CODE(NON_FINITE_COORDINATE, "a point has a coordinate that is not finite") /**< NaN or infinity in a point */ \
  CODE(DEGENERATE_FACE, "a degenerate face where an area is needed") \
    /**< a face (almost) without area, or an edge without length, where one is needed */ \
  CODE(BAD_WEIGHT, "an edge weight is not positive and finite") /**< an edge weight that is not positive and finite */ \
  CODE(BAD_CONSTRAINTS, "the fixed vertices do not determine a map") \
    /**< fixed vertices: one or two, at equal positions, a zero vector; or the mesh is too coarse */ \
  CODE(NOT_CONVERGED, "the solver did not reach the accuracy") /**< the residual did not reach the accuracy */ \
  CODE(INTERRUPTED, "the computation was interrupted") \
    /**< stopped by the callback or the time limit; the best map so far is stored, if there is one */ \
  CODE(NOT_BIJECTIVE, "the map found is not bijective") \
    /**< converged, but faces are flipped or the degree is not 1 */ \
  CODE(BAD_INDEX, "a triangle names a point that does not exist") \
    /**< a triangle that names a point that is not there (only in soups) */ \
  CODE(BAD_DENSITY, "a density is not positive and finite") /**< a density that is not positive and finite */
#define CGAL_SP_ENUMERATOR(name, sentence) name,
#define CGAL_SP_CASE_OF_NAME(name, sentence) case Error_code::name: return #name;
#define CGAL_SP_CASE_OF_SENTENCE(name, sentence) case Error_code::name: return sentence;
// clang-format on

namespace CGAL::Spherical_parameterization {
/// \addtogroup PkgSphericalParameterizationMap
/// @{

/// What is wrong with the input, or with the map that was found. Only `OK` stands for a certified spherical map.
enum class Error_code { CGAL_SP_ERROR_CODES(CGAL_SP_ENUMERATOR) };

/// \param code  what is wrong, or `OK`
/// \return the name of the code, such as "BOUNDARY", for programs; never freed
inline const char* get_error_name(Error_code code)
{
  switch(code) {
    CGAL_SP_ERROR_CODES(CGAL_SP_CASE_OF_NAME)
  }
  return "UNKNOWN";
}

/// The message of an error code, in words; `Result::detail` has the details and the place.
/// \param code  what is wrong, or `OK`
/// \return a string that is never freed, without full stop
inline const char* get_error_message(Error_code code)
{
  switch(code) {
    CGAL_SP_ERROR_CODES(CGAL_SP_CASE_OF_SENTENCE)
  }
  return "unknown error";
}

/// The exception for wrong data in functions that do not return a `Result`. Wrong arguments, such as a negative
/// accuracy, throw a `CGAL::Precondition_exception` instead.
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
  /// \return what to do about it: the end of `detail()` after "; "; empty if there is none
  const std::string& remedy() const { return remedy_; }

private:
  Error_code code_;
  std::string detail_;
  std::string remedy_;
};

/// \cond SKIP_IN_MANUAL
namespace internal {
/// What this package throws itself. The functions that answer with a `Result` catch this only: an `Error` of the
/// caller's own, and all that comes out of a callback, goes through. What functions of this package throw in a property
/// map does not go through.
class Input_error : public Error {
public:
  using Error::Error;
};
} // namespace internal
/// \endcond

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_VALUES_ERROR_H
