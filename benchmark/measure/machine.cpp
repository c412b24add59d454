// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "measure/machine.h"

#include <CGAL/version.h>

#include <boost/version.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/version.h>
#endif
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
#include <CL/cl.h>
#endif

#include <ctime>
#include <fstream>
#include <thread>

namespace benchmark {
namespace {

/// What follows `key` and a colon in a file like those of /proc.
std::string value_of(const char* file, const std::string& key)
{
  std::ifstream in(file);
  for(std::string line; std::getline(in, line);)
    if(line.compare(0, key.size(), key) == 0) {
      const std::size_t begin = line.find_first_not_of(" \t", line.find(':') + 1);
      if(begin != std::string::npos)
        return line.substr(begin);
    }
  return "unknown";
}

std::string memory()
{
  const std::string kilobytes = value_of("/proc/meminfo", "MemTotal");
  return kilobytes == "unknown" ? kilobytes : std::to_string(std::stoll(kilobytes) / (1 << 20)) + " GiB";
}

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
/// Calls an OpenCL query that fills a buffer of characters, first for its size.
template <class Query>
std::string text(Query query)
{
  std::size_t size = 0;
  query(0, nullptr, &size);
  std::string buffer(size, '\0');
  query(size, buffer.data(), nullptr);
  return buffer.c_str(); // without the final zeros
}

std::string opencl_devices()
{
  cl_uint count = 0;
  clGetPlatformIDs(0, nullptr, &count);
  std::vector<cl_platform_id> platforms(count);
  if(count > 0)
    clGetPlatformIDs(count, platforms.data(), nullptr);
  std::string all;
  for(cl_platform_id platform : platforms) {
    const std::string version = text([&](std::size_t size, char* buffer, std::size_t* needed) {
      return clGetPlatformInfo(platform, CL_PLATFORM_VERSION, size, buffer, needed);
    });
    cl_uint device_count = 0;
    clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, 0, nullptr, &device_count);
    std::vector<cl_device_id> devices(device_count);
    if(device_count > 0)
      clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, device_count, devices.data(), nullptr);
    for(cl_device_id device : devices) {
      const auto info = [&](cl_device_info what) {
        return text([&](std::size_t size, char* buffer, std::size_t* needed) {
          return clGetDeviceInfo(device, what, size, buffer, needed);
        });
      };
      all +=
        (all.empty() ? "" : "; ") + info(CL_DEVICE_NAME) + ", driver " + info(CL_DRIVER_VERSION) + " (" + version + ")";
    }
  }
  return all.empty() ? "no device" : all;
}
#else
std::string opencl_devices() { return "not in this build"; }
#endif

std::string compiler()
{
#if defined(__clang__)
  return "clang " __clang_version__;
#elif defined(__GNUC__)
  return "g++ " __VERSION__;
#else
  return "unknown";
#endif
}

std::string tbb_version()
{
#ifdef CGAL_LINKED_WITH_TBB
  return TBB_VERSION_STRING;
#else
  return "not in this build";
#endif
}

std::string boost_version()
{
  return std::to_string(BOOST_VERSION / 100000) + '.' + std::to_string(BOOST_VERSION / 100 % 1000) + '.' +
         std::to_string(BOOST_VERSION % 100);
}

std::string today()
{
  const std::time_t now = std::time(nullptr);
  char buffer[32];
  std::strftime(buffer, sizeof buffer, "%Y-%m-%d %H:%M UTC", std::gmtime(&now));
  return buffer;
}

} // namespace

std::vector<std::string> machine_description()
{
  return {"processor: " + value_of("/proc/cpuinfo", "model name") + ", " +
            std::to_string(std::thread::hardware_concurrency()) + " cores; memory: " + memory(),
          "OpenCL: " + opencl_devices(),
          "compiler: " + compiler() + " (" BENCHMARK_BUILD_TYPE "); CGAL " CGAL_VERSION_STR ", Boost " +
            boost_version() + ", TBB " + tbb_version(),
          "date: " + today()};
}

} // namespace benchmark
