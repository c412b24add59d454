// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "devices_command.h"

#include "policies.h"

#include <CLI/CLI.hpp>

#include <iostream>

namespace tool {

void add_devices_command(CLI::App& app, int& exit_code)
{
  CLI::App* command = app.add_subcommand("devices", "List the execution policies of this build and what they run on");
  command->callback([&exit_code] {
    for(const Named_policy& policy : available_policies())
      std::cout << policy.name << ": " << policy.description << '\n';
    std::cout << "opencl: not available, this build has no OpenCL support\n";
    exit_code = 0;
  });
}

} // namespace tool
