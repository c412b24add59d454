// SPDX-License-Identifier: GPL-3.0-or-later

#include "collections/lock.h"
#include "runner/step.h"

#include "mapping/spherical_map.h"
#include "output/text_writer.h"
#include "system/interruption.h"

#include <CGAL/Spherical_parameterization/shape_atlas.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <sstream>
#include <system_error>

namespace tool {
namespace {

namespace fs = std::filesystem;

struct Atlas_options {
  std::string template_mesh; ///< empty: the first that has a map
  int rounds = 1;
  std::string faces = "icosphere";
  int level = 5;
  std::string placement = "rigid";
  int modes = 5;
  bool ascii = false;
};

SP::Atlas_placement placement_of(const Atlas_options& options)
{
  using Placement = SP::Atlas_placement;
  return options.placement == "none"     ? Placement::AS_THEY_STAND
         : options.placement == "centre" ? Placement::CENTRED
         : options.placement == "rigid"  ? Placement::RIGID
                                         : Placement::SIMILARITY;
}

/// The options on which maps do not depend, and those on which registered shapes do not.
const std::set<std::string> not_of_maps = {"--template", "--rounds", "--faces", "--level",
                                           "--align",    "--modes",  "--ascii", "--report"};
const std::set<std::string> not_of_shapes = {"--template", "--rounds", "--align", "--modes", "--ascii", "--report"};

using SP::Atlas_mesh;

const CGAL::Parallel_if_available_tag all_cores;

/// Shapes are left out one by one as long as that takes no time: n groups cost n^4.
constexpr std::size_t most_left_out_alone = 100;
constexpr int groups_beyond = 20;

/// From which specificity is taken.
constexpr int random_shapes = 1000;

/// Meshes of modes show so many standard deviations.
constexpr double deviations_shown = 2;

void write_scores(std::ostream& out, const std::vector<std::string>& names,
                  const SP::Shape_statistics<SP::Shape_points>& statistics)
{
  Text_writer write(out);
  write("name");
  for(std::size_t k = 1; k <= statistics.modes.size(); ++k)
    write(",score_", k);
  write('\n');
  for(std::size_t i = 0; i < names.size(); ++i) {
    write(csv_quoted(names[i]));
    for(const double score : statistics.scores[i])
      write(',', score);
    write('\n');
  }
}

/// A line for every number of modes; generalization ends where the shapes that are not left out have no more.
void write_quality(std::ostream& out, const SP::Model_quality& quality)
{
  Text_writer write(out);
  write("modes,compactness,generalization,specificity,specificity_error\n");
  for(std::size_t k = 0; k < quality.compactness.size(); ++k) {
    write(k, ',', quality.compactness[k], ',');
    if(k < quality.generalization.size())
      write(quality.generalization[k]);
    write(',', quality.specificity[k], ',', quality.specificity_error[k], '\n');
  }
}

/// Removes the files of modes that an earlier run has left beyond so many.
void remove_other_modes(const std::string& folder, std::size_t modes)
{
  std::error_code none;
  for(std::size_t k = modes + 1;; ++k) {
    const fs::path name = fs::path(folder) / ("mode_" + std::to_string(k));
    const bool plus = fs::remove(name.string() + "_plus.ply", none),
               minus = fs::remove(name.string() + "_minus.ply", none);
    if(!plus && !minus)
      return;
  }
}

/// A mesh file with its map in another one.
struct Mapped_file {
  std::string mesh, sphere;
};

/// Reads the mesh, mended as it was mapped, and the certified map of the file.
void read_mapped(Mapping_options one, const Mapped_file& file, Prepare how, Mapped_mesh& input)
{
  one.prepare = how;
  one.input = file.mesh;
  one.sphere = file.sphere;
  one.policy = "sequential"; // the other cores have meshes of their own
  read_input(one, input);
  map_input(one, input);
}

/// The files that a run writes at its end.
Work::Files files_of(const Atlas_options& options, const std::string& folder)
{
  Work::Files files;
  for(const char* name : {"/mean.ply", "/variance.ply", "/scores.csv", "/quality.csv", "/report.json"})
    files.emplace_back("--output", folder + name);
  for(int k = 1; k <= options.modes && k <= 1000; ++k)
    for(const char* side : {"_plus.ply", "_minus.ply"})
      files.emplace_back("--output", folder + "/modes/mode_" + std::to_string(k) + side);
  return files;
}

/// The steps of a run, and where their files are.
class Atlas {
public:
  Atlas(const Atlas_options& options, Run& run) : options_(options), run_(run), folder_(run.file()) {}

