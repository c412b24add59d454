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

#ifdef __OPENCL_C_VERSION__
#define CGAL_SP_GLOBAL __global
#else
#include <CGAL/Spherical_parameterization/internal/base/vec3.h>
#include <cstddef>
#define CGAL_SP_GLOBAL
namespace CGAL::Spherical_parameterization::internal {
using std::size_t;
#endif

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

/* returns (A x)_i */
CGAL_SP_FUNCTION vec3 laplacian(int i, graph_view a, CGAL_SP_GLOBAL const vec3* x)
{
  const vec3 xi = x[i];
  vec3 sum = make_vec3(0, 0, 0);
  const int end = a.offset[i + 1];
  for(int k = a.offset[i]; k < end; ++k)
    sum = add_scaled(sum, a.weight[k], sub(xi, x[a.target[k]]));
  return a.excess ? add_scaled(sum, a.excess[i], xi) : sum;
}

/* returns (T x)_i */
CGAL_SP_FUNCTION vec3 row_times(int i, sparse_view t, CGAL_SP_GLOBAL const vec3* x)
{
  vec3 sum = make_vec3(0, 0, 0);
  const int end = t.offset[i + 1];
  for(int k = t.offset[i]; k < end; ++k)
    sum = add_scaled(sum, t.value[k], x[t.column[k]]);
  return sum;
}

/* y = x */
CGAL_SP_FUNCTION void copy_at(int i, CGAL_SP_GLOBAL const vec3* x, CGAL_SP_GLOBAL vec3* y) { y[i] = x[i]; }

/* s[0]: x . y */
CGAL_SP_FUNCTION void dot_at(int i, CGAL_SP_GLOBAL const vec3* x, CGAL_SP_GLOBAL const vec3* y, real* s)
{
  s[0] += inner(x[i], y[i]);
}

/* y = A x; s[0]: x . y */
CGAL_SP_FUNCTION void multiply_at(int i, graph_view a, CGAL_SP_GLOBAL const vec3* x, CGAL_SP_GLOBAL vec3* y, real* s)
{
  y[i] = laplacian(i, a, x);
  s[0] += inner(x[i], y[i]);
}

/* x += alpha p and r -= alpha q */
CGAL_SP_FUNCTION void descend_at(int i, real alpha, CGAL_SP_GLOBAL const vec3* p, CGAL_SP_GLOBAL const vec3* q,
                                 CGAL_SP_GLOBAL vec3* x, CGAL_SP_GLOBAL vec3* r)
{
  x[i] = add_scaled(x[i], alpha, p[i]);
  r[i] = add_scaled(r[i], -alpha, q[i]);
}

/* p = s + beta p */
CGAL_SP_FUNCTION void conjugate_at(int i, real beta, CGAL_SP_GLOBAL const vec3* s, CGAL_SP_GLOBAL vec3* p)
{
  p[i] = add_scaled(s[i], beta, p[i]);
}

/* r = b - A x */
CGAL_SP_FUNCTION void residual_at(int i, graph_view a, CGAL_SP_GLOBAL const vec3* b, CGAL_SP_GLOBAL const vec3* x,
                                  CGAL_SP_GLOBAL vec3* r)
{
  r[i] = sub(b[i], laplacian(i, a, x));
}

/* x = gain D^-1 b, the damped Jacobi step from 0 */
CGAL_SP_FUNCTION void start_smoothing_at(int i, CGAL_SP_GLOBAL const real* inverse_diagonal, real gain,
                                         CGAL_SP_GLOBAL const vec3* b, CGAL_SP_GLOBAL vec3* x)
{
  x[i] = scale(gain * inverse_diagonal[i], b[i]);
}

/* y = x + gain D^-1 (b - A x), a damped Jacobi step */
CGAL_SP_FUNCTION void smooth_at(int i, graph_view a, real gain, CGAL_SP_GLOBAL const vec3* b,
                                CGAL_SP_GLOBAL const vec3* x, CGAL_SP_GLOBAL vec3* y)
{
  y[i] = add_scaled(x[i], gain * a.inverse_diagonal[i], sub(b[i], laplacian(i, a, x)));
}

/* y = T x */
CGAL_SP_FUNCTION void transfer_at(int i, sparse_view t, CGAL_SP_GLOBAL const vec3* x, CGAL_SP_GLOBAL vec3* y)
{
  y[i] = row_times(i, t, x);
}

/* y += T x */
CGAL_SP_FUNCTION void transfer_add_at(int i, sparse_view t, CGAL_SP_GLOBAL const vec3* x, CGAL_SP_GLOBAL vec3* y)
{
  y[i] = add(y[i], row_times(i, t, x));
}

/* y = B x, B a dense matrix of n rows and n columns, row by row */
CGAL_SP_FUNCTION void multiply_dense_at(int i, int n, CGAL_SP_GLOBAL const real* b, CGAL_SP_GLOBAL const vec3* x,
                                        CGAL_SP_GLOBAL vec3* y)
{
  const size_t columns = n;
  CGAL_SP_GLOBAL const real* row = b + columns * i;
  vec3 sum = make_vec3(0, 0, 0);
  for(int j = 0; j < n; ++j)
    sum = add_scaled(sum, row[j], x[j]);
  y[i] = sum;
}

#ifndef __OPENCL_C_VERSION__
} // namespace CGAL::Spherical_parameterization::internal
#endif

#endif
