// SPDX-License-Identifier: GPL-3.0-or-later
// What the tool shows on a terminal while it works.

#include "helpers/meshes.h"
#include "helpers/tool.h"

#include <catch2/catch.hpp>

#include <array>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

using namespace test;

namespace {

/// What the tool writes to a terminal of so many columns that is its standard error.
std::string shown_on_terminal(const std::vector<std::string>& arguments, unsigned short columns)
{
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  REQUIRE(terminal >= 0);
  REQUIRE((grantpt(terminal) == 0 && unlockpt(terminal) == 0));
  const std::string name = ptsname(terminal);
  const int other_end = open(name.c_str(), O_RDWR | O_NOCTTY); // until it is closed there is no end to what can be read
  REQUIRE(other_end >= 0);
  winsize size = {};
  size.ws_col = columns;
  size.ws_row = 25;
  REQUIRE(ioctl(terminal, TIOCSWINSZ, &size) == 0);

  std::string text;
  std::thread reader([&] {
    std::array<char, 4096> buffer;
    for(ssize_t n; (n = read(terminal, buffer.data(), buffer.size())) > 0;)
      text.append(buffer.data(), static_cast<std::size_t>(n));
  });
  std::vector<std::string> command = {"/bin/sh", "-c", "terminal=$1; shift; exec \"$0\" \"$@\" 2> \"$terminal\"", TOOL,
                                      name};
  command.insert(command.end(), arguments.begin(), arguments.end());
  const Process_result run = run_process(command);
  close(other_end);
  reader.join();
  close(terminal);
  CHECK(run.exit_code == 0);
  return text;
}

} // namespace

TEST_CASE("the progress bar fits the terminal", "[tool][terminal]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", spiky_star(5, 1));
  const auto columns = GENERATE(std::size_t(0), std::size_t(40), std::size_t(64), std::size_t(200)); // 0: unknown
  const std::string text = shown_on_terminal({"map", input, "-o", scratch / "out.off", "--policy", "sequential"},
                                             static_cast<unsigned short>(columns));
  std::size_t longest = 0, line = 0;
  for(const char c : text) {
    line = c == '\r' || c == '\n' ? 0 : line + 1;
    longest = std::max(longest, line);
  }
  CAPTURE(columns, text);
  CHECK(text.find('%') != std::string::npos);
  CHECK(longest < (columns == 0 ? 80 : columns)); // the last column stays free: some terminals would break the line
  CHECK(longest > (columns == 40 ? 30u : 40u));
}
