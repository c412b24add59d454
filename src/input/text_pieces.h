// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "input/mesh_readers.h"

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace tool {

/// A text in pieces of whole lines, which are as large for any number of cores; a short one is a single piece.
std::vector<std::string_view> pieces_of(std::string_view text);

/// How many lines each piece has, blank ones and comments, too.
std::vector<std::size_t> numbers_of_lines(const std::vector<std::string_view>& pieces);

/// Reads pieces on all cores, and puts them together. `read(i)` returns the points and faces of piece `i`, or nothing,
/// or throws a `Refusal`, where that is not enough. Then nothing is returned: the text has to be read as a whole, which
/// knows the places of errors.
std::optional<Soup> read_pieces(std::size_t number, const std::function<std::optional<Soup>(std::size_t)>& read);

} // namespace tool
