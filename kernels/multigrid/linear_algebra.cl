/* SPDX-License-Identifier: LGPL-3.0-or-later
 * Part of CGAL Spherical Parameterization.
 *
 * The verbs of linear algebra: see Host_backend.h for what they compute, formulas/linear_algebra.h for how.
 */

KERNEL sp_copy(int n, CONST_VECTORS x, VECTORS y)
{
  FOR_EACH(i, n)
  copy_at(i, x, y);
}

KERNEL sp_dot(int n, CONST_VECTORS x, CONST_VECTORS y, SCALARS partial)
{
  SUMS(1);
  FOR_EACH_OF_BLOCK(i, n)
  dot_at(i, x, y, s);
  ADD_UP(1);
}

KERNEL sp_multiply(int n, MATRIX(a), CONST_VECTORS x, VECTORS y, SCALARS partial)
{
  SUMS(1);
  FOR_EACH_OF_BLOCK(i, n)
  multiply_at(i, VIEW(a), x, y, s);
  ADD_UP(1);
}

KERNEL sp_descend(int n, real alpha, CONST_VECTORS p, CONST_VECTORS q, VECTORS x, VECTORS r)
{
  FOR_EACH(i, n)
  descend_at(i, alpha, p, q, x, r);
}

KERNEL sp_conjugate(int n, real beta, CONST_VECTORS s, VECTORS p)
{
  FOR_EACH(i, n)
  conjugate_at(i, beta, s, p);
}

KERNEL sp_residual(int n, MATRIX(a), CONST_VECTORS b, CONST_VECTORS x, VECTORS r)
{
  FOR_EACH(i, n)
  residual_at(i, VIEW(a), b, x, r);
}

KERNEL sp_start_smoothing(int n, CONST_SCALARS inverse_diagonal, real gain, CONST_VECTORS b, VECTORS x)
{
  FOR_EACH(i, n)
  start_smoothing_at(i, inverse_diagonal, gain, b, x);
}

KERNEL sp_smooth(int n, MATRIX(a), real gain, CONST_VECTORS b, CONST_VECTORS x, VECTORS y)
{
  FOR_EACH(i, n)
  smooth_at(i, VIEW(a), gain, b, x, y);
}

KERNEL sp_transfer(int n, TRANSFER(t), CONST_VECTORS x, VECTORS y)
{
  FOR_EACH(i, n)
  transfer_at(i, TRANSFER_VIEW(t), x, y);
}

KERNEL sp_transfer_add(int n, TRANSFER(t), CONST_VECTORS x, VECTORS y)
{
  FOR_EACH(i, n)
  transfer_add_at(i, TRANSFER_VIEW(t), x, y);
}

KERNEL sp_multiply_dense(int n, CONST_SCALARS b, CONST_VECTORS x, VECTORS y)
{
  FOR_EACH(i, n)
  multiply_dense_at(i, n, b, x, y);
}
