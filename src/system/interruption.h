// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "system/refusal.h"

#include <CGAL/Named_function_parameters.h>

#include <string>

namespace tool {

/// From now on the first SIGINT, SIGTERM or SIGHUP is only noted, so that work can end in good order. A second one
/// kills. One that is ignored stays so.
void watch_for_interruption();

bool was_interrupted();

/// Named parameters of a function of the library, which it then ends with an Error.
inline auto stopped_by_signals()
{
  return CGAL::parameters::callback([](double) { return !was_interrupted(); });
}

/// What is said of the file `input` then.
Refusal interrupted(const std::string& input);

/// Throws it if the program was interrupted.
void stop_if_interrupted(const std::string& input);

/// Ends the process by the signal that was noted, if there was one. To be called last, when everything has been cleaned
/// up: a shell sees a program that SIGINT has ended (130), and ends its loops and scripts, too.
void die_if_interrupted();

} // namespace tool
