// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "measure/measure.h"

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
#include <CGAL/Spherical_parameterization/OpenCL_device.h>
#endif

#include <CGAL/version.h>

#include <boost/config.hpp>
#include <boost/date_time/posix_time/posix_time.hpp>
#include <boost/version.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/version.h>
#endif
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <fstream>
#include <limits>
#include <thread>

namespace benchmark {
namespace {

/// What follows `key` and a colon in a file like those of /proc.
std::string value_of(const char* file, const std::string& key)
{
  std::ifstream in(file);
  for(std::string line; std::getline(in, line);)
    if(line.compare(0, key.size(), key) == 0)
      return line.substr(line.find_first_not_of(" \t", line.find(':') + 1));
  return "unknown";
}

/// The same in bytes, where it is given in kB.
double bytes_of(const char* file, const std::string& key)
{
  const std::string kilobytes = value_of(file, key);
  return kilobytes == "unknown" ? std::numeric_limits<double>::quiet_NaN() : 1024 * std::stod(kilobytes);
}

std::string opencl_devices()
{
  std::string all;
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
  for(const auto& device : CGAL::Spherical_parameterization::opencl_devices())
    all += (all.empty() ? "" : "; ") + device.name + ", driver " + device.driver + " (" + device.version + ", " +
           device.platform + ")";
#endif
  return all.empty() ? "no device" : all;
}

std::string tbb_version()
{
#ifdef CGAL_LINKED_WITH_TBB
  return TBB_VERSION_STRING;
#endif
  return "not in this build";
}

} // namespace

std::vector<std::string> machine_description()
{
  const double memory = bytes_of("/proc/meminfo", "MemTotal");
  return {"processor: " + value_of("/proc/cpuinfo", "model name") + ", " +
            std::to_string(std::thread::hardware_concurrency()) + " cores; memory: " +
            (memory > 0 ? std::to_string(static_cast<int>(memory / (1 << 30))) + " GiB" : "unknown"),
          "OpenCL: " + opencl_devices(),
          "compiler: " BOOST_COMPILER " (" BENCHMARK_BUILD_TYPE "); CGAL " CGAL_VERSION_STR ", Boost " BOOST_LIB_VERSION
          ", TBB " +
            tbb_version(),
          "date: " + to_iso_extended_string(boost::posix_time::second_clock::universal_time()) + " UTC"};
}

Peak_memory::Peak_memory()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  std::ofstream reset("/proc/self/clear_refs");
  reset << 5 << std::flush; // proc(5): sets VmHWM, the peak, to the present size
  before_ = reset ? bytes_of("/proc/self/status", "VmRSS") : std::numeric_limits<double>::quiet_NaN();
}

double Peak_memory::growth() const { return bytes_of("/proc/self/status", "VmHWM") - before_; }

} // namespace benchmark
