// SPDX-License-Identifier: GPL-3.0-or-later

#include "check_reading.h"
#include "Input_file.h"
#include "targets.h"

namespace fuzz {

void read_formats(const std::uint8_t* data, std::size_t size)
{
  if(size == 0)
    return;
  const char* const extensions[] = {".gii", ".glb", ".gltf", ".white", ".gz"};
  const Input_file file(extensions[*data % 5], data + 1, size - 1);
  check_file(file.name(), false);
}

} // namespace fuzz