  void run()
  {
    Atomic_file::create_folder(folder_);
    const Lock lock(folder_, Lock::Kind::FOLDER); // or another run would replace the spheres that this one registers
    Files files;
    for(const auto& [option, file] : files_of(options_, folder_))
      files.push_back(file);
    for(int round = 2; round <= options_.rounds; ++round)
      files.insert(files.end(), {template_of(round).mesh, template_of(round).sphere});
    Atomic_file::remove_leftovers(folder_, files);
    map_meshes();
    const Mapped_file first = {template_.mesh, sphere_of(template_)};
    std::vector<SP::Shape_points> shapes;
    Mapped_file to = first;
    for(int round = 1; round <= options_.rounds; ++round) {
      if(round > 1)
        to = write_template(round, std::move(shapes));
      register_meshes(round, to, first);
      shapes = read_shapes(round);
    }
    Json report = {{"settings", settings()},
                   {"template", template_.mesh},
                   {"rounds", options_.rounds},
                   {"shapes", shapes.size()},
                   {"vertices", mesh_->mesh.number_of_vertices()},
                   {"faces", mesh_->mesh.number_of_faces()},
                   {"meshes", Json::array()}};
    for(const Item& item : items_) {
      const auto& [status, line] = said_.at(item.name);
      report["meshes"].push_back({{"name", item.name}, {"mesh", item.mesh}, {"status", status}, {"line", line}});
    }
    stop_if_interrupted(folder_);
    Atomic_file::create_folder(folder_ + "/modes");
    const auto [found, modes] = write_statistics(std::move(shapes), report);
    run_.details = std::move(report);
    run_.commit();
    remove_other_modes(folder_ + "/modes", modes);
    std::ostringstream text;
    text << folder_ << ": " << found << '\n' << run_.figures.seconds_total << " s";
    run_.text = text.str();
    run_.exit_code = exit_code_;
  }

private:
  std::string settings(const std::set<std::string>& left_out = {}) const { return "atlas" + run_.settings(left_out); }
  std::string sphere_of(const Item& item) const { return folder_ + "/spheres/" + item.name + ".ply"; }
  Mapped_file template_of(int round) const
  {
    const std::string name = folder_ + "/templates/" + std::to_string(round);
    return {name + ".ply", name + "_sphere.ply"};
  }
  std::string folder_of(int round) const { return folder_ + "/registered/" + std::to_string(round); }

  using Files = std::vector<std::string>;

  /// Makes a file in the folder of each item, of the files `inputs(item)`, and notes what was said of it. It is opened
  /// and written by `make(item, file, files)`, which returns the line.
  void run_step(const std::string& folder, const std::set<std::string>& left_out, const std::vector<Item>& items,
                const std::function<Files(const Item&)>& inputs,
                const std::function<std::string(const Item&, const std::string&, Atomic_files&)>& make)
  {
    const auto job = [&](const Item& item) {
      const std::string file = folder + '/' + item.name + ".ply";
      return Job{inputs(item), {file}, [&make, item, file] {
                   Outcome outcome;
                   outcome.refusal = guarded(item.mesh, [&] {
                     Atomic_files files;
                     outcome.line = make(item, file, files);
                     files.commit(item.mesh);
                   });
                   return outcome;
                 }};
    };
    const auto tell = [this](const Item& item, const std::string& status, const std::string& line) {
      said_[item.name] = {status, line};
    };
    const int threads = run_.meshes.number_of_jobs();
    exit_code_ = std::max(exit_code_, run_collection({folder, settings(left_out), items, job, threads, tell}));
  }

  /// In the step that was run last. A file may also be one of an earlier run.
  bool is_done(const Item& item) const { return said_.at(item.name).first == "OK"; }

