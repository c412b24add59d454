// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_OPENCL_BACKEND_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_OPENCL_BACKEND_H

#include <CGAL/Spherical_parameterization/internal/backend/Verbs.h>
#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/backend/opencl/OpenCL_queue.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/text/text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// An array on the device, of T with `real` in place of double. It has no memory if it is empty.
template <class T>
struct OpenCL_array {
  std::size_t count = 0;
  cl::Buffer buffer;

  std::size_t size() const { return count; }
  cl_mem memory() const { return buffer(); }
};

/// A Weighted_graph on the device.
struct OpenCL_matrix {
  OpenCL_array<int> offset, target;
  OpenCL_array<double> weight, excess, inverse_diagonal;
};

/// A Weighted_smoother on the device.
struct OpenCL_smoother {
  OpenCL_array<int> offset, target;
  OpenCL_array<float> weight, excess;
};

/// Aggregates on the device.
struct OpenCL_aggregates {
  OpenCL_array<int> of_vertex, offset, member;
};

/// A machine that is an OpenCL device: a verb is a kernel of kernels/, named like the verb. Everything is done in the
/// order of the calls, since the queue is in order. Set-up on the host is run with `Loop`. An object is for one thread;
/// `parameterize()` makes its own.
template <class Loop>
class OpenCL_machine {
public:
  using Host_loop = Loop;
  template <class T>
  using Array = OpenCL_array<T>;
  using Vectors = Array<vec3>;
  using Scalars = Array<double>;
  using Steps = Array<float4>;
  using Floats = Array<float>;
  using Matrix = std::shared_ptr<const OpenCL_matrix>;
  using Smoother = std::shared_ptr<const OpenCL_smoother>;
  using Aggregates = OpenCL_aggregates;
  using Colouring = std::vector<Array<int>>;

  explicit OpenCL_machine(const OpenCL_queue& queue) : queue_(queue), program_(queue.program()) {}

  std::string device_name() const
  {
    const OpenCL_device_info& info = queue_.info();
    return info.name + " (" + info.platform + "), " + (is_double() ? "double" : "single") + " precision";
  }

  double rounding() const { return is_double() ? 1e-13 : 1e-6; }

  /// In single precision the residual of eq. (2) came down to between 0.7e-7 and 1.5e-7 times sqrt(n) on meshes of 162
  /// to 10242 vertices, and that of the balanced map to 1.5e-8 times sqrt(n) up to 163842 vertices.
  double best_accuracy(int n) const { return is_double() ? 0 : 3e-7 * std::sqrt(static_cast<double>(n)); }

  const Loop& host_loop() const { return loop_; }

  /// How often the host has waited for the device
  std::size_t number_of_read_backs() const { return number_of_read_backs_; }

  Vectors vectors(int n) const { return zeros<vec3>(n); }
  Steps steps(int n) const { return zeros<float4>(n); }
  /// In the memory of x, or in single precision, where a vec3 has 12 bytes and a float4 16, in memory of their own,
  /// made anew by each call.
  Steps steps_in(Vectors& x) const
  {
    if(is_double() || x.count == 0)
      return {x.count, x.buffer};
    return {x.count, allocate(CL_MEM_READ_WRITE, x.count * sizeof(float4), nullptr)};
  }
  Scalars scalars(int n) const { return zeros<double>(n); }

  template <class T>
  Array<T> zeros(std::size_t n) const
  {
    if(n == 0)
      return {};
    const std::size_t bytes = n * bytes_of<T>();
    Array<T> x = {n, allocate(CL_MEM_READ_WRITE, bytes, nullptr)};
    const cl_uint zero = 0;
    check(clEnqueueFillBuffer(handle(), x.memory(), &zero, sizeof zero, 0, bytes, 0, nullptr, nullptr),
          "clEnqueueFillBuffer");
    return x;
  }

  template <class T>
  Array<T> upload(const Host_array<T>& host) const
  {
    if(host.empty())
      return {};
    if(is_as_on_host<T>())
      return {host.size(), allocate(CL_MEM_COPY_HOST_PTR, host.size() * sizeof(T), host.data())};
    std::vector<float> rounded(host.size() * components<T>());
    const double* const values = reinterpret_cast<const double*>(host.data());
    std::copy_n(values, rounded.size(), rounded.begin());
    return {host.size(), allocate(CL_MEM_COPY_HOST_PTR, rounded.size() * sizeof(float), rounded.data())};
  }

  Matrix upload(const Shared_graph& host) const
  {
    const auto shared = [&](const auto& array) { return share(array, host); };
    return std::make_shared<const OpenCL_matrix>(OpenCL_matrix{shared(host->offset), shared(host->target),
                                                               shared(host->weight), shared(host->excess),
                                                               shared(host->inverse_diagonal)});
  }

