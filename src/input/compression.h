// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace tool {

enum class Compression { NONE, GZIP, XZ, ZSTD, BZIP2 };

/// The extensions of compressed files, as in ".gz".
std::vector<std::string> compression_extensions();

/// By the extension of a file: .gz, .xz, .zst, .bz2.
Compression compression_of_name(const std::string& file);

/// By the first bytes.
Compression compression_of_content(std::string_view bytes);

/// "mesh.ply" for "mesh.ply.gz".
std::string without_compression(const std::string& file);

/// The content of bytes that may be compressed. Throws a `Refusal` if they are damaged or cut short, if they unfold to
/// more than a thousand times their size, as no mesh does, and if this build lacks Boost.Iostreams, without which only
/// gzip is known.
std::string decompressed(const std::string& file, std::string bytes);

/// \name The format of zlib (RFC 1950), as it is inside XML files
/// @{
std::string to_zlib(const std::string& bytes);

/// Nothing if the bytes are damaged, or do not unfold to this size.
std::optional<std::string> from_zlib(std::string_view bytes, std::size_t size);
/// @}

/// A stream that writes what it gets, compressed, to `out`; all of it when it is destroyed. `file` is the name for the
/// `Refusal` that is thrown if this build lacks Boost.Iostreams.
std::unique_ptr<std::ostream> compressing_stream(std::ostream& out, Compression compression, const std::string& file);

} // namespace tool
