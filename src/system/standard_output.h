// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <string>

namespace tool {

/// \name What commands print on `std::cout`
/// @{

/// From now on it goes to the standard error: the standard output is for a file. Can be called again.
void keep_standard_output_for_data();

/// From now on it goes nowhere, and there is no progress bar.
void be_quiet();
bool is_quiet();

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

} // namespace tool
