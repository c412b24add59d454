// SPDX-License-Identifier: GPL-3.0-or-later

#include "Input_file.h"
#include "targets.h"

#include "collections/nearest_signatures.h"
#include "collections/signature_index.h"
#include "system/refusal.h"

#include <algorithm>
#include <string>
#include <vector>

namespace fuzz {

void read_indices(const std::uint8_t* data, std::size_t size)
{
  // The header is the same in all of them, and far too long to be found by chance.
  std::string text = tool::index_header() + '\n';
  text.append(reinterpret_cast<const char*>(data), size);
  const Input_file file(".csv", reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  try {
    const std::vector<tool::Signature_row> rows = tool::read_index(file.name());
    for(const tool::Signature_row& row : rows) {
      const auto again = tool::from_index_line(tool::to_index_line(row));
      promise(again && again->name == row.name && again->status == row.status && again->message == row.message &&
                again->vertices == row.vertices && again->signature.has_value() == row.signature.has_value() &&
                (!row.signature || again->signature->values == row.signature->values),
              "a row that comes back changed");
    }
    for(const tool::Signature_row& row : rows)
      if(row.signature) {
        const auto nearest = tool::nearest_signatures(rows, *row.signature, 3);
        promise(!nearest.empty() && nearest.front().distance == 0, "a signature that is not its own neighbour");
      }
  } catch(const tool::Refusal& refusal) {
    promise(std::string(refusal.what()).find('\n') == std::string::npos, "a refusal of several lines");
  }
}

} // namespace fuzz
