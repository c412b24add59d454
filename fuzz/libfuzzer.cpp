// SPDX-License-Identifier: GPL-3.0-or-later
// A program of libFuzzer for the target FUZZ_TARGET.

#include "targets.h"

#include <CGAL/assertions.h>

namespace {

void print_nothing(const char*, const char*, const char*, int, const char*) {}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  CGAL::set_error_handler(print_nothing); // what the exception says is enough
  fuzz::FUZZ_TARGET(data, size);          // what it throws ends the program, and is a finding
  return 0;
}
