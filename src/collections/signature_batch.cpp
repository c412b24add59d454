// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "collections/signature_batch.h"

#include "output/atomic_file.h"
#include "system/interruption.h"
#include "collections/journal.h"
#include "system/progress_bar.h"
#include "system/refusal.h"
#include "collections/signature_index.h"

#include <optional>

namespace tool {
namespace {

std::optional<std::string> name_of_line(const std::string& line)
{
  const std::optional<Signature_row> row = from_index_line(line);
  return row ? std::optional(row->name) : std::nullopt;
}

void compute_missing(const std::vector<std::string>& meshes, Signature_workers& workers, Journal& journal)
{
  std::vector<std::string> missing;
  for(const std::string& mesh : meshes)
    if(journal.lines().count(mesh) == 0)
      missing.push_back(mesh);
  const double resumed = static_cast<double>(meshes.size() - missing.size());

  Progress_bar bar;
  for(std::size_t started = 0, finished = 0; finished < missing.size();) {
    if(was_interrupted())
      throw Refusal("INTERRUPTED", journal.file(),
                    "interrupted with " + std::to_string(journal.lines().size()) + " rows done",
                    "the same command goes on from there");
    while(started < missing.size() && workers.idle() > 0)
      workers.start(missing[started++]);
    if(const std::optional<Finished_line> result = workers.wait()) {
      journal.add(result->name, result->line);
      ++finished;
    }
    bar.show((resumed + static_cast<double>(finished)) / static_cast<double>(meshes.size()));
  }
}

} // namespace

std::string journal_of(const std::string& output) { return output + ".journal"; }

Batch_summary run_batch(const std::vector<std::string>& meshes, const std::string& output, Signature_workers& workers)
{
  Journal journal(journal_of(output), index_header(), name_of_line);
  Batch_summary summary;
  summary.meshes = meshes.size();
  for(const std::string& mesh : meshes)
    summary.resumed += journal.lines().count(mesh);
  compute_missing(meshes, workers, journal);

  Atomic_file index(output);
  index.stream() << index_header() << '\n';
  for(const std::string& mesh : meshes) {
    const std::string& line = journal.lines().at(mesh);
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
