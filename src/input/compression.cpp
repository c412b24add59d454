// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "input/compression.h"

#include "input/text_lines.h"
#include "system/refusal.h"

#ifdef SPHERICAL_PARAMETERIZATION_WITH_COMPRESSION
#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/filter/bzip2.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filter/lzma.hpp>
#include <boost/iostreams/filter/zstd.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <boost/iostreams/filtering_streambuf.hpp>
#endif

#include <filesystem>
#include <ios>

namespace tool {
namespace {

struct Kind {
  Compression compression;
  std::string_view extension;
  std::string_view magic;
};

using namespace std::string_view_literals;
constexpr Kind kinds[] = {{Compression::GZIP, ".gz", "\x1f\x8b"sv},
                          {Compression::XZ, ".xz",
                           "\xfd"
                           "7zXZ\0"sv},
                          {Compression::ZSTD, ".zst", "\x28\xb5\x2f\xfd"sv},
                          {Compression::BZIP2, ".bz2", "BZh"sv}};

#ifdef SPHERICAL_PARAMETERIZATION_WITH_COMPRESSION
namespace io = boost::iostreams;
#endif

} // namespace

std::vector<std::string> compression_extensions()
{
  std::vector<std::string> extensions;
  for(const Kind& kind : kinds)
    extensions.emplace_back(kind.extension);
  return extensions;
}

Compression compression_of_name(const std::string& file)
{
  const std::string extension = lower_case(std::filesystem::path(file).extension().string());
  for(const Kind& kind : kinds)
    if(extension == kind.extension)
      return kind.compression;
  return Compression::NONE;
}

Compression compression_of_content(std::string_view bytes)
{
  for(const Kind& kind : kinds)
    if(bytes.substr(0, kind.magic.size()) == kind.magic)
      return kind.compression;
  return Compression::NONE;
}

std::string without_compression(const std::string& file)
{
  return compression_of_name(file) == Compression::NONE ? file
                                                        : std::filesystem::path(file).replace_extension().string();
}

#ifdef SPHERICAL_PARAMETERIZATION_WITH_COMPRESSION
std::string decompressed(const std::string& file, const std::string& bytes, Compression compression)
{
  constexpr std::size_t largest_ratio = 1000;
  io::filtering_istreambuf source;
  switch(compression) {
  case Compression::NONE: break;
  case Compression::GZIP: source.push(io::gzip_decompressor()); break;
  case Compression::XZ: source.push(io::lzma_decompressor()); break;
  case Compression::ZSTD: source.push(io::zstd_decompressor()); break;
  case Compression::BZIP2: source.push(io::bzip2_decompressor()); break;
  }
  source.push(io::array_source(bytes.data(), bytes.size()));
  std::string result, part(std::size_t(1) << 20, '\0');
  try {
    for(std::streamsize n; (n = source.sgetn(part.data(), static_cast<std::streamsize>(part.size()))) > 0;) {
      result.append(part, 0, static_cast<std::size_t>(n));
      if(result.size() > largest_ratio * bytes.size())
        throw Refusal(unreadable_file, file,
                      "unfolds to more than " + std::to_string(largest_ratio) + " times its size, as no mesh does",
                      "decompress it yourself if you trust it");
    }
  } catch(const std::ios_base::failure&) { // all errors of the decompressors are of this kind
    result.clear();
  }
  if(result.empty())
    throw Refusal(unreadable_file, file, "is compressed, and damaged or cut short", "compress or download it again");
  return result;
}

std::unique_ptr<std::ostream> compressing_stream(std::ostream& out, Compression compression, const std::string&)
{
  auto stream = std::make_unique<io::filtering_ostream>();
  switch(compression) {
  case Compression::NONE: break;
  case Compression::GZIP: stream->push(io::gzip_compressor()); break;
  case Compression::XZ: stream->push(io::lzma_compressor()); break;
  case Compression::ZSTD: stream->push(io::zstd_compressor()); break;
  case Compression::BZIP2: stream->push(io::bzip2_compressor()); break;
  }
  stream->push(out);
  return stream;
}
#else
std::string decompressed(const std::string& file, const std::string&, Compression)
{
  throw Refusal(unreadable_file, file, "is compressed, which this build does not read",
                "decompress it, or build with Boost.Iostreams (libboost-iostreams-dev)");
}

std::unique_ptr<std::ostream> compressing_stream(std::ostream&, Compression, const std::string& file)
{
  throw Refusal(unwritable_file, file, "would be compressed, which this build cannot do",
                "leave the last extension out, or build with Boost.Iostreams (libboost-iostreams-dev)");
}
#endif

} // namespace tool
