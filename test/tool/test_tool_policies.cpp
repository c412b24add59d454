// SPDX-License-Identifier: GPL-3.0-or-later
// The command-line tool on every policy.

#include "helpers/meshes.h"
#include "helpers/policies.h"
#include "helpers/tool.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace test;

TEST_CASE("map: the sphere is that of one core, byte for byte", "[tool][policies]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", bumpy_sphere(5)); // 10242 vertices
  const std::string method = GENERATE("balanced", "saddle-point");
  const auto sphere = [&](const std::string& policy) {
    std::vector<std::string> arguments = {
      "map",      input,  "-o",       scratch / (policy + ".off"), "--method", method,
      "--policy", policy, "--report", scratch / "report.json"};
    if(method == "saddle-point") // few sweeps, and whatever map they give
      arguments.insert(arguments.end(), {"--start", "harmonic", "--check-interval", "10", "--accuracy", "0.5"});
    const Process_result run = run_tool(arguments);
    CAPTURE(run.out, run.err);
    REQUIRE(run.exit_code == 0);
    const auto report = nlohmann::json::parse(text_of(scratch / "report.json"));
    CHECK(report.at("policy") == policy);
    CHECK(run.out.find(policy + " on " + report.at("device").get<std::string>()) != std::string::npos);
    return text_of(scratch / (policy + ".off"));
  };
  CHECK((sphere(default_policy_name()) == sphere("sequential"))); // in brackets: no print-out of both
}

TEST_CASE("map: the time limit stops every policy", "[tool][policies]")
{
  Scratch scratch;
  check_refused(scratch, write_off(scratch / "in.off", dumbbell(3)), "--max-time",
                {"--policy", default_policy_name(), "--max-time", "1e-9"});
}

TEST_CASE("register: with spheres of before, too, the policy may be chosen, and the points are the same",
          "[tool][policies]")
{
  Scratch scratch;
  const std::string a = write_off(scratch / "a.off", bumpy_sphere(3)), b = write_off(scratch / "b.off", dumbbell(3));
  for(const std::string name : {"a", "b"})
    REQUIRE(run_tool({"map", scratch / (name + ".off"), "-o", scratch / (name + ".ply")}).exit_code == 0);
  const auto points = [&](const std::string& policy) {
    const Process_result run = run_tool({"register", a, b, "--sphere", scratch / "a.ply", scratch / "b.ply", "--policy",
                                         policy, "--correspondence", scratch / (policy + ".csv")});
    CAPTURE(run.out, run.err);
    REQUIRE(run.exit_code == 0);
    return text_of(scratch / (policy + ".csv"));
  };
  CHECK((points(default_policy_name()) == points("sequential")));
}
