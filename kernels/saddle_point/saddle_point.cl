/* SPDX-License-Identifier: LGPL-3.0-or-later
 * Part of CGAL Spherical Parameterization.
 *
 * The verbs of the published method; see Host_backend for what they compute.
 */

KERNEL sp_jacobi_sweep(int n, MATRIX(a), real omega, CONST_VECTORS v, CONST_VECTORS u, VECTORS w)
{
  FOR_EACH(i, n)
  w[i] = saddle_point_relaxation(i, VIEW(a), omega, v, u);
}

/* For the n vertices of one colour. */
KERNEL sp_gauss_seidel_sweep(int n, MATRIX(a), INDICES colour, real omega, CONST_VECTORS v, VECTORS u)
{
  FOR_EACH(k, n)
  u[colour[k]] = saddle_point_relaxation(colour[k], VIEW(a), omega, v, u);
}

KERNEL sp_saddle_point_residual2(int n, MATRIX(a), CONST_VECTORS v, CONST_VECTORS u, SCALARS partial)
{
  SUMS(1);
  FOR_EACH_OF_BLOCK(i, n)
  {
    const vec3 step = sub(saddle_point_relaxation(i, VIEW(a), 1, v, u), u[i]);
    s[0] += inner(step, step);
  }
  ADD_UP(1);
}

KERNEL sp_normalise(int n, CONST_SCALARS inverse_diagonal, CONST_VECTORS u, VECTORS v)
{
  FOR_EACH(i, n)
  if(inverse_diagonal[i] > 0)
    v[i] = unit(u[i]);
}

KERNEL sp_barycentric_residual2(int n, MATRIX(a), CONST_VECTORS v, SCALARS partial)
{
  SUMS(1);
  FOR_EACH_OF_BLOCK(i, n)
  {
    const vec3 r = barycentric_residual(i, VIEW(a), v);
    s[0] += inner(r, r);
  }
  ADD_UP(1);
}
