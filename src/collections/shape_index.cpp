// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "collections/shape_index.h"

#include "input/files.h"

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/nil_generator.hpp>
#include <boost/uuid/uuid_io.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <queue>
#include <sstream>
#include <unordered_set>

#include <sys/stat.h>

namespace tool {
namespace {

constexpr Database::Format format = {0x53484158, "an index of signatures", R"(
  CREATE TABLE mesh(id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE,
    bytes INTEGER NOT NULL, changed INTEGER NOT NULL, hash TEXT NOT NULL,
    vertices INTEGER NOT NULL, status TEXT NOT NULL, map TEXT NOT NULL, message TEXT NOT NULL, signature BLOB);
  CREATE TABLE code(block INTEGER PRIMARY KEY, codes BLOB NOT NULL))"};

/// A signature in a quarter of the space, in steps of 1/4096 from 1 up to where 16 bits go. Zeros are no signature.
typedef std::array<std::uint16_t, Shape_signature::size> Code;
constexpr double steps_per_unit = 4096;

constexpr std::int64_t code_size = sizeof(Code);
constexpr std::int64_t codes_per_block = 64; ///< quicker to read than so many rows

Code code_of(const std::optional<Shape_signature>& signature)
{
  Code code = {};
  if(signature)
    std::transform(signature->values.begin(), signature->values.end(), code.begin(), [](double x) {
      return static_cast<std::uint16_t>(std::lround(std::clamp(1 + steps_per_unit * x, 1., 65535.)));
    });
  return code;
}

std::uint32_t steps_between(const Code& a, const Code& b)
{
  std::uint32_t sum = 0;
  for(std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] > b[i] ? a[i] - b[i] : b[i] - a[i];
  return sum;
}

/// No signatures with codes so far apart are nearer: rounding has moved each coordinate of both by up to half a step.
/// One step more is for the sums of distance().
double least_distance(std::uint32_t steps)
{
  return (steps - static_cast<double>(Shape_signature::size) - 1) / steps_per_unit;
}

} // namespace

File_version version_of(const std::string& file)
{
  struct stat status = {};
  if(stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode))
    return {};
  constexpr std::int64_t nano = 1000000000;
  return {status.st_size, status.st_ctim.tv_sec * nano + status.st_ctim.tv_nsec, ""};
}

std::string content_hash(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  const boost::uuids::name_generator_sha1 sha1(boost::uuids::nil_uuid());
  return in ? to_string(sha1(bytes.str())) : "";
}

std::string index_of(const std::string& file)
{
  return lower_case_extension(file) == ".csv" ? std::filesystem::path(file).replace_extension(".db").string() : file;
}

Shape_index::Shape_index(const std::string& file, Database::Access access) : database_(file, format, access) {}

bool Shape_index::is_current(const std::string& mesh)
{
  auto row =
    database_.query("SELECT bytes, changed, hash FROM mesh WHERE name = ? AND status <> 'OUT_OF_MEMORY'", mesh);
  const File_version now = version_of(mesh);
  if(!row.next() || row.integer(0) != now.bytes)
    return false;
  if(row.integer(1) == now.changed)
    return true;
  if(row.text(2) != content_hash(mesh))
    return false;
  database_.run("UPDATE mesh SET changed = ? WHERE name = ?", now.changed, mesh);
  return true;
}

