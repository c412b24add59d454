// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <cstddef>
#include <string>

namespace tool {

/// \name What commands print on `std::cout`
/// @{

/// From now on it goes to the standard error: the standard output is for a file. Can be called again.
void keep_standard_output_for_data();

/// From now on it goes nowhere, and there is no progress bar.
void be_quiet();

/// From now on commands say more about their work.
void be_verbose();
bool is_verbose();

/// How a file is called in messages: "standard input" or "standard output" for "-".
std::string shown(const std::string& file, const char* standard_stream);

/// Writes to the standard output all that `source` has; `false` if not all could be written.
bool write_to_standard_output(std::streambuf* source);

/// Writes what is still in the buffer of the standard output. Throws a `Refusal` if that, or anything before, could not
/// be written.
void flush_standard_output();
/// @}

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
