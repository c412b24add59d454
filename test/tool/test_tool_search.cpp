// SPDX-License-Identifier: GPL-3.0-or-later
// The command search, on an index made by the command signature.

#include "helpers/meshes.h"
#include "helpers/tool.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iterator>
#include <map>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace test;

namespace {

struct Hit {
  double distance;
  std::string name;
};

std::vector<Hit> hits(const std::string& out)
{
  std::istringstream in(out);
  std::string header;
  std::getline(in, header);
  CHECK(header == "distance  name");
  std::vector<Hit> result;
  for(Hit hit; in >> hit.distance && std::getline(in >> std::ws, hit.name);)
    result.push_back(hit);
  return result;
}

std::string make_index(const Scratch& scratch)
{
  for(int i = 0; i < 4; ++i) {
    write_off(scratch / ("star" + std::to_string(i) + ".off"), spiky_star(4, 3 + 0.05 * i));
    write_off(scratch / ("dumbbell" + std::to_string(i) + ".off"),
              transformed(dumbbell(4), [i](const Point& p) { return Point(p.x(), p.y(), (1 + 0.03 * i) * p.z()); }));
  }
  write_off(scratch / "torus.off", torus(8, 8));                                  // has no signature
  std::string index = scratch / "index.csv";                                      // and index.db
  REQUIRE(run_tool({"signature", scratch.folder(), "-o", index}).exit_code == 1); // one cannot be mapped
  return index;
}

/// Name and numbers of the rows of a table that have a signature.
std::map<std::string, std::vector<double>> signatures(const std::string& table)
{
  std::map<std::string, std::vector<double>> result;
  for(const std::string& line : lines_of(text_of(table))) {
    std::istringstream in(line);
    std::vector<std::string> fields;
    for(std::string field; std::getline(in, field, ',');)
      fields.push_back(field);
    if(fields.at(2) == "OK")
      std::transform(fields.begin() + 5, fields.end(), std::back_inserter(result[fields[0]]),
                     [](const std::string& field) { return std::stod(field); });
  }
  return result;
}

double distance_of(const std::vector<double>& a, const std::vector<double>& b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0., std::plus<>(),
                            [](double x, double y) { return std::abs(x - y); });
}

} // namespace

TEST_CASE("search: exactly the nearest ones, by the numbers of the table", "[tool][search]")
{
  Scratch scratch;
  const std::string index = make_index(scratch);
  const auto all = signatures(index);
  REQUIRE(all.size() == 8);
  for(const auto& [query, numbers] : all) {
    std::vector<std::pair<double, std::string>> expected;
    for(const auto& [name, other] : all)
      expected.emplace_back(distance_of(numbers, other), name);
    std::sort(expected.begin(), expected.end());
    const std::vector<Hit> found = hits(run_tool({"search", query, "--index", index, "-k", "5"}).out);
    REQUIRE(found.size() == 5);
    for(std::size_t i = 0; i < found.size(); ++i) {
      CHECK(found[i].name == expected[i].second);
      CHECK(std::abs(found[i].distance - expected[i].first) < 1e-4);
    }
  }
}

TEST_CASE("search: exactly the nearest ones, though codes of signatures tell them no longer apart", "[tool][search]")
{
  Scratch scratch;
  for(int i = 0; i < 16; ++i)
    write_off(scratch / ("star" + std::to_string(i) + ".off"), spiky_star(3, 3 + 1e-3 * i));
  const std::string index = scratch / "index.csv";
  REQUIRE(run_tool({"signature", scratch.folder(), "-o", index}).exit_code == 0);
  const auto all = signatures(index);
  REQUIRE(all.size() == 16);
  double largest = 0;
  for(const auto& [query, numbers] : all) {
    std::vector<double> expected;
    for(const auto& entry : all)
      expected.push_back(distance_of(numbers, entry.second));
    std::sort(expected.begin(), expected.end());
    largest = std::max(largest, expected.back());
    const std::vector<Hit> found = hits(run_tool({"search", query, "--index", index, "-k", "4"}).out);
    REQUIRE(found.size() == 4);
    for(std::size_t i = 0; i < found.size(); ++i)
      CHECK(std::abs(found[i].distance - expected[i]) < 1e-4);
  }
  CHECK(largest < 96. / 4096); // by which rounding may change a distance: a 4096th in each coordinate
  CHECK(largest > 1e-3);
}

