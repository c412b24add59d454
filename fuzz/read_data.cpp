// SPDX-License-Identifier: GPL-3.0-or-later

#include "check_reading.h"
#include "Input_file.h"
#include "targets.h"

namespace fuzz {

void read_data(const std::uint8_t* data, std::size_t size)
{
  if(size < 2)
    return;
  const char* const extensions[] = {".curv",      ".annot", ".label", ".csv", ".func.gii",
                                    ".label.gii", ".ply",   ".vtk",   ".vtp"};
  const Input_file file(extensions[data[0] % 9], data + 2, size - 2);
  check_data(file.name(), data[1]);
  if(data[0] % 9 > 6)
    check_file(file.name(), false);
}

} // namespace fuzz
