// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_COMPRESSING_STREAM_H
#define SPHERICAL_PARAMETERIZATION_TOOL_COMPRESSING_STREAM_H

#include "input/compression.h"

#include <memory>
#include <ostream>
#include <string>

namespace tool {

/// A stream that writes what it gets, compressed, to `out`; all of it when it is destroyed. `file` is the name for the
/// `Refusal` that is thrown if this build lacks Boost.Iostreams.
std::unique_ptr<std::ostream> compressing_stream(std::ostream& out, Compression compression, const std::string& file);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_COMPRESSING_STREAM_H
