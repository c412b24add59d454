// SPDX-License-Identifier: LGPL-3.0-or-later

#include "system/refusal.h"

#include "system/interruption.h"

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
#include <CGAL/Spherical_parameterization/values/OpenCL_error.h>
#endif

#include <exception>
#include <iostream>
#include <new>

namespace tool {

std::optional<Refusal> guarded(const std::string& named, const std::function<void()>& action)
{
  const std::string input = named.empty() ? "the meshes" : named;
  // Ctrl-C reaches the compiler of the kernels, too, and the library says in its own words that it was interrupted.
  const auto unless_interrupted = [&input](const Refusal& refusal) {
    return was_interrupted() ? interrupted(input) : refusal;
  };
  try {
    action();
  } catch(const Refusal& refusal) {
    return refusal;
  }
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
  catch(const SP::OpenCL_error& error) {
    const std::string& log = error.build_log();
    const std::string text = error.what(); // its lines from the second on are the log
    return unless_interrupted({opencl_error, input, log.empty() ? text : text.substr(0, text.find('\n')),
                               error.code() == CL_DEVICE_NOT_FOUND ? "see the command 'devices'" : "", log});
  }
#endif
  catch(const std::bad_alloc&) {
    return Refusal(out_of_memory, input, "not enough memory", "simplify the mesh");
  } catch(const SP::Error& error) {
    return unless_interrupted({error.code(), input, without_remedy(error.what(), error.remedy()), error.remedy()});
  } catch(const std::exception& exception) {
    return unless_interrupted({internal_error, input, exception.what(), "please report this"});
  }
  return std::nullopt;
}

int exit_code_of(const std::optional<Refusal>& refusal)
{
  if(!refusal)
    return 0;
  std::cerr << "spherical-parameterization: " << refusal->what() << std::endl;
  if(!refusal->log().empty())
    std::cerr << refusal->log() << std::endl;
  return 1;
}

} // namespace tool