  /// The maps of all meshes, and of the template, which need not be one of them.
  void map_meshes()
  {
    items_ = items_of(run_.meshes, {{"--output", folder_}});
    std::vector<Item> all = items_;
    template_ = {options_.template_mesh, ""};
    std::error_code none;
    for(const Item& item : items_)
      if(!options_.template_mesh.empty() && fs::equivalent(item.mesh, options_.template_mesh, none))
        template_ = item;
    if(!template_.mesh.empty() && template_.name.empty()) {
      template_.name = "template of the atlas";
      all.push_back(template_);
    }
    run_step(
      folder_ + "/spheres", not_of_maps, all, [](const Item&) { return Files(); },
      [this](const Item& item, const std::string& sphere, Atomic_files& files) {
        Mapping_options one = run_.options;
        one.input = item.mesh;
        Mapped_mesh input;
        read_input(one, input);
        check_orientation(item.mesh, input);
        std::ostream& file = files.open(sphere);
        map_input(one, input);
        write_mesh(file, {}, input.mesh(), input.sphere, Surface::SPHERE);
        return std::to_string(input.mesh().number_of_vertices()) + " vertices, " + input.result.method + " map" +
               (was_mended(input.prepared) ? ", prepared" : "");
      });
    for(const Item& item : items_)
      if(is_done(item)) {
        mapped_.push_back(item);
        if(template_.mesh.empty())
          template_ = item;
      }
    if(!template_.mesh.empty() && !is_done(template_))
      throw Refusal(said_.at(template_.name).first, template_.mesh, "is the template, and has no map",
                    "name another --template");
    check_number(mapped_.size(), "could be mapped");
  }

  void check_number(std::size_t meshes, const std::string& what) const
  {
    if(meshes < 2)
      throw Refusal(Error_code::EMPTY_MESH, folder_,
                    "of " + std::to_string(items_.size()) + " meshes " + std::to_string(meshes) + ' ' + what,
                    "statistics need two or more; the lines of the others say what is wrong");
  }

  /// The meshes that have a map, sampled where their registered maps have the directions of the atlas. `first` is the
  /// template of the first round, whose map gives the directions if the atlas has its faces.
  void register_meshes(int round, const Mapped_file& to, const Mapped_file& first)
  {
    Mapped_mesh target;
    read_mapped(run_.options, to, round == 1 ? run_.options.prepare : Prepare::NO, target); // a mean is a sphere
    if(round == 1) {
      mesh_ = options_.faces == "icosphere" ? SP::icosphere_of_atlas(options_.level)
                                            : Atlas_mesh{target.mesh(), target.sphere};
    }
    run_step(
      folder_of(round), not_of_shapes, mapped_,
      [&](const Item& item) {
        return Files{sphere_of(item), to.mesh, to.sphere, first.sphere};
      },
      [&](const Item& item, const std::string& shape, Atomic_files& files) {
        std::ostream& file = files.open(shape);
        Mapped_mesh input;
        read_mapped(run_.options, {item.mesh, sphere_of(item)}, run_.options.prepare, input);
        std::ostringstream line;
        line.precision(2);
        if(item.mesh == to.mesh)
          line << "the template";
        else {
          const SP::Registration_result found = SP::register_maps(
            CGAL::Sequential_tag(), SP::mapped_mesh(input.mesh(), as_map(input.sphere)),
            SP::mapped_mesh(target.mesh(), as_map(target.sphere)), as_map(input.sphere), {}, {}, stopped_by_signals());
          stop_if_interrupted(item.mesh);
          if(!found)
            throw Refusal(found.error, item.mesh, "could not be registered: " + found.detail, "");
          line << "registered by " << found.start << ", mismatch of features " << found.mismatch_before << " -> "
               << found.mismatch << ", distortion " << found.distortion;
        }
        write_mesh(file, {Mesh_format::PLY, options_.ascii}, mesh_->mesh,
                   SP::shape_at(CGAL::Sequential_tag(), SP::mapped_mesh(input.mesh(), as_map(input.sphere)), *mesh_),
                   Surface::SHAPE);
        return line.str();
      });
  }

  std::vector<SP::Shape_points> read_shapes(int round)
  {
    std::vector<SP::Shape_points> shapes;
    names_.clear();
    for(const Item& item : mapped_)
      if(is_done(item)) {
        names_.push_back(item.name);
        shapes.push_back(read_mesh(folder_of(round) + '/' + item.name + ".ply").mesh.points());
        stop_if_interrupted(folder_);
      }
    check_number(shapes.size(), "could be registered");
    return shapes;
  }

