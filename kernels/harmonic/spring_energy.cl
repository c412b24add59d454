/* SPDX-License-Identifier: LGPL-3.0-or-later
 * Part of CGAL Spherical Parameterization.
 *
 * The verbs of the descent on the sphere; see Host_backend for what they compute.
 */

/* Gradient and curvature are kernels twice, for exponent 2 and for all others: the mere presence of pow() makes the
 * code of a CPU driver three times slower, even where it is not called. */
#define GRADIENT(p)                                                                                                    \
  SUMS(4);                                                                                                             \
  FOR_EACH_OF_BLOCK(i, n)                                                                                              \
  {                                                                                                                    \
    real energy;                                                                                                       \
    g[i] = spring_gradient(i, VIEW(a), p, v, &energy);                                                                 \
    density[i] = energy;                                                                                               \
    s[0] += energy;                                                                                                    \
    s[1] += g[i].x;                                                                                                    \
    s[2] += g[i].y;                                                                                                    \
    s[3] += g[i].z;                                                                                                    \
  }                                                                                                                    \
  ADD_UP(4)

KERNEL sp_gradient(int n, MATRIX(a), CONST_VECTORS v, VECTORS g, SCALARS density, SCALARS partial) { GRADIENT(2); }

KERNEL sp_stiffening_gradient(int n, MATRIX(a), real p, CONST_VECTORS v, VECTORS g, SCALARS density, SCALARS partial)
{
  GRADIENT(p);
}

KERNEL sp_spring_masses(int n, MATRIX(a), CONST_VECTORS v, SCALARS m)
{
  FOR_EACH(i, n)
  m[i] = fmax((real)0, spring_density(i, VIEW(a), 2, v));
}

KERNEL sp_balance_gradient(int n, CONST_SCALARS inverse_diagonal, CONST_SCALARS mass, vec3 mu, CONST_VECTORS v,
                           VECTORS g, SCALARS partial)
{
  SUMS(1);
  FOR_EACH_OF_BLOCK(i, n)
  {
    g[i] = add_scaled(g[i], -mass[i], tangent(mu, v[i]));
    s[0] += inner(g[i], g[i]) * inverse_diagonal[i] * inverse_diagonal[i];
  }
  ADD_UP(1);
}

KERNEL sp_direction_products(int n, CONST_SCALARS mass, CONST_VECTORS v, CONST_VECTORS g, CONST_VECTORS old_g,
                             CONST_VECTORS step, CONST_VECTORS d, SCALARS partial)
{
  SUMS(15);
  FOR_EACH_OF_BLOCK(i, n)
  {
    const vec3 tangent_step = tangent(step[i], v[i]);
    s[0] += inner(old_g[i], tangent_step);
    add_products(mass[i], v[i], g[i], tangent_step, s + 1);
    add_products(mass[i], v[i], g[i], tangent(d[i], v[i]), s + 8);
  }
  ADD_UP(15);
}

KERNEL sp_direct(int n, real beta, vec3 y, vec3 omega, CONST_VECTORS v, CONST_VECTORS step, VECTORS d)
{
  FOR_EACH(i, n)
  d[i] = next_direction(beta, y, omega, v[i], step[i], d[i]);
}

#define CURVATURE(p)                                                                                                   \
  SUMS(5);                                                                                                             \
  FOR_EACH_OF_BLOCK(i, n)                                                                                              \
  {                                                                                                                    \
    s[0] += spring_curvature(i, VIEW(a), p, v, d, density[i] - mass[i] * inner(mu, v[i]));                             \
    const real push = mass[i] * inner(d[i], d[i]);                                                                     \
    s[1] += push;                                                                                                      \
    s[2] += push * v[i].x;                                                                                             \
    s[3] += push * v[i].y;                                                                                             \
    s[4] += push * v[i].z;                                                                                             \
  }                                                                                                                    \
  ADD_UP(5)

KERNEL sp_curvature(int n, MATRIX(a), CONST_SCALARS mass, vec3 mu, CONST_VECTORS v, CONST_VECTORS d,
                    CONST_SCALARS density, SCALARS partial)
{
  CURVATURE(2);
}

KERNEL sp_stiffening_curvature(int n, MATRIX(a), real p, CONST_SCALARS mass, vec3 mu, CONST_VECTORS v, CONST_VECTORS d,
                               CONST_SCALARS density, SCALARS partial)
{
  CURVATURE(p);
}

KERNEL sp_retract(int n, CONST_SCALARS mass, real alpha, vec3 c, CONST_VECTORS v, CONST_VECTORS d, VECTORS w,
                  SCALARS partial)
{
  SUMS(9);
  FOR_EACH_OF_BLOCK(i, n)
  {
    w[i] = displaced(v[i], alpha, d[i], c);
    add_moments(mass[i], w[i], s);
  }
  ADD_UP(9);
}

KERNEL sp_moments(int n, CONST_SCALARS mass, CONST_VECTORS v, SCALARS partial)
{
  SUMS(9);
  FOR_EACH_OF_BLOCK(i, n)
  add_moments(mass[i], v[i], s);
  ADD_UP(9);
}

KERNEL sp_transform(int n, CONST_SCALARS mass, vec3 c, CONST_VECTORS v, VECTORS w, SCALARS partial)
{
  SUMS(9);
  FOR_EACH_OF_BLOCK(i, n)
  {
    w[i] = boost(v[i], c);
    add_moments(mass[i], w[i], s);
  }
  ADD_UP(9);
}
