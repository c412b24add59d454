// SPDX-License-Identifier: GPL-3.0-or-later
// The command-line tool in builds with OpenCL: which devices it lists, takes and refuses.

#include "helpers/meshes.h"
#include "helpers/policies.h"
#include "helpers/tool.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace test;
namespace SP = CGAL::Spherical_parameterization;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// With environment variables "NAME=value" of its own.
Process_result run_tool_with(std::vector<std::string> variables, const std::vector<std::string>& arguments)
{
  variables.insert(variables.begin(), "/usr/bin/env");
  variables.emplace_back(TOOL);
  variables.insert(variables.end(), arguments.begin(), arguments.end());
  return run_process(variables);
}

} // namespace

TEST_CASE("devices: the OpenCL devices, one of which is the default", "[tool][opencl]")
{
  if(!some_policy<SP::OpenCL_device>())
    return;
  const auto devices = SP::opencl_devices();
  const Process_result run = run_tool({"devices"});
  CAPTURE(run.out);
  CHECK(contains(run.out, "\n  " + std::to_string(SP::find_opencl_device()) + " (default): "));
  for(const SP::OpenCL_device_info& device : devices)
    for(const std::string& text : {device.name, device.platform, device.driver})
      CHECK(contains(run.out, text));
  CHECK(contains(run.out, " GB; fp64 "));
}

TEST_CASE("devices: an environment that asks for a device that is not there", "[tool][opencl]")
{
  if(!some_policy<SP::OpenCL_device>())
    return;
  const Process_result run = run_tool_with({"CGAL_SPHERICAL_PARAMETERIZATION_DEVICE=abacus"}, {"devices"});
  CAPTURE(run.out, run.err);
  CHECK(run.exit_code == 0);
  CHECK(
    contains(run.out, "no default: no OpenCL device is called 'abacus', as CGAL_SPHERICAL_PARAMETERIZATION_DEVICE"));
}

TEST_CASE("map: a small mesh stays on the host, and the report says so", "[tool][opencl]")
{
  if(!some_policy<SP::OpenCL_device>())
    return;
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", icosphere(2));
  const Process_result run =
    run_tool({"map", input, "-o", scratch / "out.off", "--policy", "opencl", "--report", scratch / "report.json"});
  CAPTURE(run.err);
  CHECK(run.exit_code == 0);
  const auto report = nlohmann::json::parse(text_of(scratch / "report.json"));
  CHECK(report.at("device") == "one core (the mesh has fewer than 10000 vertices)");
}

TEST_CASE("without an OpenCL driver all else works", "[tool][opencl]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", icosphere(2));
  std::filesystem::create_directory(scratch / "no drivers");
  const std::vector<std::string> nothing = {"OCL_ICD_VENDORS=" + scratch / "no drivers"};
  const Process_result list = run_tool_with(nothing, {"devices"});
  CAPTURE(list.out, list.err);
  CHECK(list.exit_code == 0);
  CHECK(list.err.empty());
  CHECK(contains(list.out, "opencl: no OpenCL device: install a driver (for the CPU, the Debian package "
                           "pocl-opencl-icd)"));
  const Process_result run = run_tool_with(nothing, {"map", input, "-o", scratch / "out.off", "--policy", "opencl"});
  CAPTURE(run.err);
  CHECK(run.exit_code == 1);
  CHECK(is_one_line(run.err));
  CHECK(contains(run.err, "install a driver"));
  CHECK(scratch.number_of_files() == 2);
  CHECK(run_tool_with(nothing, {"map", input, "-o", scratch / "out.off"}).exit_code == 0);
}

TEST_CASE("map: a device by number or by part of its name", "[tool][opencl]")
{
  if(!some_policy<SP::OpenCL_device>())
    return;
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", icosphere(5));
  check_refused(scratch, input, "no OpenCL device 99", {"--policy", "opencl", "--device", "99"});
  check_refused(scratch, input, "'abacus'", {"--policy", "opencl", "--device", "abacus"});

  const SP::OpenCL_device_info device = SP::opencl_devices().at(0);
  for(const std::string& asked : {std::string("0"), device.name.substr(1)}) {
    const Process_result run = run_tool({"map", input, "-o", scratch / "out.off", "--policy", "opencl", "--device",
                                         asked, "--precision", "single", "--report", scratch / "report.json"});
    CAPTURE(asked, run.err);
    CHECK(run.exit_code == 0);
    const auto report = nlohmann::json::parse(text_of(scratch / "report.json"));
    CHECK(report.at("device") == device.name + " (" + device.platform + "), single precision");
  }
}

TEST_CASE("map: a device that fails in the middle is reported in one line, and nothing is written", "[tool][opencl]")
{
  if(!some_policy<SP::OpenCL_device>())
    return;
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", spiky_star(5, 1)); // large enough for devices
  const auto with_failure_at = [&](long call, const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"map", input, "-o", scratch / "out.off", "--policy", "opencl"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_tool_with({"LD_PRELOAD=" FAILING_OPENCL, "FAIL_OPENCL_AT=" + std::to_string(call)}, arguments);
  };
  for(const std::vector<std::string>& options : {std::vector<std::string>{"--method", "balanced"},
                                                 {"--method", "balanced", "--spring-exponent", "3"},
                                                 {"--method", "saddle-point", "--iterations", "2"},
                                                 {"--method", "automatic"}}) {
    int failures = 0;
    for(long call = 1;; call = call * 3 + 1) { // the set-up is dense, the iterations are all alike
      const Process_result run = with_failure_at(call, options);
      CAPTURE(options, call, run.exit_code, run.out, run.err);
      if(!contains(run.err, "CL_")) { // there are not so many calls
        CHECK(failures > 3);
        break;
      }
      ++failures;
      CHECK(run.exit_code == 1);
      CHECK(is_one_line(run.err));
      CHECK((contains(run.err, "CL_OUT_OF_RESOURCES") || contains(run.err, "CL_MEM_OBJECT_ALLOCATION_FAILURE")));
      CHECK(scratch.number_of_files() == 1);
    }
    std::filesystem::remove(scratch / "out.off");
  }
}
