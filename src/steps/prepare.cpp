// SPDX-License-Identifier: GPL-3.0-or-later

#include "runner/step.h"

#include "input/compression.h"
#include "input/files.h"
#include "input/mesh_readers.h"
#include "preparation/prepare.h"
#include "system/interruption.h"
#include "system/terminal.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <sstream>

namespace tool {
namespace {

namespace fs = std::filesystem;

/// The command line of `prepare`.
struct Prepare_options {
  std::string steps = "merge,orient,largest,holes,handles";
  std::optional<double> merge_distance;
  bool wrap = false;
  Preparation_settings::Wrap wrap_settings;
};

/// What has come of the command, for the report.
struct Prepared {
  std::optional<Soup> soup;
  std::optional<Preparation> preparation;
  std::vector<std::string> files; ///< with the mesh, or its parts
  std::optional<Hausdorff_distance> distance;
  double diagonal = 0; ///< of the bounding box of IN
  double seconds_read = 0, seconds_prepare = 0, seconds_measure = 0;
};

/// The words of --steps. Throws what is wrong usage.
std::set<std::string> steps_of(const Prepare_options& options)
{
  const std::vector<std::string> all = {"merge", "orient", "largest", "split", "degenerate", "holes", "handles"};
  std::set<std::string> steps;
  std::istringstream words(options.steps);
  for(std::string step; std::getline(words, step, ',');) {
    require(std::find(all.begin(), all.end(), step) != all.end(), "--steps",
            "'" + step + "' is none of " + join(all, ", "));
    steps.insert(step);
  }
  return steps;
}

bool is_split(const Prepare_options& options) { return steps_of(options).count("split") > 0; }

/// The names of the parts of a mesh that is split have a number between these two: out.ply becomes out_1.ply
std::pair<std::string, std::string> around_number(const std::string& file)
{
  const std::string plain = without_compression(file);
  const std::size_t end = without_extension(plain).size();
  return {file.substr(0, end) + '_', file.substr(end)};
}

/// Nobody has typed the names of parts, and how many there will be is not known: what has such a name stays.
void check_parts(const Request& request)
{
  const auto [beginning, end] = around_number(request.file());
  for(const std::string& file : numbered_files(beginning, end))
    require(false, "--output", "'" + file + "' exists, and has the name of a part; remove it, or name another output");
  require(!is_numbered(request.file("--report"), beginning, end), "--report", "has the name of a part");
}

void check_options(const Prepare_options& options, const Request& request)
{
  const std::set<std::string> steps = steps_of(options);
  require(steps.count("largest") == 0 || steps.count("split") == 0, "--steps", "is either largest or split");
  if(steps.count("split") > 0) {
    require(!request.is_one_of_many, "--steps",
            "split writes a file for every component, and so takes one IN at a time");
    for(const char* option : {"--vertex-map", "--face-map", "--data-output"})
      require(request.file(option).empty(), "--steps",
              std::string("split has several outputs, so ") + option + " is not possible");
    require(!request.file().empty() && request.file() != standard_stream, "--steps",
            "split requires a file as --output");
    check_parts(request);
  }
  require(!options.merge_distance || steps.count("merge") > 0, "--merge-distance", "requires the step merge");
}

Preparation_settings settings_of(const Prepare_options& options)
{
  using Components = Preparation_settings::Components;
  const std::set<std::string> steps = steps_of(options);
  const auto has = [&steps](const char* step) { return steps.count(step) > 0; };
  Preparation_settings settings;
  settings.merge_distance = options.merge_distance.value_or(0);
  if(!has("merge"))
    settings.merge_distance.reset();
  settings.components = has("largest") ? Components::LARGEST : has("split") ? Components::SPLIT : Components::TOGETHER;
  settings.removes_degenerate_faces = has("degenerate");
  settings.fills_holes = has("holes");
  settings.cuts_handles = has("handles");
  if(options.wrap)
    settings.wrap = options.wrap_settings;
  return settings;
}

void write_numbers(std::ostream* out, const std::vector<int>& numbers)
{
  if(out != nullptr)
    for(const int i : numbers)
      *out << i << '\n';
}

/// Whether readers of the format make one vertex of several at the same place, and there are such.
bool loses_copies(Mesh_format format, const std::vector<Glued_surface>& parts)
{
  if(format != Mesh_format::GLB && format != Mesh_format::GLTF)
    return false;
  return std::any_of(parts.begin(), parts.end(), [format](const Glued_surface& part) {
    std::set<Point> places;
    for(const Point& p : part.points)
      places.insert(as_stored(format, Surface::SHAPE, p));
    return places.size() < part.points.size();
  });
}

/// "closed, of one component, without handles", or what is left.
std::string shape_of(const std::vector<Glued_surface>& parts, bool are_copies_lost)
{
  std::size_t pieces = 0;
  int holes = 0, handles = 0;
  for(const Glued_surface& part : parts) {
    std::vector<int> unused;
    for(const Component& component : components(part, unused)) {
      ++pieces;
      holes += component.holes;
      handles += component.genus();
    }
  }
  const auto left = [](std::size_t n, const std::string& what) {
    return std::to_string(n) + ' ' + what + (n == 1 ? "" : "s");
  };
  if(pieces == 1 && holes == 0 && handles == 0 && are_copies_lost)
    return "a closed surface of genus 0, but of vertices at the same place glTF makes one again: name another format "
           "for 'map'";
  if(pieces == 1 && holes == 0 && handles == 0)
    return "a closed surface of genus 0, which 'map' accepts";
  return left(pieces, "component") + ", " + left(static_cast<std::size_t>(holes), "hole") + ", " +
         left(static_cast<std::size_t>(handles), "handle");
}

Json report_of(const Prepared& prepared)
{
  Json outputs = Json::array();
  if(prepared.preparation)
    for(const Glued_surface& part : prepared.preparation->parts)
      outputs.push_back({{"vertices", part.number_of_vertices()}, {"faces", part.number_of_faces()}});
  return {
    {"vertices", prepared.soup ? Json(prepared.soup->points.size()) : Json(nullptr)},
    {"faces", prepared.soup ? Json(prepared.soup->faces) : Json(nullptr)},
    {"preparation", prepared.preparation ? to_json(*prepared.preparation) : Json(nullptr)},
    {"parts", outputs},
    {"files", prepared.files},
    {"diagonal", known(prepared.soup.has_value(), prepared.diagonal)},
    {"distance_from_output_to_input", prepared.distance ? to_json(prepared.distance->from_new) : Json(nullptr)},
    {"distance_from_input_to_output", prepared.distance ? to_json(prepared.distance->from_old) : Json(nullptr)},
    {"seconds",
     {{"read", prepared.seconds_read}, {"prepare", prepared.seconds_prepare}, {"measure", prepared.seconds_measure}}}};
}

void say(Run& run, const Prepared& prepared)
{
  const Soup& soup = *prepared.soup;
  const Preparation& preparation = *prepared.preparation;
  std::ostringstream text, line, distance;
  distance.precision(3);
  std::vector<std::string> done = sentences(preparation);
  if(done.empty())
    done.emplace_back("nothing to repair");

  constexpr double rounding = 1e-14;
  const auto& [from_new, from_old] = *prepared.distance;
  const double hausdorff = std::max(from_new.high, from_old.high);
  if(hausdorff <= rounding * prepared.diagonal)
    distance << 0;
  else
    distance << hausdorff << ", " << 100 * (hausdorff / prepared.diagonal) << " % of its diagonal";

  std::size_t vertices = 0, faces = 0;
  for(const Glued_surface& part : preparation.parts) {
    vertices += part.points.size();
    faces += part.faces.size();
  }
  line << vertices << " vertices, " << faces << " faces, "
       << shape_of(preparation.parts,
                   !prepared.files.empty() && loses_copies(run.mesh_format().format, preparation.parts));

  text.precision(3);
  text << run.name_of_input() << ": " << soup.points.size() << " vertices, " << soup.faces << " faces\n";
  if(!soup.polygons.empty())
    text << "triangulated " << soup.polygons.size() << " polygons: faces below are triangles\n";
  for(const std::string& sentence : done)
    text << sentence << '\n';
  if(share_of_area_kept(preparation) < 0.5)
    text << "most of the area was removed: --merge-distance unites parts that nearly meet, --wrap makes a surface "
            "around all parts, --steps without largest keeps them\n";
  text << (prepared.files.empty() ? "it would be: " : "it is now: ") << line.str()
       << "\nHausdorff distance to IN: " << distance.str();
  if(distance.str() != "0")
    text << " (from OUT to IN " << from_new.high << ", from IN to OUT " << from_old.high << ')';
  for(const std::string& file : prepared.files)
    text << "\nwritten: " << shown(file, "standard output");
  if(prepared.files.empty())
    text << "\nno mesh was written, since --output is not given";
  run.text = text.str();

  line << "; Hausdorff distance to IN " << distance.str();
  if(!soup.polygons.empty())
    line << "; triangulated " << soup.polygons.size() << " polygons";
  for(const std::string& sentence : done)
    line << "; " << sentence;
  run.line = line.str();
}

void write(const Prepare_options& options, Run& run, Prepared& prepared)
{
  const Stopwatch writing;
  const auto write_surface = [&](std::ostream& out, const Glued_surface& surface) {
    write_mesh(out, run.mesh_format(), Mesh(Mesh::Unchecked(), surface.points, surface.faces), surface.points,
               Surface::SHAPE, prepared.soup->annotations, carried(prepared.soup->data, surface.old_vertex));
  };
  const std::vector<Glued_surface>& parts = prepared.preparation->parts;
  if(is_split(options)) {
    const auto [beginning, end] = around_number(run.file());
    for(const Glued_surface& part : parts) {
      prepared.files.push_back(beginning + std::to_string(prepared.files.size() + 1) + end);
      write_surface(run.open(prepared.files.back()), part);
      run.complete();
    }
  } else {
    const Glued_surface all = joined(parts);
    run.data = carried(prepared.soup->data, all.old_vertex);
    if(std::ostream* const out = run.out()) {
      write_surface(*out, all);
      prepared.files.push_back(run.file());
    }
    write_numbers(run.out("--vertex-map"), all.old_vertex);
    write_numbers(run.out("--face-map"), all.old_face);
  }
  run.figures.seconds_write = writing.seconds();
}

void prepare(const Prepare_options& options, Run& run, Prepared& prepared)
{
  constexpr double tolerance = 1e-4; // of the distance, as a part of the diagonal
  const std::string& input = run.options.input;
  const Stopwatch reading;
  prepared.soup = read_triangles(input, Coordinates::ANY);
  run.annotations = prepared.soup->annotations;
  read_data(run.options, prepared.soup->points.size(), prepared.soup->data);
  prepared.diagonal = diagonal(*prepared.soup);
  prepared.seconds_read = reading.seconds();
  const Stopwatch preparing;
  prepared.preparation = tool::prepare(input, *prepared.soup, settings_of(options));
  if(!run.file().empty()) // the distance is that of the file
    if(const Mesh_format format = run.mesh_format().format; stores_floats(format))
      for(Glued_surface& part : prepared.preparation->parts) {
        check_float_range(run.file(), part.points);
        for(Point& p : part.points)
          p = as_stored(format, Surface::SHAPE, p);
      }
  prepared.seconds_prepare = preparing.seconds();
  const Stopwatch measuring;
  prepared.distance = hausdorff_distance(*prepared.soup, prepared.preparation->parts, tolerance * prepared.diagonal,
                                         [&input] { stop_if_interrupted(input); });
  prepared.seconds_measure = measuring.seconds();
  write(options, run, prepared);
}

void prepare_and_say(const Prepare_options& options, Run& run)
{
  Prepared prepared;
  try {
    prepare(options, run, prepared);
  } catch(...) {
    run.details = report_of(prepared); // as far as it came
    throw;
  }
  run.details = report_of(prepared);
  run.commit();
  say(run, prepared);
}

Work prepare_work()
{
  const auto own = std::make_shared<Prepare_options>();
  Work work = {[own](Run& run) { prepare_and_say(*own, run); }};
  Options& options = work.options;
  options(
    "--steps", own->steps,
    "What is done, separated by commas: merge (merge boundary vertices at the same position), orient (always done, "
    "like removing invalid faces, and cutting non-manifold parts from each other), largest or split (keep the "
    "component of largest area, or write each component as OUT_1, OUT_2, ..., none of which may exist), degenerate "
    "(remove faces of area 0, which 'map' does not need), holes (fill holes), handles (cut handles of components "
    "without holes, and close them). merge,orient alone does not change the shape, and is what 'map --prepare' does")
    .is("LIST");
  options("--merge-distance", own->merge_distance,
          "Merge boundary vertices up to this distance, not only those at the same position [0]")
    .in("[0,inf)");
  options("--wrap", own->wrap, "First replace the mesh, however broken it is, by a surface around it");
  options("--alpha", own->wrap_settings.alpha,
          "Wrap: cavities that a ball of this radius cannot enter are filled [diagonal / 50]")
    .in("(0,inf)")
    .only_with("--wrap");
  options("--offset", own->wrap_settings.offset, "Wrap: distance of the surface from the mesh [diagonal / 1500]")
    .in("(0,inf)")
    .only_with("--wrap");
  work.check = [own](const Request& request) { check_options(*own, request); };
  return work;
}

} // namespace

Step prepare_step()
{
  return {"prepare",
          "Repair a mesh so that it is one closed surface, which 'map' accepts",
          {Takes::EACH, nullptr, "", Takes::NO_SPHERE, Prepare::NO, "", "Meshes with any defects, or folders of them"},
          {{"-o,--output",
            "Output file, in which the remaining vertices and faces of IN keep their order (without --output the "
            "command only prints what it would do)",
            {},
            Output::MESH},
           {"--vertex-map", "Write for each vertex of the output its index in IN, counted from 0, or -1 if it is new"},
           {"--face-map", "Write for each face of the output its index in IN, counted from 0, or -1 if it is new"}},
          prepare_work,
          "prepare scan.ply -o closed.ply --vertex-map vertices.txt"};
}

} // namespace tool
