// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "output/compressing_stream.h"

#include "system/refusal.h"

#ifdef SPHERICAL_PARAMETERIZATION_WITH_COMPRESSION
#include <boost/iostreams/filter/bzip2.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filter/lzma.hpp>
#include <boost/iostreams/filter/zstd.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#endif

namespace tool {

#ifdef SPHERICAL_PARAMETERIZATION_WITH_COMPRESSION
std::unique_ptr<std::ostream> compressing_stream(std::ostream& out, Compression compression, const std::string&)
{
  namespace io = boost::iostreams;
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
std::unique_ptr<std::ostream> compressing_stream(std::ostream&, Compression, const std::string& file)
{
  throw Refusal(unwritable_file, file, "would be compressed, which this build cannot do",
                "leave the last extension out, or build with Boost.Iostreams (libboost-iostreams-dev)");
}
#endif

} // namespace tool
