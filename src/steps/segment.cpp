// SPDX-License-Identifier: GPL-3.0-or-later

#include "runner/step.h"

#include "mapping/registered_pair.h"

#include <CGAL/Spherical_parameterization/segmentation.h>
#include <CGAL/Spherical_parameterization/transfer_properties.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <mutex>

namespace tool {
namespace {

using Labels = std::vector<std::size_t>; // of faces

struct Segment_options {
  std::optional<std::int64_t> number;
  std::string like;        ///< the shape that has the labels
  std::string like_labels; ///< their file; empty: they are its segments
};

/// That shape, for all meshes: the first one makes it.
struct Labelled_shape {
  std::once_flag is_made;
  std::optional<Refusal> refusal; ///< it is tried once
  Mapped_mesh mesh;               ///< with a map for registration
  Labels labels;
};

/// How harmonic maps shrink limbs is what tells them. Where these have no answer, any other map will do.
Labels segments_of(const Segment_options& own, const Mapping_options& options, Mapped_mesh& input)
{
  map_input(options, input, Map_quality::CONVERGED);
  Labels segments(input.mesh().number_of_faces());
  SP::Majority_vote method;
  method.number_of_segments = static_cast<std::size_t>(own.number.value_or(0));
  const SP::Segmentation_result result = on_host(input, [&](const auto& policy) {
    return SP::segmentation_via_area_stretch(policy, input.mesh(), as_map(input.sphere),
                                             as_map<Mesh::Face_index>(segments), method,
                                             stopped_as_map(options, input));
  });
  check_answer(options, result.error, result.detail);
  return segments;
}

void make(const Segment_options& own, Mapping_options options, Labelled_shape& shape)
{
  options.input = own.like;
  options.sphere.clear(); // as all that is for the vertices of IN
  options.fixed.clear();
  options.density.clear();
  options.data.clear();
  read_input(options, shape.mesh);
  const auto& prepared = shape.mesh.prepared;
  if(own.like_labels.empty())
    shape.labels = segments_of(own, options, shape.mesh);
  else {
    shape.labels =
      read_labels(own.like_labels, prepared ? prepared->soup.triangles.size() : shape.mesh.mesh().number_of_faces());
    if(prepared)
      shape.labels = labels_of_mended(*prepared, shape.labels);
  }
  shape.mesh.sphere.clear();
  map_input(to_register(options, ""), shape.mesh);
}

/// Gives the segments the labels of the shape that correspond, and says how sure that is.
SP::Registration_result label_like(const Segment_options& own, const Labelled_shape& shape, const Run& run,
                                   Labels& segments)
{
  Registered_pair pair;
  pair.a = run.input;
  pair.a.sphere.clear();
  pair.b = shape.mesh;
  register_pair(to_register(run.options, own.like), pair);
  on_host(pair.a, [&](const auto& policy) {
    const SP::Spherical_locator<Mesh> locator(policy, pair.b.mesh(), as_map(pair.b.sphere));
    Labels labels = shape.labels;
    SP::transfer_segment_labels(policy, locator, as_map<Mesh::Face_index>(labels), pair.a.mesh(),
                                as_map(pair.registered), as_map<Mesh::Face_index>(segments),
                                as_map<Mesh::Face_index>(segments));
  });
  return pair.result;
}

/// Numbers them from 0 on without gaps.
void renumber(Labels& labels)
{
  const std::set<std::size_t> used(labels.begin(), labels.end());
  const Labels sorted(used.begin(), used.end());
  for(std::size_t& label : labels)
    label = static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), label) - sorted.begin());
}

void segment(const Segment_options& own, Labelled_shape& shape, Run& run)
{
  Mapped_mesh& input = run.input;
  run.options.falls_back = !run.has("--method");
  run.read();
  const Stopwatch whole;
  Labels segments = segments_of(own, run.options, input);
  run.figures.seconds_measure = whole.seconds() - input.seconds_map;
  std::optional<SP::Registration_result> likeness;
  if(!own.like.empty()) {
    std::call_once(shape.is_made, [&] { shape.refusal = guarded(own.like, [&] { make(own, run.options, shape); }); });
    if(shape.refusal)
      throw Refusal(*shape.refusal);
    likeness = label_like(own, shape, run, segments);
  }

  if(input.prepared) {
    const Labels& known = likeness ? shape.labels : segments;
    segments = labels_of_file(*input.prepared, segments, *std::max_element(known.begin(), known.end()) + 1);
    if(!likeness)
      renumber(segments); // a label may be that of new faces only
    run.data = input.prepared->soup.data;
  }
  const std::size_t number_of_segments = std::set<std::size_t>(segments.begin(), segments.end()).size();
  on_mesh_of_file(input, [&](const Mesh& mesh) {
    write_segments_ply(*run.out(), run.ascii, mesh, segments, number_of_segments, run.data);
  });
  if(std::ostream* const labels = run.out("--labels"))
    for(const std::size_t segment : segments)
      *labels << segment << '\n';
  run.details["segments"] = number_of_segments;
  if(likeness)
    run.details["like"] = {{"mesh", own.like},
                           {"trust", SP::get_trust_name(likeness->trust())},
                           {"margin", likeness->margin},
                           {"signature_difference", likeness->signature_difference},
                           {"stretching", likeness->stretching}};
  run.commit();
  const std::string name_of_input = run.name_of_input();
  run.line = std::to_string(number_of_segments) + " segments";
  if(likeness)
    run.line += ", labels of " + own.like + ": " + SP::get_trust_name(likeness->trust());
  run.text = triangulation_text(name_of_input, input, "that have segments") + preparation_text(name_of_input, input) +
             name_of_input + ": " + run.line;
  if(!input.result.fallback_reason.empty()) {
    run.line += ", " + input.result.method;
    run.text += "\nautomatic: " + input.result.fallback_reason;
  }
}

Work segment_work()
{
  const auto own = std::make_shared<Segment_options>();
  const auto shape = std::make_shared<Labelled_shape>();
  Work work = {[own, shape](Run& run) { segment(*own, *shape, run); }};
  Options& options = work.options;
  options("--segments", own->number, "Number of segments to aim at; there may be fewer [as many as the shape has]")
    .in("[1,inf)");
  options("--like", own->like,
          "A mesh: every segment gets the label and the colour of the segment of this mesh that corresponds to it, by "
          "registration. The line of a mesh and the report say how far to trust the labels: sure, unsure or unlike");
  options("--like-labels", own->like_labels,
          "A label for each face of that mesh, a whole number, one per line [its segments]")
    .only_with("--like");
  work.reads = [own](const Request&) {
    return Work::Files{{"--like", own->like}, {"--like-labels", own->like_labels}};
  };
  return work;
}

} // namespace

Step segment_step()
{
  return {"segment",
          "Segment a shape into body and limbs",
          {Takes::EACH, "balanced", "clamped", Takes::OPTION, Prepare::ALL}, // as tuned
          {{"-o,--output",
            "Output file: .ply, IN with a colour per segment; - is the standard output",
            {".ply"},
            Output::FILE,
            Output::REQUIRED},
           {"--labels", "Write the segment number of each face, counted from 0, one per line"}},
          segment_work,
          "segment bunny.ply -o segments.ply --labels labels.txt"};
}

} // namespace tool
