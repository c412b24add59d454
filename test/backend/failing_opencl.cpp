// SPDX-License-Identifier: GPL-3.0-or-later
// A library to be preloaded: the device fails at the call number $FAIL_OPENCL_AT to any of these functions, and, as
// lost devices do, at all that follow.

#include <CL/cl.h>

#include <atomic>
#include <cstdlib>

#include <dlfcn.h>

namespace {

bool fails_now()
{
  static const char* const at = std::getenv("FAIL_OPENCL_AT");
  static std::atomic<long> calls(0);
  return at && ++calls >= std::atol(at);
}

template <class Function>
Function* original(Function*, const char* name)
{
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

} // namespace

extern "C" {

cl_int clEnqueueNDRangeKernel(cl_command_queue queue, cl_kernel kernel, cl_uint dimensions, const size_t* offset,
                              const size_t* global, const size_t* local, cl_uint n, const cl_event* events,
                              cl_event* event)
{
  static const auto call = original(&clEnqueueNDRangeKernel, "clEnqueueNDRangeKernel");
  return fails_now() ? CL_OUT_OF_RESOURCES : call(queue, kernel, dimensions, offset, global, local, n, events, event);
}

cl_int clEnqueueReadBuffer(cl_command_queue queue, cl_mem buffer, cl_bool is_blocking, size_t offset, size_t size,
                           void* to, cl_uint n, const cl_event* events, cl_event* event)
{
  static const auto call = original(&clEnqueueReadBuffer, "clEnqueueReadBuffer");
  return fails_now() ? CL_OUT_OF_RESOURCES : call(queue, buffer, is_blocking, offset, size, to, n, events, event);
}

cl_mem clCreateBuffer(cl_context context, cl_mem_flags flags, size_t size, void* content, cl_int* error)
{
  static const auto call = original(&clCreateBuffer, "clCreateBuffer");
  if(!fails_now())
    return call(context, flags, size, content, error);
  if(error)
    *error = CL_MEM_OBJECT_ALLOCATION_FAILURE;
  return nullptr;
}
}
