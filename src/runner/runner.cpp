// SPDX-License-Identifier: GPL-3.0-or-later

#include "runner/step.h"

#include "input/files.h"
#include "input/mesh_format.h"
#include "output/write_vertex_data.h"
#include "system/terminal.h"

#include <CGAL/version.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <system_error>

namespace tool {
namespace {

namespace fs = std::filesystem;

bool is_folder(const std::string& file)
{
  std::error_code none; // of a file that does not exist
  return fs::is_directory(file, none);
}

/// The command line of a step, and what it stands for.
class Line {
public:
  Line(const Step& step, CLI::App& command) : step_(step), command_(command), work_(step.work())
  {
    if(step_.takes.meshes != Takes::NONE)
      step_.gives.push_back(
        {"--report", "Write results, times, memory and settings, or the error, as JSON", {}, Output::FILE});
    const auto may_be_ply = [](const Output& output) {
      const auto& all = output.extensions;
      return output.kind == Output::MESH ? all.empty() || all.front() == ".ply"
                                         : std::count(all.begin(), all.end(), ".ply") > 0;
    };
    const bool has_ply = std::any_of(step_.gives.begin(), step_.gives.end(), may_be_ply);
    carries_data_ = step_.takes.meshes == Takes::PAIR || (is_about_each() && has_ply);
    if(carries_data_)
      step_.gives.push_back(
        {"--data-output",
         std::string("Write the columns of --data, and those that the mesh has, at the vertices of the output: ") +
           data_names});
    add_inputs();
    for(const Output& output : step_.gives)
      add_output(output);
    if(carries_data_)
      all_("--data", request_.options.data,
           std::string("Values and labels at the vertices of ") +
             (step_.takes.meshes == Takes::PAIR ? "A" : "IN; of several IN the same for all") +
             ": FreeSurfer's curv, .annot and .label, GIFTI, .csv. They are written to outputs that hold them (.ply, "
             ".vtk, .vtp), as are those that the mesh has itself")
        .times(0);
    const Output* const first = step_.gives.empty() ? nullptr : &step_.gives.front();
    if(first != nullptr && first->kind == Output::MESH) {
      std::vector<std::string> words;
      for(const auto& [word, format] : output_formats())
        if(first->extensions.empty() ||
           std::count(first->extensions.begin(), first->extensions.end(), extension_of_format(word)) > 0)
          words.push_back(word);
      all_("--format", request_.format,
           "Format of the output [by its name; in a folder: " +
             (first->extensions.empty() ? "ply" : first->extensions.front().substr(1)) + ']')
        .of(words);
    }
    if(has_ply)
      all_("--ascii", request_.ascii, "Write PLY, VTK and VTP files as text instead of binary");
    if(step_.takes.prepare == Prepare::ALL)
      all_("--prepare", prepares_,
           std::string("Repair the mesh first as the command 'prepare' does: holes, handles, components, ...; ") +
             step_.takes.prepared);
    if(step_.takes.prepare == Prepare::HARMLESS)
      all_("--prepare", prepares_,
           "Repair IN first as far as its shape does not change: merge vertices at the same position, orient "
           "faces, remove repeated faces and isolated vertices. The sphere is then that of the repaired mesh "
           "('prepare --steps merge,orient' writes it)");
    if(step_.takes.meshes == Takes::PAIR) {
      all_("--sphere", request_.spheres,
           "Spheres of A and B that 'map' has written, to use instead of new maps. Cannot be combined with options "
           "that say how to map, except --max-time, which also limits the registration")
        .times(2);
      all_("--spheres", request_.spheres, "").times(2).group.clear(); // its name before
    }
    if(step_.takes.sphere == Takes::OPTION)
      all_("--sphere", request_.options.sphere,
           "Sphere of IN that 'map' has written, to use instead of a new map; for several IN the folder of their "
           "spheres. Cannot be combined with options that say how to map")
        .is("FILE|FOLDER");
    if(step_.takes.method != nullptr) {
      request_.options.method = step_.takes.method;
      request_.options.weights = step_.takes.weights;
      add_mapping_options(all_, request_.options, is_about_each());
    }
    add_options(command_, work_.options);
    add_options(command_, all_);
    command_.footer((step.notes.empty() ? "" : wrapped(step.notes) + '\n') +
                    (step.example.empty() ? "" : "Example: spherical-parameterization " + step.example + '\n') +
                    "Exit code: 0 done, 1 refused or not done (stderr says why), 2 wrong usage, 130 interrupted.");
  }

