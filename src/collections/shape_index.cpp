// SPDX-License-Identifier: GPL-3.0-or-later

#include "collections/shape_index.h"

#include "input/files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <functional>
#include <iterator>
#include <queue>
#include <unordered_set>

namespace tool {
namespace {

constexpr Database::Format format = {0x53484146, "an index of signatures", R"(
  CREATE TABLE mesh(id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE,
    bytes INTEGER NOT NULL, changed INTEGER NOT NULL, hash TEXT NOT NULL,
    vertices INTEGER NOT NULL, status TEXT NOT NULL, map TEXT NOT NULL, message TEXT NOT NULL, signature BLOB,
    prepared INTEGER NOT NULL, program TEXT NOT NULL, form BLOB);
  CREATE TABLE code(block INTEGER PRIMARY KEY, codes BLOB NOT NULL))"};

/// A signature in a quarter of the space, in steps of 1/4096 from 1 up to where 16 bits go. Zeros are no signature.
typedef std::array<std::uint16_t, Shape_signature::size> Code;
constexpr double steps_per_unit = 4096;

/// As many as fill a page of the database, which is read and written at once.
constexpr std::int64_t codes_per_block = 21;
typedef std::array<Code, codes_per_block> Block;

/// The bytes of a row as what they are. `what` says so if they are damaged.
template <class Value>
Value value_of(const Database& database, const Database::Rows& row, int column, const std::string& what)
{
  const std::string_view bytes = row.bytes(column);
  Value value;
  if(bytes.size() != sizeof value)
    database.refuse_damaged(what + " is not complete");
  std::memcpy(value.data(), bytes.data(), sizeof value);
  return value;
}

template <class Numbers>
Numbers finite_numbers(const Database& database, const Database::Rows& row, int column, const std::string& what)
{
  const auto numbers = value_of<Numbers>(database, row, column, what);
  if(!std::all_of(numbers.begin(), numbers.end(), [](auto x) { return std::isfinite(x); }))
    database.refuse_damaged(what + " is not finite");
  return numbers;
}

/// None: the mesh has none.
std::optional<Shape_signature> signature_of(const Database& database, const Database::Rows& row, int column)
{
  if(row.bytes(column).empty())
    return std::nullopt;
  return Shape_signature{finite_numbers<decltype(Shape_signature::values)>(database, row, column, "a signature")};
}

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

std::string index_of(const std::string& file)
{
  return lower_case_extension(file) == ".csv" ? std::filesystem::path(file).replace_extension(".db").string() : file;
}

Shape_index::Shape_index(const std::string& file, Database::Access access) : database_(file, format, access) {}

bool Shape_index::is_current(const std::string& mesh, bool is_mended)
{
  if(!tool::is_current(database_, mesh, mesh))
    return false;
  auto row =
    database_.query(is_mended ? "SELECT 1 FROM mesh WHERE name = ? AND program = ? AND (status = 'OK' OR prepared > 0)"
                              : "SELECT 1 FROM mesh WHERE name = ? AND program = ? AND prepared < 2",
                    mesh, this_program());
  return row.next();
}

void Shape_index::put(const Signature_row& row)
{
  database_.run("BEGIN");
  auto inserted = database_.query(
    "INSERT OR REPLACE INTO mesh VALUES((SELECT id FROM mesh WHERE name = ?1), ?1, ?, ?, ?, ?, ?, ?, ?, "
    "?, ?, ?, ?) RETURNING id",
    row.name, row.version.bytes, row.version.changed, row.version.hash, static_cast<std::int64_t>(row.vertices),
    row.status, row.map, row.message,
    row.signature ? Bytes{row.signature->values.data(), sizeof row.signature->values} : Bytes(),
    static_cast<std::int64_t>(row.mending), this_program(),
    row.signature ? Bytes{row.form.values.data(), sizeof row.form.values} : Bytes());
  inserted.next();
  const std::int64_t id = inserted.integer(0), block = id / codes_per_block;
  inserted.next(); // to the end, or it could not be committed
  Block codes = {};
  if(auto old = database_.query("SELECT codes FROM code WHERE block = ?", block); old.next())
    codes = value_of<Block>(database_, old, 0, "a block of codes");
  codes[static_cast<std::size_t>(id % codes_per_block)] = code_of(row.signature);
  database_.run("INSERT OR REPLACE INTO code VALUES(?, ?)", block, Bytes{codes.data(), sizeof codes});
  database_.run("COMMIT");
}

std::optional<Signature_row> Shape_index::row(const std::string& mesh) const
{
  auto row = database_.query("SELECT * FROM mesh WHERE name = ?", mesh);
  if(!row.next())
    return std::nullopt;
  const File_version version = {row.integer(2), row.integer(3), row.text(4)};
  const auto vertices = static_cast<std::size_t>(row.integer(5));
  const auto mending = static_cast<Mending>(row.integer(10));
  const auto signature = signature_of(database_, row, 9);
  Shape_form form;
  if(signature)
    form.values = finite_numbers<decltype(form.values)>(database_, row, 12, "a form");
  return Signature_row{mesh,        version, vertices,  row.text(6), row.text(7),
                       row.text(8), mending, signature, form,        std::nullopt};
}

Shape_description Shape_index::description(const std::string& mesh) const
{
  const std::optional<Signature_row> found = row(mesh);
  if(!found || !found->signature)
    database_.refuse_damaged("the signature of " + mesh + " is missing");
  return {*found->signature, found->form};
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
    std::int64_t id = codes_per_block * row.integer(0);
    for(const Code& other : value_of<Block>(database_, row, 1, "a block of codes")) {
      if(other.front() > 0)
        candidates.emplace_back(steps_between(code, other), id);
      ++id;
    }
  }
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue(std::greater<>(), std::move(candidates));

  std::set<std::pair<double, std::string>> found;
  for(; !queue.empty(); queue.pop()) {
    const auto& [steps, id] = queue.top();
    if(found.size() == k && least_distance(steps) > found.rbegin()->first)
      break;
    auto row = database_.query("SELECT name, signature FROM mesh WHERE id = ?", id);
    if(const auto other = row.next() ? signature_of(database_, row, 1) : std::nullopt) // none: removed
      found.emplace(distance(query, *other), row.text(0));
    if(found.size() > k)
      found.erase(std::prev(found.end()));
  }
  return found;
}

} // namespace tool
