// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_REFUSAL_H
#define SPHERICAL_PARAMETERIZATION_TOOL_REFUSAL_H

#include <stdexcept>
#include <string>

namespace tool {

/// Why no certified map can be handed over: one line for the user, and a code for programs that read the report.
class Refusal : public std::runtime_error {
public:
  /// `wrong` says what is wrong with `file`, `remedy` what to do about it.
  Refusal(const std::string& code, const std::string& file, const std::string& wrong, const std::string& remedy)
    : std::runtime_error(file + ": " + wrong + (remedy.empty() ? "" : "; " + remedy)), code_(code)
  {}

  const std::string& code() const { return code_; }

private:
  std::string code_;
};

/// The code of everything that keeps a file from being read at all.
inline const char* const unreadable_file = "UNREADABLE_FILE";

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_REFUSAL_H
