/* SPDX-License-Identifier: LGPL-3.0-or-later
 * Part of CGAL Spherical Parameterization.
 *
 * The verbs of linear algebra: see formulas/linear_algebra.h for what they compute.
 */

KERNEL sp_copy(int n, vec3_in x, vec3_out y)
{
  FOR_EACH(i, n)
  copy_at(i, x, y);
}

KERNEL sp_dot(int n, vec3_in x, vec3_in y, real_out partial)
{
  SUMS(1);
  FOR_EACH_OF_BLOCK(i, n)
  dot_at(i, x, y, s);
  ADD_UP(1);
}

KERNEL sp_multiply(int n, MATRIX(a), vec3_in x, vec3_out y, real_out partial)
{
  SUMS(1);
  FOR_EACH_OF_BLOCK(i, n)
  multiply_at(i, VIEW(a), x, y, s);
  ADD_UP(1);
}

KERNEL sp_descend(int n, real alpha, vec3_in p, vec3_in q, vec3_out x, vec3_out r)
{
  FOR_EACH(i, n)
  descend_at(i, alpha, p, q, x, r);
}

KERNEL sp_conjugate(int n, real beta, vec3_in s, vec3_out p)
{
  FOR_EACH(i, n)
  conjugate_at(i, beta, s, p);
}

KERNEL sp_residual(int n, MATRIX(a), vec3_in b, vec3_in x, vec3_out r)
{
  FOR_EACH(i, n)
  residual_at(i, VIEW(a), b, x, r);
}

KERNEL sp_start_smoothing(int n, real_in inverse_diagonal, real gain, vec3_in b, vec3_out x)
{
  FOR_EACH(i, n)
  start_smoothing_at(i, inverse_diagonal, gain, b, x);
}

KERNEL sp_smooth(int n, MATRIX(a), real gain, vec3_in b, vec3_in x, vec3_out y)
{
  FOR_EACH(i, n)
  smooth_at(i, VIEW(a), gain, b, x, y);
}

KERNEL sp_correct(int n, AGGREGATES(of), vec3_in e, vec3_out x)
{
  FOR_EACH(i, n)
  correct_at(i, AGGREGATES_VIEW(of), e, x);
}

KERNEL sp_restrict(int n, AGGREGATES(of), vec3_in r, vec3_out y)
{
  FOR_EACH(c, n)
  restrict_at(c, AGGREGATES_VIEW(of), r, y);
}

KERNEL sp_multiply_dense(int n, int columns, real_in b, vec3_in x, vec3_out y)
{
  FOR_EACH(i, n)
  multiply_dense_at(i, columns, b, x, y);
}
