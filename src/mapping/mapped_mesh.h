// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "input/mesh.h"
#include "input/mesh_format.h"
#include "mapping/prepared_mesh.h"
#include "mapping/spherical_map.h"
#include "options/mapping_options.h"
#include "system/interruption.h"
#include "system/stopwatch.h"

#include <CGAL/Spherical_parameterization/values/Result.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace tool {

/// The mesh that a command works on, and its certified spherical map, once `read_input()` and `map_input()` have not
/// refused it.
struct Mapped_mesh {
  const Mesh& mesh() const { return file->mesh; }

  std::optional<Input_mesh> file;        ///< what has been read, and prepared if that is asked for
  std::optional<Prepared_mesh> prepared; ///< with --prepare: what it was before
  Sphere sphere;                         ///< unit vectors
  SP::Result result;                     ///< of mapping; with --sphere nothing but sizes and certificate
  Map_data data;
  bool needs_neighbours = true; ///< after mapping; without them the mesh takes less memory
  double seconds_read = 0;      ///< reading and checking
  double seconds_map = 0;       ///< all of `map_input()`
};

/// Reads the mesh, and from here on watches for interruption. Throws a `Refusal`, and what `make_policy()` throws.
void read_input(const Mapping_options& options, Mapped_mesh& input);

/// Appends the columns of --data, for so many vertices. Throws a `Refusal`.
void read_data(const Mapping_options& options, std::size_t number_of_vertices, Vertex_data& data);

/// What a command needs.
enum class Map_quality {
  CERTIFIED, ///< no flipped face, degree 1
  CONVERGED  ///< or flipped faces where limbs are too thin for doubles; of a sphere that is given, degree 1
};

/// Maps the mesh with a progress bar, or reads the sphere that the user has. Throws a `Refusal` if there is no such
/// map; then, too, `input.result` says what happened.
void map_input(const Mapping_options& options, Mapped_mesh& input, Map_quality quality = Map_quality::CERTIFIED);

/// Certifies a sphere of the mesh as a file of `format` will have it, which may hold floats: the certificate of the
/// result is that of the file then. Throws a `Refusal` that names `output` if rounding flips faces.
void certify_as_stored(const std::string& output, Mesh_format format, Mapped_mesh& input, const Sphere& sphere);

/// If polygons were triangulated: a line, with its end, which says of the faces of what that they are others.
std::string triangulation_text(const std::string& file, const Mapped_mesh& input, const std::string& of_what);

/// Lines on what was done to the mesh, each with its end; if nothing was, whether it is turned inside out, which counts
/// where shapes are compared or cut.
std::string preparation_text(const std::string& file, const Mapped_mesh& input);

/// Throws a `Refusal` of a mesh that is turned inside out: compared with others it would be their mirror image.
void check_orientation(const std::string& file, const Mapped_mesh& input);

/// By vertex of the file: that of the mesh which is mapped, -1 if it was left out.
std::vector<int> mapped_vertices(const Mapped_mesh& input);

/// The sphere becomes that of a file of `format`, which holds floats. The figures of the result that are not computed
/// anew are no numbers then.
void take_as_stored(Mesh_format format, Mapped_mesh& input);

/// Named parameters of a function that works with the map: signals end it, and so does --max-time, less the time that
/// the map took.
inline auto stopped_as_map(const Mapping_options& options, const Mapped_mesh& input)
{
  const double limit = options.max_time.value_or(std::numeric_limits<double>::infinity());
  return stopped_by_signals().maximum_running_time(std::max(0., limit - input.seconds_map));
}

/// Throws a `Refusal` if such a function has been stopped, or has had no answer.
void check_answer(const Mapping_options& options, Error_code error, const std::string& detail);

/// Calls `function` with the mesh as it is in its file, which is not that of the map if it was mended.
template <class Function>
void on_mesh_of_file(const Mapped_mesh& input, Function function)
{
  if(input.prepared)
    function(input.prepared->of_file());
  else
    function(input.mesh());
}

/// Calls `function` with the policy for functions that run on the host: all cores, but for `--policy sequential`.
template <class Function>
auto on_host(const Mapped_mesh& input, Function function)
{
  return std::visit(function, input.data.policy);
}

} // namespace tool
