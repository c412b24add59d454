// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "shapes/descriptors.h"

#include <CGAL/Spherical_parameterization/internal/signature/signature_values_impl.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>
#include <CGAL/Spherical_parameterization/parameterize.h>
#include <CGAL/Spherical_parameterization/shape_signature.h>
#include <CGAL/Spherical_parameterization/spherical_harmonics.h>
#include <CGAL/Spherical_parameterization/stretch_histogram.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace benchmark {
namespace {

namespace SP = CGAL::Spherical_parameterization;
using SP::Shape_signature;
using SP::Stretch_histogram;
using SP::internal::Conformal_factor;
using SP::internal::Discrete_surface;
using SP::internal::Histogram;
using SP::internal::Mapped_surface;
const SP::internal::Host_loop one_core;
SP::internal::Monitor nobody;
const SP::internal::Watched_loop<SP::internal::Host_loop> watched(one_core, nobody);

constexpr std::size_t girths = Shape_signature::coarse_bins + Shape_signature::fine_bins;

/// The signature without the Poisson solve: u is what the areas of the map say.
Descriptor_values without_poisson(const Mesh& mesh, Sphere_map sphere)
{
  const Mapped_surface map =
    SP::internal::read_map(mesh, mesh.points(), sphere, SP::internal::Reading::BREADTH_FIRST, one_core);
  const Conformal_factor factor(watched, map);
  Mesh copy = mesh;
  const auto stretch = copy.add_property_map<Mesh::Vertex_index, double>("v:stretch").first;
  SP::vertex_log_area_stretch(mesh, sphere, stretch);
  Discrete_surface::Vector u(factor.surface.size());
  for(int i = 0; i < u.size(); ++i)
    u[i] = -stretch[Mesh::Vertex_index(map.position[i])];
  u = SP::internal::smoothed(watched, factor.surface, u, 0.003);
  Shape_signature signature;
  SP::internal::add_girths(factor.surface, u, signature.values);
  SP::internal::add_limbs(factor.surface, u, signature.values);
  return {signature.values.begin(), signature.values.end()};
}

/// The signature before it was improved: one histogram of 32 bins, 12 limbs, and bumps count as limbs.
Descriptor_values first_version(const Mesh& mesh, Sphere_map sphere)
{
  constexpr std::size_t limbs = 12;
  const Mapped_surface map =
    SP::internal::read_map(mesh, mesh.points(), sphere, SP::internal::Reading::BREADTH_FIRST, one_core);
  const Conformal_factor factor(watched, map);
  const Discrete_surface& surface = factor.surface;
  const Discrete_surface::Vector u = SP::internal::smoothed(watched, surface, factor.u, 0.003);
  const Discrete_surface::Vector gradient = surface.gradient_norm(u);
  Histogram histogram(32, -1, 5);
  for(int i = 0; i < surface.size(); ++i)
    histogram.add_interpolated(std::log(std::max(gradient[i], 1e-9)), surface.mass()[i]);
  Descriptor_values values;
  for(double share : histogram.shares())
    values.push_back(share / SP::internal::girth_unit);

  std::vector<SP::internal::Basin> basins = SP::internal::basins(u, surface.mass(), [&](int i, const auto& visit) {
    for(Discrete_surface::Matrix::InnerIterator entry(surface.laplacian(), i); entry; ++entry)
      visit(static_cast<int>(entry.row()));
  });
  basins.resize(limbs, {0, 0, 0});
  std::vector<double> masses;
  for(const auto& basin : basins) {
    values.push_back(std::sqrt(basin.persistence) / SP::internal::limb_unit);
    masses.push_back(6 * std::sqrt(basin.mass / (4 * SP::internal::pi)) / SP::internal::limb_unit);
  }
  std::sort(masses.rbegin(), masses.rend());
  values.insert(values.end(), masses.begin(), masses.end());
  return values;
}

/// With the sum of squares 1, so that the size of the shape does not matter.
Descriptor_values normalized(Descriptor_values values)
{
  double sum = 0;
  for(const double value : values)
    sum += value * value;
  for(double& value : values)
    value /= std::sqrt(sum);
  return values;
}

/// The power spectrum P of the coordinates on an isometric map, which neither rotations nor the place of the shape
/// change: by degree, from 1 on, the root of P. Roots, as in M. Kazhdan, T. Funkhouser, S. Rusinkiewicz, "Rotation
/// invariant spherical harmonic representation of 3D shape descriptors", SGP 2003.
Descriptor_values power_of_coordinates(const Mesh& mesh, Sphere_map)
{
  constexpr int degree = 32; // four times the coefficients that a mesh of 252 vertices could be fitted by
  Mesh copy = mesh;
  const auto sphere = copy.add_property_map<Mesh::Vertex_index, Point_3>("v:isometric").first;
  const auto result = SP::parameterize(copy, SP::Isometric(), sphere);
  if(!result)
    throw std::runtime_error("no isometric map: " + result.detail);
  const auto analysis = SP::harmonic_analysis(copy, sphere, copy.points(), degree, SP::Integration());
  const std::vector<double> power = SP::power_spectrum(analysis.coefficients);
  Descriptor_values values;
  for(int l = 1; l <= degree; ++l)
    values.push_back(std::sqrt(power[l]));
  return normalized(std::move(values));
}

/// The same for the gradient, whose power is l (l + 1) P.
Descriptor_values power_of_gradient(Descriptor_values values)
{
  for(std::size_t i = 0; i < values.size(); ++i)
    values[i] *= std::sqrt((i + 1.) * (i + 2.));
  return normalized(std::move(values));
}

} // namespace

std::vector<Descriptor> own_descriptors()
{
  const auto signature_part = [](std::size_t begin, std::size_t end) {
    return [=](const Mesh& mesh, Sphere_map sphere) {
      const auto values = SP::shape_signature(mesh, sphere).values;
      return Descriptor_values(values.begin() + begin, values.begin() + end);
    };
  };
  Stretch_histogram paper;
  paper.sampling = Stretch_histogram::Sampling::RANDOM;
  paper.scale = Stretch_histogram::Scale::LINEAR;
  paper.low = 0;
  paper.high = 8;
  const auto stretch = [](const Stretch_histogram& histogram) {
    return [=](const Mesh& mesh, Sphere_map sphere) { return SP::stretch_histogram(mesh, sphere, histogram); };
  };
  return {{"signature", true, signature_part(0, Shape_signature::size)},
          {"its girths alone", true, signature_part(0, girths)},
          {"its limbs alone", true, signature_part(girths, Shape_signature::size)},
          {"one histogram, 12 limbs", true, first_version},
          {"without Poisson solve", true, without_poisson},
          {"paper: stretch histogram", true, stretch(paper)},
          {"log stretch, exact areas", true, stretch(Stretch_histogram())},
          {"power spectrum", false, power_of_coordinates, true},
          {"power spectrum of the gradient", false, {}, true, power_of_gradient}};
}

} // namespace benchmark
