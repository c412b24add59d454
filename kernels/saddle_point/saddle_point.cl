/* SPDX-License-Identifier: LGPL-3.0-or-later
 * Part of CGAL Spherical Parameterization.
 *
 * The verbs of the published method: see Host_backend.h for what they compute, formulas/saddle_point.h for how.
 */

KERNEL sp_jacobi_sweep(int n, MATRIX(a), real omega, CONST_VECTORS v, CONST_VECTORS u, VECTORS w)
{
  FOR_EACH(i, n)
  jacobi_sweep_at(i, VIEW(a), omega, v, u, w);
}

/* For the n vertices of one colour. */
KERNEL sp_gauss_seidel_sweep(int n, MATRIX(a), INDICES colour, real omega, CONST_VECTORS v, VECTORS u)
{
  FOR_EACH(k, n)
  gauss_seidel_sweep_at(k, VIEW(a), colour, omega, v, u);
}

KERNEL sp_saddle_point_residual2(int n, MATRIX(a), CONST_VECTORS v, CONST_VECTORS u, SCALARS partial)
{
  SUMS(1);
  FOR_EACH_OF_BLOCK(i, n)
  saddle_point_residual2_at(i, VIEW(a), v, u, s);
  ADD_UP(1);
}

KERNEL sp_normalize(int n, CONST_SCALARS inverse_diagonal, CONST_VECTORS u, VECTORS v)
{
  FOR_EACH(i, n)
  normalize_at(i, inverse_diagonal, u, v);
}

KERNEL sp_barycentric_residual2(int n, MATRIX(a), CONST_VECTORS v, SCALARS partial)
{
  SUMS(1);
  FOR_EACH_OF_BLOCK(i, n)
  barycentric_residual2_at(i, VIEW(a), v, s);
  ADD_UP(1);
}