void Shape_index::put(const Signature_row& row)
{
  const Code code = code_of(row.signature);
  database_.run("BEGIN");
  database_.run("INSERT OR REPLACE INTO mesh VALUES((SELECT id FROM mesh WHERE name = ?1), ?1, ?, ?, ?, ?, ?, ?, ?, ?)",
                row.name, row.version.bytes, row.version.changed, row.version.hash,
                static_cast<std::int64_t>(row.vertices), row.status, row.map, row.message,
                row.signature ? Bytes{row.signature->values.data(), sizeof row.signature->values} : Bytes());
  database_.run("INSERT OR IGNORE INTO code SELECT id / ?2, zeroblob(?2 * ?3) FROM mesh WHERE name = ?1", row.name,
                codes_per_block, code_size);
  database_.run(
    "UPDATE code SET codes = CAST(substr(codes, 1, id % ?2 * ?3) || ?4 || substr(codes, id % ?2 * ?3 + ?3 + 1) "
    "AS BLOB) FROM mesh WHERE name = ?1 AND block = id / ?2",
    row.name, codes_per_block, code_size, Bytes{code.data(), sizeof code});
  database_.run("COMMIT");
}

std::optional<Shape_signature> Shape_index::signature(const Database::Rows& row, int column) const
{
  const std::string_view bytes = row.bytes(column);
  if(bytes.empty())
    return std::nullopt;
  Shape_signature signature;
  if(bytes.size() != sizeof signature.values)
    database_.refuse_damaged("a signature is not complete");
  std::memcpy(signature.values.data(), bytes.data(), bytes.size());
  if(!std::all_of(signature.values.begin(), signature.values.end(), [](double x) { return std::isfinite(x); }))
    database_.refuse_damaged("a signature is not finite");
  return signature;
}

std::optional<Signature_row> Shape_index::row(const std::string& mesh) const
{
  auto row = database_.query("SELECT * FROM mesh WHERE name = ?", mesh);
  if(!row.next())
    return std::nullopt;
  const File_version version = {row.integer(2), row.integer(3), row.text(4)};
  const auto vertices = static_cast<std::size_t>(row.integer(5));
  return Signature_row{mesh, version, vertices, row.text(6), row.text(7), row.text(8), signature(row, 9)};
}

std::size_t Shape_index::keep_only(const std::vector<std::string>& meshes)
{
  const std::unordered_set<std::string> kept(meshes.begin(), meshes.end());
  std::vector<std::string> others;
  for(auto row = database_.query("SELECT name FROM mesh"); row.next();)
    if(kept.count(row.text(0)) == 0)
      others.push_back(row.text(0));
  database_.run("BEGIN");
  for(const std::string& name : others)
    database_.run("DELETE FROM mesh WHERE name = ?", name);
  if(!others.empty())
    database_.run("DELETE FROM code WHERE block NOT IN (SELECT id / ? FROM mesh)", codes_per_block);
  database_.run("COMMIT");
  return others.size();
}

std::set<std::pair<double, std::string>> Shape_index::nearest(const Shape_signature& query, std::size_t k) const
{
  const Code code = code_of(query);
  typedef std::pair<std::uint32_t, std::int64_t> Candidate; // steps between the codes, id
  std::vector<Candidate> candidates;
  for(auto row = database_.query("SELECT block, codes FROM code"); row.next();) {
    const std::string_view codes = row.bytes(1);
    if(codes.size() != codes_per_block * sizeof(Code))
      database_.refuse_damaged("a block of codes is not complete");
    for(std::int64_t i = 0; i < codes_per_block; ++i) {
      Code other;
      std::memcpy(other.data(), codes.data() + i * code_size, sizeof other);
      if(other.front() > 0)
        candidates.emplace_back(steps_between(code, other), codes_per_block * row.integer(0) + i);
    }
  }
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue(std::greater<>(), std::move(candidates));

  std::set<std::pair<double, std::string>> found;
  for(; !queue.empty(); queue.pop()) {
    const auto& [steps, id] = queue.top();
    if(found.size() == k && least_distance(steps) > found.rbegin()->first)
      break;
    auto row = database_.query("SELECT name, signature FROM mesh WHERE id = ?", id);
    if(const auto other = row.next() ? signature(row, 1) : std::nullopt) // none: removed
      found.emplace(distance(query, *other), row.text(0));
    if(found.size() > k)
      found.erase(std::prev(found.end()));
  }
  return found;
}

} // namespace tool
