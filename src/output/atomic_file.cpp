// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "output/atomic_file.h"

#include "input/mesh_format.h"
#include "output/compressing_stream.h"
#include "system/refusal.h"
#include "system/standard_output.h"

#include <cerrno>
#include <filesystem>
#include <system_error>

#include <unistd.h>

namespace tool {

namespace {

const std::string before_process = ".part";

/// In the same folder, since renaming must not copy.
std::string temporary_of(const std::string& file)
{
  const std::string name =
    file == standard_stream ? (std::filesystem::temp_directory_path() / "spherical-parameterization").string() : file;
  return name + before_process + std::to_string(getpid());
}

} // namespace

Atomic_file::Atomic_file(const std::string& file) : file_(file), temporary_(temporary_of(file))
{
  if(file == standard_stream)
    keep_standard_output_for_data();
  errno = 0;
  out_.open(temporary_, std::ios::binary | std::ios::trunc);
  if(!out_)
    refuse("cannot be written (" + std::generic_category().message(errno) + ")");
  if(const Compression compression = compression_of_name(file); compression != Compression::NONE)
    try {
      compressed_ = compressing_stream(out_, compression, file);
    } catch(...) {
      remove();
      throw;
    }
}

Atomic_file::~Atomic_file()
{
  compressed_ = nullptr;
  remove();
}

void Atomic_file::remove()
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
    throw Refusal(unwritable_file, folder, "cannot be created (" + error.message() + ")",
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

void Atomic_file::commit_all(const std::vector<Atomic_file*>& files)
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
  compressed_ = nullptr; // flushes, as the next line does
  out_.close();
  if(!out_) // the reason of an earlier failure is lost
    refuse("could not be written completely" + (errno == 0 ? "" : " (" + std::generic_category().message(errno) + ")"));
}

void Atomic_file::rename()
{
  if(file_ == standard_stream) {
    std::ifstream complete(temporary_, std::ios::binary);
    remove(); // before SIGPIPE can end the program; what is open stays readable
    if(!write_to_standard_output(complete.rdbuf()))
      refuse("could not be written completely");
    return;
  }
  std::error_code error;
  std::filesystem::rename(temporary_, file_, error);
  if(error)
    refuse("cannot be written (" + error.message() + ")");
}

void Atomic_file::refuse(const std::string& wrong) const
{
  throw Refusal(unwritable_file, file_ == standard_stream ? "standard output" : file_, wrong,
                "check the folder, its permissions and the space on the disk");
}

} // namespace tool
