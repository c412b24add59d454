// SPDX-License-Identifier: LGPL-3.0-or-later

#include "output/atomic_file.h"

#include "input/mesh_format.h"
#include "input/compression.h"
#include "system/interruption.h"
#include "system/refusal.h"
#include "system/terminal.h"

#include <cerrno>
#include <filesystem>
#include <random>
#include <system_error>
#include <unordered_set>

#include <fcntl.h>
#include <unistd.h>

namespace tool {

namespace {

const std::string before_number = ".part";

/// What the name of the temporary file of a file begins with: the name, or so much of it as leaves room for the rest.
std::string beginning_of_temporary(const std::string& file)
{
  constexpr std::size_t longest_name = 255, longest_number = 10;
  const std::size_t longest = longest_name - before_number.size() - longest_number;
  const std::size_t begin = file.rfind('/') + 1; // 0 if there is none
  if(file.size() - begin <= longest)
    return file;
  std::size_t end = begin + longest;
  while(end > begin && (file[end] & 0xc0) == 0x80) // not within a character of UTF-8
    --end;
  return file.substr(0, end);
}

/// In the same folder, since renaming must not copy.
std::string temporary_without_number(const std::string& file)
{
  if(file != standard_stream)
    return beginning_of_temporary(file) + before_number;
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::temp_directory_path(error);
  if(error)
    throw Refusal(unwritable_file, "standard output",
                  "there is no folder for temporary files (" + error.message() + ")", "set TMPDIR to one");
  return (folder / "spherical-parameterization").string() + before_number;
}

} // namespace

Atomic_file::Atomic_file(const std::string& file) : file_(file)
{
  if(file == standard_stream)
    keep_standard_output_for_data();
  open();
  if(const Compression compression = compression_of_name(file); compression != Compression::NONE)
    try {
      compressed_ = compressing_stream(out_, compression, file);
    } catch(...) {
      remove();
      throw;
    }
}

/// A new file of a name that nobody knows: in a folder that others may write to, too, there is no link of this name.
void Atomic_file::open()
{
  const std::string beginning = temporary_without_number(file_);
  std::random_device random;
  int file = -1;
  do {
    temporary_ = beginning + std::to_string(random());
    file = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while(file < 0 && errno == EEXIST);
  if(file >= 0) {
    close(file);
    out_.open(temporary_, std::ios::binary | std::ios::trunc);
  }
  if(!out_.is_open())
    refuse("cannot be written (" + std::generic_category().message(errno) + ")");
}

Atomic_file::~Atomic_file()
{
  compressed_ = nullptr;
  remove();
}

void Atomic_file::remove()
{
  out_.close();
  std::error_code ignored; // after rename() there is nothing left to remove
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

void Atomic_file::remove_leftovers(const std::string& folder, const std::vector<std::string>& files)
{
  std::unordered_set<std::string> ours;
  for(const std::string& file : files)
    ours.insert(beginning_of_temporary(file));
  std::error_code none; // what cannot be looked at stays
  for(std::filesystem::recursive_directory_iterator it(folder, none), end; it != end; it.increment(none)) {
    const std::string file = it->path().string();
    const std::size_t number = file.rfind(before_number);
    if(number != std::string::npos && ours.count(file.substr(0, number)) > 0 &&
       file.find_first_not_of("0123456789", number + before_number.size()) == std::string::npos)
      std::filesystem::remove(it->path(), none);
  }
}

void Atomic_file::complete()
{
  errno = 0;
  compressed_ = nullptr; // flushes, as the next line does
  out_.close();
  if(!out_) // the reason of an earlier failure is lost
    refuse("could not be written completely" + (errno == 0 ? "" : " (" + std::generic_category().message(errno) + ")"));
  if(file_ == standard_stream)
    return;
  const int file = ::open(temporary_.c_str(), O_RDONLY | O_CLOEXEC);
  const bool is_on_disk = file >= 0 && fsync(file) == 0;
  const int error = errno;
  if(file >= 0)
    close(file);
  if(!is_on_disk)
    refuse("could not be written completely (" + std::generic_category().message(error) + ")");
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
  const std::filesystem::file_status status = std::filesystem::status(file_, error);
  if(std::filesystem::is_fifo(status) || std::filesystem::is_character_file(status)) { // nothing to replace
    const std::ifstream complete(temporary_, std::ios::binary);
    std::ofstream special(file_, std::ios::binary);
    if(!(special << complete.rdbuf() << std::flush))
      refuse("could not be written completely");
    return;
  }
  if(std::filesystem::is_regular_file(status))
    std::filesystem::permissions(temporary_, status.permissions(), error); // stay as they were
  std::filesystem::rename(temporary_, file_, error);
  if(error)
    refuse("cannot be written (" + error.message() + ")");
}

void Atomic_file::refuse(const std::string& wrong) const
{
  throw Refusal(unwritable_file, file_ == standard_stream ? "standard output" : file_, wrong,
                "check the folder, its permissions and the space on the disk");
}

std::ostream& Atomic_files::open(const std::string& file)
{
  files_.push_back(std::make_unique<Atomic_file>(file));
  return files_.back()->stream();
}

void Atomic_files::complete()
{
  for(; completed_ < files_.size(); ++completed_)
    files_[completed_]->complete();
}

void Atomic_files::commit()
{
  complete();
  for(auto file = files_.rbegin(); file != files_.rend(); ++file)
    (*file)->rename();
}

void Atomic_files::commit(const std::string& input)
{
  complete();
  stop_if_interrupted(input);
  commit();
}

} // namespace tool
