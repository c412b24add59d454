// SPDX-License-Identifier: GPL-3.0-or-later

#include "runner/step.h"

#include "mapping/spherical_map.h"
#include "system/interruption.h"
#include "system/terminal.h"

#include <CGAL/Spherical_parameterization/distortion_summary.h>

#include <cmath>
#include <cstddef>
#include <iomanip>
#include <sstream>

namespace tool {
namespace {

Sphere mirror_image(Sphere points)
{
  for(Point& p : points)
    p[0] = -p[0];
  return points;
}

/// Points off a common sphere are projected to it, of which people should know.
void say_radius(std::ostream& out, const std::string& file, const Given_sphere& sphere)
{
  constexpr double rounding = 1e-3; // of files of floats, and of programs that keep spheres only roughly
  out << file << ": ";
  if(sphere.largest_radius <= (1 + rounding) * sphere.smallest_radius)
    out << "radius " << sphere.largest_radius << '\n';
  else
    out << "points at distances from " << std::setprecision(5) << sphere.smallest_radius << " to "
        << sphere.largest_radius << std::setprecision(3)
        << " of the origin, from which they are projected to the sphere\n";
}

void say_distortion(std::ostream& out, const SP::Distortion_summary& d)
{
  constexpr double degrees = 57.295779513082321;
  out << "angle distortion: mean " << degrees * d.angle_distortion.mean << " degrees, 95 % of the area below "
      << degrees * d.angle_distortion.percentile_95;
  if(!std::isnan(d.log_area_stretch.mean))
    out << "\narea shrinks by factors from " << std::exp(d.log_area_stretch.percentile_5) << " to "
        << std::exp(d.log_area_stretch.percentile_95) << " (90 % of the area)";
}

void certify(Run& run)
{
  Mapped_mesh& input = run.input;
  run.read();
  const Stopwatch reading;
  const Given_sphere sphere = read_given_sphere(run.options.sphere, run.options.input, input.mesh());
  input.seconds_read += reading.seconds();

  const Stopwatch certifying;
  const auto certified = [&](const std::vector<Point>& points) {
    return tool::certify(input.data.policy, input.mesh(), points);
  };
  input.result = certified(sphere.points);
  const bool is_mirrored = input.result.degree == -1;
  // the measures are of maps that keep the orientation
  input.sphere = is_mirrored ? mirror_image(sphere.on_unit_sphere) : sphere.on_unit_sphere;
  input.result.seconds.certify = certifying.seconds();
  const Stopwatch measuring;
  run.figures.distortion = on_host(
    input, [&](const auto& policy) { return SP::distortion_summary(policy, input.mesh(), as_map(input.sphere)); });
  run.figures.seconds_measure = measuring.seconds();
  stop_if_interrupted(run.options.input);

  const SP::Result& result = input.result;
  std::ostringstream certificate, text;
  certificate << "spherical map: " << result.flipped_faces << " flipped faces, degree " << result.degree;
  text.precision(3);
  text << run.name_of_input() << ": " << result.number_of_vertices << " vertices, " << result.number_of_faces
       << " faces\n"
       << (result        ? "valid "
           : is_mirrored ? "mirrored "
                         : "no valid ")
       << certificate.str() << '\n';
  say_radius(text, shown(run.options.sphere, "standard input"), sphere);
  say_distortion(text, *run.figures.distortion);
  run.text = text.str();
  run.line = "valid " + certificate.str() + ", " + std::to_string(result.number_of_vertices) + " vertices";
  if(is_mirrored) {
    const std::size_t left = certified(mirror_image(sphere.points)).flipped_faces;
    throw Refusal("MIRRORED", run.options.sphere,
                  std::string("is a mirror image, ") +
                    (left == 0 ? std::string("otherwise a valid spherical map")
                               : "and its mirror image has " + std::to_string(left) + " flipped faces"),
                  "negate one coordinate of the sphere, or reverse the faces of both");
  }
  if(!result)
    throw Refusal(result.error, run.options.sphere, "is no valid spherical map: " + result.detail, "");
}

Work certify_work()
{
  const auto triangulates = std::make_shared<bool>(false);
  Work work = {[triangulates](Run& run) {
    run.options.triangulate = *triangulates;
    certify(run);
  }};
  work.options("--triangulate", *triangulates, "Triangulate the polygons of MESH as 'map' does; SPHERE has triangles");
  return work;
}

} // namespace

Step certify_step()
{
  return {
    "certify",
    "Certify and measure a spherical map of any program",
    {Takes::EACH, nullptr, "", Takes::ARGUMENT, Prepare::HARMLESS, "",
     "MESH... SPHERE: closed triangle meshes of genus 0, or folders of them; the last argument is the sphere, or the "
     "folder of the spheres with the same names. A sphere has the same vertices and faces in the same order as its "
     "mesh; its centre is the origin, its radius may be any"},
    {{"-o,--output",
      "Folder for the reports of several MESH, and for the list of finished ones, with which the same command resumes",
      {},
      Output::FOLDER}},
    certify_work,
    "certify lh.pial.ply lh.sphere.ply --report report.json",
    "The exit code is 0 if the map is valid. Points that are not on a common sphere are projected from the origin, and "
    "the output says so. Mirror images are recognized."};
}

} // namespace tool
