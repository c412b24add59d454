/* SPDX-License-Identifier: LGPL-3.0-or-later
 * Part of CGAL Spherical Parameterization.
 *
 * Formulas of linear algebra: sparse and dense products, conjugate gradients, smoothing. See vertex_formulas.h.
 *
 * The Laplacian of a weighted graph is always applied to differences, (Lx)_i = sum_j w_ij (x_i - x_j) + e_i x_i. Inside
 * a long limb all x_j agree to many digits, and D_i x_i - sum_j w_ij x_j would lose the digits that differ. The excess
 * e (the row sums of the matrix) is zero except in the preconditioner of exponents above 2.
 */
#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_FORMULAS_LINEAR_ALGEBRA_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_FORMULAS_LINEAR_ALGEBRA_H

#ifndef __OPENCL_C_VERSION__
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
namespace CGAL::Spherical_parameterization::internal {
#endif

/* Arrays, which on a device are in its memory: those that are read, and those that are written. */
typedef CGAL_SP_GLOBAL const int* int_in;
typedef CGAL_SP_GLOBAL const real* real_in;
typedef CGAL_SP_GLOBAL const vec3* vec3_in;
typedef CGAL_SP_GLOBAL const float* float_in;
typedef CGAL_SP_GLOBAL const float4* float4_in;
typedef CGAL_SP_GLOBAL real* real_out;
typedef CGAL_SP_GLOBAL vec3* vec3_out;
typedef CGAL_SP_GLOBAL float4* float4_out;

/* A weighted graph in compressed rows: the neighbours of i are target[offset[i]] ... target[offset[i+1]-1]. */
typedef struct {
  int_in offset;
  int_in target;
  real_in weight;
  real_in excess;           /* null: zero */
  real_in inverse_diagonal; /* 1 / (sum_j w_ij + e_i); 0 marks a fixed vertex */
} graph_view;

/* Aggregates of vertices: those of aggregate c are member[offset[c]] ... member[offset[c+1]-1]. */
typedef struct {
  int_in of_vertex; /* -1: none, as for fixed vertices */
  int_in offset;
  int_in member;
} aggregates_view;

/* returns (A x)_i */
CGAL_SP_FUNCTION vec3 laplacian(int i, graph_view a, vec3_in x)
{
  const vec3 xi = x[i];
  vec3 sum = make_vec3(0, 0, 0);
  const int end = a.offset[i + 1];
  for(int k = a.offset[i]; k < end; ++k)
    sum = add_scaled(sum, a.weight[k], sub(xi, x[a.target[k]]));
  return a.excess ? add_scaled(sum, a.excess[i], xi) : sum;
}

/* y = x */
CGAL_SP_FUNCTION void copy_at(int i, vec3_in x, vec3_out y) { y[i] = x[i]; }

/* s[0]: x . y */
CGAL_SP_FUNCTION void dot_at(int i, vec3_in x, vec3_in y, real* s) { s[0] += inner(x[i], y[i]); }

/* y = A x; s[0]: x . y */
CGAL_SP_FUNCTION void multiply_at(int i, graph_view a, vec3_in x, vec3_out y, real* s)
{
  y[i] = laplacian(i, a, x);
  s[0] += inner(x[i], y[i]);
}

/* x += alpha p and r -= alpha q */
CGAL_SP_FUNCTION void descend_at(int i, real alpha, vec3_in p, vec3_in q, vec3_out x, vec3_out r)
{
  x[i] = add_scaled(x[i], alpha, p[i]);
  r[i] = add_scaled(r[i], -alpha, q[i]);
}

/* p = s + beta p */
CGAL_SP_FUNCTION void conjugate_at(int i, real beta, vec3_in s, vec3_out p) { p[i] = add_scaled(s[i], beta, p[i]); }

/* r = b - A x */
CGAL_SP_FUNCTION void residual_at(int i, graph_view a, vec3_in b, vec3_in x, vec3_out r)
{
  r[i] = sub(b[i], laplacian(i, a, x));
}

/* x = gain D^-1 b, the damped Jacobi step from 0 */
CGAL_SP_FUNCTION void start_smoothing_at(int i, real_in inverse_diagonal, real gain, vec3_in b, vec3_out x)
{
  x[i] = scale(gain * inverse_diagonal[i], b[i]);
}

/* y = x + gain D^-1 (b - A x), a damped Jacobi step */
CGAL_SP_FUNCTION void smooth_at(int i, graph_view a, real gain, vec3_in b, vec3_in x, vec3_out y)
{
  y[i] = add_scaled(x[i], gain * a.inverse_diagonal[i], sub(b[i], laplacian(i, a, x)));
}

/* x += T e: every vertex gets the value of its aggregate */
CGAL_SP_FUNCTION void correct_at(int i, aggregates_view of, vec3_in e, vec3_out x)
{
  const int own = of.of_vertex[i];
  if(own >= 0)
    x[i] = add(x[i], e[own]);
}

/* y = T^T r, of aggregate c */
CGAL_SP_FUNCTION void restrict_at(int c, aggregates_view of, vec3_in r, vec3_out y)
{
  vec3 sum = make_vec3(0, 0, 0);
  for(int m = of.offset[c]; m < of.offset[c + 1]; ++m)
    sum = add(sum, r[of.member[m]]);
  y[c] = sum;
}

/* y = B x, B a dense matrix with so many columns, row by row */
CGAL_SP_FUNCTION void multiply_dense_at(int i, int columns, real_in b, vec3_in x, vec3_out y)
{
  const size_t stride = columns;
  real_in row = b + stride * i;
  vec3 sum = make_vec3(0, 0, 0);
  for(int j = 0; j < columns; ++j)
    sum = add_scaled(sum, row[j], x[j]);
  y[i] = sum;
}

#ifndef __OPENCL_C_VERSION__
} // namespace CGAL::Spherical_parameterization::internal
#endif

#endif
