// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_CONJUGATE_GRADIENTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_CONJUGATE_GRADIENTS_H

#include <CGAL/Spherical_parameterization/internal/base/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/multigrid/Multigrid.h>

#include <cmath>
#include <cstddef>

namespace CGAL::Spherical_parameterization::internal {

/// Solves A x = b on level k of the hierarchy, for three right-hand sides, by conjugate gradients with one multigrid
/// cycle as the preconditioner, to a relative error of about `accuracy` in the energy norm. `x` is 0 on entry. Returns
/// the number of iterations.
template <class Backend>
std::size_t conjugate_gradients(const Backend& backend, Multigrid<Backend>& multigrid, std::size_t k,
                                typename Backend::Vectors r, double accuracy, Monitor& monitor, double share_of_work,
                                typename Backend::Vectors& x)
{
  constexpr std::size_t maximum_iterations = 200;
  const typename Backend::Matrix& a = multigrid.matrix(k);
  const int n = multigrid.size(k);
  typename Backend::Vectors s = backend.vectors(n), p = backend.vectors(n), q = backend.vectors(n);
  double rs = 0;
  double energy = 0, first = 0;
  for(std::size_t it = 0; it < maximum_iterations; ++it) {
    multigrid.apply(k, r, s);
    const double previous = rs;
    rs = backend.dot(r, s);
    backend.conjugate(it > 0 ? rs / previous : 0, s, p);
    const double curvature = backend.multiply(a, p, q);
    if(!(curvature > 0)) // r is exactly zero, or rounding has eaten it
      return it;
    const double alpha = rs / curvature;
    backend.descend(alpha, p, q, x, r);
    // alpha rs is by how much the squared energy norm of the error has fallen in this step.
    const double gain = alpha * rs;
    energy += gain;
    if(it == 0)
      first = gain;
    monitor.log("start map", it, std::sqrt(gain / energy), energy);
    if(!monitor.advance(share_of_work * Monitor::share(gain, first, accuracy * accuracy * energy)))
      return it + 1;
    if(gain <= accuracy * accuracy * energy)
      return it + 1;
  }
  return maximum_iterations;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_CONJUGATE_GRADIENTS_H
