// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_BINARY_CACHE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_BINARY_CACHE_H

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

/// The hash FNV-1a: the same in every run, which std::hash need not be.
inline std::uint64_t fnv1a(const std::string& text)
{
  std::uint64_t hash = 14695981039346656037u;
  for(unsigned char c : text)
    hash = (hash ^ c) * 1099511628211u;
  return hash;
}

/// Compiled programs, one per file of the user's cache folder. A cache that cannot be used (no folder, no space, files
/// that are damaged or not ours) is the same as none: nothing is ever reported.
class Binary_cache {
public:
  explicit Binary_cache(std::filesystem::path folder = default_folder()) : folder_(std::move(folder)) {}

  /// $XDG_CACHE_HOME or $HOME/.cache; empty, which means no cache, if there is neither
  static std::filesystem::path default_folder()
  {
    const char* const name = "cgal-spherical-parameterization";
    const char* const cache = std::getenv("XDG_CACHE_HOME");
    if(cache && std::filesystem::path(cache).is_absolute()) // the standard says: ignore relative ones
      return std::filesystem::path(cache) / name;
    const char* const home = std::getenv("HOME");
    return home && *home ? std::filesystem::path(home) / ".cache" / name : std::filesystem::path();
  }

  std::filesystem::path file(const std::string& key) const
  {
    char name[17];
    std::uint64_t hash = fnv1a(key);
    for(int i = 16; i-- > 0; hash /= 16)
      name[i] = "0123456789abcdef"[hash % 16];
    name[16] = 0;
    return folder_ / name;
  }

  std::optional<std::string> load(const std::string& key) const
  {
    if(folder_.empty())
      return {};
    std::ifstream in(file(key), std::ios::binary);
    std::ostringstream all;
    all << in.rdbuf();
    const std::string content = all.str();
    const std::string start = head(key);
    std::uint64_t length_and_sum[2];
    if(content.size() < start.size() + sizeof length_and_sum || content.compare(0, start.size(), start) != 0)
      return {};
    std::memcpy(length_and_sum, content.data() + start.size(), sizeof length_and_sum);
    std::string binary = content.substr(start.size() + sizeof length_and_sum);
    if(length_and_sum[0] != binary.size() || length_and_sum[1] != fnv1a(binary))
      return {};
    return binary;
  }

  /// Written aside and renamed: who reads at the same time sees the old file or the new one.
  void store(const std::string& key, const std::string& binary) const
  {
    if(folder_.empty())
      return;
    std::error_code failed;
    std::filesystem::create_directories(folder_, failed);
    std::filesystem::path scratch = file(key);
    scratch += "." + std::to_string(std::random_device()());
    const std::uint64_t length_and_sum[2] = {binary.size(), fnv1a(binary)};
    std::ofstream out(scratch, std::ios::binary);
    out << head(key);
    out.write(reinterpret_cast<const char*>(length_and_sum), sizeof length_and_sum);
    out << binary;
    out.close();
    if(out)
      std::filesystem::rename(scratch, file(key), failed);
    if(!out || failed)
      std::filesystem::remove(scratch, failed);
  }

private:
  /// The whole key: two keys of the same hash are told apart.
  static std::string head(const std::string& key)
  {
    return "CGAL spherical parameterization, compiled program, 1\n" + std::to_string(key.size()) + '\n' + key;
  }

  std::filesystem::path folder_;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_BINARY_CACHE_H
