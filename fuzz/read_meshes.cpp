// SPDX-License-Identifier: GPL-3.0-or-later

#include "check_reading.h"
#include "Input_file.h"
#include "targets.h"

#include "input/mesh_readers.h"

#include <string>

namespace fuzz {

void read_meshes(const std::uint8_t* data, std::size_t size)
{
  if(size == 0)
    return;
  const char* const extensions[] = {".off", ".ply", ".obj", ".stl", ".txt"};
  const std::string extension = extensions[*data % 5];
  const bool triangulate = *data >= 128;
  const Input_file file(extension, data + 1, size - 1);
  if(extension == ".txt") {
    try {
      tool::read_fixed_vertices(file.name(), 12);
    } catch(const tool::Refusal& refusal) {
      check_refusal(refusal);
    }
    return;
  }
  check_file(file.name(), triangulate);
}

} // namespace fuzz
