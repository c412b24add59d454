// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "shapes/descriptors.h"

#include <CGAL/Spherical_parameterization/internal/signature/Discrete_surface.h>
#include <CGAL/Spherical_parameterization/internal/signature/conformal_factor.h>
#include <CGAL/Spherical_parameterization/internal/base/histogram.h>
#include <CGAL/Spherical_parameterization/stretch_histogram.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/mesh_segmentation.h>
#include <CGAL/point_generators_3.h>

#ifdef BENCHMARK_WITH_SPECTRA
#include <Spectra/MatOp/SparseSymShiftSolve.h>
#include <Spectra/SymEigsShiftSolver.h>
#endif

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace benchmark {
namespace {

namespace SP = CGAL::Spherical_parameterization;
namespace PMP = CGAL::Polygon_mesh_processing;
using SP::Stretch_histogram;
using SP::internal::Histogram;

Descriptor stretch_descriptor(const std::string& name, const Stretch_histogram& options)
{
  return {name, true,
          [options](const Mesh& mesh, Sphere_map sphere) { return SP::stretch_histogram(mesh, sphere, options); }};
}

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
  for(std::size_t k = 0; k < pairs; ++k) {
    const Point_3 p = *generator++, q = *generator++;
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

#ifdef BENCHMARK_WITH_SPECTRA
/// The smallest 30 eigenvalues of the Laplacian that are not 0, scaled to area 4 pi and over their number, to which
/// they are proportional by Weyl's law: M. Reuter, F.-E. Wolter, N. Peinecke, "Laplace-Beltrami spectra as 'Shape-DNA'
/// of surfaces and solids", CAD 38 (2006). On the intrinsic Delaunay triangulation, like the package's signature.
Descriptor_values shape_dna(const Mesh& mesh, Sphere_map)
{
  constexpr int count = 30;
  constexpr double shift = -0.05; // next to the eigenvalue 0
  const SP::internal::Mapped_surface map =
    SP::internal::read_mapped_surface(mesh, mesh.points(), mesh.points(), SP::internal::Host_loop());
  const SP::internal::Discrete_surface surface(SP::internal::Intrinsic_triangulation(map, map.point));
  const Eigen::VectorXd scale = surface.mass().array().rsqrt();
  const Eigen::SparseMatrix<double> a = scale.asDiagonal() * surface.laplacian() * scale.asDiagonal();
  Spectra::SparseSymShiftSolve<double> operation(a);
  Spectra::SymEigsShiftSolver<Spectra::SparseSymShiftSolve<double>> solver(operation, count + 1, 2 * count + 10, shift);
  solver.init();
  solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-8, Spectra::SortRule::SmallestAlge);
  if(solver.info() != Spectra::CompInfo::Successful)
    throw std::runtime_error("no eigenvalues");
  Descriptor_values values;
  for(int i = 1; i <= count; ++i)
    values.push_back(solver.eigenvalues()[i] / i);
  return values;
}
#endif

} // namespace

std::vector<Descriptor> other_descriptors()
{
  Stretch_histogram paper;
  paper.sampling = Stretch_histogram::Sampling::RANDOM;
  paper.scale = Stretch_histogram::Scale::LINEAR;
  paper.low = 0;
  paper.high = 8;
  return {stretch_descriptor("paper: stretch histogram", paper),
          stretch_descriptor("log stretch, exact areas", Stretch_histogram()),
          {"D2", false, d2},
          {"SDF", false, [](const Mesh& mesh, Sphere_map) { return sdf(mesh, true); }, true},
          {"log SDF", false, [](const Mesh& mesh, Sphere_map) { return sdf(mesh, false); }, true},
#ifdef BENCHMARK_WITH_SPECTRA
          {"ShapeDNA", false, shape_dna}
#endif
  };
}

} // namespace benchmark
