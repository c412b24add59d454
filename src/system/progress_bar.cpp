// SPDX-License-Identifier: LGPL-3.0-or-later

#include "system/progress_bar.h"

#include "system/standard_output.h"

#include <algorithm>
#include <atomic>
#include <iostream>

#include <sys/ioctl.h>
#include <unistd.h>

namespace tool {
namespace {

/// " [" and "] 100 %", and the last column, at which some terminals begin a new line.
constexpr std::size_t other_columns = 10;

std::size_t width_of_bar(std::size_t phase)
{
  constexpr std::size_t smallest = 10, largest = 60, columns_if_unknown = 80;
  if(is_quiet() || isatty(STDERR_FILENO) != 1)
    return 0;
  winsize size = {};
  const bool is_known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  const std::size_t columns = is_known ? size.ws_col : columns_if_unknown;
  const std::size_t others = phase + other_columns;
  return std::clamp(columns, smallest + others, largest + others) - others;
}

std::atomic<bool> is_there(false); ///< a bar

} // namespace

Progress_bar::Progress_bar(const std::string& phase)
  : is_only_one_(!is_there.exchange(true)), phase_(phase), width_(is_only_one_ ? width_of_bar(phase.size()) : 0)
{}

Progress_bar::~Progress_bar()
{
  hide();
  if(is_only_one_)
    is_there = false;
}

void Progress_bar::hide()
{
  if(percent_ >= 0)
    std::cerr << "\r\033[K" << std::flush; // leaves the line as it was
  percent_ = -1;
}

void Progress_bar::show(double fraction)
{
  const int percent = static_cast<int>(100 * std::clamp(fraction, 0., 1.));
  if(width_ == 0 || percent == percent_)
    return;
  percent_ = percent;
  const std::size_t filled = static_cast<std::size_t>(percent) * width_ / 100;
  std::cerr << '\r' << phase_ << " [" << std::string(filled, '#') << std::string(width_ - filled, ' ') << "] "
            << percent << " %" << std::flush;
}

} // namespace tool
