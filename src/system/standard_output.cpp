// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "system/standard_output.h"

#include "system/refusal.h"

#include <iostream>

namespace tool {

void flush_standard_output()
{
  if(!std::cout.flush())
    throw Refusal("UNWRITABLE_FILE", "standard output", "could not be written",
                  "check the space on the disk, or where the output goes");
}

} // namespace tool
