// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "system/refusal.h"

#include <cerrno>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace tool {

/// Keeps other processes from taking the same one as long as it is there.
class Lock {
public:
  enum class Kind {
    FILE,  ///< is created where there is none
    FOLDER ///< is there; where its file system has no locks of folders, nobody is kept out
  };

  /// Throws a `Refusal`, also if another process has it.
  Lock(const std::string& path, Kind kind)
    : descriptor_(open(path.c_str(),
                       (kind == Kind::FILE ? O_WRONLY | O_APPEND | O_CREAT : O_RDONLY | O_DIRECTORY) | O_CLOEXEC, 0666))
  {
    if(descriptor_ < 0)
      throw Refusal(unwritable_file, path, "cannot be written (" + std::generic_category().message(errno) + ")",
                    "check the folder and its permissions");
    if(flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && (kind == Kind::FILE || errno == EWOULDBLOCK)) {
      close(descriptor_);
      refuse(path);
    }
  }

  ~Lock() { close(descriptor_); }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

  /// Throws the `Refusal` of what another process has.
  [[noreturn]] static void refuse(const std::string& path)
  {
    throw Refusal(unwritable_file, path, "is in use by another program",
                  "wait until it ends, or choose another --output");
  }

private:
  int descriptor_;
};

} // namespace tool
