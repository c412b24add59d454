// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"

#include "input/binary.h"
#include "input/files.h"
#include "mapping/registered_pair.h"
#include "morph_html.h"
#include "options/mesh_output.h"
#include "options/usage.h"
#include "output/atomic_file.h"
#include "output/write_mesh.h"
#include "system/refusal.h"
#include "system/interruption.h"

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <boost/algorithm/string/replace.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace tool {
namespace {

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
    : from_(by_columns(from)), to_(by_columns(to)), from_centre_(from_.rowwise().mean()),
      to_centre_(to_.rowwise().mean())
  {
    from_.colwise() -= from_centre_;
    to_.colwise() -= to_centre_;
    turn_ = Eigen::Matrix3d(Eigen::umeyama(from_, to_, false).topLeftCorner<3, 3>());
    to_ = turn_.inverse().toRotationMatrix() * to_;
  }

  std::vector<Point> at(double t) const
  {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(t * turn_.angle(), turn_.axis()).toRotationMatrix();
    const Points all = (turn * ((1 - t) * from_ + t * to_)).colwise() + ((1 - t) * from_centre_ + t * to_centre_);
    std::vector<Point> points;
    for(Eigen::Index v = 0; v < all.cols(); ++v)
      points.push_back({all(0, v), all(1, v), all(2, v)});
    return points;
  }

private:
  using Points = Eigen::Matrix<double, 3, Eigen::Dynamic>;
  static Points by_columns(const std::vector<Point>& points)
  {
    return Eigen::Map<const Points>(points.front().data(), 3, static_cast<Eigen::Index>(points.size()));
  }

  Points from_, to_; ///< about their centres; those of the other shape turned back
  Eigen::Vector3d from_centre_, to_centre_;
  Eigen::AngleAxisd turn_;
};

/// Writes one HTML file that shows a mesh moving from the first frame to the last one and back, drawn by WebGL 2.
/// Nothing is loaded from elsewhere.
void write_morph_page(std::ostream& out, const std::string& title, const Mesh& mesh,
                      const std::vector<std::vector<Point>>& frames)
{
  std::array<double, 3> low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for(const auto& points : frames)
    for(const Point& p : points)
      for(std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], p[k]);
        high[k] = std::max(high[k], p[k]);
      }
  const double size = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2], 1e-300});
  std::string bytes;
  for(const auto& points : frames)
    for(const Point& p : points)
      for(std::size_t k = 0; k < 3; ++k)
        append_number(bytes, static_cast<std::uint16_t>(
                               std::lround(65535 * (0.5 + (p[k] / 2 - low[k] / 4 - high[k] / 4) * 2 / size))));
  bytes.append((4 - bytes.size() % 4) % 4, '\0');
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for(const std::int32_t v : mesh.triangle(f))
      append_number(bytes, v);

  const std::string name = nlohmann::json(title).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  out << morph_page_before_header()
      << "name: " << boost::replace_all_copy(name, "<", "\\u003c") // no end of the element
      << ", vertices: " << mesh.number_of_vertices() << ", faces: " << mesh.number_of_faces()
      << ", frames: " << frames.size() << morph_page_before_data() << to_base64(bytes) << morph_page_after_data();
}

std::string name_of_step(const Morph_options& options, int step)
{
  const std::string number = std::to_string(step), last = std::to_string(options.steps);
  return options.output + "/step_" + std::string(last.size() - number.size(), '0') + number + '.' + options.format;
}

std::string page_of(const Morph_options& options) { return options.output + "/morph.html"; }

/// No mesh of A, B or another run may be in the place of a step, or among the steps.
void check_outputs(const Morph_options& options)
{
  const std::vector<File_option> inputs = registration_inputs(options);
  check_files(inputs, {{"--output", page_of(options)}});
  std::set<std::string> steps;
  for(int step = 0; step <= options.steps; ++step) {
    steps.insert(name_of_step(options, step));
    check_files(inputs, {{"--output", name_of_step(options, step)}});
  }
  for(const std::string& file : numbered_files(options.output + "/step_", '.' + options.format))
    require(steps.count(file) > 0, "--output", "'" + file + "' is of another run; remove it, or name another folder");
}

void morph(const Morph_options& options)
{
  Registered_pair pair;
  read_pair(options, pair);
  Atomic_file::create_folder(options.output);
  register_pair(options, pair);

  const Mesh& mesh = pair.a.mesh();
  const Rigid_path path(mesh.points(), pair.points_on_b);
  Atomic_files files;
  constexpr int frames_of_page = 8; // between which the page interpolates
  std::vector<std::vector<Point>> frames;
  for(int k = 0; k <= frames_of_page; ++k)
    frames.push_back(path.at(double(k) / frames_of_page));
  write_morph_page(files.open(page_of(options)),
                   std::filesystem::path(options.input).filename().string() + " to " +
                     std::filesystem::path(options.other).filename().string(),
                   mesh, frames);
  for(int step = 0; step <= options.steps; ++step) {
    const std::string name = name_of_step(options, step);
    // both ends are as they are, without rounding
    const std::vector<Point> points = step == 0               ? mesh.points()
                                      : step == options.steps ? pair.points_on_b
                                                              : path.at(double(step) / options.steps);
    write_mesh(files.open(name), output_format_of_name("--format", name, options.ascii), mesh, points, Surface::SHAPE,
               pair.a.file->annotations);
    files.complete();
    stop_if_interrupted(options.input);
  }
  files.commit(options.input);
  std::cout << preparation_text(options, pair) << "written: " << name_of_step(options, 0) << " to "
            << name_of_step(options, options.steps)
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
  add_checked_option(*command, "--steps", options->steps, "The number of steps: one mesh more is written",
                     CLI::Range(1, 10000));
  add_checked_option(*command, "--format", options->format, "Format of the meshes",
                     CLI::IsMember({"off", "obj", "ply", "glb"}));
  add_ascii_option(*command, options->ascii);
  add_footer(*command, "morph lion1.obj lion2.obj -o morph --steps 20");
  command->callback([options, &exit_code] {
    while(options->output.size() > 1 && options->output.back() == '/')
      options->output.pop_back();
    check_registration_options(*options);
    check_outputs(*options);
    exit_code = exit_code_of(guarded(options->input, [&] { morph(*options); }));
  });
}

} // namespace tool
