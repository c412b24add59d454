// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"

#include "mapping/registered_pair.h"
#include "options/usage.h"
#include "output/atomic_file.h"
#include "output/morph_page.h"
#include "output/write_mesh.h"
#include "system/guarded.h"
#include "system/interruption.h"

#include <CGAL/Spherical_parameterization/internal/algebra/rotations.h>
#include <CGAL/Spherical_parameterization/internal/algebra/point_coordinates.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace tool {
namespace {

using namespace CGAL::Spherical_parameterization::internal;

struct Morph_options : Registration_options {
  std::string output;
  std::string format = "ply";
  int steps = 10;
  bool ascii = false;
};

/// The path of the vertices from one shape to the other: the best rigid motion between them is made at an even speed,
/// and the rest is linear, so that a shape that only turns does not shrink on the way.
class Rigid_path {
public:
  Rigid_path(const std::vector<Point>& from, const std::vector<Point>& to)
    : from_centre_(mean(from)), to_centre_(mean(to))
  {
    for(std::size_t i = 0; i < from.size(); ++i) {
      from_.push_back(sub(coordinates(from[i]), from_centre_));
      to_.push_back(sub(coordinates(to[i]), to_centre_));
    }
    const Matrix_3 r = best_rotation(from_, to_);
    const vec3 twist = {r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]}; // 2 sin(angle) times the axis
    const double angle = std::atan2(norm(twist), r[0][0] + r[1][1] + r[2][2] - 1);
    if(norm(twist) > 0)
      rotation_ = scale(angle / norm(twist), twist);
    const Matrix_3 back = rotation_about(scale(-1, rotation_));
    for(vec3& p : to_)
      p = rotated(back, p);
  }

  std::vector<Point> at(double t) const
  {
    const Matrix_3 turn = rotation_about(scale(t, rotation_));
    const vec3 centre = add_scaled(scale(1 - t, from_centre_), t, to_centre_);
    std::vector<Point> points;
    for(std::size_t i = 0; i < from_.size(); ++i) {
      const vec3 p = add(centre, rotated(turn, add_scaled(scale(1 - t, from_[i]), t, to_[i])));
      points.push_back({p.x, p.y, p.z});
    }
    return points;
  }

private:
  static vec3 mean(const std::vector<Point>& points)
  {
    vec3 sum = {0, 0, 0};
    for(const Point& p : points)
      sum = add_scaled(sum, 1. / double(points.size()), coordinates(p));
    return sum;
  }

  vec3 from_centre_, to_centre_;
  vec3 rotation_ = {0, 0, 0}; ///< axis times angle
  std::vector<vec3> from_, to_;
};

std::string name_of_step(const Morph_options& options, int step)
{
  const std::string number = std::to_string(step), last = std::to_string(options.steps);
  return options.output + "/step_" + std::string(last.size() - number.size(), '0') + number + '.' + options.format;
}

void morph(const Morph_options& options)
{
  Registered_pair pair;
  read_pair(options, pair);
  Atomic_file::create_folder(options.output);
  register_pair(options, pair);

  const Mesh& mesh = pair.a.mesh();
  const Rigid_path path(mesh.points(), pair.points_on_b);
  for(int step = 0; step <= options.steps; ++step) {
    const std::string name = name_of_step(options, step);
    // both ends are as they are, without rounding
    const std::vector<Point> points = step == 0               ? mesh.points()
                                      : step == options.steps ? pair.points_on_b
                                                              : path.at(double(step) / options.steps);
    Atomic_file file(name);
    write_mesh(file.stream(), output_format_of_name("--format", name, options.ascii), mesh, points, Surface::SHAPE,
               pair.a.file->annotations);
    stop_if_interrupted(options.input);
    file.commit();
  }
  std::vector<std::vector<Point>> frames;
  constexpr int frames_of_page = 8; // between which the page interpolates
  for(int k = 0; k <= frames_of_page; ++k)
    frames.push_back(path.at(double(k) / frames_of_page));
  Atomic_file page(options.output + "/morph.html");
  write_morph_page(page.stream(),
                   std::filesystem::path(options.input).filename().string() + " to " +
                     std::filesystem::path(options.other).filename().string(),
                   mesh, frames);
  stop_if_interrupted(options.input);
  page.commit();
  std::cout << "written: " << name_of_step(options, 0) << " to " << name_of_step(options, options.steps)
            << ", and morph.html to look at\nregistered map: " << pair.result.flipped_faces << " flipped faces, degree "
            << pair.result.degree << std::endl;
}

} // namespace

void add_morph_command(CLI::App& app, int& exit_code)
{
  CLI::App* command = app.add_subcommand("morph", "Write meshes that lead from one shape to another one, and a page");
  const auto options = std::make_shared<Morph_options>();
  add_registration_options(*command, *options);
  command
    ->add_option("-o,--output", options->output,
                 "Output folder: step_0, which is A, to step_STEPS, which is A in the shape of B, and morph.html")
    ->required()
    ->type_name("FOLDER");
  command->add_option("--steps", options->steps, "The number of steps: one mesh more is written")
    ->check(CLI::Range(1, 10000))
    ->capture_default_str();
  command->add_option("--format", options->format, "Format of the meshes")
    ->check(CLI::IsMember({"off", "obj", "ply", "glb"}))
    ->capture_default_str();
  add_ascii_option(*command, options->ascii);
  command->footer("Example: spherical-parameterization morph lion1.obj lion2.obj -o morph --steps 20\n"
                  "Exit code: 0 the files were written, 1 not all were written (stderr says why), 2 wrong usage,\n"
                  "130 interrupted.");
  command->callback([options, &exit_code] {
    while(options->output.size() > 1 && options->output.back() == '/')
      options->output.pop_back();
    check_registration_options(*options);
    check_files(registration_inputs(*options), {{"--output", options->output + "/morph.html"}});
    exit_code = exit_code_of(guarded(options->input, [&] { morph(*options); }));
  });
}

} // namespace tool
