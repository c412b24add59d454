// SPDX-License-Identifier: GPL-3.0-or-later

#include "preparation/prepare.h"

#include "system/interruption.h"
#include "system/refusal.h"

#include <nlohmann/json.hpp>

#include <functional>

namespace tool {
namespace {

Json to_json(const Defect& defect)
{
  return {{"count", defect.count}, {"first", known(defect.first >= 0, defect.first)}};
}

Json to_json(const std::vector<Loop>& loops)
{
  Json json = Json::array();
  for(const Loop& loop : loops)
    json.push_back({{"edges", loop.edges}, {"length", loop.length}, {"vertex", known(loop.vertex >= 0, loop.vertex)}});
  return json;
}

Json to_json(const std::vector<Piece>& pieces)
{
  Json json = Json::array();
  for(const Piece& piece : pieces)
    json.push_back({{"faces", piece.size.faces},
                    {"area", piece.size.area},
                    {"holes", piece.size.holes},
                    {"handles", piece.size.genus()},
                    {"vertex", known(piece.vertex >= 0, piece.vertex)},
                    {"kept", piece.is_kept}});
  return json;
}

} // namespace

Preparation prepare(const std::string& file, const Soup& soup, const Preparation_settings& settings)
{
  const std::function<void()> go_on = [&file] { stop_if_interrupted(file); };
  try {
    return SP::preparation::prepare(soup, settings, go_on);
  } catch(const SP::Error& error) {
    throw Refusal(error.code(), file, "has " + error.detail(), "");
  }
}

Json to_json(const Preparation& preparation)
{
  const Gluing_defects& d = preparation.defects;
  Json json = {{"done", sentences(preparation)},
               {"non_finite_vertices", to_json(d.non_finite_vertices)},
               {"isolated_vertices", to_json(d.isolated_vertices)},
               {"faces_with_repeated_corners", to_json(d.repeated_corners)},
               {"repeated_faces", to_json(d.repeated_faces)},
               {"merged_vertices", to_json(d.merged_vertices)},
               {"non_manifold_edges", to_json(d.non_manifold_edges)},
               {"crowded_edges", to_json(d.crowded_edges)},
               {"copies_of_non_manifold_vertices", to_json(d.non_manifold_vertices)},
               {"slits", to_json(d.slits)},
               {"reversed_faces", to_json(d.reversed_faces)},
               {"cut_edges", to_json(d.cut_edges)},
               {"components", to_json(preparation.pieces)},
               {"holes", to_json(preparation.holes)},
               {"holes_filled", preparation.is_filled},
               {"handle_loops", to_json(preparation.handles)},
               {"handles_cut_at_once", preparation.handles_cut_at_once},
               {"degenerate_faces", to_json(preparation.degenerate_faces)},
               {"degenerate_faces_removed", !preparation.has_degenerate_faces},
               {"split_edges", preparation.split_edges},
               {"turned_outwards", preparation.turned_parts > 0},
               {"wrap", nullptr}};
  if(preparation.wrap)
    json["wrap"] = {{"alpha", *preparation.wrap->alpha}, {"offset", *preparation.wrap->offset}};
  return json;
}

Json to_json(const Bounds& bounds) { return {bounds.low, bounds.high}; }

Json known(bool is_known, const Json& value) { return is_known ? value : Json(nullptr); }

} // namespace tool
