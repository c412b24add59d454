// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "input/readable_file.h"

#include "system/refusal.h"

#include <filesystem>
#include <fstream>
#include <system_error>

namespace tool {

void check_readable(const std::string& file)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  const auto refuse = [&file](const std::string& wrong, const std::string& remedy) {
    throw Refusal(unreadable_file, file, wrong, remedy);
  };
  if(status.type() == fs::file_type::none)
    refuse("cannot be read (" + error.message() + ")", "check its permissions and those of its folder");
  if(status.type() == fs::file_type::not_found)
    refuse("does not exist", "check the name");
  if(status.type() == fs::file_type::directory)
    refuse("is a directory", "name a file in it");
  if(status.type() != fs::file_type::regular)
    refuse("is not a regular file", "save the data to a file first");
  if(fs::file_size(file) == 0)
    refuse("is empty", "export it again");
  if(!std::ifstream(file))
    refuse("cannot be opened", "check that it may be read");
}

} // namespace tool
