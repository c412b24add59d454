// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifdef BENCHMARK_WITH_SPECTRA
#include "shapes/descriptors.h"

#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>
#include <CGAL/Spherical_parameterization/internal/signature/Discrete_surface.h>

#include <Spectra/MatOp/SparseSymShiftSolve.h>
#include <Spectra/SymEigsShiftSolver.h>

#include <stdexcept>

namespace internal = CGAL::Spherical_parameterization::internal;

benchmark::Descriptor_values benchmark::shape_dna(const Mesh& mesh, Sphere_map)
{
  constexpr int count = 30;
  constexpr double shift = -0.05; // next to the eigenvalue 0
  const internal::Mapped_surface map =
    internal::read_map(mesh, mesh.points(), mesh.points(), internal::Reading::BREADTH_FIRST, internal::Host_loop());
  const internal::Discrete_surface surface(
    internal::Intrinsic_triangulation(map.copy_of_corner_table(internal::Host_loop()), map.point));
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
