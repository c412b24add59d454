// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_OPENCL_HEADER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_OPENCL_HEADER_H

// Includes CL/opencl.hpp for OpenCL 1.2. Settings of the user stay: a newer version works, with and without
// CL_HPP_ENABLE_EXCEPTIONS. The classes of opencl.hpp only own handles here; every call that can fail is one of the C
// interface.
#ifndef CL_HPP_TARGET_OPENCL_VERSION
#define CL_HPP_TARGET_OPENCL_VERSION 120
#ifndef CL_HPP_MINIMUM_OPENCL_VERSION
#define CL_HPP_MINIMUM_OPENCL_VERSION 120
#endif
#endif
#ifndef CL_USE_DEPRECATED_OPENCL_1_2_APIS
#define CL_USE_DEPRECATED_OPENCL_1_2_APIS // clCreateCommandQueue, the only one that every platform has
#endif
#include <CL/opencl.hpp>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_OPENCL_HEADER_H
