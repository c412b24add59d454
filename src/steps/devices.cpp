// SPDX-License-Identifier: GPL-3.0-or-later

#include "runner/step.h"

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
#include <CGAL/Spherical_parameterization/OpenCL_device.h>
#endif

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <iomanip>
#include <sstream>

namespace tool {
namespace {

void print_policy(std::ostream& out, const std::string& name, const std::string& runs_on)
{
  out << name << (name == default_policy ? " (default): " : ": ") << runs_on << '\n';
}

std::string tbb_threads()
{
#ifdef CGAL_LINKED_WITH_TBB
  const int threads = tbb::this_task_arena::max_concurrency();
  return std::to_string(threads) + (threads == 1 ? " thread" : " threads");
#else
  return "not available, this build has no TBB support";
#endif
}

void print_opencl_devices(std::ostream& out)
{
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
  using namespace CGAL::Spherical_parameterization;
  const std::vector<OpenCL_device_info> devices = opencl_devices();
  std::optional<std::size_t> default_device;
  std::string why_none;
  try {
    default_device = find_opencl_device();
  } catch(const OpenCL_error& error) { // no device, or the environment asks for one that is not there
    why_none = error.what();
  }
  print_policy(out, "opencl", devices.empty() ? why_none : std::to_string(devices.size()) + " device(s)");
  out << std::fixed << std::setprecision(1);
  for(std::size_t k = 0; k < devices.size(); ++k) {
    const OpenCL_device_info& device = devices[k];
    out << "  " << k << (k == default_device ? " (default): " : ": ") << device.name << "; platform " << device.platform
        << "; driver " << device.driver << "; memory " << static_cast<double>(device.memory) / 1e9 << " GB; fp64 "
        << (device.has_fp64 ? "yes" : "no") << '\n';
  }
  if(!devices.empty() && !default_device)
    out << "  no default: " << why_none << '\n';
#else
  print_policy(out, "opencl", "not available, this build has no OpenCL support");
#endif
}

void list_devices(Run& run)
{
  std::ostringstream text;
  print_policy(text, "sequential", "one core");
  print_policy(text, "tbb", tbb_threads());
  print_opencl_devices(text);
  run.text = text.str();
  run.text.pop_back(); // the end of the last line
}

} // namespace

Step devices_step()
{
  return {
    "devices", "List the execution policies of this build and their devices", {}, {}, [] {
            return Work{list_devices}; },
    "devices"};
}

} // namespace tool
