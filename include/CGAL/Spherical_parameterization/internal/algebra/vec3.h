/* SPDX-License-Identifier: LGPL-3.0-or-later
 * Part of CGAL Spherical Parameterization.
 *
 * Vectors of three numbers, and of floats for what needs no more. The text is valid C++ and valid OpenCL C 1.2: the
 * host includes it, a device compiles it.
 */
#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_VEC3_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_VEC3_H

#ifdef __OPENCL_C_VERSION__
#define CGAL_SP_FUNCTION
#define CGAL_SP_GLOBAL __global
#else
#include <cmath>
#include <cstddef>
#define CGAL_SP_FUNCTION inline
#define CGAL_SP_GLOBAL
namespace CGAL::Spherical_parameterization::internal {
using std::size_t;
using std::sqrt;
constexpr double pi = 3.14159265358979323846;
typedef double real; /* a device may take float: kernels/backend/precision.cl */
/* as in OpenCL: four lanes of a register, of which the last one is unused (an extension of GCC's and Clang's) */
typedef float float4 __attribute__((vector_size(16)));
#endif

typedef struct {
  real x, y, z;
} vec3;

CGAL_SP_FUNCTION vec3 make_vec3(real x, real y, real z)
{
  const vec3 r = {x, y, z};
  return r;
}
CGAL_SP_FUNCTION vec3 add(vec3 a, vec3 b) { return make_vec3(a.x + b.x, a.y + b.y, a.z + b.z); }
CGAL_SP_FUNCTION vec3 sub(vec3 a, vec3 b) { return make_vec3(a.x - b.x, a.y - b.y, a.z - b.z); }
CGAL_SP_FUNCTION vec3 scale(real s, vec3 a) { return make_vec3(s * a.x, s * a.y, s * a.z); }
/* a + s b */
CGAL_SP_FUNCTION vec3 add_scaled(vec3 a, real s, vec3 b)
{
  return make_vec3(a.x + s * b.x, a.y + s * b.y, a.z + s * b.z);
}
CGAL_SP_FUNCTION real inner(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
CGAL_SP_FUNCTION vec3 outer(vec3 a, vec3 b)
{
  return make_vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
CGAL_SP_FUNCTION real squared_distance(vec3 a, vec3 b) { return inner(sub(a, b), sub(a, b)); }
CGAL_SP_FUNCTION real norm(vec3 a) { return sqrt(inner(a, a)); }
CGAL_SP_FUNCTION vec3 unit(vec3 a) { return scale(1 / sqrt(inner(a, a)), a); }
/* P_v a, the part of a that is tangent to the sphere at the unit vector v */
CGAL_SP_FUNCTION vec3 tangent(vec3 a, vec3 v) { return add_scaled(a, -inner(a, v), v); }

/* Rounded; the last lane is 0. */
CGAL_SP_FUNCTION float4 to_float4(vec3 a)
{
#ifdef __OPENCL_C_VERSION__
  return (float4)((float)a.x, (float)a.y, (float)a.z, 0);
#else
  return float4{static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z), 0};
#endif
}
/* Exact, but for the last lane, which is lost. */
CGAL_SP_FUNCTION vec3 to_vec3(float4 a)
{
#ifdef __OPENCL_C_VERSION__
  return make_vec3(a.x, a.y, a.z);
#else
  return make_vec3(a[0], a[1], a[2]);
#endif
}

#ifndef __OPENCL_C_VERSION__
} // namespace CGAL::Spherical_parameterization::internal
#endif

#endif
