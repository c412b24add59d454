// SPDX-License-Identifier: GPL-3.0-or-later

#include "runner/step.h"
#include "system/interruption.h"

#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>

#include <fcntl.h>
#include <unistd.h>

#ifdef __GLIBC__ // which the headers above define
#include <malloc.h>

using CGAL::Spherical_parameterization::large_page;

// All large arrays of this program have large pages, as those of the library have.
void* operator new(std::size_t size)
{
  void* const p = size < large_page ? std::malloc((std::max)(size, std::size_t(1)))
                                    : std::aligned_alloc(large_page, (size / large_page + 1) * large_page);
  if(!p)
    throw std::bad_alloc();
  if(size >= large_page)
    CGAL::Spherical_parameterization::use_large_pages(p, size);
  return p;
}

void operator delete(void* p) noexcept { std::free(p); }

void operator delete(void* p, std::size_t) noexcept { std::free(p); }
#endif

namespace {

/// Large arrays go back to the system as soon as they are freed, and of what small ones take 64 MB stay: to map them
/// anew took a fifth of the time of a folder of small meshes. And the stack has room: one that cannot grow later, for
/// want of memory, is a crash and not a bad_alloc. Products of Eigen's matrices take up to 256 kB of it.
[[gnu::noinline]] void manage_memory() // or main() would keep the array
{
#ifdef __GLIBC__
  constexpr std::size_t size = 1 << 19, page = 1 << 12;
  [[maybe_unused]] volatile char stack[size];
  for(std::size_t i = 0; i < size; i += page)
    stack[i] = 0;
  mallopt(M_MMAP_THRESHOLD, large_page); // fixed: what is above goes back to the system
  mallopt(M_TRIM_THRESHOLD, 1 << 26);
#endif
}

/// Or a file that is opened would get the number of a standard stream that is closed, and with it what is printed. To
/// read from it or to write to it fails as before.
void take_places_of_closed_streams()
{
  for(const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if(fcntl(stream, F_GETFD) < 0)
      open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

/// CGAL prints several lines before it throws; what the exception says is enough.
void print_nothing(const char*, const char*, const char*, int, const char*) {}

int run_guarded(int argc, char** argv)
{
  try {
    return tool::run(argc, argv, tool::steps());
  } catch(const std::bad_alloc&) {
    std::cerr << "spherical-parameterization: not enough memory" << std::endl;
  } catch(const std::exception& exception) {
    std::cerr << "spherical-parameterization: " << exception.what() << std::endl;
  }
  return 1;
}

} // namespace

int main(int argc, char** argv)
{
  take_places_of_closed_streams();
  CGAL::set_error_handler(print_nothing);
  manage_memory();
  std::signal(SIGXFSZ, SIG_IGN); // a file that exceeds its limit is then an error like a full disk
  const int exit_code = run_guarded(argc, argv);
  if(exit_code != 0)
    tool::die_if_interrupted();
  return exit_code;
}
