/* SPDX-License-Identifier: LGPL-3.0-or-later
 * Part of CGAL Spherical Parameterization.
 *
 * The first part of the program: what a real number is. Products and sums are not contracted, so that results are
 * those of the host.
 */
#pragma OPENCL FP_CONTRACT OFF

#ifdef CGAL_SP_DOUBLE
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
typedef double real;
#else
typedef float real;
#endif
