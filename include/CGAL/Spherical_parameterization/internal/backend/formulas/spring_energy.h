/* SPDX-License-Identifier: LGPL-3.0-or-later
 * Part of CGAL Spherical Parameterization.
 *
 * Formulas of the spring energy on the sphere, of the descent on it, and of balance. See vertex_formulas.h.
 */
#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_FORMULAS_SPRING_ENERGY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_FORMULAS_SPRING_ENERGY_H

#ifndef __OPENCL_C_VERSION__
#include <CGAL/Spherical_parameterization/internal/backend/formulas/linear_algebra.h>
#include <CGAL/Spherical_parameterization/internal/backend/formulas/power.h>
namespace CGAL::Spherical_parameterization::internal {
#endif

/* Adds v to s[0] ... s[2]. */
CGAL_SP_FUNCTION void add_to(vec3 v, real* s)
{
  s[0] += v.x;
  s[1] += v.y;
  s[2] += v.z;
}

/* ---- the energy and its derivatives ------------------------------------------------------------------------------ */

/* Weight of a spring of exponent p whose ends are apart by the square root of squared_length: w length^(p-2). */
CGAL_SP_FUNCTION real spring_weight(real w, real squared_length, real p)
{
  return p == 2 ? w : (squared_length > 0 ? w * power(squared_length, p / 2 - 1) : 0);
}

/* returns sum_j w_ij(v) |v_i - v_j|^2 / 2; the densities of all vertices sum up to p E */
CGAL_SP_FUNCTION real spring_density(int i, graph_view a, real p, vec3_in v)
{
  real sum = 0;
  const int end = a.offset[i + 1];
  for(int k = a.offset[i]; k < end; ++k) {
    const vec3 delta = sub(v[i], v[a.target[k]]);
    const real length2 = inner(delta, delta);
    sum += spring_weight(a.weight[k], length2, p) * length2;
  }
  return sum / 2;
}

/* s[0]: the energy of exponent 2, sum over edges of w |v_i - v_j|^2 / 2 */
CGAL_SP_FUNCTION void energy_at(int i, graph_view a, vec3_in v, real* s) { s[0] += spring_density(i, a, 2, v) / 2; }

/* g = P_i (L(v) v)_i, the tangent gradient of the spring energy, and 0 at fixed vertices; density = spring density:
 * |v_i - v_j|^2 / 2 is v_i . (v_i - v_j) for unit vectors; s[0]: p E; s[1] ... s[3]: g */
CGAL_SP_FUNCTION void stiffening_gradient_at(int i, graph_view a, real p, vec3_in v, vec3_out g, real_out density,
                                             real* s)
{
  const vec3 vi = v[i];
  vec3 sum = make_vec3(0, 0, 0);
  const int end = a.offset[i + 1];
  for(int k = a.offset[i]; k < end; ++k) {
    const vec3 delta = sub(vi, v[a.target[k]]);
    sum = add_scaled(sum, spring_weight(a.weight[k], inner(delta, delta), p), delta);
  }
  density[i] = inner(vi, sum);
  g[i] = a.inverse_diagonal[i] > 0 ? tangent(sum, vi) : make_vec3(0, 0, 0);
  s[0] += density[i];
  add_to(g[i], s + 1);
}

/* The same for exponent 2, without what powers cost even where they are not taken. */
CGAL_SP_FUNCTION void gradient_at(int i, graph_view a, vec3_in v, vec3_out g, real_out density, real* s)
{
  stiffening_gradient_at(i, a, 2, v, g, density, s);
}

/* m = the spring density of exponent 2, or 0 where negative weights (of coarse levels) make it negative */
CGAL_SP_FUNCTION void spring_masses_at(int i, graph_view a, vec3_in v, real_out m)
{
  const real mass = spring_density(i, a, 2, v);
  m[i] = mass > 0 ? mass : 0;
}

/* s[0]: the second derivative of the Lagrangian E - mu . sum m_i v_i along the geodesics with velocity d;
 * s[1]: m |d|^2; s[2] ... s[4]: m |d|^2 v */
CGAL_SP_FUNCTION void stiffening_curvature_at(int i, graph_view a, real p, real_in mass, vec3 mu, vec3_in v,
                                              float4_in d, real_in density, real* s)
{
  const vec3 vi = v[i], di = to_vec3(d[i]);
  real sum = 0;
  const int end = a.offset[i + 1];
  for(int k = a.offset[i]; k < end; ++k) {
    const vec3 dd = sub(di, to_vec3(d[a.target[k]]));
    const vec3 delta = sub(vi, v[a.target[k]]);
    const real length2 = inner(delta, delta);
    const real along = inner(delta, dd);
    const real stiffening = p > 2 && length2 > 0 ? (p - 2) * along * along / length2 : 0;
    sum += spring_weight(a.weight[k], length2, p) * (inner(dd, dd) + stiffening);
  }
  const real pull = density[i] - mass[i] * inner(mu, vi); /* less what the multiplier takes off */
  const real push = mass[i] * inner(di, di);
  s[0] += sum / 2 - pull * inner(di, di);
  s[1] += push;
  add_to(scale(push, vi), s + 2);
}

/* The same for exponent 2 */
CGAL_SP_FUNCTION void curvature_at(int i, graph_view a, real_in mass, vec3 mu, vec3_in v, float4_in d, real_in density,
                                   real* s)
{
  stiffening_curvature_at(i, a, 2, mass, mu, v, d, density, s);
}

/* ---- directions of the descent ----------------------------------------------------------------------------------- */

/* b = D^-1 (g - m P_v mu), in floats, the right-hand side of a cycle; s[0]: |b|^2; s[1]: step . D b */
CGAL_SP_FUNCTION void balance_gradient_at(int i, real_in inverse_diagonal, real_in mass, vec3 mu, vec3_in v, vec3_in g,
                                          float4_in step, float4_out b, real* s)
{
  const vec3 balanced = add_scaled(g[i], -mass[i], tangent(mu, v[i]));
  s[0] += inner(balanced, balanced) * inverse_diagonal[i] * inverse_diagonal[i];
  s[1] += inner(to_vec3(step[i]), balanced);
  b[i] = to_float4(scale(inverse_diagonal[i], balanced));
}

/* Adds what decides about a direction d at v to s[0] ... s[6]: g . d, the momentum m d and the spin m v x d. */
CGAL_SP_FUNCTION void add_products(real m, vec3 v, vec3 g, vec3 d, real* s)
{
  const vec3 push = scale(m, d);
  s[0] += inner(g, d);
  add_to(push, s + 1);
  add_to(outer(v, push), s + 4);
}

/* s[0] ... s[6]: add_products() of P step; s[7] ... s[13]: add_products() of P d; both with the gradient D b */
CGAL_SP_FUNCTION void direction_products_at(int i, real_in inverse_diagonal, real_in mass, vec3_in v, float4_in b,
                                            float4_in step, float4_in d, real* s)
{
  const real diagonal = inverse_diagonal[i] > 0 ? 1 / inverse_diagonal[i] : 0;
  const vec3 g = scale(diagonal, to_vec3(b[i]));
  add_products(mass[i], v[i], g, tangent(to_vec3(step[i]), v[i]), s);
  add_products(mass[i], v[i], g, tangent(to_vec3(d[i]), v[i]), s + 7);
}

/* d = P_v (beta d - step - y) - omega x v: the conjugate direction after the step, less a boost and a rotation */
CGAL_SP_FUNCTION void next_direction_at(int i, real beta, vec3 y, vec3 omega, vec3_in v, float4_in step, float4_out d)
{
  const vec3 combined = sub(sub(scale(beta, to_vec3(d[i])), to_vec3(step[i])), y);
  d[i] = to_float4(sub(tangent(combined, v[i]), outer(omega, v[i])));
}

/* ---- Moebius transformations and balance ------------------------------------------------------------------------- */

/* The boost of the sphere with centre c, |c| < 1: x -> (1 - c^2) (x - c) / |x - c|^2 - c, to first order x - 2 P_x c.
 */
CGAL_SP_FUNCTION vec3 boost(vec3 x, vec3 c)
{
  const vec3 d = sub(x, c);
  return unit(sub(scale((1 - inner(c, c)) / inner(d, d), d), c));
}

/* Adds m v and m v v^T (xx, xy, xz, yy, yz, zz) to s[0] ... s[8]. */
CGAL_SP_FUNCTION void add_moments(real m, vec3 v, real* s)
{
  const vec3 mv = scale(m, v);
  add_to(mv, s);
  add_to(scale(mv.x, v), s + 3);
  s[6] += mv.y * v.y;
  s[7] += mv.y * v.z;
  s[8] += mv.z * v.z;
}

/* s[0] ... s[8]: the moments of v */
CGAL_SP_FUNCTION void moments_at(int i, real_in mass, vec3_in v, real* s) { add_moments(mass[i], v[i], s); }

/* m = (1 + tilt . v) density, or 0 where rounding or a large tilt make it negative; s[0] ... s[8]: the moments of v */
CGAL_SP_FUNCTION void tilt_masses_at(int i, real_in density, vec3 tilt, vec3_in v, real_out m, real* s)
{
  const real mass = (1 + inner(tilt, v[i])) * density[i];
  m[i] = mass > 0 ? mass : 0;
  add_moments(m[i], v[i], s);
}

/* w = (v + alpha d - 2 P_v c) / |...|: v moved by alpha d and, to first order, a small boost with centre c;
 * s[0] ... s[8]: the moments of w */
CGAL_SP_FUNCTION void retract_at(int i, real_in mass, real alpha, vec3 c, vec3_in v, float4_in d, vec3_out w, real* s)
{
  w[i] = unit(add_scaled(add_scaled(v[i], alpha, to_vec3(d[i])), -2, tangent(c, v[i])));
  add_moments(mass[i], w[i], s);
}

/* w = boost of v with centre c; s[0] ... s[8]: the moments of w */
CGAL_SP_FUNCTION void transform_at(int i, real_in mass, vec3 c, vec3_in v, vec3_out w, real* s)
{
  w[i] = boost(v[i], c);
  add_moments(mass[i], w[i], s);
}

#ifndef __OPENCL_C_VERSION__
} // namespace CGAL::Spherical_parameterization::internal
#endif

#endif
