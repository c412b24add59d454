// SPDX-License-Identifier: GPL-3.0-or-later
// Catch's main() with one more option: where the maps of the tests are computed.

#define CATCH_CONFIG_RUNNER
#include "helpers/policies.h"

#include <catch2/catch.hpp>

#include <iostream>

int main(int argc, char* argv[])
{
  Catch::Session session;
  std::string policy = "sequential";
  session.cli(session.cli() |
              Catch::clara::Opt(policy, "sequential|tbb|opencl")["--policy"]("where maps are computed"));
  if(const int wrong_usage = session.applyCommandLine(argc, argv))
    return wrong_usage;
  try {
    if(!test::set_default_policy(policy))
      return 0;
  } catch(const std::exception& error) {
    std::cerr << error.what() << std::endl;
    return 1;
  }
  const int result = session.run();
  test::set_default_policy("sequential"); // lets go of a device while its driver is there
  return result;
}