TEST_CASE("search: the class of the query comes first", "[tool][search]")
{
  Scratch scratch;
  const std::string index = make_index(scratch);
  const std::string kind = GENERATE("star", "dumbbell");
  const std::string query = scratch / (kind + "2.off");
  const Process_result run = run_tool({"search", query, "--index", index});
  CAPTURE(run.out, run.err);
  REQUIRE(run.exit_code == 0);
  const std::vector<Hit> found = hits(run.out);
  REQUIRE(found.size() == 8); // all that have a signature
  CHECK(found[0].name == query);
  CHECK(found[0].distance == 0);
  for(std::size_t i = 1; i < found.size(); ++i) {
    CHECK(found[i].distance >= found[i - 1].distance);
    CHECK((found[i].name.find(kind) != std::string::npos) == (i < 4));
  }
  const std::vector<Hit> first = hits(run_tool({"search", query, "--index", index, "-k", "3"}).out);
  REQUIRE(first.size() == 3);
  CHECK(first[2].name == found[2].name);
}

TEST_CASE("search --prepare: says what was repaired", "[tool][search]")
{
  Scratch scratch;
  const std::string index = make_index(scratch), query = write_off(scratch / "open.off", open_sphere(3)),
                    report = scratch / "report.json";
  const Process_result run = run_tool({"search", query, "--index", index, "--prepare", "--report", report});
  CAPTURE(run.out, run.err);
  REQUIRE(run.exit_code == 0);
  const std::size_t table = run.out.find("distance  name");
  CHECK(run.out.substr(0, table).find("open.off: filled 1 hole") != std::string::npos);
  CHECK(hits(run.out.substr(table)).size() == 8);
  CHECK(nlohmann::json::parse(text_of(report))["preparation"].size() == 1);
}

TEST_CASE("search: what is wrong is said in one line", "[tool][search]")
{
  Scratch scratch;
  const std::string good = write_off(scratch / "good.off", icosphere(2));
  const std::string bad = write_off(scratch / "bad.off", open_sphere(2));
  const std::string index = scratch / "index.db", broken = scratch / "broken.db";
  REQUIRE(run_tool({"signature", good, "-o", index}).exit_code == 0);
  const auto check = [&](const std::string& query, const std::string& file, const std::string& word) {
    const Process_result run = run_tool({"search", query, "--index", file});
    CAPTURE(word, run.err);
    CHECK(run.exit_code == 1);
    CHECK(is_one_line(run.err));
    CHECK(run.err.find(word) != std::string::npos);
  };
  check(bad, index, "closed");
  check(scratch / "none.off", index, "does not exist");
  check(good, scratch / "none.csv", "does not exist");
  check(good, scratch.folder(), "directory");
  const std::string bytes = text_of(index);
  write_text(broken, "a,b\n1,2\n");
  check(good, broken, "no database");
  write_text(broken, bytes.substr(0, bytes.size() / 2));
  check(good, broken, "damaged");
  write_text(broken, bytes.substr(0, 100) + std::string(bytes.size() - 100, '\xaa'));
  check(good, broken, "damaged");
  write_text(scratch / "old.csv", "name,vertices\n"); // an index of older versions
  check(good, scratch / "old.csv", "'signature'");
  write_text(broken, "");
  check(good, broken, "is empty");
  CHECK(run_tool({"search", good}).exit_code == 2);
  CHECK(run_tool({"search", "--index", index}).exit_code == 2);
  CHECK(run_tool({"search", good, "--index", index, "-k", "0"}).exit_code == 2);
}

TEST_CASE("search --form: by relevance, which is said", "[tool][search]")
{
  Scratch scratch;
  const std::string index = make_index(scratch), query = scratch / "dumbbell1.off";
  const std::string report = scratch / "report.json";
  const Process_result run = run_tool({"search", query, "--index", index, "-k", "7", "--form", "--report", report});
  CAPTURE(run.out, run.err);
  REQUIRE(run.exit_code == 0);
  const std::vector<std::string> lines = lines_of(run.out);
  REQUIRE(lines.size() == 8);
  CHECK(lines[0] == "distance     form  relevance  name");
  const nlohmann::json found = nlohmann::json::parse(text_of(report))["found"];
  REQUIRE(found.size() == 7);
  CHECK(found[0]["name"] == query);
  CHECK(found[0]["form_distance"] == 0);
  for(std::size_t i = 0; i < found.size(); ++i) {
    CHECK(lines[i + 1].find(found[i]["name"]) != std::string::npos);
    CHECK((std::string(found[i]["name"]).find("dumbbell") != std::string::npos) == (i < 4));
    CHECK((i == 0 || found[i]["relevance"] <= found[i - 1]["relevance"]));
  }
}

