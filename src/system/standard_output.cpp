// SPDX-License-Identifier: LGPL-3.0-or-later

#include "system/standard_output.h"

#include "system/refusal.h"

#include <iostream>

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

bool is_quiet() { return quiet; }

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

} // namespace tool
