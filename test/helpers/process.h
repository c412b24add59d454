// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a program as a user would, without a shell in between.

#ifndef TEST_HELPERS_PROCESS_H
#define TEST_HELPERS_PROCESS_H

#include <functional>
#include <string>
#include <vector>

namespace test {

struct Process_result {
  int exit_code = -1;   ///< 128 + signal if one killed it
  std::string out, err; ///< what it wrote
  long peak_memory = 0; ///< in bytes
};

struct Process_options {
  int interrupt_after = 0;     ///< milliseconds until SIGINT is sent; 0: never
  long largest_file = 0;       ///< bytes that can be written to a file, as if the disk were full then; 0: no limit
  long address_space = 0;      ///< bytes of memory that can be had; 0: no limit
  long stack = 0;              ///< bytes of it that every thread takes; 0: as usual
  bool as_nobody = false;      ///< whether root runs it as a user who is not
  std::string directory = "."; ///< where it runs
  std::function<void(int pid)> meanwhile = [](int) {}; ///< called while it runs
};

/// Standard input is empty.
Process_result run_process(const std::vector<std::string>& command, const Process_options& options = {});

} // namespace test

#endif // TEST_HELPERS_PROCESS_H
