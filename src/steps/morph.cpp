// SPDX-License-Identifier: GPL-3.0-or-later

#include "runner/step.h"

#include "input/files.h"
#include "runner/page.h"
#include "runner/pair.h"
#include "system/interruption.h"

#include <CGAL/Spherical_parameterization/rigid_path.h>

#include <filesystem>
#include <memory>
#include <system_error>

namespace tool {
namespace {

namespace fs = std::filesystem;

struct Morph_options {
  std::string format = "ply";
  int steps = 10;
  bool ascii = false;
};

std::string name_of_step(const Morph_options& options, const std::string& folder, int step)
{
  const std::string number = std::to_string(step), last = std::to_string(options.steps);
  return folder + "/step_" + std::string(last.size() - number.size(), '0') + number + '.' + options.format;
}

/// The page and the meshes.
Work::Files files_of(const Morph_options& options, const std::string& folder)
{
  Work::Files files = {{"--output", folder + "/morph.html"}};
  for(int step = 0; step <= options.steps; ++step)
    files.emplace_back("--output", name_of_step(options, folder, step));
  return files;
}

/// No mesh of another run may be among the steps.
void check_folder(const Morph_options& options, const std::string& folder)
{
  std::set<std::string> steps;
  for(const auto& [option, file] : files_of(options, folder))
    steps.insert(file);
  for(const std::string& file : numbered_files(folder + "/step_", '.' + options.format))
    require(steps.count(file) > 0, "--output",
            "'" + file + "' belongs to another run; remove it, or name another folder");
}

/// A folder that is removed again if nothing gets into it.
class New_folder {
public:
  explicit New_folder(const std::string& name) : name_(fs::exists(name) ? "" : name)
  {
    Atomic_file::create_folder(name);
  }
  New_folder(const New_folder&) = delete;
  ~New_folder()
  {
    std::error_code none; // fails where it is not empty
    fs::remove(name_, none);
  }

private:
  std::string name_;
};

void morph(const Morph_options& own, const Registration_options& options, Run& run)
{
  Registered_pair pair;
  read_pair(options, pair);
  Page::check_size(options.input, pair.a.mesh().number_of_vertices());
  const std::string first = name_of_step(own, run.file(), 0);
  check_floats({format_of_name(first).value(), false, first}, pair.a.mesh().points()); // before the work
  const New_folder folder(run.file());
  register_pair(options, pair);

  const Mesh& mesh = pair.a.mesh();
  const auto path = SP::rigid_path(mesh.points(), pair.points_on_b);
  Page page;
  constexpr int shapes_of_page = 9; // between which the page interpolates
  for(int k = 0; k < shapes_of_page; ++k)
    page.add(path(double(k) / (shapes_of_page - 1)));
  page.add(mesh);
  page.header["vertices"] = mesh.number_of_vertices();
  page.header["faces"] = mesh.number_of_faces();
  page.header["registration"] = registration_json(options, pair);
  page.header["text"] = registration_text(options, pair);
  const Work::Files files = files_of(own, run.file());
  page.write(run.open(files.front().second));
  for(int step = 0; step <= own.steps; ++step) {
    const std::string& name = files[static_cast<std::size_t>(step) + 1].second;
    write_mesh(run.open(name), {format_of_name(name).value(), own.ascii, name}, mesh, path(double(step) / own.steps),
               Surface::SHAPE, pair.a.file->annotations, pair.a.file->data);
    run.complete();
    stop_if_interrupted(options.input);
  }
  run.data = pair.a.file->data;
  run.annotations = pair.a.file->annotations;
  run.details = registration_json(options, pair);
  run.commit();
  run.text = preparation_text(options, pair) + "written: " + files[1].second + " to " + files.back().second +
             ", and the page morph.html\n" + registration_text(options, pair);
}

Work morph_work()
{
  const auto own = std::make_shared<Morph_options>();
  Work work = work_on_pair([own](const Registration_options& options, Run& run) { morph(*own, options, run); });
  work.options("--steps", own->steps, "The number of steps: STEPS + 1 meshes are written").in("[1,10000]");
  work.options("--format", own->format, "Format of the meshes").of({"off", "obj", "ply", "glb"});
  work.options("--ascii", own->ascii, "Write PLY files as text instead of little-endian binary");
  work.check = [own, check = work.check](const Request& request) {
    check(request);
    check_folder(*own, request.file());
  };
  work.writes = [own](const Request& request) { return files_of(*own, request.file()); };
  return work;
}

} // namespace

Step morph_step()
{
  return {"morph",
          "Write meshes that lead from one shape to another one, and a web page",
          pair_of_meshes(),
          {{"-o,--output",
            "Output folder: step_0, which is A, to step_STEPS, which is A in the shape of B, and morph.html",
            {},
            Output::FOLDER,
            Output::REQUIRED}},
          morph_work,
          "morph lion1.obj lion2.obj -o morph --steps 20"};
}

} // namespace tool
