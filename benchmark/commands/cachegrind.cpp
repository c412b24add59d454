// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/cachegrind.h"

#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace benchmark {
namespace {

std::string quoted(const std::string& argument)
{
  std::string result = "'";
  for(char c : argument)
    result += c == '\'' ? "'\\''" : std::string(1, c);
  return result + "'";
}

/// The total in a line "==1== D1  misses:  1,234  (1,000 rd + 234 wr)".
double total(const std::string& line)
{
  std::string digits;
  for(std::size_t i = line.find("misses:"); i < line.size() && line[i] != '('; ++i)
    if(std::isdigit(static_cast<unsigned char>(line[i])))
      digits += line[i];
  return digits.empty() ? std::numeric_limits<double>::quiet_NaN() : std::stod(digits);
}

} // namespace

bool has_valgrind() { return std::system("command -v valgrind >/dev/null 2>&1") == 0; }

Cache_misses cache_misses(const std::vector<std::string>& arguments)
{
  std::string command = "valgrind --tool=cachegrind --cache-sim=yes --I1=32768,8,64 --D1=32768,8,64 "
                        "--LL=1048576,16,64 --cachegrind-out-file=/dev/null " +
                        quoted(std::filesystem::read_symlink("/proc/self/exe").string());
  for(const std::string& argument : arguments)
    command += ' ' + quoted(argument);
  command += " 2>&1";

  Cache_misses misses;
  if(std::FILE* pipe = popen(command.c_str(), "r")) {
    char buffer[1024];
    while(std::fgets(buffer, sizeof buffer, pipe)) {
      const std::string line = buffer;
      if(line.find("== D1  misses:") != std::string::npos)
        misses.first_level = total(line);
      else if(line.find("== LLd misses:") != std::string::npos)
        misses.last_level = total(line);
    }
    pclose(pipe);
  }
  return misses;
}

} // namespace benchmark
