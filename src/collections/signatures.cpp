// SPDX-License-Identifier: GPL-3.0-or-later

#include "collections/signatures.h"

#include "collections/compute_in_parallel.h"
#include "input/mesh.h"
#include "mapping/prepared_mesh.h"
#include "mapping/spherical_map.h"
#include "output/atomic_file.h"
#include "output/text_writer.h"
#include "system/interruption.h"
#include "system/refusal.h"
#include "system/terminal.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <ostream>
#include <utility>

namespace tool {
namespace {

using SP::Result;

/// Whether there is a map to work with, good or bad.
bool has_map(Error_code code)
{
  return code == Error_code::OK || code == Error_code::NOT_CONVERGED || code == Error_code::NOT_BIJECTIVE;
}

/// Fills `row` but for its name. Throws.
void sign(const std::string& file, bool mends, std::optional<Prepared_mesh>* what_was_done, Signature_row& row)
{
  row.version = version_with_hash(file);
  row.mending = mends ? Mending::NOTHING_TO_DO : Mending::NOT_ASKED;
  std::optional<Prepared_mesh> prepared;
  const Mesh mesh =
    (mends ? read_prepared_mesh(file, Prepare::ALL, prepared)
           : read_mesh(file, Polygons::REFUSE, "--prepare does it", "triangulate the mesh, or use --prepare"))
      .mesh;
  if(was_mended(prepared))
    row.mending = Mending::DONE;
  if(what_was_done)
    *what_was_done = std::move(prepared);
  prepared.reset();
  row.vertices = mesh.number_of_vertices();
  Mapping_options options;
  options.method = "balanced";
  const Map_data on_one_core = {CGAL::Sequential_tag(), {}, {}}; // the others have meshes of their own
  const auto compute = [&](Sphere& sphere, const char* weights) {
    options.weights = weights;
    return map_to_sphere(mesh, sphere, options, on_one_core, [](double) { return !was_interrupted(); });
  };
  Sphere sphere;
  const Result result = compute(sphere, "clamped");
  if(!has_map(result.error))
    throw Refusal(result.error, file,
                  get_error_message(result.error) + (result.detail.empty() ? "" : ": " + result.detail), "");
  row.map = result ? "clamped" : "uncertified";
  if(result.error == Error_code::NOT_CONVERGED || (!result && result.degree != 1)) {
    Sphere barycentric;
    const Result other = compute(barycentric, "barycentric");
    if(other) {
      row.map = "barycentric";
      sphere = std::move(barycentric);
    }
  }
  row.signature = SP::shape_signature(CGAL::Sequential_tag(), mesh, as_map(sphere), stopped_by_signals());
  row.form = SP::shape_form(mesh);
}

void write_csv_header(std::ostream& out)
{
  const std::initializer_list<std::pair<const char*, std::size_t>> numbers = {
    {"girth_coarse", Shape_signature::coarse_bins},
    {"girth_fine", Shape_signature::fine_bins},
    {"limb_length", Shape_signature::limbs},
    {"limb_area", Shape_signature::limbs}};
  out << "name,vertices,status,map,message";
  for(const auto& [name, count] : numbers)
    for(std::size_t i = 0; i < count; ++i)
      out << ',' << name << '_' << i;
  out << '\n';
}

void write_csv(std::ostream& out, const Signature_row& row)
{
  Text_writer write(out);
  write(csv_quoted(row.name), ',', row.vertices > 0 ? std::to_string(row.vertices) : "", ',', csv_quoted(row.status),
        ',', csv_quoted(row.map), ',', csv_quoted(row.message));
  for(std::size_t i = 0; i < Shape_signature::size; ++i) {
    write(',');
    if(row.signature)
      write(row.signature->values[i]);
  }
  write('\n');
}

} // namespace

std::optional<Signature_row> sign_mesh(const std::string& file, bool mends, std::optional<Prepared_mesh>* what_was_done)
{
  Signature_row row;
  row.name = file;
  row.status = "OK";
  row.refusal = guarded(file, [&] { sign(file, mends, what_was_done, row); });
  if(row.refusal && was_interrupted()) // which is all that was wrong
    return std::nullopt;
  if(row.refusal) {
    if(version_with_hash(file).hash != row.version.hash) // it is away, perhaps for this moment only
      row.version.hash.clear();
    row.status = row.refusal->code();
    row.message = row.refusal->what();
    row.map.clear();
  }
  return row;
}

Batch_summary update_index(const std::vector<std::string>& meshes, const std::string& output, int threads, bool mends)
{
  Shape_index index(index_of(output), Database::Access::WRITE);
  std::vector<std::string> missing;
  std::copy_if(meshes.begin(), meshes.end(), std::back_inserter(missing),
               [&index, mends](const std::string& mesh) { return !index.is_current(mesh, mends); });
  Batch_summary summary;
  summary.meshes = meshes.size();
  summary.resumed = meshes.size() - missing.size();
  std::size_t finished = summary.resumed;
  {
    Progress_bar bar("signatures");
    compute_in_parallel(missing.size(), threads, [&](std::size_t i) -> Store {
      const std::optional<Signature_row> row = sign_mesh(missing[i], mends);
      if(!row)
        return nullptr;
      return [&index, &finished, &bar, &meshes, row] {
        index.put(*row);
        bar.show(static_cast<double>(++finished) / static_cast<double>(meshes.size()));
      };
    });
  }
  if(finished < meshes.size())
    throw Refusal("INTERRUPTED", output, "interrupted with " + std::to_string(finished) + " rows done",
                  "the same command resumes from there");

  summary.removed = index.keep_only(meshes);
  Atomic_files files;
  std::ostream* const table = output != index_of(output) ? &files.open(output) : nullptr;
  if(table)
    write_csv_header(*table);
  for(const std::string& mesh : meshes) {
    const Signature_row row = index.row(mesh).value();
    if(table)
      write_csv(*table, row);
    summary.mended += row.signature && row.mending == Mending::DONE;
    if(!row.signature)
      summary.without_signature.push_back(row.message);
  }
  files.commit();
  return summary;
}

} // namespace tool
