/* SPDX-License-Identifier: LGPL-3.0-or-later
 * Part of CGAL Spherical Parameterization.
 *
 * The verbs of the descent on the sphere: see formulas/spring_energy.h for what they compute.
 */

/* Gradient and curvature are kernels twice, for exponent 2 and for all others: the mere presence of powers (measured
 * with the driver's own pow()) makes the code of a CPU driver three times slower, even where none is taken. */

KERNEL sp_energy(int n, MATRIX(a), vec3_in v, real_out partial)
{
  SUMS(1);
  FOR_EACH_OF_BLOCK(i, n)
  energy_at(i, VIEW(a), v, s);
  ADD_UP(1);
}

KERNEL sp_gradient(int n, MATRIX(a), vec3_in v, vec3_out g, real_out density, real_out partial)
{
  SUMS(4);
  FOR_EACH_OF_BLOCK(i, n)
  gradient_at(i, VIEW(a), v, g, density, s);
  ADD_UP(4);
}

KERNEL sp_stiffening_gradient(int n, MATRIX(a), real p, vec3_in v, vec3_out g, real_out density, real_out partial)
{
  SUMS(4);
  FOR_EACH_OF_BLOCK(i, n)
  stiffening_gradient_at(i, VIEW(a), p, v, g, density, s);
  ADD_UP(4);
}

KERNEL sp_spring_masses(int n, MATRIX(a), vec3_in v, real_out m)
{
  FOR_EACH(i, n)
  spring_masses_at(i, VIEW(a), v, m);
}

KERNEL sp_tilt_masses(int n, real_in density, vec3 tilt, vec3_in v, real_out m, real_out partial)
{
  SUMS(9);
  FOR_EACH_OF_BLOCK(i, n)
  tilt_masses_at(i, density, tilt, v, m, s);
  ADD_UP(9);
}

KERNEL sp_curvature(int n, MATRIX(a), real_in mass, vec3 mu, vec3_in v, float4_in d, real_in density, real_out partial)
{
  SUMS(5);
  FOR_EACH_OF_BLOCK(i, n)
  curvature_at(i, VIEW(a), mass, mu, v, d, density, s);
  ADD_UP(5);
}

KERNEL sp_stiffening_curvature(int n, MATRIX(a), real p, real_in mass, vec3 mu, vec3_in v, float4_in d, real_in density,
                               real_out partial)
{
  SUMS(5);
  FOR_EACH_OF_BLOCK(i, n)
  stiffening_curvature_at(i, VIEW(a), p, mass, mu, v, d, density, s);
  ADD_UP(5);
}

KERNEL sp_balance_gradient(int n, real_in inverse_diagonal, real_in mass, vec3 mu, vec3_in v, vec3_in g, float4_in step,
                           float4_out b, real_out partial)
{
  SUMS(2);
  FOR_EACH_OF_BLOCK(i, n)
  balance_gradient_at(i, inverse_diagonal, mass, mu, v, g, step, b, s);
  ADD_UP(2);
}

KERNEL sp_direction_products(int n, real_in inverse_diagonal, real_in mass, vec3_in v, float4_in b, float4_in step,
                             float4_in d, real_out partial)
{
  SUMS(14);
  FOR_EACH_OF_BLOCK(i, n)
  direction_products_at(i, inverse_diagonal, mass, v, b, step, d, s);
  ADD_UP(14);
}

KERNEL sp_next_direction(int n, real beta, vec3 y, vec3 omega, vec3_in v, float4_in step, float4_out d)
{
  FOR_EACH(i, n)
  next_direction_at(i, beta, y, omega, v, step, d);
}

KERNEL sp_retract(int n, real_in mass, real alpha, vec3 c, vec3_in v, float4_in d, vec3_out w, real_out partial)
{
  SUMS(9);
  FOR_EACH_OF_BLOCK(i, n)
  retract_at(i, mass, alpha, c, v, d, w, s);
  ADD_UP(9);
}

KERNEL sp_moments(int n, real_in mass, vec3_in v, real_out partial)
{
  SUMS(9);
  FOR_EACH_OF_BLOCK(i, n)
  moments_at(i, mass, v, s);
  ADD_UP(9);
}

KERNEL sp_transform(int n, real_in mass, vec3 c, vec3_in v, vec3_out w, real_out partial)
{
  SUMS(9);
  FOR_EACH_OF_BLOCK(i, n)
  transform_at(i, mass, c, v, w, s);
  ADD_UP(9);
}
