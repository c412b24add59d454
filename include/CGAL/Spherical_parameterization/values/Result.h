// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_VALUES_RESULT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_VALUES_RESULT_H

#include <CGAL/Spherical_parameterization/values/Error.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationMap
/// @{

/// Why a method ended.
enum class Termination {
  CONVERGED,  ///< the residual of the map that is stored is within the accuracy, or what rounding to floats leaves
  ITERATIONS, ///< all iterations were made
  TIME,       ///< the time limit was reached
  CALLBACK,   ///< the callback returned `false`
  STALLED     ///< no more improvement; or vertices were moved off the solution to repair faces
};

/// \param termination  why a method ended
/// \return "converged", "iterations", "time", "callback" or "stalled"; never freed
inline const char* get_termination_name(Termination termination)
{
  constexpr const char* names[] = {"converged", "iterations", "time", "callback", "stalled"};
  return names[static_cast<int>(termination)];
}

/// The verdict of `parameterize()`, the certificate, and the work that was done. Times are wall-clock seconds.
struct Result {
  Error_code error = Error_code::OK; ///< `OK` if and only if the map is certified
  std::string detail;                ///< what is wrong, where, and what to do; empty if `OK`
  std::string remedy; ///< what may help a map that is not valid, such as another method: how `detail` ends; else empty

  std::size_t number_of_vertices = 0; ///< of the mesh
  std::size_t number_of_faces = 0;    ///< of the mesh

  /// \name Certificate and Figures
  /// Of the coordinates as the sphere map stores them: floats are rounded first. Flips and degree are exact.
  /// @{
  std::size_t flipped_faces = 0;  ///< faces (a,b,c) with orientation(O,a,b,c) <= 0
  std::size_t moved_vertices = 0; ///< `Conformal_weights`: vertices that were moved off the solution to repair their
                                  ///< faces
  int degree = 0;                 ///< how often the map covers the sphere; 1 for a valid map
  double residual = 0;            ///< L2 norm over the free vertices (not divided by their number) of the residual of
                                  ///< the equation that the method solves, relative to the weight sum of a vertex;
                                  ///< `Isometric`: relative gain of energy that one more step predicts; NaN for a
                                  ///< map that was interrupted, as is its energy then
  double energy = 0;              ///< spring energy of the map, 1/p * sum over edges; `Isometric`: mean distortion;
                                  ///< infinite if it exceeds the range of doubles
  double density_deviation = 0;   ///< with densities: root mean square of log(area on the sphere / target area) over
                                  ///< the faces, weighted by target area; else 0
  double smallest_area = 0;       ///< of all spherical triangles, without sign; below 1e-26 rounding flips faces
  double smallest_edge = 0;       ///< length of the shortest chord, in units of 2^-52, the rounding error
  /// @}

  /// \name Method
  /// @{
  std::string method;          ///< method of the map: "balanced", "balanced with exponent 3", "isometric", ...
  std::string fallback_reason; ///< `Automatic`: why the map of an earlier method was rejected, or that the best map is
                               ///< not usable; else empty
  /// @}

  /// \name Work
  /// @{
  std::optional<Termination> termination; ///< why the method ended; empty if there is no map, unless it was interrupted
  std::size_t start_iterations = 0;       ///< iterations for the start map, on all coarse levels together
  std::size_t iterations = 0;             ///< iterations of the method: descent steps, or saddle-point problems solved
  std::size_t sweeps = 0;                 ///< Jacobi or Gauss-Seidel sweeps (saddle-point method; else 0)
  /// Wall-clock time of each phase, in seconds. The phases add up to the total, within a few percent.
  struct Seconds {
    double read = 0;      ///< reading the mesh into arrays, with all checks of the input
    double weights = 0;   ///< edge weights; for conformal weights with the Delaunay triangulation
    double start_map = 0; ///< set-up of the multigrid hierarchy, and the start map; of all attempts
    double solve = 0;     ///< from the start map to the result, with mending; of all attempts
    double certify = 0;   ///< certificates of all attempts, and writing the property map
    double total = 0;     ///< the whole call
  };
  /// A method that was tried, and its outcome.
  struct Attempt {
    std::string method;                     ///< its name
    Error_code error = Error_code::OK;      ///< its verdict
    std::string detail;                     ///< what is wrong, and where; if `OK`: why the map is not usable
    Seconds seconds;                        ///< how long it took; `read` and `weights` are 0
    std::optional<Termination> termination; ///< why it ended; as in `Result`
  };
  Seconds seconds;               ///< of all attempts together
  std::vector<Attempt> attempts; ///< all methods that were tried, in order: `Automatic` tries up to two
  std::string device;            ///< the device, or the cores, that the method ran on
  /// @}

  /// \return `true` iff the map is certified
  explicit operator bool() const { return error == Error_code::OK; }
};

/// Why the residual of a valid map is above the accuracy.
/// \param r  a result
/// \return one clause, in words; empty if the method has converged, or if there is no map
inline std::string get_shortcoming(const Result& r)
{
  if(!r.termination || *r.termination == Termination::CONVERGED)
    return "";
  if(r.moved_vertices > 0)
    return std::to_string(r.moved_vertices) + (r.moved_vertices == 1 ? " vertex was" : " vertices were") +
           " moved off the solution so that their faces are valid";
  switch(*r.termination) {
  case Termination::ITERATIONS: return "the accuracy was not reached when all iterations were made";
  case Termination::TIME: return "the accuracy was not reached within the time limit";
  case Termination::CALLBACK: return "it was stopped before the accuracy was reached";
  default: return "the accuracy was not reached: nothing improved any more";
  }
}

/// Writes one line: the verdict, and the main figures.
/// \param out  a stream
/// \param r    what to write
/// \return `out`
inline std::ostream& operator<<(std::ostream& out, const Result& r)
{
  out << get_error_message(r.error);
  if(!r.detail.empty())
    out << ": " << r.detail;
  if(r && !get_shortcoming(r).empty())
    out << ", but " << get_shortcoming(r);
  if(r.degree != 0 || r.termination) {
    out << " (" << r.number_of_vertices << " vertices, ";
    out << r.flipped_faces << " flipped faces, degree " << r.degree << ", ";
    if(!std::isnan(r.residual))
      out << "residual " << r.residual << ", ";
    out << r.start_iterations << " + " << r.iterations << " iterations, " << r.seconds.total << " s)";
  }
  return out;
}

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_VALUES_RESULT_H
