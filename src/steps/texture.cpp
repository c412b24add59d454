// SPDX-License-Identifier: GPL-3.0-or-later

#include "runner/step.h"

#include "input/files.h"

#include <CGAL/Spherical_parameterization/texture_coordinates.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <sstream>

namespace tool {
namespace {

namespace fs = std::filesystem;

struct Own_options {
  std::string chart = "latitude-longitude";
  std::optional<std::array<double, 3>> north;
  std::string image;
};

/// The file next to the output with another extension.
std::string beside(const std::string& output, const char* extension)
{
  return fs::path(output).replace_extension(extension).string();
}

/// Whether material and image are files of their own; glTF has them inside.
bool is_obj(const Request& request) { return request.mesh_format().format == Mesh_format::OBJ; }

SP::Texture_options texture_options(const Own_options& options)
{
  SP::Texture_options result;
  if(options.chart == "octahedral")
    result.chart = SP::Texture_chart::OCTAHEDRAL;
  if(options.north) {
    // longitude 0 at the coordinate axis that is farthest from the pole
    SP::Texture_axes axes = {*options.north, {0, 0, 0}};
    std::size_t least = 0;
    for(std::size_t i = 1; i < 3; ++i)
      if(std::abs(axes.north[i]) < std::abs(axes.north[least]))
        least = i;
    axes.meridian[least] = 1;
    result.axes = axes;
  }
  result.bits = 23; // viewers read floats
  return result;
}

void say(Run& run, const SP::Texture_report& report)
{
  std::ostringstream line, more;
  line.precision(3);
  more.precision(3);
  const auto& north = report.axes.north;
  line << "no face " << (was_mended(run.input.prepared) ? "of the repaired mesh " : "")
       << "is flipped in the texture; north pole at " << north[0] << ' ' << north[1] << ' ' << north[2] << ", "
       << report.seam_faces << " faces across the seam";
  if(report.moved_faces > 0)
    more << '\n'
         << report.moved_faces << " faces have a moved corner, at most " << report.largest_move
         << " away from that of their neighbours: " << report.unresolved_faces
         << " are smaller than the resolution of floats, " << report.moved_faces - report.unresolved_faces
         << " are too long and thin for the chart";
  run.line = line.str();
  if(report.moved_faces > 0)
    run.line += ", " + std::to_string(report.moved_faces) + " faces with a moved corner";
  run.text =
    preparation_text(run.name_of_input(), run.input.prepared) + run.name_of_output() + ": " + line.str() + more.str();
}

int checker_rows(const Own_options& options) { return options.chart == "octahedral" ? 32 : 16; }

/// The image for glTF, which has it inside.
std::string image_of(const Own_options& options)
{
  if(options.image.empty()) {
    std::ostringstream png;
    write_checker(png, 32, checker_rows(options));
    return png.str();
  }
  std::string image = read_file(options.image);
  if(type_of_image(image).empty())
    refuse_file(options.image, "is neither PNG nor JPEG, the formats that glTF files can hold",
                "convert it, or write .obj");
  return image;
}

void texture(const Own_options& options, Run& run)
{
  Mapped_mesh& input = run.input;
  if(!options.image.empty())
    check_readable(options.image);
  run.read();
  check_floats(run.mesh_format(), run.mesh().points()); // before the work
  const bool has_files_beside = is_obj(run);
  run.out();
  std::ostream* const material = has_files_beside ? &run.open(beside(run.file(), ".mtl")) : nullptr;
  std::ostream* const checker =
    has_files_beside && options.image.empty() ? &run.open(beside(run.file(), ".png")) : nullptr;
  const std::string image_inside = has_files_beside ? "" : image_of(options);
  run.map();

  // one per halfedge
  std::vector<Uv> uv(3 * input.mesh().number_of_faces());
  const SP::Texture_report report = on_host(input, [&](const auto& policy) {
    return SP::texture_coordinates(policy, input.mesh(), as_map(input.sphere), as_map<Mesh::Halfedge_index>(uv),
                                   texture_options(options), stopped_by_signals());
  });
  if(input.prepared)
    uv = coordinates_of_file(*input.prepared, uv);
  if(has_files_beside) {
    const fs::path image = options.image.empty() ? beside(run.file(), ".png") : options.image;
    on_mesh_of_file(input, [&](const Mesh& mesh) {
      write_textured_obj(*run.out(), mesh, uv, fs::path(beside(run.file(), ".mtl")).filename().string());
    });
    const fs::path place = place_of(image.parent_path()) / image.filename();
    write_material(*material, place.lexically_relative(place_of(fs::path(run.file()).parent_path())).string());
    if(checker)
      write_checker(*checker, 32, checker_rows(options));
  } else
    on_mesh_of_file(
      input, [&](const Mesh& mesh) { write_textured_gltf(*run.out(), run.mesh_format(), mesh, uv, image_inside); });
  run.details["texture"] = {{"north", report.axes.north},
                            {"seam_faces", report.seam_faces},
                            {"moved_faces", report.moved_faces},
                            {"largest_move", report.largest_move},
                            {"unresolved_faces", report.unresolved_faces}};
  run.commit();
  say(run, report);
}

Work texture_work()
{
  const auto own = std::make_shared<Own_options>();
  Work work = {[own](Run& run) { texture(*own, run); }};
  Options& options = work.options;
  options("--chart", own->chart, "Parameterization of the sphere over the plane")
    .of({"latitude-longitude", "octahedral"});
  options("--north", own->north, "North pole on the sphere [that of the least distorted texture]").is("X Y Z").times(3);
  options("--image", own->image, "Image of the material, instead of a checker; PNG or JPEG for .glb and .gltf");
  work.check = [own](const Request& request) {
    require(!own->north || *own->north != std::array<double, 3>{0, 0, 0}, "--north", "must not be the zero vector");
    require(request.file() != standard_stream || !is_obj(request), "--output",
            "is the standard output, but obj has two more files beside it");
    require(own->image != standard_stream || !is_obj(request), "--image", "is named in the material; name a file");
  };
  work.reads = [own](const Request&) { return Work::Files{{"--image", own->image}}; };
  work.writes = [own](const Request& request) {
    if(!is_obj(request))
      return Work::Files();
    return Work::Files{{"the material", beside(request.file(), ".mtl")},
                       {"the image", own->image.empty() ? beside(request.file(), ".png") : ""}};
  };
  return work;
}

} // namespace

Step texture_step()
{
  return {"texture",
          "Give a mesh texture coordinates, without flipped or degenerate faces",
          {Takes::EACH, "automatic", "conformal", Takes::OPTION, Prepare::ALL},
          {{"-o,--output",
            "Output file of the textured mesh: .glb or .gltf with the image inside, or .obj, with the material and a "
            "checker next to it as .mtl and .png",
            {".obj", ".glb", ".gltf"},
            Output::MESH,
            Output::REQUIRED}},
          texture_work,
          "texture bunny.ply -o textured.obj --chart octahedral"};
}

} // namespace tool
