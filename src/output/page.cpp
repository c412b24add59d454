// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "output/page.h"

#include "system/refusal.h"

#include <boost/algorithm/string/replace.hpp>
#include <nlohmann/json.hpp>

namespace tool {

void check_size_of_page(const std::string& input, std::size_t number_of_vertices)
{
  constexpr std::size_t most = std::size_t(1) << 8 * bytes_of_vertex;
  if(number_of_vertices > most)
    throw Refusal(Error_code::TOO_LARGE, input,
                  "has " + std::to_string(number_of_vertices) + " vertices, and a page holds " + std::to_string(most),
                  "simplify the mesh");
}

std::string inside_of_page(const nlohmann::json& json)
{
  return boost::replace_all_copy(json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace), "<", "\\u003c");
}

} // namespace tool
