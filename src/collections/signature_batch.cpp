// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "collections/signature_batch.h"

#include "collections/journal.h"
#include "collections/signature_index.h"
#include "output/atomic_file.h"
#include "system/interruption.h"
#include "system/progress_bar.h"
#include "system/refusal.h"

#include <filesystem>
#include <map>
#include <optional>

namespace tool {
namespace {

/// A line of the journal: size and time of the mesh file when its work was started, and the line of the index.
struct Journal_line {
  std::string version; ///< of the file: "bytes,modified"
  std::string index_line;
};

const std::string version_header = "bytes,modified";

/// Two versions of a file are the same if their size and the time of their last change are. Both are empty for a file
/// that is not there.
std::string version_of(const std::string& file)
{
  std::error_code error;
  const auto bytes = std::filesystem::file_size(file, error);
  if(error)
    return ",";
  const auto modified = std::filesystem::last_write_time(file, error);
  return error ? "," : std::to_string(bytes) + ',' + std::to_string(modified.time_since_epoch().count());
}

Journal_line split(const std::string& line)
{
  const std::size_t comma = line.find(',', line.find(',') + 1); // the second one
  return comma == std::string::npos ? Journal_line() : Journal_line{line.substr(0, comma), line.substr(comma + 1)};
}

std::optional<std::string> name_of_line(const std::string& line)
{
  const std::optional<Signature_row> row = from_index_line(split(line).index_line);
  return row ? std::optional(row->name) : std::nullopt;
}

/// Whether the journal has the row of a mesh file as it is now.
bool is_done(const Journal& journal, const std::string& mesh)
{
  const auto found = journal.lines().find(mesh);
  return found != journal.lines().end() && split(found->second).version == version_of(mesh);
}

void compute(const std::vector<std::string>& missing, std::size_t resumed, Signature_workers& workers, Journal& journal)
{
  const double all = static_cast<double>(resumed + missing.size());
  std::map<std::string, std::string> versions; // of the files that are worked on
  Progress_bar bar;
  for(std::size_t started = 0, finished = 0; finished < missing.size();) {
    if(was_interrupted())
      throw Refusal("INTERRUPTED", journal.file(),
                    "interrupted with " + std::to_string(resumed + finished) + " rows done",
                    "the same command resumes from there");
    for(; started < missing.size() && workers.idle() > 0; ++started) {
      versions[missing[started]] = version_of(missing[started]); // a change from here on makes it another version
      workers.start(missing[started]);
    }
    if(const std::optional<Finished_line> result = workers.wait()) {
      journal.add(result->name, versions.at(result->name) + ',' + result->line);
      versions.erase(result->name);
      ++finished;
    }
    bar.show(static_cast<double>(resumed + finished) / all);
  }
}

} // namespace

std::string journal_of(const std::string& output) { return output + ".journal"; }

Batch_summary run_batch(const std::vector<std::string>& meshes, const std::string& output, Signature_workers& workers)
{
  Journal journal(journal_of(output), version_header + ',' + index_header(), name_of_line);
  std::vector<std::string> missing;
  for(const std::string& mesh : meshes)
    if(!is_done(journal, mesh))
      missing.push_back(mesh);
  Batch_summary summary;
  summary.meshes = meshes.size();
  summary.resumed = meshes.size() - missing.size();
  compute(missing, summary.resumed, workers, journal);

  Atomic_file index(output);
  index.stream() << index_header() << '\n';
  for(const std::string& mesh : meshes) {
    const std::string line = split(journal.lines().at(mesh)).index_line;
    index.stream() << line << '\n';
    const std::optional<Signature_row> row = from_index_line(line);
    if(row && !row->signature)
      summary.without_signature.push_back(row->message);
  }
  index.commit();
  journal.remove();
  return summary;
}

} // namespace tool