  /// The mean of the shapes of the round before. Files that have these contents stay as they are, so that what was
  /// registered to them does, too.
  Mapped_file write_template(int round, std::vector<SP::Shape_points> shapes) const
  {
    const Mapped_file file = template_of(round);
    Atomic_file::create_folder(folder_ + "/templates");
    const std::vector<Point> mean =
      SP::mean_shape(all_cores, *mesh_, std::move(shapes), placement_of(options_), stopped_by_signals());
    for(const auto& [output, of_points, surface] :
        {std::tuple(file.mesh, mean, Surface::SHAPE), std::tuple(file.sphere, mesh_->directions, Surface::SPHERE)}) {
      std::ostringstream text;
      write_mesh(text, {}, mesh_->mesh, of_points, surface);
      std::ifstream old(output, std::ios::binary);
      if(std::string(std::istreambuf_iterator<char>(old), {}) == text.str())
        continue;
      Atomic_files out;
      out.open(output) << text.str();
      out.commit();
    }
    return file;
  }

  /// `mean.ply`, `variance.ply`, `scores.csv`, `quality.csv`, of every mode the mean plus and minus two standard
  /// deviations, `modes/mode_K_plus.ply` and `_minus.ply`; and `report.json`, the first one: `report`, to which they
  /// are added. Returns what was found, in lines without the end of the last one, and the number of modes.
  std::pair<std::string, std::size_t> write_statistics(std::vector<SP::Shape_points> shapes, Json& report)
  {
    const auto open = [this](const std::string& file) -> std::ostream& { return run_.open(folder_ + '/' + file); };
    const auto [alignment, weights, statistics] =
      SP::atlas_statistics(all_cores, *mesh_, shapes, placement_of(options_), options_.modes, stopped_by_signals());
    const int groups = shapes.size() <= most_left_out_alone ? static_cast<int>(shapes.size()) : groups_beyond;
    const SP::Model_quality quality =
      SP::model_quality(all_cores, shapes, weights, groups, random_shapes, 1, stopped_by_signals());
    const std::vector<double>& errors = quality.generalization;
    const double variance = statistics.total_variance;

    report["alignment"] = {{"converged", alignment.has_converged}, {"iterations", alignment.iterations}};
    Json motions = Json::array();
    for(std::size_t i = 0; i < alignment.motions.size(); ++i) {
      const SP::Similarity& motion = alignment.motions[i];
      motions.push_back({{"name", names_[i]},
                         {"scale", motion.scale},
                         {"rotation", motion.rotation},
                         {"translation", motion.translation}});
    }
    report["alignment"]["motions"] = std::move(motions);
    report["total_variance"] = variance;
    Json rows = Json::array();
    double explained = 0;
    for(const double v : statistics.variances) {
      explained += v;
      rows.push_back({{"variance", v},
                      {"standard_deviation", std::sqrt(v)},
                      {"explained", v / variance},
                      {"explained_so_far", explained / variance}});
    }
    report["modes"] = std::move(rows);
    report["compactness_by_modes"] = quality.compactness;
    report["left_out"] = {{"groups", groups}, {"root_mean_square_by_modes", errors}};
    report["specificity"] = {{"random_shapes", random_shapes},
                             {"mean_by_modes", quality.specificity},
                             {"standard_error_by_modes", quality.specificity_error}};

    const Output_format ply = {Mesh_format::PLY, options_.ascii};
    write_json(open("report.json"), report);
    write_mesh(open("mean.ply"), ply, mesh_->mesh, statistics.mean, Surface::SHAPE);
    std::vector<double> deviations = SP::vertex_variances(all_cores, shapes, stopped_by_signals());
    std::transform(deviations.begin(), deviations.end(), deviations.begin(), [](double v) { return std::sqrt(v); });
    write_coloured_ply(open("variance.ply"), options_.ascii, mesh_->mesh, statistics.mean, "standard_deviation",
                       deviations);
    for(std::size_t k = 0; k < statistics.modes.size(); ++k)
      for(const auto& [word, sign] : {std::pair("plus", 1.), std::pair("minus", -1.)}) {
        std::vector<double> scores(k + 1, 0);
        scores[k] = sign * deviations_shown * std::sqrt(statistics.variances[k]);
        write_mesh(open("modes/mode_" + std::to_string(k + 1) + '_' + word + ".ply"), ply, mesh_->mesh,
                   SP::shape_of_scores(statistics, scores), Surface::SHAPE);
      }
    write_scores(open("scores.csv"), names_, statistics);
    write_quality(open("quality.csv"), quality);
    std::ostringstream text;
    text.precision(3);
    text << shapes.size() << " shapes of " << mesh_->mesh.number_of_vertices()
         << " vertices; root mean square distance from "
         << "the mean "
         << std::sqrt(variance * (static_cast<double>(shapes.size()) - 1) / static_cast<double>(shapes.size()));
    if(!statistics.modes.empty())
      text << "; the first mode explains " << 100 * statistics.variances[0] / variance << " % of the variance, all "
           << statistics.modes.size() << " written modes " << 100 * explained / variance << " %";
    text << "\nleave-out error: " << errors.front() << " with the mean of the other shapes, " << errors.back()
         << " with all of their modes (" << errors.size() - 1
         << ")\nspecificity: a random shape of the model with all modes (" << quality.specificity.size() - 1 << ") is "
         << quality.specificity.back() << " +- " << quality.specificity_error.back() << " from the nearest shape";
    return {text.str(), statistics.modes.size()};
  }

