// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_REFUSAL_H
#define SPHERICAL_PARAMETERIZATION_TOOL_REFUSAL_H

#include <stdexcept>
#include <string>

namespace tool {

/// Why a command did not do what it should: one line for the user, and a code for programs that read the report.
class Refusal : public std::runtime_error {
public:
  /// `wrong` says what is wrong with `file` ("-" is the standard input), `remedy` what to do about it. `log` follows in
  /// lines of its own: the build log of OpenCL kernels that do not compile.
  Refusal(const std::string& code, const std::string& file, const std::string& wrong, const std::string& remedy,
          const std::string& log = "")
    : std::runtime_error(
        one_line((file == "-" ? "standard input" : file) + ": " + wrong + (remedy.empty() ? "" : "; " + remedy))),
      code_(code), log_(log)
  {}

  const std::string& code() const { return code_; }
  const std::string& log() const { return log_; }

private:
  static std::string one_line(std::string text)
  {
    for(char& c : text)
      if(c == '\n' || c == '\r')
        c = ' ';
    return text;
  }

  std::string code_;
  std::string log_;
};

/// What is wrong with NaN and infinity.
inline const char* const non_finite_remedy = "every coordinate must be a finite number";

/// The code of everything that keeps a file from being read at all.
inline const char* const unreadable_file = "UNREADABLE_FILE";

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_REFUSAL_H
