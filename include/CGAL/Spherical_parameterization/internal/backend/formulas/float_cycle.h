/* SPDX-License-Identifier: LGPL-3.0-or-later
 * Part of CGAL Spherical Parameterization.
 *
 * Formulas of a multigrid cycle in floats. See vertex_formulas.h, and Float_cycle for what they are for.
 *
 * A x = b is written D^-1 A x = D^-1 b, d_i = 1 / inverse_diagonal[i]: right-hand sides are steps, too, and the unit of
 * the weights does not matter. Within a graph weights may differ by a factor of 1e12; beyond that what is stiff is
 * noise, and from 1e38 on floats overflow.
 */
#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_FORMULAS_FLOAT_CYCLE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_FORMULAS_FLOAT_CYCLE_H

#ifndef __OPENCL_C_VERSION__
#include <CGAL/Spherical_parameterization/internal/backend/formulas/linear_algebra.h>
namespace CGAL::Spherical_parameterization::internal {
#endif

/* D^-1 A, A the matrix of a weighted graph */
typedef struct {
  int_in offset;
  int_in target;
  float_in weight; /* w_ij / d_i; 0 in the rows of fixed vertices */
  float_in excess; /* e_i / d_i; null: zero */
} smoother_view;

/* returns (D^-1 A x)_i */
CGAL_SP_FUNCTION float4 scaled_laplacian(int i, smoother_view a, float4_in x)
{
  const float4 xi = x[i];
  float4 sum = to_float4(make_vec3(0, 0, 0));
  const int end = a.offset[i + 1];
  for(int k = a.offset[i]; k < end; ++k)
    sum += a.weight[k] * (xi - x[a.target[k]]);
  return a.excess ? sum + a.excess[i] * xi : sum;
}

/* x = (gain + second_gain) b - gain second_gain D^-1 A b, two damped Jacobi steps, the first one from 0 */
CGAL_SP_FUNCTION void float_start_smoothing_at(int i, smoother_view a, real gain, real second_gain, float4_in b,
                                               float4_out x)
{
  x[i] = (float)(gain + second_gain) * b[i] - (float)(gain * second_gain) * scaled_laplacian(i, a, b);
}

/* y = x + gain (b - D^-1 A x), a damped Jacobi step */
CGAL_SP_FUNCTION void float_smooth_at(int i, smoother_view a, real gain, float4_in b, float4_in x, float4_out y)
{
  y[i] = x[i] + (float)gain * (b[i] - scaled_laplacian(i, a, x));
}

/* r = b - D^-1 A x */
CGAL_SP_FUNCTION void float_residual_at(int i, smoother_view a, float4_in b, float4_in x, float4_out r)
{
  r[i] = b[i] - scaled_laplacian(i, a, x);
}

/* y = D_c^-1 T^T D r, of aggregate c; share: d_i / d_c */
CGAL_SP_FUNCTION void float_restrict_at(int c, aggregates_view of, float_in share, float4_in r, float4_out y)
{
  float4 sum = to_float4(make_vec3(0, 0, 0));
  for(int m = of.offset[c]; m < of.offset[c + 1]; ++m)
    sum += share[of.member[m]] * r[of.member[m]];
  y[c] = sum;
}

/* x += T e: every vertex gets the value of its aggregate */
CGAL_SP_FUNCTION void float_correct_at(int i, aggregates_view of, float4_in e, float4_out x)
{
  const int own = of.of_vertex[i];
  if(own >= 0)
    x[i] += e[own];
}

/* y = B D x, B a dense matrix with so many columns, row by row. B stays in doubles: the inverse of an almost singular
 * matrix is a large constant plus what counts, which floats would round away. */
CGAL_SP_FUNCTION void float_multiply_dense_at(int i, int columns, real_in b, real_in inverse_diagonal, float4_in x,
                                              float4_out y)
{
  const size_t stride = columns;
  real_in row = b + stride * i;
  vec3 sum = make_vec3(0, 0, 0);
  for(int j = 0; j < columns; ++j)
    if(inverse_diagonal[j] > 0)
      sum = add_scaled(sum, row[j] / inverse_diagonal[j], to_vec3(x[j]));
  y[i] = to_float4(sum);
}

#ifndef __OPENCL_C_VERSION__
} // namespace CGAL::Spherical_parameterization::internal
#endif

#endif
