// SPDX-License-Identifier: GPL-3.0-or-later

#include "helpers/process.h"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <grp.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace test {
namespace {

/// A file without a name: unlike a pipe it never makes the writer wait for us.
struct Capture {
  std::FILE* file = std::tmpfile();

  ~Capture() { std::fclose(file); }

  std::string text()
  {
    std::string all;
    std::array<char, 4096> buffer;
    std::rewind(file);
    for(std::size_t n; (n = std::fread(buffer.data(), 1, buffer.size(), file)) > 0;)
      all.append(buffer.data(), n);
    return all;
  }
};

void limit(decltype(RLIMIT_AS) resource, long value)
{
  if(value <= 0)
    return;
  const rlimit both = {static_cast<rlim_t>(value), static_cast<rlim_t>(value)};
  if(setrlimit(resource, &both) != 0)
    _exit(125);
}

void become_nobody()
{
  constexpr uid_t nobody = 65534;
  if(geteuid() == 0 && (setgroups(0, nullptr) != 0 || setgid(nobody) != 0 || setuid(nobody) != 0))
    _exit(125);
}

} // namespace

Process_result run_process(const std::vector<std::string>& command, const Process_options& options)
{
  Capture out, err;
  std::vector<char*> arguments;
  for(const std::string& argument : command)
    arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);

  // Between fork() and execv() the child has our handlers of SIGINT, those of Catch and of PoCL's LLVM, which wait for
  // ever for threads that it does not have. And if we ignore SIGINT, like what shells run in the background, it should
  // not.
  sigset_t interrupt, mask;
  sigemptyset(&interrupt);
  sigaddset(&interrupt, SIGINT);
  pthread_sigmask(SIG_BLOCK, &interrupt, &mask);
  const pid_t child = fork();
  if(child != 0)
    pthread_sigmask(SIG_SETMASK, &mask, nullptr);
  if(child < 0)
    throw std::runtime_error("cannot start " + command.front());
  if(child == 0) {
    std::signal(SIGINT, SIG_DFL);
    sigprocmask(SIG_UNBLOCK, &interrupt, nullptr);
    if(chdir(options.directory.c_str()) != 0)
      _exit(126);
    limit(RLIMIT_FSIZE, options.largest_file);
    limit(RLIMIT_AS, options.address_space);
    limit(RLIMIT_STACK, options.stack);
    if(options.as_nobody)
      become_nobody();
    dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
    dup2(fileno(out.file), STDOUT_FILENO);
    dup2(fileno(err.file), STDERR_FILENO);
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  if(options.interrupt_after > 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(options.interrupt_after));
    kill(child, SIGINT);
  }
  options.meanwhile(child);
  Process_result result;
  int status = 0;
  rusage usage;
  if(wait4(child, &status, 0, &usage) != child)
    throw std::runtime_error("lost " + command.front());
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  result.out = out.text();
  result.err = err.text();
  result.peak_memory = usage.ru_maxrss * 1024;
  return result;
}

} // namespace test
