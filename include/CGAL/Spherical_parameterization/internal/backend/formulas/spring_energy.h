/* SPDX-License-Identifier: LGPL-3.0-or-later
 * Part of CGAL Spherical Parameterization.
 *
 * Formulas of the spring energy on the sphere, of the descent on it, and of balance. See vertex_formulas.h.
 */
#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_FORMULAS_SPRING_ENERGY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_FORMULAS_SPRING_ENERGY_H

#ifndef __OPENCL_C_VERSION__
#include <CGAL/Spherical_parameterization/internal/backend/formulas/linear_algebra.h>
#include <cmath>
namespace CGAL::Spherical_parameterization::internal {
using std::pow;
#endif

/* ---- the energy and its derivatives ------------------------------------------------------------------------------ */

/* Weight of a spring of exponent p whose ends are apart by the square root of squared_length: w length^(p-2). */
CGAL_SP_FUNCTION real spring_weight(real w, real squared_length, real p)
{
  return p == 2 ? w : (squared_length > 0 ? w * pow(squared_length, p / 2 - 1) : 0);
}

/* returns sum_j w_ij(v) |v_i - v_j|^2 / 2; the densities of all vertices sum up to p E */
CGAL_SP_FUNCTION real spring_density(int i, graph_view a, real p, CGAL_SP_GLOBAL const vec3* v)
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

/* returns the tangent gradient P_i (L(v) v)_i of the spring energy, and 0 at fixed vertices. Sets *density to the
 * spring density: |v_i - v_j|^2 / 2 is v_i . (v_i - v_j) for unit vectors. */
CGAL_SP_FUNCTION vec3 spring_gradient(int i, graph_view a, real p, CGAL_SP_GLOBAL const vec3* v, real* density)
{
  const vec3 vi = v[i];
  vec3 sum = make_vec3(0, 0, 0);
  const int end = a.offset[i + 1];
  if(p == 2)
    for(int k = a.offset[i]; k < end; ++k)
      sum = add_scaled(sum, a.weight[k], sub(vi, v[a.target[k]]));
  else
    for(int k = a.offset[i]; k < end; ++k) {
      const vec3 delta = sub(vi, v[a.target[k]]);
      sum = add_scaled(sum, spring_weight(a.weight[k], inner(delta, delta), p), delta);
    }
  *density = inner(vi, sum);
  return a.inverse_diagonal[i] > 0 ? tangent(sum, vi) : make_vec3(0, 0, 0);
}

/* returns vertex i's share of the second derivative of the energy along the geodesics with velocity d; `pull` is its
 * density, less what a multiplier takes off */
CGAL_SP_FUNCTION real spring_curvature(int i, graph_view a, real p, CGAL_SP_GLOBAL const vec3* v,
                                       CGAL_SP_GLOBAL const vec3* d, real pull)
{
  const vec3 di = d[i];
  real sum = 0;
  const int end = a.offset[i + 1];
  if(p == 2)
    for(int k = a.offset[i]; k < end; ++k) {
      const vec3 dd = sub(di, d[a.target[k]]);
      sum += a.weight[k] * inner(dd, dd);
    }
  else
    for(int k = a.offset[i]; k < end; ++k) {
      const vec3 dd = sub(di, d[a.target[k]]);
      const vec3 delta = sub(v[i], v[a.target[k]]);
      const real length2 = inner(delta, delta);
      const real along = inner(delta, dd);
      const real stiffening = length2 > 0 ? (p - 2) * along * along / length2 : 0;
      sum += spring_weight(a.weight[k], length2, p) * (inner(dd, dd) + stiffening);
    }
  return sum / 2 - pull * inner(di, di);
}

/* s[0]: the energy of exponent 2, sum over edges of w |v_i - v_j|^2 / 2 */
CGAL_SP_FUNCTION void energy_at(int i, graph_view a, CGAL_SP_GLOBAL const vec3* v, real* s)
{
  s[0] += spring_density(i, a, 2, v) / 2;
}

/* g = tangent gradient, density = spring density; s[0]: p E; s[1] ... s[3]: g */
CGAL_SP_FUNCTION void gradient_at(int i, graph_view a, real p, CGAL_SP_GLOBAL const vec3* v, CGAL_SP_GLOBAL vec3* g,
                                  CGAL_SP_GLOBAL real* density, real* s)
{
  real own_density;
  g[i] = spring_gradient(i, a, p, v, &own_density);
  density[i] = own_density;
  s[0] += own_density;
  s[1] += g[i].x;
  s[2] += g[i].y;
  s[3] += g[i].z;
}

/* m = spring density of exponent 2, or 0 where negative weights (of coarse levels) make it negative */
CGAL_SP_FUNCTION void spring_masses_at(int i, graph_view a, CGAL_SP_GLOBAL const vec3* v, CGAL_SP_GLOBAL real* m)
{
  const real density = spring_density(i, a, 2, v);
  m[i] = density > 0 ? density : 0;
}

/* s[0]: the second derivative of the Lagrangian E - mu . sum m_i v_i along the geodesics with velocity d;
 * s[1]: m |d|^2; s[2] ... s[4]: m |d|^2 v */
CGAL_SP_FUNCTION void curvature_at(int i, graph_view a, real p, CGAL_SP_GLOBAL const real* mass, vec3 mu,
                                   CGAL_SP_GLOBAL const vec3* v, CGAL_SP_GLOBAL const vec3* d,
                                   CGAL_SP_GLOBAL const real* density, real* s)
{
  s[0] += spring_curvature(i, a, p, v, d, density[i] - mass[i] * inner(mu, v[i]));
  const real push = mass[i] * inner(d[i], d[i]);
  s[1] += push;
  s[2] += push * v[i].x;
  s[3] += push * v[i].y;
  s[4] += push * v[i].z;
}

/* ---- directions of the descent ----------------------------------------------------------------------------------- */

/* g -= m P_v mu; s[0]: |g_i / D_i|^2 */
CGAL_SP_FUNCTION void balance_gradient_at(int i, CGAL_SP_GLOBAL const real* inverse_diagonal,
                                          CGAL_SP_GLOBAL const real* mass, vec3 mu, CGAL_SP_GLOBAL const vec3* v,
                                          CGAL_SP_GLOBAL vec3* g, real* s)
{
  g[i] = add_scaled(g[i], -mass[i], tangent(mu, v[i]));
  s[0] += inner(g[i], g[i]) * inverse_diagonal[i] * inverse_diagonal[i];
}

/* Adds what decides about a direction d at v to s[0] ... s[6]: g . d, the momentum m d and the spin m v x d. */
CGAL_SP_FUNCTION void add_products(real m, vec3 v, vec3 g, vec3 d, real* s)
{
  const vec3 push = scale(m, d);
  const vec3 spin = outer(v, push);
  s[0] += inner(g, d);
  s[1] += push.x;
  s[2] += push.y;
  s[3] += push.z;
  s[4] += spin.x;
  s[5] += spin.y;
  s[6] += spin.z;
}

/* s[0]: old_g . P step; s[1] ... s[7]: add_products() of P step; s[8] ... s[14]: add_products() of P d */
CGAL_SP_FUNCTION void direction_products_at(int i, CGAL_SP_GLOBAL const real* mass, CGAL_SP_GLOBAL const vec3* v,
                                            CGAL_SP_GLOBAL const vec3* g, CGAL_SP_GLOBAL const vec3* old_g,
                                            CGAL_SP_GLOBAL const vec3* step, CGAL_SP_GLOBAL const vec3* d, real* s)
{
  const vec3 tangent_step = tangent(step[i], v[i]);
  s[0] += inner(old_g[i], tangent_step);
  add_products(mass[i], v[i], g[i], tangent_step, s + 1);
  add_products(mass[i], v[i], g[i], tangent(d[i], v[i]), s + 8);
}

/* d = P_v (beta d - step - y) - omega x v: the conjugate direction after the step, less a boost and a rotation */
CGAL_SP_FUNCTION void next_direction_at(int i, real beta, vec3 y, vec3 omega, CGAL_SP_GLOBAL const vec3* v,
                                        CGAL_SP_GLOBAL const vec3* step, CGAL_SP_GLOBAL vec3* d)
{
  d[i] = sub(tangent(sub(sub(scale(beta, d[i]), step[i]), y), v[i]), outer(omega, v[i]));
}

/* ---- Moebius transformations and balance ------------------------------------------------------------------------- */

/* returns (v + alpha d - 2 P_v c) / |...|: a step alpha along d, and to first order a small boost with centre c */
CGAL_SP_FUNCTION vec3 displaced(vec3 v, real alpha, vec3 d, vec3 c)
{
  return unit(add_scaled(add_scaled(v, alpha, d), -2, tangent(c, v)));
}

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
  s[0] += m * v.x;
  s[1] += m * v.y;
  s[2] += m * v.z;
  s[3] += m * v.x * v.x;
  s[4] += m * v.x * v.y;
  s[5] += m * v.x * v.z;
  s[6] += m * v.y * v.y;
  s[7] += m * v.y * v.z;
  s[8] += m * v.z * v.z;
}

