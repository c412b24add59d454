// SPDX-License-Identifier: GPL-3.0-or-later

#include "collections/mesh_collection.h"

#include "collections/compute_in_parallel.h"
#include "collections/results.h"
#include "input/files.h"
#include "input/mesh_format.h"
#include "output/atomic_file.h"
#include "system/interruption.h"
#include "system/terminal.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <system_error>
#include <thread>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace tool {
namespace {

namespace fs = std::filesystem;

/// Where files are: without links, but for the file itself. Remembers the last folder.
class Places {
public:
  fs::path operator()(const fs::path& file)
  {
    if(file.parent_path() != parent_ || canonical_.empty()) {
      parent_ = file.parent_path();
      canonical_ = place_of(parent_);
    }
    return canonical_ / file.filename();
  }

private:
  fs::path parent_, canonical_;
};

bool is_in(const fs::path& file, const fs::path& folder)
{
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

fs::path common_folder(const fs::path& a, const fs::path& b)
{
  fs::path common;
  const auto end = std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first;
  for(auto part = a.begin(); part != end; ++part)
    common /= *part;
  return common;
}

/// Names of files in `root` by their places.
std::vector<Item> named(const std::vector<std::pair<std::string, fs::path>>& files, const fs::path& root)
{
  std::unordered_map<std::string, int> count;
  const auto name = [&root](const fs::path& place) {
    return without_extension(place.lexically_relative(root).string());
  };
  for(const auto& [mesh, place] : files)
    ++count[name(place)];
  std::vector<Item> items;
  for(const auto& [mesh, place] : files)
    items.push_back({mesh, count[name(place)] == 1 ? name(place) : place.lexically_relative(root).string()});
  return items;
}

/// Program, settings, and versions of the files besides the mesh: another result is to be expected if any of them
/// differs.
std::string settings_of(const Collection& collection, const Job& job)
{
  std::string text = this_program() + ' ' + collection.settings;
  for(const std::string& file : job.inputs) {
    const File_version version = version_of(file);
    text += '\n' + file + ' ' + std::to_string(version.bytes) + ' ' + std::to_string(version.changed);
  }
  return text;
}

std::string database_of(const Collection& collection) { return collection.folder + "/meshes.db"; }

/// Whether the refusal is about the mesh as it was, not about what was away, perhaps for a moment only.
bool is_about_mesh(const Refusal& refusal, const std::string& mesh, const Job& job, const File_version& version)
{
  const std::string what = refusal.what();
  const auto is_away = [&what](const std::string& file) {
    return what.compare(0, file.size() + 1, file + ':') == 0 && version_of(file).bytes < 0;
  };
  return !version.hash.empty() && version_with_hash(mesh).hash == version.hash &&
         std::none_of(job.inputs.begin(), job.inputs.end(), is_away);
}

/// All outputs, none of which would take the place of another one, or of what is read.
std::vector<std::string> checked_outputs(const Collection& collection)
{
  Places place;
  std::unordered_map<std::string, std::string> files; // by place: what each is
  for(const char* end : {"", "-wal", "-shm", "-journal"})
    if(!collection.folder.empty())
      files.emplace(place(database_of(collection) + end).string(), "the results of the run");
  for(const Item& item : collection.items) {
    files.emplace(place(item.mesh).string(), "the mesh " + item.mesh);
    for(const std::string& input : collection.job(item).inputs)
      files.emplace(place(input).string(), input + ", which is read");
  }
  std::vector<std::string> outputs;
  for(const Item& item : collection.items)
    for(const std::string& output : collection.job(item).outputs) {
      const auto [other, is_new] = files.emplace(place(output).string(), "an output for " + item.mesh);
      require(is_new, "--output", "'" + output + "' would overwrite " + other->second);
      outputs.push_back(output);
    }
  for(const std::string& output : outputs)
    for(fs::path folder = place(output).parent_path(); folder.has_relative_path(); folder = folder.parent_path())
      if(const auto file = files.find(folder.string()); file != files.end())
        require(false, "--output", "'" + output + "' would be in " + file->first + ", which is " + file->second);
  return outputs;
}

} // namespace

std::vector<std::string> Collection_options::meshes() const
{
  std::vector<std::string> files = list_meshes(names);
  if(files.empty())
    refuse_file(inputs.empty() ? list : inputs.front(), "has no mesh file",
                std::string("meshes are read from ") + mesh_extensions + " files");
  return files;
}

int Collection_options::number_of_jobs() const
{
  return static_cast<int>(jobs.value_or(std::max(1u, std::thread::hardware_concurrency())));
}

std::vector<Item> items_of(const Collection_options& options, const std::vector<File_option>& other_folders)
{
  Places place;
  fs::path root;
  std::vector<fs::path> left_out;
  std::unordered_set<std::string> named_files; // which are meant wherever they are
  for(const std::string& input : options.names) {
    std::error_code none;
    const bool is_folder = fs::is_directory(input, none);
    if(!is_folder)
      named_files.insert(place(input).string());
    const fs::path base = place_of(is_folder ? fs::path(input) : fs::path(input).parent_path());
    root = root.empty() ? base : common_folder(root, base);
    for(const auto& [option, folder] : other_folders)
      if(const fs::path other = place_of(folder); is_folder && !folder.empty() && is_in(other, base)) {
        require(other != base, option, "'" + folder + "' is the folder of the meshes; name another one, or one in it");
        left_out.push_back(other);
      }
  }
  std::unordered_set<std::string> known;
  std::vector<std::pair<std::string, fs::path>> files;
  for(const std::string& mesh : options.meshes()) {
    const fs::path there = place(mesh);
    const auto is_around = [&](const fs::path& folder) { return is_in(there, folder); };
    const bool is_output =
      named_files.count(there.string()) == 0 && std::any_of(left_out.begin(), left_out.end(), is_around);
    if(!is_output && known.insert(there.string()).second)
      files.emplace_back(mesh, there);
  }
  if(files.empty())
    refuse_file(root.string(), "has no meshes except outputs of an earlier run", "name other meshes");
  return named(files, root);
}

std::map<std::string, std::string> spheres_in(const std::string& folder)
{
  std::map<std::string, std::string> by_name;
  if(folder.empty())
    return by_name;
  if(std::error_code none; !fs::is_directory(folder, none))
    refuse_file(folder, "is not a folder, but there are several meshes", "name the folder of their spheres");
  std::vector<std::pair<std::string, fs::path>> files;
  for(const std::string& mesh : list_meshes({folder}))
    files.emplace_back(mesh, mesh);
  for(const auto& [mesh, name] : named(files, folder)) {
    by_name[name] = mesh;
    if(fs::path(mesh).lexically_relative(folder).string() == name) // there are others
      by_name.emplace(without_extension(name), "");
  }
  return by_name;
}

int run_collection(const Collection& collection)
{
  watch_for_interruption();
  const std::vector<std::string> all_outputs = checked_outputs(collection);
  const std::vector<Item>& items = collection.items;
  std::optional<Results> results;
  if(!collection.folder.empty()) {
    Atomic_file::create_folder(collection.folder);
    results.emplace(database_of(collection));
    Atomic_file::remove_leftovers(collection.folder, all_outputs); // nobody else's: there is one run at a time
  }

  std::vector<std::optional<Results::Row>> rows(items.size());
  std::vector<std::size_t> missing;
  for(std::size_t i = 0; i < items.size(); ++i) {
    const Job job = collection.job(items[i]);
    if(results)
      rows[i] = results->current(items[i].name, items[i].mesh, settings_of(collection, job));
    if(rows[i] && !are_versions(rows[i]->outputs, job.outputs))
      rows[i].reset();
    if(!rows[i])
      missing.push_back(i);
  }
  const std::size_t earlier = items.size() - missing.size();
  std::size_t done = earlier;
  {
    Progress_bar bar("meshes");
    std::size_t printed = 0;
    const auto print = [&] { // in the order of the items, whatever the threads do
      bar.hide();
      for(; printed < items.size() && rows[printed]; ++printed)
        std::cout << (rows[printed]->status == "OK" ? items[printed].mesh + ": " : "") << rows[printed]->message
                  << '\n';
      flush_standard_output();
      bar.show(static_cast<double>(done) / static_cast<double>(items.size()));
    };
    print();
    compute_in_parallel(missing.size(), collection.threads, [&](std::size_t k) -> Store {
      const std::size_t i = missing[k];
      const Job job = collection.job(items[i]);
      const std::string settings = settings_of(collection, job);
      File_version version;
      Outcome outcome;
      outcome.refusal = guarded(items[i].mesh, [&] {
        version = version_with_hash(items[i].mesh);
        if(version.hash.empty())
          check_readable(items[i].mesh);
        for(const fs::path output : job.outputs)
          Atomic_file::create_folder(output.parent_path().string());
      });
      std::vector<File_version> before;
      std::transform(job.outputs.begin(), job.outputs.end(), std::back_inserter(before), version_of);
      if(!outcome.refusal)
        outcome = job.run();
      if(outcome.refusal && was_interrupted())
        return nullptr;
      // not for the mesh, but for what all meshes have in common: there is no use in going on
      if(outcome.refusal && (outcome.refusal->code() == unwritable_file || outcome.refusal->code() == opencl_error))
        throw Refusal(*outcome.refusal);
      const bool is_known = !outcome.refusal || is_about_mesh(*outcome.refusal, items[i].mesh, job, version);
      for(std::size_t o = 0; o < before.size() && outcome.refusal && is_known; ++o)
        if(std::error_code none; before[o].bytes >= 0 && version_of(job.outputs[o]).changed == before[o].changed)
          fs::remove(job.outputs[o], none); // an older one
      const std::string outputs = versions_of(job.outputs);
      const Results::Row row = outcome.refusal
                                 ? Results::Row{outcome.refusal->code(), outcome.refusal->what(), outputs, ""}
                                 : Results::Row{"OK", outcome.line, outputs, ""};
      return [&, i, settings, version, row, is_known] {
        if(results && is_known)
          results->put(items[i].name, items[i].mesh, version, settings, row);
        rows[i] = row;
        ++done;
        print();
      };
    });
  }
  const std::string prefix = collection.folder.empty() ? "" : collection.folder + ": ";
  if(done < items.size())
    throw Refusal("INTERRUPTED", collection.folder.empty() ? items.front().mesh : collection.folder,
                  "interrupted with " + std::to_string(done) + " of " + std::to_string(items.size()) + " meshes done",
                  collection.folder.empty() ? "" : "the same command resumes from there");
  for(std::size_t i = 0; i < items.size() && collection.tell; ++i)
    collection.tell(items[i], rows[i]->status, rows[i]->message);
  const auto refused =
    std::count_if(rows.begin(), rows.end(), [](const std::optional<Results::Row>& row) { return row->status != "OK"; });
  std::cout << prefix << items.size() << (items.size() == 1 ? " mesh, " : " meshes, ") << refused << " refused";
  if(earlier > 0)
    std::cout << ", " << earlier << " done by an earlier run";
  std::cout << std::endl;
  if(refused > 0)
    std::cerr << "spherical-parameterization: " << prefix << refused << " of " << items.size()
              << " meshes were refused; their lines on the standard output say why" << std::endl;
  return refused > 0 ? 1 : 0;
}

} // namespace tool
