// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes as a file, for code that takes names.

#ifndef FUZZ_INPUT_FILE_H
#define FUZZ_INPUT_FILE_H

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace fuzz {

/// A file in the folder for temporary files while it lives.
class Input_file {
public:
  Input_file(const std::string& extension, const std::uint8_t* data, std::size_t size)
    : name_((std::filesystem::temp_directory_path() / ("fuzz-" + std::to_string(getpid()) + extension)).string())
  {
    std::ofstream(name_, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  }
  ~Input_file()
  {
    std::error_code ignored;
    std::filesystem::remove(name_, ignored);
  }

  Input_file(const Input_file&) = delete;
  Input_file& operator=(const Input_file&) = delete;

  const std::string& name() const { return name_; }

private:
  std::string name_;
};

} // namespace fuzz

#endif // FUZZ_INPUT_FILE_H
