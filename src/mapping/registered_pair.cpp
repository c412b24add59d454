// SPDX-License-Identifier: GPL-3.0-or-later

#include "mapping/registered_pair.h"

#include "input/compression.h"
#include "input/files.h"
#include "input/text_lines.h"
#include "system/interruption.h"
#include "system/refusal.h"
#include "system/terminal.h"

#include <CGAL/Spherical_parameterization/distortion_summary.h>
#include <CGAL/Spherical_parameterization/for_each_index.h>
#include <CGAL/Spherical_parameterization/transfer_properties.h>
#include <CGAL/tags.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <type_traits>

namespace tool {
namespace {

using Landmarks = std::vector<SP::Landmark_pair<Mesh, Mesh>>;

Mapping_options options_of(const Registration_options& options, bool is_second)
{
  Mapping_options result = options;
  if(is_second) {
    result.input = options.other;
    result.data.clear(); // which are those of A
  }
  if(!options.spheres.empty())
    result.sphere = options.spheres[is_second ? 1 : 0];
  return result;
}

Landmarks read_landmarks(const std::string& file, const Registered_pair& pair)
{
  const std::vector<int> mapped[2] = {mapped_vertices(pair.a), mapped_vertices(pair.b)};
  const std::string remedy = "a line must be 'vertex-of-A vertex-of-B'";
  Landmarks landmarks;
  std::set<int> seen[2];
  Text_lines lines(file, decompressed(file, read_file(file)));
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
                       " was removed when the mesh was repaired",
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
    refuse_file(file, "has no landmark", remedy);
  return landmarks;
}

/// Gives the vertices that were added when the mesh was repaired the means of their neighbours, from the border of what
/// was filled inwards.
void extend(const Mesh& mesh, const std::vector<int>& old_vertex, std::vector<double>& values)
{
  for(bool is_complete = false; !is_complete;) {
    std::vector<double> sum(values.size()), number(values.size());
    for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      for(std::size_t k = 0; k < 3; ++k) { // every neighbour once, since the mesh is closed
        const auto from = std::size_t(mesh.triangle(f)[k]), to = std::size_t(mesh.triangle(f)[(k + 1) % 3]);
        if(std::isfinite(values[from])) {
          sum[to] += values[from];
          ++number[to];
        }
      }
    is_complete = true;
    for(std::size_t v = 0; v < values.size(); ++v)
      if(old_vertex[v] < 0 && std::isnan(values[v]) && number[v] > 0) {
        values[v] = sum[v] / number[v];
        is_complete = false;
      }
  }
}

/// The columns of a file of --features at the vertices of the mesh that is mapped.
Vertex_data read_features(const std::string& file, const Mapped_mesh& input)
{
  Vertex_data data =
    read_vertex_data(file, input.prepared ? input.prepared->soup.points.size() : input.mesh().number_of_vertices());
  if(input.prepared) {
    const std::vector<int>& old_vertex = input.prepared->preparation.parts.front().old_vertex;
    data = carried(data, old_vertex);
    for(Vertex_column& column : data)
      extend(input.mesh(), old_vertex, column.values);
  }
  for(const Vertex_column& column : data) {
    if(column.is_label)
      refuse_file(file, "column '" + column.name + "' has labels", "features are numbers");
    if(!std::all_of(column.values.begin(), column.values.end(), [](double x) { return std::isfinite(x); }))
      refuse_file(file, "column '" + column.name + "' has no value at some vertices of the mesh",
                  "give a value to every vertex");
  }
  return data;
}

/// Column k of both files is one feature.
std::vector<SP::Registration_feature> read_features(const Registration_options& options, const Registered_pair& pair)
{
  std::vector<SP::Registration_feature> result;
  if(options.features.empty())
    return result;
  const Vertex_data a = read_features(options.features[0], pair.a), b = read_features(options.features[1], pair.b);
  const std::vector<double> weights = feature_weights(options);
  if(a.size() != b.size() || (weights.size() != 1 && weights.size() != a.size()))
    refuse_file(options.features[1],
                "has " + std::to_string(b.size()) + " columns, " + options.features[0] + " has " +
                  std::to_string(a.size()) + ", and there are " + std::to_string(weights.size()) + " weights",
                "as many columns are needed, and one weight or as many");
  for(std::size_t k = 0; k < a.size(); ++k)
    result.push_back({a[k].values, b[k].values, weights[weights.size() == 1 ? 0 : k]});
  return result;
}

/// What people see of changes of lengths.
std::string verdict(const SP::Length_changes& changes, bool has_landmarks)
{
  return changes.share_of_large < 0.02 ? "no part of A is lost"
         : changes.share_of_large < 0.1
           ? "small parts of A are squeezed or stretched on B, as if B had no such part"
           : std::string("large parts of A are squeezed or stretched on B; ") + (has_landmarks ? "more " : "") +
               "--landmarks can say which points correspond";
}

/// How far to trust the correspondence; empty if nothing is known.
std::string trust_text(const SP::Registration_result& result, bool has_landmarks)
{
  switch(result.trust()) {
  case SP::Registration_result::Trust::SURE:
    return std::string("\ncorrespondence: sure") + (has_landmarks ? ", but for what the landmarks changed" : "");
  case SP::Registration_result::Trust::UNSURE:
    return std::string("\ncorrespondence: not sure, other candidates are nearly as good; check it, or give ") +
           (has_landmarks ? "more " : "") + "--landmarks";
  case SP::Registration_result::Trust::UNLIKE: return "\ncorrespondence: the shapes are unlike; check it";
  case SP::Registration_result::Trust::UNKNOWN: break;
  }
  return "";
}

} // namespace

Registration_options to_register(const Mapping_options& options, const std::string& other)
{
  Registration_options result;
  result.input = options.input;
  result.other = other;
  result.triangulate = options.triangulate;
  result.prepare = options.prepare;
  result.can_prepare_all = options.can_prepare_all;
  result.policy = options.policy;
  result.device = options.device;
  result.precision = options.precision;
  result.max_time = options.max_time;
  result.method = "isometric";
  return result;
}

void add_registration_options(Options& all, Registration_options& options)
{
  all("--landmarks", options.landmarks,
      "Text file of corresponding vertices: a line 'vertex-of-A vertex-of-B' for each pair, numbered from 0. They are "
      "moved onto each other where this flips no face. With --motion rotation or moebius, three or more pairs also "
      "determine the rotation of the sphere");
  all("--motion", options.motion,
      "How the map of A may be moved: rotation, moebius (for conformal maps), or deformation")
    .of({"rotation", "moebius", "deformation"});
  const auto add_weight = [&all](const char* name, double& weight, const char* what) -> Option& {
    return all(name, weight, std::string("Deformation: weight of ") + what).in("[0,1000000]");
  };
  SP::Registration& registration = options.registration;
  add_weight("--curvature-weight", registration.curvature_weight, "the mean curvature");
  all("--features", options.features,
      "Two files, as for --data, with values at the vertices of A and of B that should be equal at corresponding "
      "points, such as sulcal depth. Columns are compared in order; their units do not matter. Vertices that "
      "--prepare adds get the means of their neighbours")
    .times(2);
  all("--feature-weight", options.feature_weights,
      "Deformation: weight of the features, or of each column as W,W,...; with --curvature-weight 0 the features "
      "replace the curvature")
    .is("W")
    .only_with("--features");
  add_weight("--stretch-weight", registration.stretch_weight,
             "the area stretch of the maps, which must come from the same method");
  add_weight("--isometry-weight", registration.isometry_weight, "the stretching of the surface of A onto that of B");
  add_weight("--position-weight", registration.position_weight,
             "the positions in space, for shapes in the same position and pose");
  add_weight("--landmark-weight", registration.landmark_weight,
             "the landmarks at the beginning, where they cannot all be put in place at once");
  add_weight("--landmark-stiffness", registration.landmark_weight, "").group.clear(); // its name before
}

std::vector<double> feature_weights(const Registration_options& options)
{
  std::vector<double> weights;
  std::istringstream words(options.feature_weights);
  for(std::string word; std::getline(words, word, ',');) {
    double weight = 0;
    require(to_number(word, weight) == Number::FINITE && weight >= 0 && weight <= 1e6, "--feature-weight",
            in_quotes(word) + " is no number from 0 to 1000000");
    weights.push_back(weight);
  }
  require(!weights.empty(), "--feature-weight", "is empty");
  return weights;
}

void read_pair(const Registration_options& options, Registered_pair& pair)
{
  for(Mapped_mesh* const mesh : {&pair.a, &pair.b})
    if(!mesh->file)
      read_input(options_of(options, mesh == &pair.b), *mesh);
}

void register_pair(const Registration_options& options, Registered_pair& pair)
{
  const Mesh &a = pair.a.mesh(), &b = pair.b.mesh();
  const Landmarks landmarks = options.landmarks.empty() ? Landmarks() : read_landmarks(options.landmarks, pair);
  const Stopwatch since;
  const auto time_left = [&options, &since] { // of the limit, which is one for both maps and the registration
    return options.max_time ? std::optional(std::max(0., *options.max_time - since.seconds())) : std::nullopt;
  };
  for(Mapped_mesh* const mesh : {&pair.a, &pair.b})
    if(mesh->sphere.empty()) {
      Mapping_options one = options_of(options, mesh == &pair.b);
      one.max_time = time_left();
      map_input(one, *mesh);
    }
  SP::Registration registration = options.registration;
  registration.features = read_features(options, pair);
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
    CGAL::parameters::maximum_running_time(time_left().value_or(std::numeric_limits<double>::infinity()))
      .callback(go_on);
  on_host(pair.a, [&](const auto& policy) {
    pair.result =
      SP::register_maps(policy, SP::mapped_mesh(a, as_map(pair.a.sphere)), SP::mapped_mesh(b, as_map(pair.b.sphere)),
                        as_map(pair.registered), registration, landmarks, watched);
    if(pair.result) {
      const SP::Spherical_locator<Mesh> locator(policy, b, as_map(pair.b.sphere));
      SP::for_each_index(policy, static_cast<int>(pair.registered.size()), [&](int v) {
        const SP::Face_location<Mesh> location = locator.locate(pair.registered[v]);
        const auto& [last, first, second] = location.second; // halfedge(face) begins at the last corner
        pair.places_on_b[v] = {location.first.idx(), {first, second, last}};
        pair.points_on_b[v] = SP::interpolate(b, location, as_map(b.points()));
      });
    }
  });
  bar.hide();
  stop_if_interrupted(options.input);
  if(!pair.result)
    throw Refusal(pair.result.error, options.input, std::string("cannot be registered: ") + pair.result.detail,
                  pair.result.error == SP::Error_code::INTERRUPTED ? "allow more --max-time" : "");
  pair.changes_of_faces.resize(a.number_of_faces());
  pair.changes = on_host(pair.a, [&](const auto& policy) {
    return SP::face_length_changes(policy, a, as_map(pair.points_on_b),
                                   as_map<Mesh::Face_index>(pair.changes_of_faces));
  });
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
  return preparation_text(options.input, pair.a) + preparation_text(options.other, pair.b);
}

std::string registration_text(const Registration_options& options, const Registered_pair& pair)
{
  const SP::Registration_result& r = pair.result;
  std::ostringstream text;
  text.precision(3);
  text << "registered map: " << r.flipped_faces << " flipped faces, degree " << r.degree << "; start by " << r.start;
  if(options.motion == "deformation")
    text << ", then deformed: mismatch of features from " << r.mismatch_before << " to " << r.mismatch
         << ", mean distortion " << r.distortion << " (4: none)";
  const SP::Length_changes& changes = pair.changes;
  const bool has_landmarks = !options.landmarks.empty();
  text << "\nlengths of A change " << changes.factor.median << " times (median), and more than " << changes.large
       << " times on " << 100 * changes.share_of_large << " % of it: " << verdict(changes, has_landmarks)
       << trust_text(r, has_landmarks);
  if(has_landmarks)
    text << "\nlandmarks: at most " << r.largest_landmark_distance << " radians apart";
  return text.str();
}

Json registration_json(const Registration_options& options, const Registered_pair& pair)
{
  const SP::Registration_result& r = pair.result;
  const auto done = [](const Mapped_mesh& mesh) {
    return mesh.prepared ? Json(sentences(mesh.prepared->preparation)) : nullptr;
  };
  const bool is_deformed = options.motion == "deformation";
  return {{"inputs", {options.input, options.other}},
          {"preparation", Json::array({done(pair.a), done(pair.b)})},
          {"vertices", {pair.a.mesh().number_of_vertices(), pair.b.mesh().number_of_vertices()}},
          {"methods_used", {pair.a.result.method, pair.b.result.method}},
          {"motion", options.motion},
          {"curvature_weight", options.registration.curvature_weight},
          {"stretch_weight", options.registration.stretch_weight},
          {"isometry_weight", options.registration.isometry_weight},
          {"position_weight", options.registration.position_weight},
          {"features", options.features},
          {"feature_weight", feature_weights(options)},
          {"start", r.start},
          {"margin", r.margin},
          {"signature_difference", r.signature_difference},
          {"trust", SP::get_trust_name(r.trust())},
          {"rotation", r.rotation},
          {"iterations", r.iterations},
          {"mismatch_before", known(is_deformed, r.mismatch_before)},
          {"mismatch", known(is_deformed, r.mismatch)},
          {"stretching", known(is_deformed, r.stretching)},
          {"distortion", known(is_deformed, r.distortion)},
          {"change_of_lengths", pair.changes.factor.median},
          {"share_of_large_changes", pair.changes.share_of_large},
          {"largest_landmark_distance", r.largest_landmark_distance},
          {"flipped_faces", r.flipped_faces},
          {"degree", r.degree},
          {"seconds",
           {{"map", pair.a.result.seconds.total + pair.b.result.seconds.total},
            {"align", r.seconds.align},
            {"refine", r.seconds.refine},
            {"register", r.seconds.total}}}};
}

} // namespace tool
