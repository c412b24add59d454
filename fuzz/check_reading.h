// SPDX-License-Identifier: GPL-3.0-or-later
// What the readers of meshes promise about any file.

#ifndef FUZZ_CHECK_READING_H
#define FUZZ_CHECK_READING_H

#include "system/refusal.h"

#include <cstddef>
#include <string>

namespace fuzz {

/// A refusal is one line, and has a code.
void check_refusal(const tool::Refusal& refusal);

/// A file is refused, or is a mesh that is one and comes back when it is written; also as a sphere.
void check_file(const std::string& file, bool triangulate);

/// A file is refused, or has columns that come back when they are written.
void check_data(const std::string& file, std::size_t number_of_vertices);

} // namespace fuzz

#endif // FUZZ_CHECK_READING_H
