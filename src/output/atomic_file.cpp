// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "output/atomic_file.h"

#include "system/refusal.h"

#include <cerrno>
#include <filesystem>
#include <system_error>

#include <unistd.h>

namespace tool {

Atomic_file::Atomic_file(const std::string& file)
  : file_(file), temporary_(file + ".part" + std::to_string(getpid())) // same folder: renaming must not copy
{
  errno = 0;
  out_.open(temporary_, std::ios::binary | std::ios::trunc);
  if(!out_)
    refuse("cannot be written (" + std::generic_category().message(errno) + ")");
}

Atomic_file::~Atomic_file()
{
  out_.close();
  std::error_code ignored; // after commit() there is nothing left to remove
  std::filesystem::remove(temporary_, ignored);
}

void Atomic_file::commit() { commit_all({this}); }

void Atomic_file::commit_all(std::initializer_list<Atomic_file*> files)
{
  for(Atomic_file* file : files)
    if(file)
      file->complete();
  for(Atomic_file* file : files)
    if(file)
      file->rename();
}

void Atomic_file::complete()
{
  errno = 0;
  out_.close(); // flushes
  if(!out_)     // the reason of an earlier failure is lost
    refuse("could not be written completely" + (errno == 0 ? "" : " (" + std::generic_category().message(errno) + ")"));
}

void Atomic_file::rename()
{
  std::error_code error;
  std::filesystem::rename(temporary_, file_, error);
  if(error)
    refuse("cannot be written (" + error.message() + ")");
}

void Atomic_file::refuse(const std::string& wrong) const
{
  throw Refusal("UNWRITABLE_FILE", file_, wrong, "check the folder, its permissions and the space on the disk");
}

} // namespace tool
