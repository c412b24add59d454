// SPDX-License-Identifier: GPL-3.0-or-later

#include "process_memory.h"
#include "runner/step.h"
#include "system/interruption.h"

#include <CGAL/assertions.h>

#include <csignal>
#include <exception>
#include <iostream>
#include <new>

namespace {

/// CGAL prints several lines before it throws; what the exception says is enough.
void print_nothing(const char*, const char*, const char*, int, const char*) {}

int run_guarded(int argc, char** argv)
{
  try {
    return tool::run(argc, argv, tool::steps());
  } catch(const std::bad_alloc&) {
    std::cerr << "spherical-parameterization: not enough memory" << std::endl;
  } catch(const std::exception& exception) {
    std::cerr << "spherical-parameterization: " << exception.what() << std::endl;
  }
  return 1;
}

} // namespace

int main(int argc, char** argv)
{
  CGAL::set_error_handler(print_nothing);
  tool::manage_memory();
  std::signal(SIGXFSZ, SIG_IGN); // a file that exceeds its limit is then an error like a full disk
  const int exit_code = run_guarded(argc, argv);
  if(exit_code != 0)
    tool::die_if_interrupted();
  return exit_code;
}
