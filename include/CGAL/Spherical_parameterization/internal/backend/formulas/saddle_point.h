/* SPDX-License-Identifier: LGPL-3.0-or-later
 * Part of CGAL Spherical Parameterization.
 *
 * Formulas of the published method. Its graphs have no excess. See vertex_formulas.h.
 */
#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_FORMULAS_SADDLE_POINT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_FORMULAS_SADDLE_POINT_H

#ifndef __OPENCL_C_VERSION__
#include <CGAL/Spherical_parameterization/internal/backend/formulas/linear_algebra.h>
namespace CGAL::Spherical_parameterization::internal {
#endif

/* returns sum_j w_ij u_j */
CGAL_SP_FUNCTION vec3 neighbour_sum(int i, graph_view a, vec3_in u)
{
  vec3 sum = make_vec3(0, 0, 0);
  const int end = a.offset[i + 1];
  for(int k = a.offset[i]; k < end; ++k)
    sum = add_scaled(sum, a.weight[k], u[a.target[k]]);
  return sum;
}

/* Lines 3 to 5 of Algorithm 1: relax towards the mean of the neighbours, then back to the plane u_i . v_i = 1. Fixed
 * vertices stay. */
CGAL_SP_FUNCTION vec3 saddle_point_relaxation(int i, graph_view a, real omega, vec3_in v, vec3_in u)
{
  if(a.inverse_diagonal[i] == 0)
    return u[i];
  const vec3 moved = add_scaled(scale(1 - omega, u[i]), omega * a.inverse_diagonal[i], neighbour_sum(i, a, u));
  const real lambda = inner(v[i], moved) - 1;
  return add_scaled(moved, -lambda, v[i]);
}

/* One Jacobi sweep from u to w */
CGAL_SP_FUNCTION void jacobi_sweep_at(int i, graph_view a, real omega, vec3_in v, vec3_in u, vec3_out w)
{
  w[i] = saddle_point_relaxation(i, a, omega, v, u);
}

/* A Gauss-Seidel step of vertex k of a colour, in place */
CGAL_SP_FUNCTION void gauss_seidel_sweep_at(int k, graph_view a, int_in colour, real omega, vec3_in v, vec3_out u)
{
  u[colour[k]] = saddle_point_relaxation(colour[k], a, omega, v, u);
}

/* s[0]: |P_v (u_i - neighbour mean of u)|^2 */
CGAL_SP_FUNCTION void saddle_point_residual2_at(int i, graph_view a, vec3_in v, vec3_in u, real* s)
{
  const vec3 step = sub(saddle_point_relaxation(i, a, 1, v, u), u[i]);
  s[0] += inner(step, step);
}

/* v = u / |u|; fixed vertices stay */
CGAL_SP_FUNCTION void normalize_at(int i, real_in inverse_diagonal, vec3_in u, vec3_out v)
{
  if(inverse_diagonal[i] > 0)
    v[i] = unit(u[i]);
}

/* s[0]: |r_i|^2, with r_i = v_i - m / |m| and m = sum_j w_ij v_j: the residual of eq. (2), 0 at fixed vertices */
CGAL_SP_FUNCTION void barycentric_residual2_at(int i, graph_view a, vec3_in v, real* s)
{
  const vec3 r = a.inverse_diagonal[i] == 0 ? make_vec3(0, 0, 0) : sub(v[i], unit(neighbour_sum(i, a, v)));
  s[0] += inner(r, r);
}

#ifndef __OPENCL_C_VERSION__
} // namespace CGAL::Spherical_parameterization::internal
#endif

#endif
