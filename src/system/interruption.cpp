// SPDX-License-Identifier: LGPL-3.0-or-later

#include "system/interruption.h"

#include <atomic>
#include <csignal>

namespace {

std::atomic<int> noted_signal{0}; ///< 0: none. Threads read it
static_assert(std::atomic<int>::is_always_lock_free, "or a signal handler must not write it");

extern "C" void note_interruption(int signal)
{
  noted_signal = signal;
  std::signal(signal, SIG_DFL);
}

} // namespace

namespace tool {

void watch_for_interruption()
{
  if(!was_interrupted())
    for(const int signal : {SIGINT, SIGTERM, SIGHUP})
      if(std::signal(signal, note_interruption) == SIG_IGN) // by a shell, of what runs in the background
        std::signal(signal, SIG_IGN);
}

bool was_interrupted() { return noted_signal != 0; }

Refusal interrupted(const std::string& input)
{
  return {Error_code::INTERRUPTED, input, "interrupted", "nothing has been written"};
}

void stop_if_interrupted(const std::string& input)
{
  if(was_interrupted())
    throw interrupted(input);
}

void die_if_interrupted()
{
  if(!was_interrupted())
    return;
  std::signal(noted_signal, SIG_DFL);
  std::raise(noted_signal);
}

} // namespace tool