/* s[0] ... s[8]: the moments of v */
CGAL_SP_FUNCTION void moments_at(int i, CGAL_SP_GLOBAL const real* mass, CGAL_SP_GLOBAL const vec3* v, real* s)
{
  add_moments(mass[i], v[i], s);
}

/* w = v moved by alpha d and a small boost with centre c; s[0] ... s[8]: the moments of w */
CGAL_SP_FUNCTION void retract_at(int i, CGAL_SP_GLOBAL const real* mass, real alpha, vec3 c,
                                 CGAL_SP_GLOBAL const vec3* v, CGAL_SP_GLOBAL const vec3* d, CGAL_SP_GLOBAL vec3* w,
                                 real* s)
{
  w[i] = displaced(v[i], alpha, d[i], c);
  add_moments(mass[i], w[i], s);
}

/* w = boost of v with centre c; s[0] ... s[8]: the moments of w */
CGAL_SP_FUNCTION void transform_at(int i, CGAL_SP_GLOBAL const real* mass, vec3 c, CGAL_SP_GLOBAL const vec3* v,
                                   CGAL_SP_GLOBAL vec3* w, real* s)
{
  w[i] = boost(v[i], c);
  add_moments(mass[i], w[i], s);
}

#ifndef __OPENCL_C_VERSION__
} // namespace CGAL::Spherical_parameterization::internal
#endif

#endif
