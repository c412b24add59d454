// SPDX-License-Identifier: GPL-3.0-or-later

#include "runner/step.h"

#include "collections/signatures.h"
#include "input/mesh_readers.h"
#include "mapping/registered_pair.h"
#include "system/interruption.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <memory>
#include <sstream>
#include <system_error>
#include <utility>

namespace tool {
namespace {

struct Search_options {
  std::string index;
  int number = 10;
  bool by_form = false;
  int rerank = 0;
  std::string changes; ///< file of where they change
  std::string picture; ///< file of the query and the meshes that are listed, side by side
};

/// How the query is registered to a mesh.
struct Comparison {
  SP::Registration_result result;
  SP::Length_changes changes;
  std::vector<double> changes_of_faces;
};

/// How the query is like a mesh in form.
struct Formal_comparison {
  double distance;  ///< of the forms
  double relevance; ///< among the candidates
};

struct Hit {
  double distance; ///< of the signatures
  std::string name;
  std::optional<Formal_comparison> form = std::nullopt;
  std::optional<Comparison> comparison = std::nullopt;
  std::optional<Refusal> refusal = std::nullopt; ///< why it could not be compared, or read for the picture

  /// Signatures say little of where things are, registered features little of what is missing: their product.
  double order() const { return distance * comparison->result.mismatch; }
};

/// So many of the nearest signatures are compared by their form, too. They have to hold the class of the query, and the
/// time of the comparison grows with their cube: 0.2 s.
constexpr std::size_t candidates_by_form = 500;

/// Orders the hits by girths, limbs and form, and by chains of similar shapes among them.
void order_by_form(std::vector<Hit>& hits, const Shape_description& query, const Shape_index& index)
{
  std::vector<Shape_description> shapes = {query};
  for(const Hit& hit : hits)
    shapes.push_back(index.description(hit.name));
  const std::vector<double> relevance = SP::relevance_of_shapes(shapes);
  for(std::size_t i = 0; i < hits.size(); ++i)
    hits[i].form = {distance(query.form, shapes[i + 1].form), relevance[i + 1]};
  std::stable_sort(hits.begin(), hits.end(),
                   [](const Hit& a, const Hit& b) { return a.form->relevance > b.form->relevance; });
}

/// Throws a `Refusal` if the hit is no file.
void check_is_file(const std::string& name)
{
  if(name == standard_stream)
    refuse_file(name, "is that of the run that made the index", "make the signature of a file");
}

/// Registers the query to the first hits, and orders these by distance times difference; those that cannot be compared
/// come behind, in their order.
void rerank(std::vector<Hit>& hits, int number, Run& run)
{
  Registration_options options = to_register(run.options, "");
  Registered_pair pair;
  read_input(options, pair.a);
  check_orientation(options.input, pair.a);
  map_input(options, pair.a);
  const auto end = hits.begin() + std::min<std::ptrdiff_t>(number, hits.end() - hits.begin());
  std::for_each(hits.begin(), end, [&](Hit& hit) {
    hit.refusal = guarded(hit.name, [&] {
      check_is_file(hit.name);
      options.other = hit.name;
      pair.b = Mapped_mesh();
      read_pair(options, pair);
      check_orientation(hit.name, pair.b);
      register_pair(options, pair);
      hit.comparison = {pair.result, pair.changes, pair.changes_of_faces};
    });
    stop_if_interrupted(run.options.input);
  });
  std::stable_sort(hits.begin(), end,
                   [](const Hit& a, const Hit& b) { return a.comparison && (!b.comparison || a.order() < b.order()); });
  run.input = std::move(pair.a);
}

/// The query, with a column for each mesh that was compared: by face, how many times lengths change on the way there.
void write_changes(const std::vector<Hit>& hits, const std::string& file, Run& run)
{
  Ply_extras extras;
  for(const Hit& hit : hits)
    if(hit.comparison) {
      const std::vector<double>& factors = hit.comparison->changes_of_faces;
      extras.of_faces.push_back({Ply_column::Type::DOUBLE, "change_" + std::to_string(extras.of_faces.size() + 1),
                                 [&factors](std::size_t f) { return factors[f]; }});
    }
  write_ply(run.open(file), false, run.mesh(), run.mesh().points(), extras);
}

/// Meshes side by side along the x axis, each scaled to area 1.
struct Row_of_meshes {
  Soup soup;
  std::vector<int> place; ///< by face: the number of its mesh
  double end = 0;         ///< of the row, on the x axis

