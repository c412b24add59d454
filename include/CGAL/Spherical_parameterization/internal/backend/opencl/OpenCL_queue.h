// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_OPENCL_QUEUE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_OPENCL_QUEUE_H

#include <CGAL/Spherical_parameterization/OpenCL_device_info.h>
#include <CGAL/Spherical_parameterization/internal/backend/opencl/OpenCL_call.h>
#include <CGAL/Spherical_parameterization/internal/backend/opencl/OpenCL_program.h>
#include <CGAL/Spherical_parameterization/internal/backend/opencl/device_queries.h>

#include <memory>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

/// A command queue, what is known of its device, and the kernels for it. A value: copies share the queue and the
/// kernels.
class OpenCL_queue {
public:
  /// \param queue           in order
  /// \param prefers_double  whether to compute with 64 bits where the device can
  /// Throws an OpenCL_error if the queue is not in order.
  OpenCL_queue(cl::CommandQueue queue, bool prefers_double)
    : queue_(std::move(queue)), program_(std::make_shared<OpenCL_program>())
  {
    const auto of_queue = [&](cl_uint key, auto value) {
      return opencl_value<decltype(value)>(clGetCommandQueueInfo, "clGetCommandQueueInfo", queue_(), key);
    };
    device_ = of_queue(CL_QUEUE_DEVICE, cl_device_id());
    context_ = of_queue(CL_QUEUE_CONTEXT, cl_context());
    info_ = opencl_device_info(device_);
    is_double_ = prefers_double && info_.has_fp64;
    if(of_queue(CL_QUEUE_PROPERTIES, cl_command_queue_properties()) & CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE)
      throw OpenCL_error("OpenCL_device", CL_INVALID_QUEUE_PROPERTIES, "the queue has to be in order");
  }

  const cl::CommandQueue& queue() const { return queue_; }
  cl_context context() const { return context_; } // kept alive by the queue
  cl_device_id device() const { return device_; }
  const OpenCL_device_info& info() const { return info_; }
  bool is_double_precision() const { return is_double_; }

  /// The kernels, compiled by the first call.
  cl::Program program() const { return program_->get(context_, device_, is_double_, info_.is_cpu); }

  /// So that what is done on GPUs can be tested without one.
  void treat_as_gpu()
  {
    info_.is_cpu = false;
    program_ = std::make_shared<OpenCL_program>();
  }

private:
  cl::CommandQueue queue_;
  cl_device_id device_;
  cl_context context_;
  OpenCL_device_info info_;
  bool is_double_;
  std::shared_ptr<OpenCL_program> program_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_OPENCL_QUEUE_H
