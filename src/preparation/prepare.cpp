// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "preparation/prepare.h"

#include "system/interruption.h"
#include "system/refusal.h"

#include <functional>

namespace tool {

Preparation prepare(const std::string& file, const Soup& soup, const Preparation_settings& settings)
{
  const std::function<void()> go_on = [&file] { stop_if_interrupted(file); };
  try {
    return SP::preparation::prepare(soup, settings, go_on);
  } catch(const SP::Error& error) {
    throw Refusal(error.code(), file, "has " + error.detail(), "");
  }
}

} // namespace tool