TEST_CASE("search --picture: the query and the meshes found, side by side", "[tool][search]")
{
  Scratch scratch;
  const std::string index = make_index(scratch), query = scratch / "star1.off", picture = scratch / "picture.ply";
  write_text(scratch / "star2.off", "OFF\n0 0 0\n"); // which cannot be drawn
  const Process_result run = run_tool({"search", query, "--index", index, "-k", "4", "--picture", picture});
  CAPTURE(run.out, run.err);
  REQUIRE(run.exit_code == 0);
  const std::vector<std::string> lines = lines_of(run.out);
  REQUIRE(lines.size() == 5);
  CHECK(std::count_if(lines.begin(), lines.end(), [](const std::string& line) {
          return line.find("star2.off: ") != std::string::npos; // the reason
        }) == 1);
  CHECK(text_of(picture).find("property int place\n") != std::string::npos);
  const Soup star = read(query), row = read(picture);
  REQUIRE(row.faces.size() == 4 * star.faces.size()); // the query, and the three stars that are left
  REQUIRE(row.points.size() == 4 * star.points.size());
  double end = -1;
  for(std::size_t i = 0; i < 4; ++i) {
    const auto first = row.points.begin() + std::ptrdiff_t(i * star.points.size());
    const auto [left, right] = std::minmax_element(first, first + std::ptrdiff_t(star.points.size()));
    CHECK(left->x() > end);
    end = right->x();
  }
  double area = 0;
  for(const auto& f : row.faces)
    area += std::sqrt(CGAL::squared_area(row.points[f[0]], row.points[f[1]], row.points[f[2]]));
  CHECK(area == Approx(4));
  CHECK(run_tool({"search", query, "--index", index, "--picture", scratch / "b.off"}).exit_code == 2);
}

TEST_CASE("search --rerank: the first ones by how little they differ, and where", "[tool][search]")
{
  Scratch scratch;
  const std::string index = make_index(scratch), query = scratch / "star1.off";
  std::filesystem::remove(scratch / "star2.off"); // which cannot be compared
  const Process_result run = run_tool({"search", query, "--index", index, "-k", "6", "--rerank", "4", "--changes",
                                       scratch / "changes.ply", "--report", scratch / "report.json"});
  CAPTURE(run.out, run.err);
  REQUIRE(run.exit_code == 0);
  const std::vector<std::string> lines = lines_of(run.out);
  REQUIRE(lines.size() == 7);
  CHECK(lines[0] == "distance  difference   alike  name");
  const nlohmann::json found = nlohmann::json::parse(text_of(scratch / "report.json"))["found"];
  REQUIRE(found.size() == 6);
  for(std::size_t i = 0; i < 6; ++i)
    CHECK(lines[i + 1].find(found[i]["name"]) != std::string::npos);
  // the query itself is among them
  CHECK(found[0]["name"] == query);
  CHECK(found[0]["difference"] < 0.05);
  CHECK(found[0]["alike"] > 0.99);
  CHECK(found[0]["change_of_lengths"] < 1.01);
  for(std::size_t i = 1; i < 3; ++i) {
    const auto order = [&](std::size_t k) { return double(found[k]["distance"]) * double(found[k]["difference"]); };
    CHECK(order(i - 1) <= order(i));
    CHECK(lines[i + 1].find(": " + std::string(found[i]["trust"])) != std::string::npos);
  }
  CHECK(found[3]["name"] == scratch / "star2.off");
  CHECK(found[3].contains("error"));
  CHECK(!found[3].contains("difference"));
  // the others are as without it
  const std::vector<Hit> all = hits(run_tool({"search", query, "--index", index, "-k", "6"}).out);
  for(std::size_t i = 4; i < 6; ++i) {
    CHECK(found[i]["name"] == all[i].name);
    CHECK(found[i].size() == 2);
  }
  const std::string ply = text_of(scratch / "changes.ply");
  CHECK(ply.find("property double change_3\n") != std::string::npos);
  CHECK(ply.find("change_4") == std::string::npos);

  CHECK(run_tool({"search", query, "--index", index, "--changes", scratch / "b.ply"}).exit_code == 2);
}