  const Atlas_options& options_;
  Run& run_;
  const std::string folder_;
  std::vector<Item> items_, mapped_;
  std::vector<std::string> names_; ///< of the shapes that have been read
  Item template_;
  std::optional<Atlas_mesh> mesh_;                                  ///< from the first round on
  std::map<std::string, std::pair<std::string, std::string>> said_; ///< by the name of the item: status, line
  int exit_code_ = 0;
};

Work atlas_work()
{
  const auto own = std::make_shared<Atlas_options>();
  Work work = {[own](Run& run) { Atlas(*own, run).run(); }};
  Options& options = work.options;
  options("--template", own->template_mesh,
          "The mesh to which all are registered first: one of IN or another one [the first of IN that has a map]");
  options("--rounds", own->rounds,
          "Number of rounds of registration; from the second round on, the template is the mean of the round before")
    .in("[1,100]");
  options("--faces", own->faces, "All shapes get the vertices and faces of an icosphere, or of the template")
    .of({"icosphere", "template"});
  options("--level", own->level, "The icosphere has 10 * 4^LEVEL + 2 vertices")
    .in("[0," + std::to_string(SP::largest_icosphere_level) + ']');
  options("--align", own->placement,
          "What is removed before shapes are compared: none (nothing), centre (translations), rigid (rotations, too: "
          "generalized Procrustes alignment), similarity (sizes, too)")
    .of({"none", "centre", "rigid", "similarity"});
  options("--modes", own->modes, "Largest number of principal components to write").in("[0,1000000]");
  options("--ascii", own->ascii, "Write PLY files as text instead of little-endian binary");
  work.reads = [own](const Request&) {
    return Work::Files(2, {"--template", own->template_mesh}); // to be mapped, and to be registered
  };
  work.writes = [own](const Request& request) { return files_of(*own, request.file()); };
  return work;
}

} // namespace

Step atlas_step()
{
  return {
    "atlas",
    "Mean shape and principal components of many meshes",
    {Takes::TOGETHER, "isometric", "conformal", Takes::NO_SPHERE, Prepare::ALL, "the template, too"},
    {{"-o,--output",
      "Output folder: mean.ply; variance.ply, coloured; modes/, the mean plus and minus two standard deviations of "
      "each mode; scores.csv; quality.csv, compactness, generalization and specificity by the number of modes; "
      "report.json; and intermediate results in spheres/, registered/ and templates/",
      {},
      Output::FOLDER,
      Output::REQUIRED}},
    atlas_work,
    "atlas scans/ -o atlas/",
    "All shapes get the same vertices and faces. If some meshes were refused, the exit code is 1 although an atlas was "
    "written. The same command resumes a run that was stopped, and brings an atlas up to date: only new and "
    "edited meshes are mapped."};
}

} // namespace tool
