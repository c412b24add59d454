// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <CGAL/Spherical_parameterization/values/Error.h>

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

namespace tool {

namespace SP = CGAL::Spherical_parameterization;
using SP::Error_code;

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
  Refusal(Error_code code, const std::string& file, const std::string& wrong, const std::string& remedy)
    : Refusal(get_error_name(code), file, wrong, remedy)
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

/// What a command has to say of a mesh.
struct Outcome {
  std::optional<Refusal> refusal;
  std::string text; ///< of a mesh alone, before the refusal if there is one: lines, without the end of the last one
  std::string line; ///< of one among many, if it is not refused: does not name the mesh, and is the same in every run
};

/// What the library says is wrong, without its own advice, for which there is a better one here.
inline std::string without_remedy(const std::string& detail, const std::string& remedy)
{
  return remedy.empty() ? detail : detail.substr(0, detail.size() - remedy.size() - 2); // "; " between them
}

/// What is wrong with NaN and infinity.
inline const char* const non_finite_remedy = "every coordinate must be a finite number; the command 'prepare' removes "
                                             "such vertices of a surface with their faces, and fills the holes";

/// \name Codes of the tool alone, beside those of the library
/// @{
inline const char* const unreadable_file = "UNREADABLE_FILE"; ///< keeps a file from being read at all
inline const char* const unwritable_file = "UNWRITABLE_FILE"; ///< the disk, not the mesh: many meshes end there
inline const char* const unwritable_data = "UNWRITABLE_DATA"; ///< what the format cannot hold
inline const char* const not_the_sphere = "NOT_THE_SPHERE";
inline const char* const opencl_error = "OPENCL_ERROR";
inline const char* const out_of_memory = "OUT_OF_MEMORY";
inline const char* const internal_error = "INTERNAL_ERROR";
inline const char* const bad_degree = "BAD_DEGREE";
/// @}

/// What to do about a file whose contents make no sense.
inline const char* const damaged = "the file is damaged; export it again";
inline const char* const damaged_or_cut_short = "the file is damaged or cut short; export it again";

/// Throws the `Refusal` of a file that cannot be read.
[[noreturn]] inline void refuse_file(const std::string& file, const std::string& wrong,
                                     const std::string& remedy = damaged)
{
  throw Refusal(unreadable_file, file, wrong, remedy);
}

/// Calls `action`, which works on the file `input`, or on several meshes if that is empty. Whatever it throws is
/// returned as a `Refusal`.
std::optional<Refusal> guarded(const std::string& input, const std::function<void()>& action);

/// Prints the refusal, if there is one, on stderr. Returns the exit code of the program: 0 or 1.
int exit_code_of(const std::optional<Refusal>& refusal);

} // namespace tool
