// SPDX-License-Identifier: LGPL-3.0-or-later

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

#include <zlib.h>

#include <filesystem>
#include <ios>
#include <new>

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

/// Takes the members of a gzip file (RFC 1952), one after the other: `take(text)` is called with what comes out.
/// Returns whether all of them are sound and complete.
template <class Take>
bool unfold_gzip(std::string_view bytes, const Take& take)
{
  z_stream stream = {};
  if(inflateInit2(&stream, 16 + MAX_WBITS) != Z_OK)
    throw std::bad_alloc();
  const std::unique_ptr<z_stream, decltype(&inflateEnd)> end(&stream, inflateEnd);
  std::string part(std::size_t(1) << 20, '\0');
  int status = Z_OK;
  do {
    if(stream.avail_in == 0) { // which counts with 32 bits
      const std::string_view next = bytes.substr(0, std::size_t(1) << 30);
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(next.data()));
      stream.avail_in = static_cast<uInt>(next.size());
      bytes.remove_prefix(next.size());
    }
    if(status == Z_STREAM_END)
      inflateReset(&stream);
    stream.next_out = reinterpret_cast<Bytef*>(part.data());
    stream.avail_out = static_cast<uInt>(part.size());
    status = inflate(&stream, Z_NO_FLUSH);
    if(status != Z_OK && status != Z_STREAM_END) // also where the input ends too early
      return false;
    take(std::string_view(part).substr(0, part.size() - stream.avail_out));
    for(; status == Z_STREAM_END && stream.avail_in > 0 && *stream.next_in == 0; --stream.avail_in)
      ++stream.next_in; // zeros fill up blocks of tapes and archives
  } while(status != Z_STREAM_END || stream.avail_in > 0 || !bytes.empty());
  return true;
}

#ifdef SPHERICAL_PARAMETERIZATION_WITH_COMPRESSION
namespace io = boost::iostreams;

/// Whether the frames of a zstd file (RFC 8878) are all there. Boost takes an end inside of one for the end.
bool has_whole_frames(std::string_view bytes)
{
  constexpr unsigned magic = 0xfd2fb528, first_skippable = 0x184d2a50;
  bool is_whole = true;
  const auto skip = [&](std::size_t size) {
    is_whole = is_whole && size <= bytes.size();
    bytes.remove_prefix(is_whole ? size : bytes.size());
  };
  const auto number = [&](std::size_t size) { // of little-endian bytes
    unsigned result = 0;
    for(std::size_t k = 0; k < size && k < bytes.size(); ++k)
      result |= static_cast<unsigned>(static_cast<unsigned char>(bytes[k])) << 8 * k;
    skip(size);
    return result;
  };
  while(is_whole && !bytes.empty()) {
    const unsigned kind = number(4);
    if((kind & ~0xfU) == first_skippable) {
      skip(number(4));
      continue;
    }
    if(kind != magic)
      return false;
    const unsigned descriptor = number(1);
    const bool is_single = (descriptor & 0x20) != 0, has_checksum = (descriptor & 4) != 0;
    constexpr std::size_t dictionary[] = {0, 1, 2, 4}, content[] = {0, 2, 4, 8};
    const std::size_t size_of_content = descriptor >> 6 == 0 && is_single ? 1 : content[descriptor >> 6];
    skip((is_single ? 0 : 1) + dictionary[descriptor & 3] + size_of_content);
    for(bool is_last = false; is_whole && !is_last;) {
      const unsigned block = number(3);
      is_last = (block & 1) != 0;
      const bool is_repeated_byte = (block >> 1 & 3) == 1;
      skip(is_repeated_byte ? 1 : block >> 3);
    }
    skip(has_checksum ? 4 : 0);
  }
  return is_whole;
}