  int execute()
  {
    for(const CLI::Option* option : command_.get_options())
      if(option->count() > 0)
        request_.given[option->get_name()] = join(option->results(), ",");
    const auto check_use = [this](const Options& options) {
      for(const Option& option : options)
        require(!request_.has(option.name()) || options.is_of_use(option), option.name(),
                "requires " + option.other + (option.values.empty() ? "" : ' ' + join(option.values, " or ")));
    };
    check_use(all_);
    check_use(work_.options);
    if(!request_.spheres.empty() || request_.has("--sphere"))
      for(const Option& option : all_) {
        const bool is_allowed = option.group == general_options || option.group.empty() ||
                                option.name() == "--policy" ||
                                (option.name() == "--max-time" && !request_.spheres.empty());
        require(!request_.has(option.name()) || is_allowed, "--sphere", "excludes " + option.name());
      }
    request_.options.prepare = prepares_ ? step_.takes.prepare : Prepare::NO;
    request_.options.can_prepare_all = step_.takes.prepare == Prepare::ALL;
    if(step_.takes.method != nullptr)
      check_mapping_options(request_.options);

    if((is_about_each() || step_.takes.meshes == Takes::TOGETHER) && request_.meshes.inputs.empty() &&
       request_.meshes.list.empty())
      throw CLI::RequiredError("IN or --list");
    if(step_.takes.sphere == Takes::ARGUMENT) {
      std::vector<std::string>& inputs = request_.meshes.inputs;
      require(inputs.size() + (request_.meshes.list.empty() ? 0 : 1) >= 2, "SPHERE", "is required, behind MESH");
      request_.options.sphere = inputs.back();
      inputs.pop_back();
    }
    request_.meshes.read_list();
    const bool is_each_of_many = is_about_each() && are_many();
    if((is_each_of_many || step_.takes.meshes == Takes::TOGETHER) && request_.meshes.number_of_jobs() > 1 &&
       !request_.has("--policy"))
      request_.options.policy = "sequential"; // the other cores have meshes of their own
    return is_each_of_many ? run_many() : run_one();
  }

private:
  using Files = Work::Files;

  bool is_about_each() const { return step_.takes.meshes == Takes::EACH; }

  void add_inputs()
  {
    if(step_.takes.meshes == Takes::PAIR) {
      const std::string format = std::string("closed triangle mesh of genus 0: ") + mesh_extensions;
      all_("A", request_.options.input, "The mesh that is registered to B, a " + format).required();
      all_("B", request_.other, "The other mesh, of the same kind").required();
    }
    if(step_.takes.meshes == Takes::ONE)
      all_("QUERY", request_.options.input, std::string("Closed triangle mesh of genus 0: ") + mesh_extensions)
        .required();
    if(!is_about_each() && step_.takes.meshes != Takes::TOGETHER)
      return;
    all_("IN", request_.meshes.inputs,
         step_.takes.what != nullptr
           ? step_.takes.what
           : std::string("Closed triangle meshes of genus 0 (") + mesh_extensions + "), or folders of them")
      .is("FILE|FOLDER")
      .times(0);
    all_("--list", request_.meshes.list, "Text file with one more IN per line");
    all_("-j,--jobs", request_.meshes.jobs, "Number of meshes to work on at the same time [all cores]").in("[1,4096]");
  }

