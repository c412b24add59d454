// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "system/failure.h"

#include "input/refusal.h"

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
#include <CGAL/Spherical_parameterization/OpenCL_error.h>
#endif

#include <algorithm>
#include <exception>
#include <iostream>
#include <new>

namespace tool {
namespace {

Failure failure(const std::string& code, std::string text, const std::string& build_log = "")
{
  std::replace(text.begin(), text.end(), '\n', ' '); // the user gets exactly one line
  return {code, text, build_log};
}

} // namespace

Failure guarded(const std::string& input, const std::function<void()>& action)
{
  try {
    action();
  } catch(const Refusal& refusal) {
    return failure(refusal.code(), refusal.what());
  }
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
  catch(const CGAL::Spherical_parameterization::OpenCL_error& error) {
    const std::string& log = error.build_log();
    const std::string text = error.what();
    return failure("OPENCL_ERROR",
                   input + ": " + (log.empty() ? text : text.substr(0, text.find('\n'))) +
                     (error.code() == CL_DEVICE_NOT_FOUND ? "; see the command 'devices'" : ""),
                   log);
  }
#endif
  catch(const std::bad_alloc&) {
    return failure("OUT_OF_MEMORY", input + ": not enough memory; simplify the mesh");
  } catch(const std::exception& exception) {
    return failure("INTERNAL_ERROR", input + ": " + exception.what() + "; please report this");
  }
  return {};
}

int report_failure(const Failure& failure)
{
  if(!failure)
    return 0;
  std::cerr << "spherical-parameterization: " << failure.text << std::endl;
  if(!failure.build_log.empty())
    std::cerr << failure.build_log << std::endl;
  return 1;
}

} // namespace tool
