/* SPDX-License-Identifier: LGPL-3.0-or-later
 * Part of CGAL Spherical Parameterization.
 *
 * The verbs of a multigrid cycle in floats: see formulas/float_cycle.h for what they compute.
 */

KERNEL sp_float_start_smoothing(int n, SMOOTHER(a), real gain, real second_gain, float4_in b, float4_out x)
{
  FOR_EACH(i, n)
  float_start_smoothing_at(i, SMOOTHER_VIEW(a), gain, second_gain, b, x);
}

KERNEL sp_float_smooth(int n, SMOOTHER(a), real gain, float4_in b, float4_in x, float4_out y)
{
  FOR_EACH(i, n)
  float_smooth_at(i, SMOOTHER_VIEW(a), gain, b, x, y);
}

KERNEL sp_float_residual(int n, SMOOTHER(a), float4_in b, float4_in x, float4_out r)
{
  FOR_EACH(i, n)
  float_residual_at(i, SMOOTHER_VIEW(a), b, x, r);
}

KERNEL sp_float_restrict(int n, AGGREGATES(of), float_in share, float4_in r, float4_out y)
{
  FOR_EACH(c, n)
  float_restrict_at(c, AGGREGATES_VIEW(of), share, r, y);
}

KERNEL sp_float_correct(int n, AGGREGATES(of), float4_in e, float4_out x)
{
  FOR_EACH(i, n)
  float_correct_at(i, AGGREGATES_VIEW(of), e, x);
}

KERNEL sp_float_multiply_dense(int n, int columns, real_in b, real_in inverse_diagonal, float4_in x, float4_out y)
{
  FOR_EACH(i, n)
  float_multiply_dense_at(i, columns, b, inverse_diagonal, x, y);
}