  void add(const std::string& file, int number)
  {
    Soup mesh = read_triangles(file);
    if(mesh.triangles.empty())
      throw Refusal(Error_code::EMPTY_MESH, file, "has no faces", "");
    if(soup.points.size() + mesh.points.size() > largest_count ||
       soup.triangles.size() + mesh.triangles.size() > largest_count)
      refuse_file(file, "is too large for the picture", "list fewer meshes (-k)");
    Point low = mesh.points[0], high = low;
    for(const Point& p : mesh.points)
      for(int k = 0; k < 3; ++k) {
        low[k] = (std::min)(low[k], p[k]);
        high[k] = (std::max)(high[k], p[k]);
      }
    double half_size = 0; // of the box; halves are taken before differences, which may overflow
    for(int k = 0; k < 3; ++k)
      half_size = (std::max)(half_size, high[k] / 2 - low[k] / 2);
    for(Point& p : mesh.points)
      for(int k = 0; k < 3; ++k)
        p[k] = half_size > 0 ? (p[k] / 2 - low[k] / 2) / half_size : 0;
    const auto distance = [&](int v, int w) {
      const Point &p = mesh.points[v], &q = mesh.points[w];
      return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    };
    double area = 0;
    for(const auto& [a, b, c] : mesh.triangles) { // Heron's formula: good enough for the eye
      const double u = distance(a, b), v = distance(b, c), w = distance(c, a), s = (u + v + w) / 2;
      area += std::sqrt((std::max)(0., s * (s - u) * (s - v) * (s - w)));
    }
    const double scale = area > 0 ? 1 / std::sqrt(area) : 1;
    const int first = static_cast<int>(soup.points.size());
    double width = 0;
    for(const auto& [x, y, z] : mesh.points) {
      soup.points.push_back({end + x * scale, y * scale, z * scale});
      width = (std::max)(width, x * scale);
    }
    for(const auto& [a, b, c] : mesh.triangles)
      soup.triangles.push_back({a + first, b + first, c + first});
    place.resize(soup.triangles.size(), number);
    constexpr double gap = 0.1;
    end += width + gap;
  }
};

/// The query and the hits in a row, the query in another colour; those that cannot be read are left out, and say so.
void write_picture(std::vector<Hit>& hits, const std::string& file, Run& run)
{
  Row_of_meshes row;
  row.add(run.options.input, 0);
  for(std::size_t i = 0; i < hits.size(); ++i) {
    stop_if_interrupted(run.options.input);
    try {
      check_is_file(hits[i].name);
      row.add(hits[i].name, static_cast<int>(i + 1));
    } catch(const Refusal& refusal) {
      hits[i].refusal = refusal;
    }
  }
  constexpr Colour of_query = {230, 120, 40}, of_hits = {150, 170, 190};
  std::vector<Colour> colours;
  colours.reserve(row.place.size());
  for(const int place : row.place)
    colours.push_back(place == 0 ? of_query : of_hits);
  Ply_extras extras;
  extras.of_faces = {{Ply_column::Type::INT, "place", [&](std::size_t f) { return row.place[f]; }}};
  for(Ply_column& column : colour_columns(colours))
    extras.of_faces.push_back(std::move(column));
  write_ply(run.open(file), false, Mesh(Mesh::Unchecked(), row.soup.points, row.soup.triangles), row.soup.points,
            extras);
}

void search(const Search_options& options, Run& run)
{
  const std::string file = index_of(options.index), &query = run.options.input;
  if(std::error_code none; file != options.index && !std::filesystem::exists(file, none))
    refuse_file(options.index, "is not an index, and " + file + " does not exist",
                "write it with the command 'signature'");
  const Shape_index index(file, Database::Access::READ); // before the work
  const std::optional<Signature_row> row = sign_mesh(query, run.options.prepare != Prepare::NO, &run.input.prepared);
  if(!row)
    throw Refusal(Error_code::INTERRUPTED, query, "interrupted", "");
  if(!row->signature)
    throw Refusal(*row->refusal);
  std::vector<Hit> hits;
  const auto number = static_cast<std::size_t>(std::max(options.number, options.rerank));
  for(const auto& [distance, name] :
      index.nearest(*row->signature, options.by_form ? std::max(number, candidates_by_form) : number))
    hits.push_back({distance, name});
  if(hits.empty())
    refuse_file(file, "has no signature", "the command 'signature' says why");
  if(options.by_form)
    order_by_form(hits, {*row->signature, row->form}, index);
  const bool has_comparisons = options.rerank > 0;
  if(has_comparisons)
    rerank(hits, options.rerank, run);
  hits.resize(std::min(hits.size(), static_cast<std::size_t>(options.number)));
  if(!options.picture.empty())
    write_picture(hits, options.picture, run);
  std::ostringstream text;
  text << preparation_text(run.name_of_input(), run.input.prepared) << "distance  "
       << (options.by_form ? "   form  relevance  " : "") << (has_comparisons ? "difference   alike  " : "") << "name"
       << std::fixed;
  for(const auto& [distance, name, form, comparison, refusal] : hits) {
    Json found = {{"distance", distance}, {"name", name}};
    text << '\n' << std::setw(8) << std::setprecision(4) << distance << "  ";
    if(form) {
      found.update({{"form_distance", form->distance}, {"relevance", form->relevance}});
      text << std::setw(7) << form->distance << "  " << std::setw(9) << form->relevance << "  ";
    }
    if(comparison) {
      const SP::Registration_result& result = comparison->result;
      const double alike = 1 - comparison->changes.share_of_large;
      const char* const trust = SP::get_trust_name(result.trust());
      found.update({{"difference", result.mismatch},
                    {"alike", alike},
                    {"change_of_lengths", comparison->changes.factor.median},
                    {"stretching", result.stretching},
                    {"margin", result.margin},
                    {"trust", trust}});
      text << std::setw(10) << result.mismatch << std::setw(6) << std::setprecision(0) << 100 * alike << " %  " << name
           << ": " << trust;
    } else
      text << (has_comparisons ? "         -       -  " : "") << name;
    if(refusal) {
      found["error"] = refusal->what();
      text << ": " << refusal->what();
    }
    run.details["found"].push_back(found);
  }
  if(!options.changes.empty())
    write_changes(hits, options.changes, run);
  run.text = text.str();
}

Work search_work()
{
  const auto own = std::make_shared<Search_options>();
  Work work = {[own](Run& run) { search(*own, run); }};
  Options& options = work.options;
  options("--index", own->index,
          "Index that the command 'signature' has written; for a table .csv, the file .db next to it is read")
    .required();
  options("-k,--number", own->number, "Number of meshes to list").in("[1,2147483647]");
  options("--form", own->by_form,
          "For things that have one pose: compare the 500 nearest meshes by their form, too, and order them by chains "
          "of similar meshes");
  options("--rerank", own->rerank,
          "Compare QUERY with so many of the nearest meshes by registration, and order these by the distance times the "
          "difference of corresponding points")
    .in("[1,2147483647]");
  options(
    "--changes", own->changes,
    "With --rerank: write QUERY, as it was repaired by --prepare, with a property 'change_1', 'change_2', ... of its "
    "faces for each mesh that was compared, in the order of the lines: how many times lengths change on the way "
    "to that mesh (.ply)");
  options("--picture", own->picture,
          "Write QUERY and the meshes that are listed side by side, each scaled to the same area, with a property "
          "'place' of the faces: 0 for QUERY, 1 for the first line, ... (.ply)");
  work.check = [own](const Request&) {
    require(own->changes.empty() || own->rerank > 0, "--changes", "requires --rerank");
    for(const auto& [option, file] : {std::pair("--changes", own->changes), std::pair("--picture", own->picture)})
      if(!file.empty())
        require_extension(option, file, {".ply"});
  };
  work.writes = [own](const Request&) { return Work::Files{{"--changes", own->changes}, {"--picture", own->picture}}; };
  work.reads = [own](const Request& request) {
    Work::Files files = {{"--index", own->index}, {"--index", index_of(own->index)}};
    if(own->rerank > 0 || !own->picture.empty())
      files.emplace_back("QUERY", request.options.input); // once more
    return files;
  };
  return work;
}

} // namespace

Step search_step()
{
  return {
    "search",
    "Find the meshes with the most similar shapes, in any pose",
    {Takes::ONE, nullptr, "", Takes::NO_SPHERE, Prepare::ALL, "as 'signature --prepare' does"},
    {},
    search_work,
    "search bunny.ply --index index.db -k 5",
    "Prints a line for each mesh: the distance of its signature, and its name. Typical distances are 0.2 between poses "
    "of the same shape and 2 between different shapes. With --form also the distance of forms, and the relevance, by "
    "which the lines are ordered then, from 0 to 1. With --rerank also how much corresponding points differ, on which "
    "share of QUERY lengths change less than three times, and how far to trust that: sure, unsure or unlike."};
}

} // namespace tool
