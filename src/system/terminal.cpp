// SPDX-License-Identifier: LGPL-3.0-or-later

#include "system/terminal.h"

#include "system/refusal.h"

#include <algorithm>
#include <atomic>
#include <iostream>

#include <sys/ioctl.h>
#include <unistd.h>

namespace tool {
namespace {

/// Takes everything, and keeps nothing.
class Null_buffer : public std::streambuf {
  int overflow(int c) override { return traits_type::not_eof(c); }
  std::streamsize xsputn(const char*, std::streamsize size) override { return size; }
};

bool quiet = false;
bool verbose = false;

std::streambuf* standard_buffer()
{
  static std::streambuf* const buffer = std::cout.rdbuf(); // the first call is before any change
  return buffer;
}

/// " [" and "] 100 %", and the last column, at which some terminals begin a new line.
constexpr std::size_t other_columns = 10;

std::size_t width_of_bar(std::size_t phase)
{
  constexpr std::size_t smallest = 10, largest = 60, columns_if_unknown = 80;
  if(quiet || isatty(STDERR_FILENO) != 1)
    return 0;
  winsize size = {};
  const bool is_known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  const std::size_t columns = is_known ? size.ws_col : columns_if_unknown;
  const std::size_t others = phase + other_columns;
  return std::clamp(columns, smallest + others, largest + others) - others;
}

std::atomic<bool> is_there(false); ///< a bar

} // namespace

void keep_standard_output_for_data()
{
  standard_buffer();
  if(!quiet)
    std::cout.rdbuf(std::cerr.rdbuf());
}

void be_quiet()
{
  static Null_buffer* const nothing = new Null_buffer; // never freed: std::cout is flushed when all else has gone
  standard_buffer();
  quiet = true;
  std::cout.rdbuf(nothing);
}

void be_verbose() { verbose = true; }

bool is_verbose() { return verbose; }

std::string shown(const std::string& file, const char* standard_stream) { return file == "-" ? standard_stream : file; }

bool write_to_standard_output(std::streambuf* source)
{
  std::ostream out(standard_buffer());
  return (out << source) && out.flush();
}

void flush_standard_output()
{
  if(!std::cout.flush())
    throw Refusal(unwritable_file, "standard output", "could not be written",
                  "check the space on the disk, or where the output goes");
}

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