  void add_output(const Output& output)
  {
    std::string text = output.description;
    if(output.kind == Output::MESH && output.option() == "--output") {
      text += output.extensions.empty() ? std::string(": ") + mesh_names : "";
      text += ", also followed by .gz, .xz, .zst or .bz2; - is the standard output";
    }
    if(output.option() == "--output" && is_about_each() && output.kind != Output::FOLDER)
      text += "; for several IN a folder";
    Option& option = all_(output.names, request_.outputs[output.option()], text);
    option.is(output.kind == Output::FOLDER ? "FOLDER" : "FILE");
    if(output.when == Output::REQUIRED)
      option.required();
  }

  /// Throws what is wrong usage, but for names of files that meet.
  void check(const Request& request) const
  {
    for(const Output& output : step_.gives) {
      const std::string& file = request.file(output.option());
      if(file.empty() || output.kind == Output::FOLDER)
        continue;
      const bool is_named = output.kind != Output::MESH || output.option() != "--output" || request.format.empty();
      const bool is_known = file == standard_stream && (output.extensions.size() == 1 || output.kind == Output::MESH);
      if(!output.extensions.empty() && is_named && !is_known)
        require_extension(output.option(), file, output.extensions);
      if(output.kind == Output::MESH)
        request.mesh_format(output.option());
      if(output.option() == "--data-output")
        require(data_format_of_name(file).has_value(), "--data-output", "'" + file + "' must be called " + data_names);
    }
    if(work_.check)
      work_.check(request);
  }

  Files inputs(const Request& request) const
  {
    Files files = input_files(request.options);
    const auto meshes = step_.takes.meshes;
    files.front().first = meshes == Takes::PAIR ? "A" : meshes == Takes::ONE ? "QUERY" : "IN";
    for(File_option& file : files)
      if(step_.takes.sphere == Takes::ARGUMENT && file.first == "--sphere")
        file.first = "SPHERE";
    files.emplace_back("B", request.other);
    for(const std::string& sphere : request.spheres)
      files.emplace_back("--sphere", sphere);
    if(work_.reads)
      for(const File_option& file : work_.reads(request))
        files.push_back(file);
    return files;
  }

  Files outputs(const Request& request) const
  {
    Files files;
    for(const Output& output : step_.gives)
      if(const std::string& file = request.file(output.option()); output.kind != Output::FOLDER && !file.empty())
        files.emplace_back(output.option(), file);
    if(work_.writes)
      for(const File_option& file : work_.writes(request))
        files.push_back(file);
    return files;
  }

  /// Whether it is named like a file that the step writes: a folder of such a name would be an accident.
  bool looks_like_file(const std::string& output) const
  {
    const auto& extensions = step_.gives.front().extensions;
    return is_mesh_file(output) || std::count(extensions.begin(), extensions.end(), lower_case_extension(output)) > 0;
  }

  /// Throws what is wrong usage of a folder of outputs, which is then without a slash at the end.
  void check_folder()
  {
    std::string& folder = request_.outputs["--output"];
    std::error_code none;
    require(folder != standard_stream, "--output", "is the standard output; name a folder");
    require(is_folder(folder) || !fs::exists(folder, none), "--output",
            "'" + folder + "' is a file; the output of several meshes is a folder");
    require(is_folder(folder) || !looks_like_file(folder), "--output",
            "'" + folder + "' has the extension of a file; the output of several meshes is a folder");
    while(folder.size() > 1 && folder.back() == '/')
      folder.pop_back();
  }

  /// Whether there are several meshes, or one whose output goes to a folder.
  bool are_many() const
  {
    const auto& [inputs, list, jobs, names] = request_.meshes;
    const std::string& output = request_.file();
    return inputs.size() != 1 || !list.empty() || is_folder(inputs.front()) ||
           (!output.empty() && (output.back() == '/' || (step_.gives.front().kind != Output::FOLDER &&
                                                         is_folder(output) && !looks_like_file(output))));
  }

