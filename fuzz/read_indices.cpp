// SPDX-License-Identifier: GPL-3.0-or-later

#include "Input_file.h"
#include "targets.h"

#include "collections/shape_index.h"
#include "system/refusal.h"

#include <fstream>
#include <iterator>
#include <string>

namespace fuzz {
namespace {

using tool::Database;
using tool::Shape_index;

/// The bytes of an index of a few meshes, one of them without a signature.
std::string good_index()
{
  const Input_file file(".db", nullptr, 0);
  Shape_index(file.name(), Database::Access::WRITE).put({"bad.off", {}, 0, "BOUNDARY", "", "it has a hole", {}, {}});
  for(const char* name : {"a.off", "b.off", "c.off"}) {
    tool::Signature_row row = {name, {7, 8, "9"}, 12, "OK", "clamped", "", {}, tool::Shape_signature()};
    row.signature->values.fill(0.01 * name[0]);
    Shape_index(file.name(), Database::Access::WRITE).put(row);
  }
  std::ifstream in(file.name(), std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

} // namespace

void read_indices(const std::uint8_t* data, std::size_t size)
{
  static const std::string good = good_index();
  std::string bytes = good;
  for(std::size_t i = 0; i + 2 < size; i += 3) // where, and what is there instead
    bytes[(data[i] + 256u * data[i + 1]) % bytes.size()] = static_cast<char>(data[i + 2]);
  const Input_file file(".db", reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  try {
    const Shape_index index(file.name(), Database::Access::READ);
    for(const char* name : {"a.off", "b.off", "c.off"})
      if(const auto row = index.row(name); row && row->signature)
        promise(index.nearest(*row->signature, 2).size() <= 2, "more neighbours than wanted");
    promise(bytes != good || index.nearest({}, 9).begin()->second == "a.off", "the nearest one is not the first");
  } catch(const tool::Refusal& refusal) {
    promise(std::string(refusal.what()).find('\n') == std::string::npos, "a refusal of several lines");
    promise(bytes != good, "a good index that is refused");
  }
}

} // namespace fuzz
