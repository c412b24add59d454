// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SIGNATURE_SIGNATURE_VALUES_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SIGNATURE_SIGNATURE_VALUES_IMPL_H

#include <CGAL/Spherical_parameterization/internal/algebra/histogram.h>
#include <CGAL/Spherical_parameterization/internal/surface/persistence.h>
#include <CGAL/Spherical_parameterization/internal/signature/conformal_factor.h>
#include <CGAL/Spherical_parameterization/internal/signature/signature_values.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Typical distances of unlike shapes, which make both parts of the signature weigh the same: what 35 models of 9
/// classes of the SHREC 2007 watertight track have on average.
constexpr double girth_unit = 0.685;
constexpr double limb_unit = 21;

/// Histograms of log |grad u|, linearly interpolated between bins. On a cylinder of radius r, |grad u| is 2 / r.
CGAL_SP_INLINE void add_girths(const Discrete_surface& surface, const Discrete_surface::Vector& u,
                               Signature_values& signature)
{
  constexpr double log_low = -1, log_high = 5; // from a radius of 5 to a hundredth, where a ball of the same area has 1
  const Discrete_surface::Vector gradient = surface.gradient_norm(u);
  Histogram coarse(Signature_sizes::coarse_bins, log_low, log_high);
  Histogram fine(Signature_sizes::fine_bins, log_low, log_high);
  for(int i = 0; i < surface.size(); ++i) {
    const double girth = std::log((std::max)(gradient[i], 1e-9));
    coarse.add_interpolated(girth, surface.mass()[i]);
    fine.add_interpolated(girth, surface.mass()[i]);
  }
  auto out = signature.begin();
  for(const Histogram* histogram : {&coarse, &fine})
    for(double share : histogram->shares())
      *out++ = share / 2 / girth_unit;
}

/// The minima of u are the tips of limbs. A limb's persistence is about twice its length over its radius.
CGAL_SP_INLINE void add_limbs(const Discrete_surface& surface, const Discrete_surface::Vector& u,
                              Signature_values& signature)
{
  constexpr double shortest = 1; // what is shorter than half its radius is a bump; limbs fade in from there
  constexpr double mass_weight = 6;
  std::vector<Basin> limbs = basins(u, surface.mass(), [&](int i, const auto& visit) {
    for(Discrete_surface::Matrix::InnerIterator entry(surface.laplacian(), i); entry; ++entry)
      visit(static_cast<int>(entry.row()));
  });
  limbs.resize((std::min)(limbs.size(), Signature_sizes::limbs), Basin{0, 0, 0});
  auto length = signature.begin() + Signature_sizes::coarse_bins + Signature_sizes::fine_bins;
  auto mass = length + Signature_sizes::limbs;
  for(const Basin& limb : limbs) {
    const double excess = (std::max)(limb.persistence - shortest, 0.);
    *length++ = std::sqrt(excess) / limb_unit;
    *mass++ = mass_weight * std::sqrt(limb.mass / (4 * pi)) * (std::min)(excess / shortest, 1.) / limb_unit;
  }
  std::sort(signature.end() - Signature_sizes::limbs, signature.end(), std::greater<double>());
}

template <class Loop>
Signature_values signature_values(const Loop& loop, const Mapped_surface& map)
{
  constexpr double smoothing_time = 0.003; // of a surface of area 4 pi: over a twentieth of the radius of that ball
  constexpr int fewest_vertices = 2000;    // coarser meshes are refined: their faces are as long as limbs are thick
  const Conformal_factor factor(loop, map, fewest_vertices);
  loop.advance(0.7);
  const Discrete_surface::Vector u = smoothed(loop, factor.surface, factor.u, smoothing_time);
  Signature_values signature{};
  add_girths(factor.surface, u, signature);
  add_limbs(factor.surface, u, signature);
  return signature;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SIGNATURE_SIGNATURE_VALUES_IMPL_H
