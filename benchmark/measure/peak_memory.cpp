// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "measure/peak_memory.h"

#include <fstream>
#include <limits>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace benchmark {
namespace {

/// A line of /proc/self/status, in bytes.
double status(const std::string& key)
{
  std::ifstream in("/proc/self/status");
  for(std::string word; in >> word;)
    if(word == key + ':') {
      double kilobytes = 0;
      if(in >> kilobytes)
        return 1024 * kilobytes;
    }
  return std::numeric_limits<double>::quiet_NaN();
}

} // namespace

Peak_memory::Peak_memory()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  std::ofstream reset("/proc/self/clear_refs");
  reset << 5 << std::flush; // proc(5): sets VmHWM, the peak, to the present size
  before_ = reset ? status("VmRSS") : std::numeric_limits<double>::quiet_NaN();
}

double Peak_memory::growth() const { return status("VmHWM") - before_; }

} // namespace benchmark
