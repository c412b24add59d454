// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "system/progress_bar.h"

#include <algorithm>
#include <iostream>
#include <string>

#include <unistd.h>

namespace tool {

Progress_bar::Progress_bar() : is_terminal_(isatty(STDERR_FILENO) == 1) {}

Progress_bar::~Progress_bar()
{
  if(percent_ >= 0)
    std::cerr << "\r\033[K" << std::flush; // leaves the line as it was
}

void Progress_bar::show(double fraction)
{
  constexpr int width = 40;
  const int percent = static_cast<int>(100 * std::clamp(fraction, 0., 1.));
  if(!is_terminal_ || percent == percent_)
    return;
  percent_ = percent;
  const auto filled = static_cast<std::size_t>(percent * width / 100);
  std::cerr << "\r[" << std::string(filled, '#') << std::string(width - filled, ' ') << "] " << percent << " %"
            << std::flush;
}

} // namespace tool
