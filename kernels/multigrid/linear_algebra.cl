/* SPDX-License-Identifier: LGPL-3.0-or-later
 * Part of CGAL Spherical Parameterization.
 *
 * The verbs of linear algebra; see Host_backend for what they compute.
 */

KERNEL sp_copy(int n, CONST_VECTORS x, VECTORS y)
{
  FOR_EACH(i, n)
  y[i] = x[i];
}

KERNEL sp_dot(int n, CONST_VECTORS x, CONST_VECTORS y, SCALARS partial)
{
  SUMS(1);
  FOR_EACH_OF_BLOCK(i, n)
  s[0] += inner(x[i], y[i]);
  ADD_UP(1);
}

KERNEL sp_multiply(int n, MATRIX(a), CONST_VECTORS x, VECTORS y, SCALARS partial)
{
  SUMS(1);
  FOR_EACH_OF_BLOCK(i, n)
  {
    y[i] = laplacian(i, VIEW(a), x);
    s[0] += inner(x[i], y[i]);
  }
  ADD_UP(1);
}

KERNEL sp_descend(int n, real alpha, CONST_VECTORS p, CONST_VECTORS q, VECTORS x, VECTORS r)
{
  FOR_EACH(i, n)
  {
    x[i] = add_scaled(x[i], alpha, p[i]);
    r[i] = add_scaled(r[i], -alpha, q[i]);
  }
}

KERNEL sp_conjugate(int n, real beta, CONST_VECTORS s, VECTORS p)
{
  FOR_EACH(i, n)
  p[i] = add_scaled(s[i], beta, p[i]);
}

KERNEL sp_energy(int n, MATRIX(a), CONST_VECTORS x, SCALARS partial)
{
  SUMS(1);
  FOR_EACH_OF_BLOCK(i, n)
  s[0] += spring_density(i, VIEW(a), 2, x);
  ADD_UP(1);
}

KERNEL sp_residual(int n, MATRIX(a), CONST_VECTORS b, CONST_VECTORS x, VECTORS r)
{
  FOR_EACH(i, n)
  r[i] = sub(b[i], laplacian(i, VIEW(a), x));
}

KERNEL sp_start_smoothing(int n, CONST_SCALARS inverse_diagonal, real gain, CONST_VECTORS b, VECTORS x)
{
  FOR_EACH(i, n)
  x[i] = scale(gain * inverse_diagonal[i], b[i]);
}

KERNEL sp_smooth(int n, MATRIX(a), real gain, CONST_VECTORS b, CONST_VECTORS x, VECTORS y)
{
  FOR_EACH(i, n)
  y[i] = smoothing_step(i, VIEW(a), gain, b, x);
}

KERNEL sp_transfer(int n, TRANSFER(t), CONST_VECTORS x, VECTORS y)
{
  FOR_EACH(i, n)
  y[i] = row_times(i, TRANSFER_VIEW(t), x);
}

KERNEL sp_transfer_add(int n, TRANSFER(t), CONST_VECTORS x, VECTORS y)
{
  FOR_EACH(i, n)
  y[i] = add(y[i], row_times(i, TRANSFER_VIEW(t), x));
}

KERNEL sp_multiply_dense(int n, CONST_SCALARS b, CONST_VECTORS x, VECTORS y)
{
  FOR_EACH(i, n)
  {
    vec3 r = make_vec3(0, 0, 0);
    for(int j = 0; j < n; ++j)
      r = add_scaled(r, b[(size_t)i * n + j], x[j]);
    y[i] = r;
  }
}
