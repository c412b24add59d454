// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "collections/journal.h"

#include "system/refusal.h"

#include <array>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace tool {

Journal::Journal(const std::string& file, const std::string& header, const Name_of& name_of)
  : file_(file), descriptor_(open(file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666))
{
  if(descriptor_ < 0)
    refuse("cannot be written (" + std::generic_category().message(errno) + ")",
           "check the folder and its permissions");
  try {
    struct stat status = {}; // no link: the program that had it open has just removed it
    if(flock(descriptor_, LOCK_EX | LOCK_NB) != 0 || fstat(descriptor_, &status) != 0 || status.st_nlink == 0)
      refuse("is in use by another program",
             "wait until it ends, or choose another --output; processes of mpirun need --mpi");
    read(header, name_of);
  } catch(...) {
    close(descriptor_);
    throw;
  }
}

Journal::~Journal() { close(descriptor_); }

void Journal::add(const std::string& name, const std::string& line)
{
  write(line + '\n');
  lines_[name] = line;
}

void Journal::remove() { unlink(file_.c_str()); }

void Journal::refuse(const std::string& wrong, const std::string& remedy) const
{
  throw Refusal("UNWRITABLE_FILE", file_, wrong, remedy);
}

/// Reads the lines and cuts off what is torn.
void Journal::read(const std::string& header, const Name_of& name_of)
{
  std::string text;
  std::array<char, 1 << 16> buffer;
  for(ssize_t n; (n = ::read(descriptor_, buffer.data(), buffer.size())) != 0;) {
    if(n < 0)
      refuse("cannot be read (" + std::generic_category().message(errno) + ")", "check the disk");
    text.append(buffer.data(), static_cast<std::size_t>(n));
  }
  std::size_t begin = 0;
  for(std::size_t end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
    const std::string line = text.substr(begin, end - begin);
    if(begin == 0) {
      if(line != header)
        refuse("is not a journal of this version of the program", "remove it to start from the beginning");
      continue;
    }
    const std::optional<std::string> name = name_of(line);
    if(!name)
      break; // nothing that follows can be trusted
    lines_[*name] = line;
  }
  if(begin < text.size() && ftruncate(descriptor_, static_cast<off_t>(begin)) != 0)
    refuse("cannot be written (" + std::generic_category().message(errno) + ")", "check the disk");
  if(begin == 0)
    write(header + '\n');
}

void Journal::write(const std::string& text)
{
  for(std::size_t done = 0; done < text.size();) {
    const ssize_t n = ::write(descriptor_, text.data() + done, text.size() - done);
    if(n < 0 && errno != EINTR)
      refuse("cannot be written (" + std::generic_category().message(errno) + ")",
             "make space on the disk; the same command then resumes the work");
    done += n > 0 ? static_cast<std::size_t>(n) : 0;
  }
}

} // namespace tool
