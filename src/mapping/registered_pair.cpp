// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "mapping/registered_pair.h"

#include "input/files.h"
#include "input/text_lines.h"
#include "mapping/report.h"
#include "system/interruption.h"
#include "system/loops.h"
#include "system/progress_bar.h"
#include "system/refusal.h"

#include <CGAL/Spherical_parameterization/transfer_properties.h>
#include <CGAL/tags.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <string_view>
#include <type_traits>

namespace tool {
namespace {

using Landmarks = std::vector<SP::Landmark_pair<Mesh, Mesh>>;

Mapping_options options_of(const Registration_options& options, bool is_second)
{
  Mapping_options result = options;
  if(is_second)
    result.input = options.other;
  if(!options.spheres.empty())
    result.sphere = options.spheres[is_second ? 1 : 0];
  return result;
}

/// By vertex of the file: that of the mesh which is mapped, -1 if it was left out.
std::vector<int> mapped_vertices(const Mapped_mesh& input)
{
  if(input.prepared)
    return mended_vertices(*input.prepared);
  std::vector<int> all(input.mesh().number_of_vertices());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

Landmarks read_landmarks(const std::string& file, const Registered_pair& pair)
{
  const std::vector<int> mapped[2] = {mapped_vertices(pair.a), mapped_vertices(pair.b)};
  const std::string remedy = "a line must be 'vertex-of-A vertex-of-B'";
  Landmarks landmarks;
  std::set<int> seen[2];
  Text_lines lines(file, read_file(file));
  while(lines.next()) {
    int index[2];
    for(int side = 0; side < 2; ++side) {
      const std::string_view token = lines.token();
      const std::optional<std::int64_t> number = to_integer(token);
      if(!number)
        lines.refuse(token.empty() ? "fewer than two vertices" : in_quotes(token) + " is not a vertex index", remedy);
      const auto vertices = std::int64_t(mapped[side].size());
      if(*number < 0 || *number >= vertices)
        lines.refuse("vertex " + std::to_string(*number) + " is not in 0.." + std::to_string(vertices - 1) +
                       (side == 0 ? " of A" : " of B"),
                     "vertices are numbered from 0 in the order of the mesh file");
      index[side] = mapped[side][static_cast<std::size_t>(*number)];
      if(index[side] < 0)
        lines.refuse("vertex " + std::to_string(*number) + (side == 0 ? " of A" : " of B") +
                       " was left out when the mesh was mended",
                     "name another one");
      if(!seen[side].insert(index[side]).second)
        lines.refuse("vertex " + std::to_string(*number) + (side == 0 ? " of A" : " of B") + " is listed twice",
                     "list every vertex once");
    }
    if(!lines.token().empty())
      lines.refuse("more than two values", remedy);
    landmarks.emplace_back(Mesh::Vertex_index(index[0]), Mesh::Vertex_index(index[1]));
  }
  if(landmarks.empty())
    throw Refusal(unreadable_file, file, "has no landmark", remedy);
  return landmarks;
}

const char* name_of(SP::Registration_result::Trust trust)
{
  switch(trust) {
  case SP::Registration_result::Trust::SURE: return "sure";
  case SP::Registration_result::Trust::UNSURE: return "unsure";
  case SP::Registration_result::Trust::UNLIKE: return "unlike";
  case SP::Registration_result::Trust::UNKNOWN: break;
  }
  return "unknown";
}

} // namespace

void add_registration_options(CLI::App& command, Registration_options& options)
{
  const std::string format = std::string("closed triangle mesh of genus 0: ") + mesh_extensions;
  command.add_option("A", options.input, "The mesh that is brought to the other one, a " + format)
    ->required()
    ->type_name("FILE");
  command.add_option("B", options.other, "The other mesh, likewise")->required()->type_name("FILE");
  add_mapping_options(command, options);
  add_prepare_option(command, options, Prepare::ALL);
  command.get_option("--prepare")
    ->description("Mend A and B first as the command 'prepare' does: holes, handles, components, ...; output meshes "
                  "have the faces of A as 'prepare' writes it");
  const auto how_to_map = command.get_options([](const CLI::Option* option) {
    return option->get_group() != "Options" && option->get_name() != "--max-time"; // which limits registration, too
  });
  CLI::Option* spheres =
    command
      .add_option("--spheres", options.spheres,
                  "Spheres of A and of B that 'map' has written; they are used instead of new maps, and exclude all "
                  "mapping options but --max-time")
      ->expected(2)
      ->type_name("FILE");
  for(CLI::Option* option : how_to_map)
    spheres->excludes(option);
  command
    .add_option("--landmarks", options.landmarks,
                "Pairs of vertices that correspond: a line 'vertex-of-A vertex-of-B' for each, numbered from 0")
    ->type_name("FILE");
  command
    .add_option("--motion", options.motion,
                "What A's map may be moved by: rotation, moebius (for conformal maps), or deformation")
    ->check(CLI::IsMember({"rotation", "moebius", "deformation"}))
    ->capture_default_str();
  const auto add_weight = [&command](const char* name, double& weight, const char* what) {
    add_checked_option(command, name, weight, what, CLI::Range(0., 1e6));
  };
  SP::Registration& registration = options.registration;
  add_weight("--curvature-weight", registration.curvature_weight, "Deformation: weight of the mean curvature");
  add_weight("--stretch-weight", registration.stretch_weight,
             "Deformation: weight of the area stretch of the maps, which have to be of the same method");
  add_weight("--isometry-weight", registration.isometry_weight,
             "Deformation: weight of how much the surface of A is stretched onto that of B");
  add_weight("--position-weight", registration.position_weight,
             "Deformation: weight of the positions in space, for shapes in the same pose");
  add_weight("--landmark-stiffness", registration.landmark_weight,
             "Deformation: weight of the landmarks to begin with");
}

void check_registration_options(const Registration_options& options)
{
  check_mapping_options(options);
  require(options.fixed.empty(), "--fixed", "is of one mesh: here corresponding vertices are given with --landmarks");
}

std::vector<File_option> registration_inputs(const Registration_options& options)
{
  std::vector<File_option> files = {{"A", options.input}, {"B", options.other}, {"--landmarks", options.landmarks}};
  for(const std::string& sphere : options.spheres)
    files.emplace_back("--spheres", sphere);
  return files;
}

void read_pair(const Registration_options& options, Registered_pair& pair)
{
  read_input(options_of(options, false), pair.a);
  read_input(options_of(options, true), pair.b);
}

void register_pair(const Registration_options& options, Registered_pair& pair)
{
  const Mesh &a = pair.a.mesh(), &b = pair.b.mesh();
  const Landmarks landmarks = options.landmarks.empty() ? Landmarks() : read_landmarks(options.landmarks, pair);
  map_input(options_of(options, false), pair.a);
  map_input(options_of(options, true), pair.b);
  SP::Registration registration = options.registration;
  registration.motion = options.motion == "rotation"  ? SP::Registration::Motion::ROTATION
                        : options.motion == "moebius" ? SP::Registration::Motion::MOEBIUS
                                                      : SP::Registration::Motion::DEFORMATION;
  pair.registered.resize(a.number_of_vertices());
  pair.places_on_b.resize(a.number_of_vertices());
  pair.points_on_b.resize(a.number_of_vertices());
  Progress_bar bar("registering");
  const auto go_on = [&bar](double fraction) {
    bar.show(fraction);
    return !was_interrupted();
  };
  const auto watched =
    CGAL::parameters::maximum_running_time(pair.a.settings->max_time.value_or(std::numeric_limits<double>::infinity()))
      .callback(go_on);
  on_host(pair.a, [&](const auto& policy) {
    pair.result =
      SP::register_maps(policy, SP::mapped_mesh(a, as_map(pair.a.sphere)), SP::mapped_mesh(b, as_map(pair.b.sphere)),
                        as_map(pair.registered), registration, landmarks, watched);
    if(pair.result) {
      const SP::Spherical_locator<Mesh> locator(policy, b, as_map(pair.b.sphere));
      for_each_index(!std::is_same_v<std::decay_t<decltype(policy)>, CGAL::Sequential_tag>, pair.registered.size(),
                     [&](std::size_t v) {
                       const SP::Face_location<Mesh> location = locator.locate(pair.registered[v]);
                       const auto& [last, first, second] = location.second; // halfedge(face) begins at the last corner
                       pair.places_on_b[v] = {location.first.idx(), {first, second, last}};
                       pair.points_on_b[v] = SP::interpolate(b, location, as_map(b.points()));
                     });
    }
    return 0;
  });
  bar.hide();
  stop_if_interrupted(options.input);
  if(!pair.result)
    throw Refusal(pair.result.error, options.input, std::string("cannot be registered: ") + pair.result.detail,
                  pair.result.error == SP::Error_code::INTERRUPTED ? "allow more --max-time" : "");
}

std::vector<Place> places_by_files(const Registered_pair& pair)
{
  const std::vector<Place> places =
    pair.b.prepared ? places_of_file(*pair.b.prepared, pair.places_on_b) : pair.places_on_b;
  std::vector<Place> result;
  for(const int v : mapped_vertices(pair.a))
    result.push_back(v < 0 ? Place() : places[static_cast<std::size_t>(v)]);
  return result;
}

std::string preparation_text(const Registration_options& options, const Registered_pair& pair)
{
  return preparation_text(options.input, pair.a.prepared) + preparation_text(options.other, pair.b.prepared);
}

std::string trust_text(const SP::Registration_result& result)
{
  switch(result.trust()) {
  case SP::Registration_result::Trust::SURE: return "correspondence: sure\n";
  case SP::Registration_result::Trust::UNSURE:
    return "correspondence: not sure, other answers are nearly as good; look at it, or give --landmarks\n";
  case SP::Registration_result::Trust::UNLIKE: return "correspondence: the shapes are unlike; look at it\n";
  case SP::Registration_result::Trust::UNKNOWN: break;
  }
  return "";
}

nlohmann::ordered_json registration_json(const Registration_options& options, const Registered_pair& pair)
{
  const SP::Registration_result& r = pair.result;
  return {{"version", SPHERICAL_PARAMETERIZATION_VERSION},
          {"inputs", {options.input, options.other}},
          {"vertices", {pair.a.mesh().number_of_vertices(), pair.b.mesh().number_of_vertices()}},
          {"methods_used", {pair.a.result.method, pair.b.result.method}},
          {"motion", options.motion},
          {"curvature_weight", options.registration.curvature_weight},
          {"stretch_weight", options.registration.stretch_weight},
          {"isometry_weight", options.registration.isometry_weight},
          {"position_weight", options.registration.position_weight},
          {"start", r.start},
          {"margin", r.margin},
          {"signature_difference", r.signature_difference},
          {"trust", name_of(r.trust())},
          {"rotation", r.rotation},
          {"iterations", r.iterations},
          {"mismatch_before", r.mismatch_before},
          {"mismatch", r.mismatch},
          {"stretching", r.stretching},
          {"distortion", r.distortion},
          {"largest_landmark_distance", r.largest_landmark_distance},
          {"flipped_faces", r.flipped_faces},
          {"degree", r.degree},
          {"seconds",
           {{"map", pair.a.result.seconds.total + pair.b.result.seconds.total},
            {"align", r.seconds.align},
            {"refine", r.seconds.refine},
            {"register", r.seconds.total}}},
          {"peak_memory_bytes", peak_memory_bytes()}};
}

} // namespace tool