  /// \param matrix  of the same graph
  Smoother upload(const Shared_smoother& host, const Matrix& matrix) const
  {
    return std::make_shared<const OpenCL_smoother>(
      OpenCL_smoother{matrix->offset, matrix->target, share(host->weight, host), share(host->excess, host)});
  }

  Aggregates upload(const Shared_aggregates& host) const
  {
    const auto shared = [&](const auto& array) { return share(array, host); };
    return {shared(host->of_vertex), shared(host->offset), shared(host->member)};
  }

  /// An array that is only read. A device that works in the memory of the host reads `host` itself, and keeps `owner`
  /// alive until it is done. Any other device gets a copy.
  template <class T>
  Array<T> share(const Host_array<T>& host, std::shared_ptr<const void> owner) const
  {
    if(host.empty() || !is_cpu() || !is_as_on_host<T>())
      return upload(host);
    const std::size_t bytes = host.size() * sizeof(T);
    Array<T> x = {host.size(), allocate(CL_MEM_READ_ONLY | CL_MEM_USE_HOST_PTR, bytes, host.data())};
    // called when all kernels that use it are done, which may be after x is gone
    auto kept = std::make_unique<std::shared_ptr<const void>>(std::move(owner));
    check(clSetMemObjectDestructorCallback(x.memory(), &release, kept.get()), "clSetMemObjectDestructorCallback");
    static_cast<void>(kept.release()); // `release` deletes it
    return x;
  }

  Host_array<vec3> download(const Vectors& x) const
  {
    Host_array<vec3> host(x.size());
    if(!host.empty())
      read(x.memory(), 3 * host.size(), &host.front().x);
    return host;
  }

  Colouring colouring(const std::vector<Host_array<int>>& colours) const
  {
    Colouring result;
    for(const Host_array<int>& colour : colours)
      result.push_back(upload(colour));
    return result;
  }

protected:
  /// Runs a kernel for i = 0 ... n-1. Its arguments are n and the others, structures of arrays member by member.
  template <auto Formula_at, class... Arguments>
  void run(Verb<Formula_at> verb, std::size_t n, const Arguments&... arguments) const
  {
    const std::size_t share = is_cpu() ? block_size : lanes;
    launch(verb.kernel, n, (n + share - 1) / share, arguments...);
  }

  /// Runs a kernel whose last argument takes K sums per block; returns the sums of the blocks, added up in order.
  template <auto Formula_at, int K, class... Arguments>
  std::array<double, K> sum(Verb<Formula_at, K> verb, std::size_t n, const Arguments&... arguments) const
  {
    const std::size_t blocks = (n + block_size - 1) / block_size;
    if(partial_.size() < K * blocks)
      partial_ = {K * blocks, allocate(CL_MEM_READ_WRITE, K * blocks * bytes_of<double>(), nullptr)};
    launch(verb.kernel, n, blocks, arguments..., partial_);
    std::vector<double> sums(K * blocks);
    if(blocks > 0)
      read(partial_.memory(), sums.size(), sums.data());
    std::array<double, K> total{};
    for(std::size_t i = 0; i < sums.size(); ++i)
      total[i % K] += sums[i];
    return total;
  }

private:
  // as in kernels/backend/loops.cl and in Host_machine
  static constexpr std::size_t lanes = 64;
  static constexpr std::size_t block_size = 1024;

  static void CL_CALLBACK release(cl_mem, void* owner) { delete static_cast<std::shared_ptr<const void>*>(owner); }

  bool is_double() const { return queue_.is_double_precision(); }
  bool is_cpu() const { return queue_.info().is_cpu; }
  cl_command_queue handle() const { return queue_.queue()(); }

  /// How many doubles a T has.
  template <class T>
  static constexpr std::size_t components()
  {
    constexpr int count = std::is_same_v<T, vec3> ? 3 : std::is_same_v<T, double> ? 1 : 0;
    static_assert(count > 0 || std::is_same_v<T, int> || std::is_same_v<T, float> || std::is_same_v<T, float4>);
    return count;
  }

  template <class T>
  bool is_as_on_host() const
  {
    return components<T>() == 0 || is_double();
  }

  template <class T>
  std::size_t bytes_of() const
  {
    return is_as_on_host<T>() ? sizeof(T) : components<T>() * sizeof(float);
  }

  static std::string gigabytes(std::size_t bytes) { return to_string(1e-9 * static_cast<double>(bytes)) + " GB"; }

  /// Throws an OpenCL_error unless `code` is CL_SUCCESS. Drivers may allocate late, so that any call can run out of
  /// memory.
  void check(cl_int code, const char* call) const
  {
    if(code == CL_MEM_OBJECT_ALLOCATION_FAILURE || code == CL_OUT_OF_RESOURCES || code == CL_OUT_OF_HOST_MEMORY)
      throw OpenCL_error(call, code,
                         "no memory left on " + queue_.info().name + ", which has " + gigabytes(queue_.info().memory));
    check_opencl(code, call);
  }

