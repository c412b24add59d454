// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_ERROR_CODE_NAMES_H
#define SPHERICAL_PARAMETERIZATION_TOOL_ERROR_CODE_NAMES_H

#include <CGAL/Spherical_parameterization/values/Result.h>

namespace tool {

using CGAL::Spherical_parameterization::Error_code;

/// The name of an error code, for programs that read the report.
// clang-format off
inline const char* name(Error_code code)
{
  switch(code) {
  case Error_code::OK:                       return "OK";
  case Error_code::EMPTY_MESH:               return "EMPTY_MESH";
  case Error_code::TOO_LARGE:                return "TOO_LARGE";
  case Error_code::NOT_TRIANGULAR:           return "NOT_TRIANGULAR";
  case Error_code::ISOLATED_VERTEX:          return "ISOLATED_VERTEX";
  case Error_code::BOUNDARY:                 return "BOUNDARY";
  case Error_code::NON_MANIFOLD:             return "NON_MANIFOLD";
  case Error_code::INCONSISTENT_ORIENTATION: return "INCONSISTENT_ORIENTATION";
  case Error_code::SEVERAL_COMPONENTS:       return "SEVERAL_COMPONENTS";
  case Error_code::WRONG_GENUS:              return "WRONG_GENUS";
  case Error_code::NON_FINITE_COORDINATE:    return "NON_FINITE_COORDINATE";
  case Error_code::DEGENERATE_FACE:          return "DEGENERATE_FACE";
  case Error_code::BAD_WEIGHT:               return "BAD_WEIGHT";
  case Error_code::BAD_INDEX:                return "BAD_INDEX";
  case Error_code::BAD_DENSITY:              return "BAD_DENSITY";
  case Error_code::BAD_CONSTRAINTS:          return "BAD_CONSTRAINTS";
  case Error_code::NOT_CONVERGED:            return "NOT_CONVERGED";
  case Error_code::INTERRUPTED:              return "INTERRUPTED";
  case Error_code::NOT_BIJECTIVE:            return "NOT_BIJECTIVE";
  }
  return "UNKNOWN";
}
// clang-format on

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_ERROR_CODE_NAMES_H
