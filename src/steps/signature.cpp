// SPDX-License-Identifier: GPL-3.0-or-later

#include "runner/step.h"

#include "collections/signatures.h"
#include "input/compression.h"
#include "input/files.h"

#include <iostream>
#include <sstream>

namespace tool {
namespace {

void sign_meshes(Run& run)
{
  const Batch_summary summary =
    update_index(run.meshes.meshes(), run.file(), run.meshes.number_of_jobs(), run.options.prepare != Prepare::NO);
  const std::size_t signatures = summary.meshes - summary.without_signature.size();
  run.details = {{"meshes", summary.meshes},   {"signatures", signatures},
                 {"mended", summary.mended},   {"resumed", summary.resumed},
                 {"removed", summary.removed}, {"without_signature", summary.without_signature}};
  run.commit(true); // the index is there
  for(const std::string& why : summary.without_signature)
    std::cerr << "spherical-parameterization: " << why << '\n';
  std::ostringstream text;
  text << run.file() << ": " << summary.meshes << (summary.meshes == 1 ? " mesh, " : " meshes, ") << signatures
       << (signatures == 1 ? " signature" : " signatures");
  if(summary.mended > 0)
    text << ", " << summary.mended << " of repaired meshes";
  if(summary.resumed > 0)
    text << ", " << summary.resumed << " rows from an earlier run";
  if(summary.removed > 0)
    text << ", " << summary.removed << " rows of other meshes removed";
  run.text = text.str();
  run.exit_code = summary.without_signature.empty() ? 0 : 1;
}

/// The index must not take the place of what it is made of.
void check(const Request& request)
{
  require(!is_mesh_file(request.file()), "--output",
          "'" + request.file() + "' has the extension of a mesh; the index is a database");
  require(without_compression(request.file()) == request.file(), "--output",
          "'" + request.file() + "' has the extension of a compressed file; tables and databases are not compressed");
}

Work signature_work()
{
  Work work = {sign_meshes};
  work.check = check;
  work.writes = [](const Request& request) {
    const std::string index = index_of(request.file());
    return Work::Files{{"the index", index == request.file() ? "" : index}};
  };
  return work;
}

} // namespace

Step signature_step()
{
  return {
    "signature",
    "Compute a shape descriptor of each mesh, for the command 'search'",
    {Takes::TOGETHER, nullptr, "", Takes::NO_SPHERE, Prepare::ALL, "the signature is that of the repaired mesh"},
    {{"-o,--output",
      "Output file of the index, an SQLite database with a row for each mesh. If its extension is .csv, the rows are "
      "written to it as a table, and the index is the file .db next to it",
      {},
      Output::DATABASE,
      Output::REQUIRED}},
    signature_work,
    "signature scans/ -o index.db",
    "A mesh without a signature has a row that says why, and the exit code is 1. The same "
    "command resumes a run that was stopped, and brings an index up to date: only new and edited meshes are computed, "
    "and rows of other meshes are removed."};
}

} // namespace tool
