// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "shapes/descriptors.h"

#include <CGAL/Spherical_parameterization/internal/algebra/histogram.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/mesh_segmentation.h>
#include <CGAL/point_generators_3.h>

#include <cmath>

namespace benchmark {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using CGAL::Spherical_parameterization::internal::Histogram;

/// The distances of random points of the surface, over their mean: R. Osada, T. Funkhouser, B. Chazelle, D. Dobkin,
/// "Shape distributions", ACM Transactions on Graphics 21 (2002).
Descriptor_values d2(const Mesh& mesh, Sphere_map)
{
  constexpr std::size_t pairs = 1 << 19;
  CGAL::Random random(0);
  CGAL::Random_points_in_triangle_mesh_3<Mesh> generator(mesh, random);
  std::vector<double> distances;
  distances.reserve(pairs);
  double mean = 0;
  const auto next = [&] {
    const Point_3 point = *generator;
    ++generator; // generator++ would copy the areas of all faces
    return point;
  };
  for(std::size_t k = 0; k < pairs; ++k) {
    const Point_3 p = next(), q = next();
    distances.push_back(std::sqrt(CGAL::squared_distance(p, q)));
    mean += distances.back() / pairs;
  }
  Histogram histogram(64, 0, 3);
  for(double d : distances)
    histogram.add(d / mean, 1);
  return histogram.shares();
}

/// L. Shapira, A. Shamir, D. Cohen-Or, "Consistent mesh partitioning and skeletonisation using the shape diameter
/// function", The Visual Computer 24 (2008), as CGAL computes it.
///
/// \param is_normalised  CGAL's postprocessing: smoothed, and scaled to [0, 1]; else the logarithm of the raw values
///                       over the square root of the area
Descriptor_values sdf(const Mesh& mesh, bool is_normalised)
{
  Mesh copy = mesh;
  const auto values = copy.add_property_map<Mesh::Face_index, double>("f:sdf").first;
  CGAL::sdf_values(copy, values, 2. / 3 * std::acos(-1.), 25, is_normalised);
  const double size = std::sqrt(PMP::area(copy));
  Histogram histogram = is_normalised ? Histogram(32, 0, 1) : Histogram(32, -5, 0);
  for(auto f : copy.faces()) {
    const double value = is_normalised ? values[f] : std::log(values[f] / size);
    if(std::isfinite(value) && (is_normalised || values[f] > 0)) // -1: no ray hit
      histogram.add_interpolated(value, PMP::face_area(f, copy));
  }
  return histogram.shares();
}

} // namespace

std::vector<Descriptor> other_descriptors()
{
  return {{"D2", false, d2},
          {"SDF", false, [](const Mesh& mesh, Sphere_map) { return sdf(mesh, true); }, true},
          {"log SDF", false, [](const Mesh& mesh, Sphere_map) { return sdf(mesh, false); }, true},
#ifdef BENCHMARK_WITH_SPECTRA
          {"ShapeDNA", false, shape_dna}
#endif
  };
}

} // namespace benchmark