  int run_one()
  {
    if(is_about_each()) {
      request_.options.input = request_.meshes.inputs.front();
      const Output& first = step_.gives.front();
      std::string& output = request_.outputs["--output"];
      require(output.empty() || first.kind != Output::FOLDER, "--output",
              "is a folder for several meshes; for one mesh, end its name with a slash");
      if(output.empty() && first.when == Output::ALWAYS) {
        require(request_.options.input != standard_stream, "--output", "is required: the standard input has no name");
        output = without_extension(fs::path(request_.options.input).filename().string()) + first.extensions.front();
      }
    } else if(!step_.gives.empty() && step_.gives.front().kind == Output::FOLDER)
      check_folder();
    check(request_);
    Files read = inputs(request_);
    if(step_.takes.meshes == Takes::TOGETHER) {
      read.emplace_back("--list", request_.meshes.list);
      const bool has_folder = step_.gives.front().kind == Output::FOLDER; // whose meshes are outputs
      for(const Item& item : items_of(request_.meshes, {{"--output", has_folder ? request_.file() : ""}})) {
        require(item.mesh != standard_stream || !has_folder, "IN",
                "is read more than once, as the standard input cannot be; name files");
        read.emplace_back("the mesh " + item.mesh, item.mesh);
      }
    }
    check_files(read, outputs(request_));
    Run run(request_);
    const Outcome outcome = perform(step_, work_, run);
    if(!outcome.text.empty())
      std::cout << outcome.text << std::endl;
    return outcome.refusal ? exit_code_of(outcome.refusal) : run.exit_code;
  }

  /// What is asked for one of many meshes: --output is a folder, and further outputs get the names that the options say
  /// behind the names of the meshes.
  Request of_item(const Item& item, const std::map<std::string, std::string>& spheres) const
  {
    Request one = request_;
    one.options.input = item.mesh;
    one.is_one_of_many = true;
    const Output& first = step_.gives.front();
    if(!request_.file().empty()) {
      const std::string name = request_.file() + '/' + item.name;
      for(auto& [option, file] : one.outputs)
        if(option != "--output" && !file.empty()) {
          const fs::path place = name;
          const std::string side = file.substr(0, 3); // FreeSurfer's names begin with it
          file = side == "lh." || side == "rh."
                   ? (place.parent_path() / (side + place.filename().string() + file.substr(2))).string()
                   : name + '.' + file;
        }
      one.outputs["--output"] = first.kind == Output::FOLDER ? ""
                                : !request_.format.empty()   ? name + extension_of_format(request_.format)
                                : first.extensions.empty()   ? name + ".ply"
                                                             : name + first.extensions.front();
    }
    if(const auto sphere = spheres.find(item.name); sphere != spheres.end())
      one.options.sphere = sphere->second;
    else if(is_folder(request_.options.sphere))
      one.options.sphere = request_.options.sphere + '/' + item.name + ".ply"; // which is missing
    return one;
  }

