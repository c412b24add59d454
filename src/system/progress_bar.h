// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <cstddef>
#include <string>

namespace tool {

/// A bar on stderr while it lives, if stderr is a terminal, the tool not quiet, and there is no other bar; otherwise
/// nothing.
class Progress_bar {
public:
  /// `phase` is what is being done, in one word; it stands before the bar.
  explicit Progress_bar(const std::string& phase);
  ~Progress_bar();

  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;

  /// `fraction` of the work, between 0 and 1.
  void show(double fraction);

  /// Until it is shown again: leaves the line to something else.
  void hide();

private:
  bool is_only_one_;
  std::string phase_;
  std::size_t width_; ///< of the bar without the phase, the brackets and the number; 0: there is no terminal
  int percent_ = -1;
};

} // namespace tool
