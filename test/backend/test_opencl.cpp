// SPDX-License-Identifier: GPL-3.0-or-later
// The OpenCL device as a policy: choosing one, what can fail, and single precision.

#include "helpers/check.h"
#include "helpers/meshes.h"
#include "helpers/process.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <optional>

using namespace test;
using SP::OpenCL_device;
using SP::OpenCL_error;
using Precision = SP::OpenCL_device::Precision;
namespace internal = SP::internal;

namespace {

bool there_is_a_device()
{
  const bool is_there = !SP::opencl_devices().empty();
  if(!is_there)
    std::cout << "SKIPPED: there is no OpenCL device; for the CPU, install the Debian package pocl-opencl-icd"
              << std::endl;
  return is_there;
}

/// An environment variable for the time of a test.
class Variable {
public:
  Variable(const char* name, const std::string& value) : name_(name)
  {
    if(const char* old = std::getenv(name))
      old_ = old;
    setenv(name, value.c_str(), 1);
  }
  Variable(const Variable&) = delete;
  ~Variable() { old_ ? setenv(name_, old_->c_str(), 1) : unsetenv(name_); }

private:
  const char* name_;
  std::optional<std::string> old_;
};

template <class F>
OpenCL_error error_of(F f)
{
  try {
    f();
  } catch(const OpenCL_error& error) {
    return error;
  }
  FAIL("no OpenCL_error");
  return OpenCL_error("", CL_SUCCESS);
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const char* const device_variable = "CGAL_SPHERICAL_PARAMETERIZATION_DEVICE";

} // namespace

TEST_CASE("devices are listed, always in the same order", "[opencl]")
{
  if(!there_is_a_device())
    return;
  const auto devices = SP::opencl_devices(), again = SP::opencl_devices();
  REQUIRE(devices.size() == again.size());
  for(std::size_t k = 0; k < devices.size(); ++k) {
    CHECK_FALSE(devices[k].name.empty());
    CHECK_FALSE(devices[k].platform.empty());
    CHECK_FALSE(devices[k].driver.empty());
    CHECK(devices[k].memory > 0);
    CHECK(devices[k].largest_allocation > 0);
    CHECK(devices[k].largest_allocation <= devices[k].memory);
    CHECK(devices[k].name == again[k].name);
    CHECK(SP::opencl_device(k).info().name == devices[k].name);
  }
}

TEST_CASE("a device is chosen by number or by part of its name", "[opencl]")
{
  if(!there_is_a_device())
    return;
  const auto devices = SP::opencl_devices();
  const std::string name = devices.back().name;
  SECTION("number")
  {
    const Variable wanted(device_variable, std::to_string(devices.size() - 1));
    CHECK(SP::opencl_device().info().name == name);
  }
  SECTION("name, in capitals")
  {
    std::string part = name.substr(1);
    std::transform(part.begin(), part.end(), part.begin(), [](unsigned char c) { return std::toupper(c); });
    const Variable wanted(device_variable, part);
    CHECK(contains(SP::opencl_device().info().name, name.substr(1)));
  }
  SECTION("empty: not set")
  {
    const Variable wanted(device_variable, "");
    CHECK_NOTHROW(SP::opencl_device());
  }
  SECTION("named by the caller: the variable does not count")
  {
    const Variable other(device_variable, "abacus");
    CHECK(SP::find_opencl_device("0") == 0);
    CHECK(devices[SP::find_opencl_device(name)].name == name);
  }
  SECTION("no such number")
  {
    const Variable wanted(device_variable, "700");
    const OpenCL_error error = error_of([] { SP::opencl_device(); });
    CHECK(error.code() == CL_DEVICE_NOT_FOUND);
    CHECK(contains(error.what(), "no OpenCL device 700, as " + std::string(device_variable) + " asks for"));
  }
  SECTION("a number that is none")
  {
    const Variable wanted(device_variable, "99999999999999999999999");
    CHECK(contains(error_of([] { SP::opencl_device(); }).what(), "is called '99999999999999999999999'"));
  }
  SECTION("no such name")
  {
    const Variable wanted(device_variable, "abacus");
    const OpenCL_error error = error_of([] { SP::opencl_device(); });
    CHECK(contains(error.what(), "'abacus'"));
    CHECK(contains(error.what(), name));
    CHECK(contains(error.what(), "CL_DEVICE_NOT_FOUND"));
  }
}

TEST_CASE("without a driver there is no device, and the error says what to install", "[opencl]")
{
  // the loader reads its variables once: a process of its own
  const Process_result list = run_process({"/usr/bin/env", "OCL_ICD_VENDORS=/nowhere", OPENCL_PROBE});
  CHECK(list.exit_code == 0);
  CHECK(contains(list.out, "0 devices"));
  CHECK(contains(list.out, "no OpenCL device: install a driver (for the CPU, the Debian package pocl-opencl-icd)"));
}

TEST_CASE("a driver without a device is not a missing driver", "[opencl]")
{
  if(!there_is_a_device())
    return;
  const Process_result list = run_process({"/usr/bin/env", "POCL_DEVICES=none", OPENCL_PROBE});
  if(contains(list.out, "0 devices")) // drivers other than PoCL do not hear it
    CHECK(contains(list.out, "no OpenCL device: no driver that is installed has one"));
}

TEST_CASE("threads may start the drivers at the same time", "[opencl]")
{
  if(!there_is_a_device())
    return;
  const std::string line = std::to_string(SP::opencl_devices().size()) + " devices\n";
  for(int i = 0; i < 5; ++i) { // drivers start once in a process
    const Process_result list = run_process({OPENCL_PROBE});
    CHECK(list.exit_code == 0);
    CHECK(list.out == line + line);
  }
}

TEST_CASE("a queue that is not in order is refused", "[opencl]")
{
  if(!there_is_a_device())
    return;
  const OpenCL_device device = SP::opencl_device();
  const internal::OpenCL_queue& in_order = device;
  cl_int code = CL_SUCCESS;
  const cl::CommandQueue queue(
    clCreateCommandQueue(in_order.context(), in_order.device(), CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE, &code));
  if(code != CL_SUCCESS)
    return; // this device has none
  CHECK(error_of([&] { OpenCL_device{queue}; }).code() == CL_INVALID_QUEUE_PROPERTIES);
}

TEST_CASE("kernels that do not compile are reported with the build log", "[opencl]")
{
  if(!there_is_a_device())
    return;
  const OpenCL_device device = SP::opencl_device();
  const internal::OpenCL_queue& queue = device;
  const OpenCL_error error = error_of(
    [&] { internal::build_program(queue.context(), queue.device(), "__kernel void f() { no_such_function(); }", ""); });
  CHECK(error.call() == "clBuildProgram");
  CHECK(std::string(error.code_name()) == "CL_BUILD_PROGRAM_FAILURE");
  CHECK(contains(error.build_log(), "no_such_function"));
  CHECK(contains(error.what(), "no_such_function"));
}

TEST_CASE("an array that does not fit is reported with its size", "[opencl]")
{
  if(!there_is_a_device())
    return;
  const OpenCL_device device = SP::opencl_device();
  const internal::Backend<OpenCL_device> backend(device);
  const OpenCL_error error = error_of([&] { backend.zeros<internal::vec3>(device.info().largest_allocation / 4); });
  CHECK(error.call() == "clCreateBuffer");
  CHECK(contains(error.what(), " GB does not fit on " + device.info().name));
}

TEST_CASE("a shared array outlives its owner's other users, and no longer than it is needed", "[opencl]")
{
  if(!there_is_a_device())
    return;
  OpenCL_device device = SP::opencl_device();
  SECTION("as it is") {}
  SECTION("as on a GPU") { device.treat_as_gpu(); }
  const internal::Backend<OpenCL_device> backend(device);
  auto host = std::make_shared<const internal::Host_array<int>>(internal::Host_array<int>{3, 1, 2});
  const std::weak_ptr<const internal::Host_array<int>> watch = host;
  {
    const internal::OpenCL_array<int> array = backend.share(*host, host);
    host.reset();
    CHECK(array.size() == 3);
    CHECK(watch.expired() == !device.info().is_cpu);
  }
  CHECK(clFinish(device.queue()()) == CL_SUCCESS);
  CHECK(watch.expired());
}

TEST_CASE("only verbs that return numbers wait for the device", "[opencl]")
{
  if(!there_is_a_device())
    return;
  const internal::Backend<OpenCL_device> backend(SP::opencl_device());
  internal::Weighted_graph triangle;
  triangle.offset = {0, 2, 4, 6};
  triangle.target = {1, 2, 0, 2, 0, 1};
  triangle.weight = {1, 2, 1, 3, 2, 3};
  triangle.update_diagonal({});
  const auto a = backend.upload(std::make_shared<const internal::Weighted_graph>(triangle));
  const auto v = backend.upload(internal::Host_array<internal::vec3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  auto w = backend.vectors(3);
  backend.copy(v, w);
  backend.jacobi_sweep(a, 0.5, v, v, w);
  backend.gauss_seidel_sweep(a, backend.colouring({{0}, {1}, {2}}), 0.5, v, w);
  backend.normalize(a, v, w);
  CHECK(backend.number_of_read_backs() == 0);
  backend.barycentric_residual2(a, v);
  CHECK(backend.number_of_read_backs() == 1);
  backend.download(w);
  CHECK(backend.number_of_read_backs() == 2);
}

TEST_CASE("single precision: a valid map, or an honest refusal", "[opencl]")
{
  if(!there_is_a_device())
    return;
  Settings settings;
  OpenCL_device device = SP::opencl_device(Precision::SINGLE).set_smallest_mesh(0);
  if(GENERATE(false, true))
    device.treat_as_gpu();
  settings.policy = device;
  const Soup soup = GENERATE(tetrahedron(), bumpy_sphere(4), dumbbell(4), spiky_star(4, 2), capsule(20, 12));
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  CAPTURE(result);
  CHECK(contains(result.device, "single precision"));
  // what the documentation of OpenCL_device promises
  settings.accuracy = 3e-7 * std::sqrt(soup.points.size());
  check_certificate(result, soup, sphere, settings, 1e-6);
  CHECK(count_vertices_off_sphere(sphere) == 0);
  const bool is_easy = soup.points.size() < 3000 && result.smallest_area > 1e-10;
  CHECK(bool(result) == is_easy);
}