/// As `unfold_gzip()`, of the other kinds.
template <class Take>
bool unfold(const std::string&, std::string_view bytes, Compression compression, const Take& take)
{
  if(compression == Compression::ZSTD && !has_whole_frames(bytes))
    return false;
  io::filtering_istreambuf source;
  switch(compression) {
  case Compression::XZ: source.push(io::lzma_decompressor()); break;
  case Compression::ZSTD: source.push(io::zstd_decompressor()); break;
  case Compression::BZIP2: source.push(io::bzip2_decompressor()); break;
  default: break;
  }
  source.push(io::array_source(bytes.data(), bytes.size()));
  std::string part(std::size_t(1) << 20, '\0');
  try {
    for(std::streamsize n; (n = source.sgetn(part.data(), static_cast<std::streamsize>(part.size()))) > 0;)
      take(std::string_view(part).substr(0, static_cast<std::size_t>(n)));
  } catch(const std::ios_base::failure&) { // all errors of the decompressors are of this kind
    return false;
  }
  return true;
}

/// Takes all that it gets: what is left when a disk is full would come again and again. The stream remembers the
/// failure.
struct Sink : io::sink {
  std::ostream* out;

  explicit Sink(std::ostream& stream) : out(&stream) {}
  std::streamsize write(const char* bytes, std::streamsize size)
  {
    out->write(bytes, size);
    return size;
  }
};
#else
template <class Take>
bool unfold(const std::string& file, std::string_view, Compression, const Take&)
{
  refuse_file(file, "is compressed in a way that is not read here: only .gz is", "decompress it first");
}
#endif

} // namespace

std::string to_zlib(const std::string& bytes)
{
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string compressed(size, '\0');
  // numbers of a mesh hardly shrink more where it takes longer
  if(compress2(reinterpret_cast<Bytef*>(compressed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
               static_cast<uLong>(bytes.size()), Z_BEST_SPEED) != Z_OK)
    throw std::bad_alloc(); // there is no other reason
  compressed.resize(size);
  return compressed;
}

std::optional<std::string> from_zlib(std::string_view bytes, std::size_t size)
{
  constexpr std::size_t largest_ratio = 1032; // that deflate can reach
  if(size / largest_ratio > bytes.size())
    return std::nullopt;
  std::string unfolded(size, '\0');
  auto unfolded_size = static_cast<uLongf>(size);
  const int status = uncompress(reinterpret_cast<Bytef*>(unfolded.data()), &unfolded_size,
                                reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uLong>(bytes.size()));
  if(status != Z_OK || unfolded_size != size)
    return std::nullopt;
  return unfolded;
}

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
  // of zstd also a frame that is to be skipped, with which pzstd begins
  const bool is_skipped = bytes.size() > 4 && (bytes[0] & 0xF0) == 0x50 && bytes.substr(1, 3) == "\x2a\x4d\x18"sv;
  return is_skipped ? Compression::ZSTD : Compression::NONE;
}

std::string without_compression(const std::string& file)
{
  return compression_of_name(file) == Compression::NONE ? file
                                                        : std::filesystem::path(file).replace_extension().string();
}

std::string decompressed(const std::string& file, std::string bytes)
{
  const Compression compression = compression_of_content(bytes);
  if(compression == Compression::NONE)
    return bytes;
  constexpr std::size_t largest_ratio = 1000;
  std::string result;
  const auto take = [&](std::string_view part) {
    result.append(part);
    if(result.size() > largest_ratio * bytes.size())
      refuse_file(file,
                  "decompresses to more than " + std::to_string(largest_ratio) + " times its size, as no mesh does",
                  "decompress it yourself if you trust it");
  };
  const bool is_sound =
    compression == Compression::GZIP ? unfold_gzip(bytes, take) : unfold(file, bytes, compression, take);
  if(!is_sound || result.empty())
    refuse_file(file, "is compressed, and damaged or cut short", "compress or download it again");
  return result;
}

#ifdef SPHERICAL_PARAMETERIZATION_WITH_COMPRESSION
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
  stream->push(Sink(out));
  return stream;
}
#else
std::unique_ptr<std::ostream> compressing_stream(std::ostream&, Compression, const std::string& file)
{
  throw Refusal(unwritable_file, file, "would be compressed, which this build cannot do",
                "leave the last extension out, or build with Boost.Iostreams (libboost-iostreams-dev)");
}
#endif

} // namespace tool
