// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "output/atomic_file.h"

#include "system/refusal.h"

#include <cerrno>
#include <filesystem>
#include <system_error>

#include <unistd.h>

namespace tool {

namespace {

const std::string before_process = ".part";

} // namespace

Atomic_file::Atomic_file(const std::string& file)
  : file_(file), temporary_(file + before_process + std::to_string(getpid())) // same folder: renaming must not copy
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

void Atomic_file::create_folder(const std::string& folder)
{
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if(error)
    throw Refusal("UNWRITABLE_FILE", folder, "cannot be created (" + error.message() + ")",
                  "check the folder above it, and its permissions");
}

void Atomic_file::remove_leftovers(const std::string& folder, const std::function<bool(const std::string&)>& is_ours)
{
  std::error_code none; // what cannot be looked at stays
  for(std::filesystem::recursive_directory_iterator it(folder, none), end; it != end; it.increment(none)) {
    const std::string file = it->path().string();
    const std::size_t process = file.rfind(before_process);
    if(process != std::string::npos && is_ours(file.substr(0, process)) &&
       file.find_first_not_of("0123456789", process + before_process.size()) == std::string::npos)
      std::filesystem::remove(it->path(), none);
  }
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