  cl::Buffer allocate(cl_mem_flags flags, std::size_t bytes, const void* content) const
  {
    const OpenCL_device_info& info = queue_.info();
    cl_int code = CL_INVALID_BUFFER_SIZE;
    if(bytes <= info.largest_allocation) {
      cl::Buffer buffer(clCreateBuffer(queue_.context(), flags, bytes, const_cast<void*>(content), &code));
      if(code == CL_SUCCESS)
        return buffer;
    }
    throw OpenCL_error("clCreateBuffer", code,
                       "an array of " + gigabytes(bytes) + " does not fit on " + info.name + ", which has " +
                         gigabytes(info.memory) + " of memory and allows arrays of " +
                         gigabytes(info.largest_allocation));
  }

  void read(cl_mem memory, std::size_t count, double* host) const
  {
    ++number_of_read_backs_;
    std::vector<float> rounded(is_double() ? 0 : count);
    void* const target = is_double() ? static_cast<void*>(host) : rounded.data();
    const std::size_t bytes = count * bytes_of<double>();
    check(clEnqueueReadBuffer(handle(), memory, CL_TRUE, 0, bytes, target, 0, nullptr, nullptr), "clEnqueueReadBuffer");
    std::copy(rounded.begin(), rounded.end(), host);
  }

  template <class... Arguments>
  void launch(const char* name, std::size_t n, std::size_t work_groups, const Arguments&... arguments) const
  {
    if(n == 0)
      return;
    const cl_kernel kernel = kernel_named(name);
    cl_uint index = 0;
    set_all(kernel, index, static_cast<int>(n), arguments...);
    const std::size_t work_items = is_cpu() ? 1 : lanes, all = work_groups * work_items;
    check(clEnqueueNDRangeKernel(handle(), kernel, 1, nullptr, &all, &work_items, 0, nullptr, nullptr), name);
  }

  cl_kernel kernel_named(const char* name) const
  {
    cl::Kernel& kernel = kernels_[name];
    if(kernel() == nullptr) {
      cl_int code = CL_SUCCESS;
      kernel = cl::Kernel(clCreateKernel(program_(), name, &code));
      check(code, name);
    }
    return kernel();
  }

  void set_bytes(cl_kernel kernel, cl_uint& index, std::size_t bytes, const void* value) const
  {
    check(clSetKernelArg(kernel, index++, bytes, value), "clSetKernelArg");
  }

  void set(cl_kernel kernel, cl_uint& index, int value) const { set_bytes(kernel, index, sizeof value, &value); }

  /// A number or a vector, in the precision of the device
  void set(cl_kernel kernel, cl_uint& index, double value) const { set_reals(kernel, index, {value}); }
  void set(cl_kernel kernel, cl_uint& index, vec3 p) const { set_reals(kernel, index, {p.x, p.y, p.z}); }
  void set_reals(cl_kernel kernel, cl_uint& index, std::initializer_list<double> values) const
  {
    const std::vector<float> rounded(values.begin(), values.end());
    is_double() ? set_bytes(kernel, index, values.size() * sizeof(double), values.begin())
                : set_bytes(kernel, index, values.size() * sizeof(float), rounded.data());
  }

  /// An empty array is a null pointer on the device.
  template <class T>
  void set(cl_kernel kernel, cl_uint& index, const OpenCL_array<T>& array) const
  {
    const cl_mem memory = array.memory();
    set_bytes(kernel, index, sizeof memory, memory ? &memory : nullptr);
  }

  template <class... Members>
  void set_all(cl_kernel kernel, cl_uint& index, const Members&... members) const
  {
    (set(kernel, index, members), ...);
  }

  void set(cl_kernel kernel, cl_uint& index, const Matrix& a) const
  {
    set_all(kernel, index, a->offset, a->target, a->weight, a->excess, a->inverse_diagonal);
  }

  void set(cl_kernel kernel, cl_uint& index, const Smoother& a) const
  {
    set_all(kernel, index, a->offset, a->target, a->weight, a->excess);
  }

  void set(cl_kernel kernel, cl_uint& index, const Aggregates& of) const
  {
    set_all(kernel, index, of.of_vertex, of.offset, of.member);
  }

  OpenCL_queue queue_;
  Loop loop_ = loop_of<OpenCL_queue>();
  cl::Program program_;
  mutable std::map<std::string, cl::Kernel> kernels_; ///< not shared: setting an argument is not thread-safe
  mutable Scalars partial_;                           ///< sums of the blocks, for the largest verb so far
  mutable std::size_t number_of_read_backs_ = 0;
};

template <class Loop>
using OpenCL_backend = Verbs<OpenCL_machine<Loop>>;

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_OPENCL_BACKEND_H