  int run_many()
  {
    check_folder();
    const std::string folder = request_.file();
    require(!folder.empty() || step_.gives.front().when != Output::ALWAYS, "--output", "is required: a folder");
    for(const auto& [option, file] : request_.outputs)
      if(option != "--output") {
        require(file.empty() || !folder.empty(), "--output",
                "is required: a folder for the files '" + file + "' of several meshes");
        require(file != standard_stream, option,
                "is the standard output, which is for one mesh; name the end of a file");
        require(file.find('/') == std::string::npos, "--output",
                "is a folder: '" + file + "' is added to the names of the meshes, and may not have a '/'");
      }
    const int threads = request_.meshes.number_of_jobs();
    const std::vector<std::string>& in = request_.meshes.names;
    const bool is_one =
      in.size() == 1 && request_.meshes.list.empty() && !is_folder(in.front()) && !is_folder(request_.options.sphere);
    const auto spheres = spheres_in(is_one ? "" : request_.options.sphere);
    const auto names = [](const Files& all) {
      std::vector<std::string> files;
      for(const auto& [option, file] : all)
        if(!file.empty())
          files.push_back(file);
      return files;
    };
    const Collection collection = {
      folder, step_.name + request_.settings(),
      items_of(request_.meshes,
               {{"--output", folder},
                {step_.takes.sphere == Takes::ARGUMENT ? "SPHERE" : "--sphere", request_.options.sphere}}),
      [&](const Item& item) {
        const Request one = of_item(item, spheres);
        std::vector<std::string> read = names(inputs(one));
        read.erase(read.begin());
        return Job{read, names(outputs(one)), [this, one] {
                     Run run(one);
                     return perform(step_, work_, run);
                   }};
      },
      threads};
    request_.meshes = {}; // is copied for every mesh, as what was typed is
    request_.given.erase("IN");
    for(const Item& item : collection.items) {
      // which has no time by which a later run knows it again
      require(folder.empty() || item.mesh != standard_stream, "IN",
              "the standard input is one mesh; name a file as --output");
      if(const auto sphere = spheres.find(item.name); sphere != spheres.end() && sphere->second.empty())
        refuse_file(request_.options.sphere + '/' + item.name, "is the name of several maps",
                    "leave one of them in the folder");
    }
    const Request first = of_item(collection.items.front(), spheres);
    check(first);
    for(const auto& [option, file] : inputs(first))
      if(!file.empty() && file != first.options.input && file != first.options.sphere) {
        require(file != standard_stream, option, "is read for each mesh, as the standard input cannot be; name a file");
        check_readable(file); // one for all meshes: without it none is done
      }
    return run_collection(collection);
  }

  Step step_; ///< with --report
  CLI::App& command_;
  Work work_;
  Options all_; ///< but for those of its own
  Request request_;
  bool prepares_ = false;
  bool carries_data_ = false;
};

} // namespace

int run(int argc, char** argv, const std::vector<Step>& all)
{
  int exit_code = 0;
  CLI::App app("Spherical parameterization of closed triangle meshes of genus 0", "spherical-parameterization");
  app.set_version_flag("--version",
                       "spherical-parameterization " SPHERICAL_PARAMETERIZATION_VERSION " (CGAL " CGAL_VERSION_STR ")");
  app.formatter(help_formatter()); // of the commands, too
  app.footer("'spherical-parameterization COMMAND --help' lists the options of a command.\n" + list_of_formats() +
             "\n"
             "Example: spherical-parameterization map bunny.ply -o sphere.off --stretch-ply stretch.ply");
  app.require_subcommand(1);
  app.add_flag_callback("-q,--quiet", be_quiet, "Print nothing but errors");
  app.add_flag_callback("-v,--verbose", be_verbose,
                        "Print what was tried for the map of IN, with its outcome and time, and the memory");
  app.fallthrough(); // behind the command, too
  for(const Step& step : all) {
    CLI::App* const command = app.add_subcommand(step.name, step.summary);
    const auto line = std::make_shared<Line>(step, *command);
    command->callback([line, &exit_code] { exit_code = line->execute(); });
  }
  if(const auto text = manual(app, all, argc, argv)) {
    std::cout << *text;
    flush_standard_output();
    return 0;
  }
  std::vector<std::string> words(argv + 1, argv + argc);
  for(std::string& word : words) {
    const std::size_t begin = word.empty() || word[0] != '-' ? 0 : word.find('=') + 1; // of a name
    if(word.size() > begin + 1 && word[begin] == '[' && word.back() == ']')            // CLI11 takes it for a list
      word.insert(begin, "./");
  }
  std::reverse(words.begin(), words.end());
  try {
    app.parse(std::move(words));         // the last one first
  } catch(const CLI::ParseError& stop) { // also what --help and --version throw
    if(stop.get_exit_code() != 0) {
      std::cerr << "spherical-parameterization: " << usage_error(app, stop)
                << "\nRun with --help for more information.\n";
      return 2;
    }
    app.exit(stop); // prints the help or the version
  }
  if(exit_code == 0)
    flush_standard_output();
  return exit_code;
}

} // namespace tool
