/* SPDX-License-Identifier: LGPL-3.0-or-later
 * Part of CGAL Spherical Parameterization.
 *
 * Every formula per vertex, once. The text is valid C++ and valid OpenCL C 1.2: the host backends include it, a device
 * backend compiles it. A backend adds nothing but the loop over i and the order of the sums.
 *
 * The Laplacian of a weighted graph is always applied to differences, (Lx)_i = sum_j w_ij (x_i - x_j) + e_i x_i: inside
 * a long limb all x_j agree to many digits, and D_i x_i - sum_j w_ij x_j would lose what is left. The excess e (the row
 * sums of the matrix) is zero but for the preconditioner of exponents above 2.
 */
#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_VERTEX_FORMULAS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_VERTEX_FORMULAS_H

#ifdef __OPENCL_C_VERSION__
#define CGAL_SP_GLOBAL __global
#define CGAL_SP_FUNCTION
#else
#include <cmath>
#define CGAL_SP_GLOBAL
#define CGAL_SP_FUNCTION inline
namespace CGAL {
namespace Spherical_parameterization {
namespace internal {
using std::pow;
using std::sqrt;
typedef double real;
#endif

typedef struct {
  real x, y, z;
} vec3;

/* A weighted graph in compressed rows: the neighbours of i are target[offset[i]] ... target[offset[i+1]-1]. */
typedef struct {
  CGAL_SP_GLOBAL const int* offset;
  CGAL_SP_GLOBAL const int* target;
  CGAL_SP_GLOBAL const real* weight;
  CGAL_SP_GLOBAL const real* excess;           /* null: zero */
  CGAL_SP_GLOBAL const real* inverse_diagonal; /* 1 / (sum_j w_ij + e_i); 0 marks a fixed vertex */
} graph_view;

/* A sparse rectangular matrix in compressed rows. */
typedef struct {
  CGAL_SP_GLOBAL const int* offset;
  CGAL_SP_GLOBAL const int* column;
  CGAL_SP_GLOBAL const real* value;
} sparse_view;

CGAL_SP_FUNCTION vec3 make_vec3(real x, real y, real z)
{
  vec3 r;
  r.x = x;
  r.y = y;
  r.z = z;
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
CGAL_SP_FUNCTION vec3 unit(vec3 a) { return scale(1 / sqrt(inner(a, a)), a); }
/* P_v a, the part of a tangent to the sphere at v */
CGAL_SP_FUNCTION vec3 tangent(vec3 a, vec3 v) { return add_scaled(a, -inner(a, v), v); }

/* ---- linear algebra ---------------------------------------------------------------------------------------------- */

/* (A x)_i */
CGAL_SP_FUNCTION vec3 laplacian(int i, graph_view a, CGAL_SP_GLOBAL const vec3* x)
{
  const vec3 xi = x[i];
  vec3 sum = make_vec3(0, 0, 0);
  const int end = a.offset[i + 1];
  for(int k = a.offset[i]; k < end; ++k)
    sum = add_scaled(sum, a.weight[k], sub(xi, x[a.target[k]]));
  return a.excess ? add_scaled(sum, a.excess[i], xi) : sum;
}

/* (T x)_i */
CGAL_SP_FUNCTION vec3 row_times(int i, sparse_view t, CGAL_SP_GLOBAL const vec3* x)
{
  vec3 sum = make_vec3(0, 0, 0);
  const int end = t.offset[i + 1];
  for(int k = t.offset[i]; k < end; ++k)
    sum = add_scaled(sum, t.value[k], x[t.column[k]]);
  return sum;
}

/* (x + gain D^-1 (b - A x))_i, a damped Jacobi step */
CGAL_SP_FUNCTION vec3 smoothing_step(int i, graph_view a, real gain, CGAL_SP_GLOBAL const vec3* b,
                                     CGAL_SP_GLOBAL const vec3* x)
{
  return add_scaled(x[i], gain * a.inverse_diagonal[i], sub(b[i], laplacian(i, a, x)));
}

/* ---- the spring energy on the sphere ----------------------------------------------------------------------------- */

/* Weight of a spring of exponent p with end points delta apart: w |delta|^(p-2). */
CGAL_SP_FUNCTION real spring_weight(real w, real squared_length, real p)
{
  return p == 2 ? w : (squared_length > 0 ? w * pow(squared_length, p / 2 - 1) : 0);
}

/* sum_j w_ij(v) |v_i - v_j|^2 / 2; the densities of all vertices sum up to p E. */
CGAL_SP_FUNCTION real spring_density(int i, graph_view a, real p, CGAL_SP_GLOBAL const vec3* v)
{
  real sum = 0;
  const int end = a.offset[i + 1];
  for(int k = a.offset[i]; k < end; ++k) {
    const vec3 delta = sub(v[i], v[a.target[k]]);
    const real length2 = inner(delta, delta);
    sum += spring_weight(a.weight[k], length2, p) * length2;
  }
  return sum / 2;
}

/* Tangent gradient P_i (L(v) v)_i of the spring energy, and in passing the spring density: |v_i - v_j|^2 / 2 is
 * v_i . (v_i - v_j) for unit vectors. */
CGAL_SP_FUNCTION vec3 spring_gradient(int i, graph_view a, real p, CGAL_SP_GLOBAL const vec3* v, real* density)
{
  const vec3 vi = v[i];
  vec3 sum = make_vec3(0, 0, 0);
  const int end = a.offset[i + 1];
  if(p == 2)
    for(int k = a.offset[i]; k < end; ++k)
      sum = add_scaled(sum, a.weight[k], sub(vi, v[a.target[k]]));
  else
    for(int k = a.offset[i]; k < end; ++k) {
      const vec3 delta = sub(vi, v[a.target[k]]);
      sum = add_scaled(sum, spring_weight(a.weight[k], inner(delta, delta), p), delta);
    }
  *density = inner(vi, sum);
  return a.inverse_diagonal[i] > 0 ? tangent(sum, vi) : make_vec3(0, 0, 0);
}

/* Vertex i's share of the second derivative of the energy along the geodesics with velocity d; `pull` is its density,
 * less what a multiplier takes off. */
CGAL_SP_FUNCTION real spring_curvature(int i, graph_view a, real p, CGAL_SP_GLOBAL const vec3* v,
                                       CGAL_SP_GLOBAL const vec3* d, real pull)
{
  const vec3 di = d[i];
  real sum = 0;
  const int end = a.offset[i + 1];
  if(p == 2)
    for(int k = a.offset[i]; k < end; ++k) {
      const vec3 dd = sub(di, d[a.target[k]]);
      sum += a.weight[k] * inner(dd, dd);
    }
  else
    for(int k = a.offset[i]; k < end; ++k) {
      const vec3 dd = sub(di, d[a.target[k]]);
      const vec3 delta = sub(v[i], v[a.target[k]]);
      const real length2 = inner(delta, delta);
      const real along = inner(delta, dd);
      const real stiffening = length2 > 0 ? (p - 2) * along * along / length2 : 0;
      sum += spring_weight(a.weight[k], length2, p) * (inner(dd, dd) + stiffening);
    }
  return sum / 2 - pull * inner(di, di);
}

/* P_v (beta d - s - y) - omega x v: the conjugate direction after the step s, less a boost and a rotation */
CGAL_SP_FUNCTION vec3 next_direction(real beta, vec3 y, vec3 omega, vec3 v, vec3 s, vec3 d)
{
  return sub(tangent(sub(sub(scale(beta, d), s), y), v), outer(omega, v));
}

/* A step alpha along d, and a small boost with centre c on top, exact to first order: (v + alpha d - 2 P_v c)_i, back
 * on the sphere. */
CGAL_SP_FUNCTION vec3 displaced(vec3 v, real alpha, vec3 d, vec3 c)
{
  return unit(add_scaled(add_scaled(v, alpha, d), -2, tangent(c, v)));
}

/* Adds what decides about a direction d at v to s[0] ... s[6]: g . d, the momentum m d and the spin m v x d. */
CGAL_SP_FUNCTION void add_products(real m, vec3 v, vec3 g, vec3 d, real* s)
{
  const vec3 push = scale(m, d);
  const vec3 spin = outer(v, push);
  s[0] += inner(g, d);
  s[1] += push.x;
  s[2] += push.y;
  s[3] += push.z;
  s[4] += spin.x;
  s[5] += spin.y;
  s[6] += spin.z;
}

/* ---- Moebius transformations and balance ------------------------------------------------------------------------- */

/* The boost of the sphere with centre c, |c| < 1: x -> (1 - c^2) (x - c) / |x - c|^2 - c, to first order x - 2 P_x c.
 */
CGAL_SP_FUNCTION vec3 boost(vec3 x, vec3 c)
{
  const vec3 d = sub(x, c);
  return unit(sub(scale((1 - inner(c, c)) / inner(d, d), d), c));
}

/* Adds m v and m v v^T (xx, xy, xz, yy, yz, zz) to s[0] ... s[8]. */
CGAL_SP_FUNCTION void add_moments(real m, vec3 v, real* s)
{
  s[0] += m * v.x;
  s[1] += m * v.y;
  s[2] += m * v.z;
  s[3] += m * v.x * v.x;
  s[4] += m * v.x * v.y;
  s[5] += m * v.x * v.z;
  s[6] += m * v.y * v.y;
  s[7] += m * v.y * v.z;
  s[8] += m * v.z * v.z;
}

/* ---- the published method ---------------------------------------------------------------------------------------- */

/* sum_j w_ij u_j */
CGAL_SP_FUNCTION vec3 neighbour_sum(int i, graph_view a, CGAL_SP_GLOBAL const vec3* u)
{
  vec3 sum = make_vec3(0, 0, 0);
  const int end = a.offset[i + 1];
  for(int k = a.offset[i]; k < end; ++k)
    sum = add_scaled(sum, a.weight[k], u[a.target[k]]);
  return sum;
}

/* Lines 3 to 5 of Algorithm 1: relax towards the mean of the neighbours, then back to the plane u_i . v_i = 1. The
 * graph has no excess. */
CGAL_SP_FUNCTION vec3 saddle_point_relaxation(int i, graph_view a, real omega, CGAL_SP_GLOBAL const vec3* v,
                                              CGAL_SP_GLOBAL const vec3* u)
{
  if(a.inverse_diagonal[i] == 0)
    return u[i];
  const vec3 moved = add_scaled(scale(1 - omega, u[i]), omega * a.inverse_diagonal[i], neighbour_sum(i, a, u));
  const real lambda = inner(v[i], moved) - 1;
  return add_scaled(moved, -lambda, v[i]);
}

/* r_i = v_i - m / |m|, m = sum_j w_ij v_j: the residual of eq. (2) */
CGAL_SP_FUNCTION vec3 barycentric_residual(int i, graph_view a, CGAL_SP_GLOBAL const vec3* v)
{
  return a.inverse_diagonal[i] == 0 ? make_vec3(0, 0, 0) : sub(v[i], unit(neighbour_sum(i, a, v)));
}

#ifndef __OPENCL_C_VERSION__
} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL
#endif

#endif
