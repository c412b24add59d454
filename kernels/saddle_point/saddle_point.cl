/* SPDX-License-Identifier: LGPL-3.0-or-later
 * Part of CGAL Spherical Parameterization.
 *
 * The verbs of the published method: see formulas/saddle_point.h for what they compute.
 */

KERNEL sp_jacobi_sweep(int n, MATRIX(a), real omega, vec3_in v, vec3_in u, vec3_out w)
{
  FOR_EACH(i, n)
  jacobi_sweep_at(i, VIEW(a), omega, v, u, w);
}

/* For the n vertices of one colour. */
KERNEL sp_gauss_seidel_sweep(int n, MATRIX(a), int_in colour, real omega, vec3_in v, vec3_out u)
{
  FOR_EACH(k, n)
  gauss_seidel_sweep_at(k, VIEW(a), colour, omega, v, u);
}

KERNEL sp_saddle_point_residual2(int n, MATRIX(a), vec3_in v, vec3_in u, real_out partial)
{
  SUMS(1);
  FOR_EACH_OF_BLOCK(i, n)
  saddle_point_residual2_at(i, VIEW(a), v, u, s);
  ADD_UP(1);
}

KERNEL sp_normalize(int n, real_in inverse_diagonal, vec3_in u, vec3_out v)
{
  FOR_EACH(i, n)
  normalize_at(i, inverse_diagonal, u, v);
}

KERNEL sp_barycentric_residual2(int n, MATRIX(a), vec3_in v, real_out partial)
{
  SUMS(1);
  FOR_EACH_OF_BLOCK(i, n)
  barycentric_residual2_at(i, VIEW(a), v, s);
  ADD_UP(1);
}
