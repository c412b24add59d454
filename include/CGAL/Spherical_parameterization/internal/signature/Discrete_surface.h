// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SIGNATURE_DISCRETE_SURFACE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SIGNATURE_DISCRETE_SURFACE_H

#include <CGAL/Spherical_parameterization/internal/algebra/dense_matrices.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/internal/backend/Host_backend.h>
#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/surface/Intrinsic_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/multigrid/Multigrid.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// A closed surface scaled to area 4 pi, with the operators on its piecewise linear functions. The Laplacian is the
/// cotangent one, not clamped; the triangulation being Delaunay, no weight is negative. A template, so that it is
/// compiled only where it is used.
template <class Any = void>
class Discrete_surface_of {
public:
  typedef typename Dense<Any>::Vector Vector;
  typedef Eigen::SparseMatrix<double> Matrix;

  explicit Discrete_surface_of(Intrinsic_triangulation triangulation)
    : triangulation_(std::move(triangulation)), size_(triangulation_.number_of_vertices()), mass_(Vector::Zero(size_)),
      defect_(Vector::Constant(size_, 2 * pi)), laplacian_(size_, size_)
  {
    const Intrinsic_triangulation& t = triangulation_;
    double total = 0;
    for(int f = 0; f < t.number_of_faces(); ++f)
      total += t.area(3 * f);
    area_unit_ = total / (4 * pi);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(std::size_t(4) * t.number_of_halfedges());
    for(int h = 0; h < t.number_of_halfedges(); ++h) {
      const int i = t.origin(h), j = t.target(h);
      mass_[i] += area(h) / 3;
      defect_[t.apex(h)] -= t.angle(h);
      const double w = t.cotangent(h) / 2;
      entries.emplace_back(i, i, w);
      entries.emplace_back(j, j, w);
      entries.emplace_back(i, j, -w);
      entries.emplace_back(j, i, -w);
    }
    laplacian_.setFromTriplets(entries.begin(), entries.end());
  }

  int size() const { return size_; }
  const Vector& mass() const { return mass_; }           ///< a third of the area round every vertex
  const Vector& defect() const { return defect_; }       ///< the curvature of every vertex, 4 pi in all
  const Matrix& laplacian() const { return laplacian_; } ///< positive semidefinite, constants in the kernel

  /// |grad x|, constant on every triangle, averaged over the triangles round every vertex by area.
  Vector gradient_norm(const Vector& x) const
  {
    const Intrinsic_triangulation& t = triangulation_;
    Vector sum = Vector::Zero(size_), weight = Vector::Zero(size_);
    for(int f = 0; f < t.number_of_faces(); ++f) {
      double energy = 0; // integral of |grad x|^2
      for(int h = 3 * f; h < 3 * f + 3; ++h) {
        const double difference = x[t.origin(h)] - x[t.target(h)];
        energy += t.cotangent(h) * difference * difference / 2;
      }
      const double a = area(3 * f);
      const double norm = std::sqrt((std::max)(energy, 0.) / a);
      for(int h = 3 * f; h < 3 * f + 3; ++h) {
        sum[t.origin(h)] += a * norm;
        weight[t.origin(h)] += a;
      }
    }
    return sum.cwiseQuotient(weight);
  }

private:
  double area(int h) const { return triangulation_.area(h) / area_unit_; }

  Intrinsic_triangulation triangulation_;
  int size_;
  double area_unit_; ///< 4 pi of these are the area before scaling
  Vector mass_, defect_;
  Matrix laplacian_;
};
typedef Discrete_surface_of<> Discrete_surface;

/// Solves (L + shift M) x = b on a surface, set up once for several right-hand sides.
template <class Surface = Discrete_surface>
class Surface_solver {
  typedef Host_backend<Host_loop> Backend;
  typedef typename Surface::Vector Vector;
  typedef typename Surface::Matrix Matrix;

public:
  /// \param shift  if 0, the right-hand sides have to sum to zero, and solutions are defined up to a constant
  /// The surface has to outlive this. Throws Error if the system is singular, and, like the operator, if the loop is
  /// ended.
  Surface_solver(const Watched_loop<Host_loop>& loop, const Surface& surface, double shift = 0)
    : surface_(surface), shift_(shift), loop_(loop), backend_(loop.bare())
  {
    if(surface.size() > largest_factorized)
      set_up_multigrid();
    else
      factorize();
  }

  Surface_solver(const Surface_solver&) = delete; // the hierarchy refers to the backend
  Surface_solver& operator=(const Surface_solver&) = delete;

  Vector operator()(const Vector& b)
  {
    if(multigrid_) {
      Vector x = solve_by_multigrid(b);
      const Vector residual = surface_.laplacian() * x + shift_ * surface_.mass().cwiseProduct(x) - b;
      if(residual.norm() <= 1e-6 * b.norm()) // false for NaN
        return x;
      multigrid_.reset();
      factorize();
    }
    return cholesky_.solve(b);
  }

private:
  /// Up to this size Cholesky's factorization is as fast as multigrid and gives a residual of rounding, whatever the
  /// triangles are like; at 134,000 vertices it takes five times as long.
  static constexpr int largest_factorized = 100000;

  void factorize()
  {
    loop_.check();
    Matrix a = surface_.laplacian();
    if(shift_ > 0)
      a.diagonal() += shift_ * surface_.mass();
    else
      a.coeffRef(0, 0) *= 2; // holds x at 0 there: a spring that no force pulls, since b sums to zero
    cholesky_.compute(a);
    if(cholesky_.info() != Eigen::Success) // else solutions are whatever is in the memory
      throw Input_error(Error_code::DEGENERATE_FACE, "the surface has no usable metric");
  }

  void set_up_multigrid()
  {
    const Matrix& laplacian = surface_.laplacian();
    const auto graph = std::make_shared<Weighted_graph>();
    for(int i = 0; i < surface_.size(); ++i) {
      for(typename Matrix::InnerIterator entry(laplacian, i); entry; ++entry)
        if(entry.row() != i && entry.value() < 0) { // what is positive is rounding
          graph->target.push_back(static_cast<int>(entry.row()));
          graph->weight.push_back(-entry.value());
        }
      graph->offset.push_back(static_cast<int>(graph->target.size()));
    }
    if(shift_ > 0)
      for(int i = 0; i < surface_.size(); ++i)
        graph->excess.push_back(shift_ * surface_.mass()[i]);
    graph->update_diagonal({}, backend_.host_loop());
    multigrid_ = std::make_unique<Multigrid<Backend>>(backend_, graph, &loop_.monitor());
  }

  Vector solve_by_multigrid(const Vector& b)
  {
    constexpr double accuracy = 1e-9; // relative, in the energy norm
    typename Backend::Vectors right(surface_.size());
    for(int i = 0; i < surface_.size(); ++i)
      right[i] = make_vec3(b[i], 0, 0);
    typename Backend::Vectors solution = backend_.vectors(surface_.size());
    conjugate_gradients(backend_, *multigrid_, 0, std::move(right), accuracy, loop_.monitor(), 0, solution);
    loop_.check();
    Vector x(surface_.size());
    for(int i = 0; i < surface_.size(); ++i)
      x[i] = solution[i].x;
    return x;
  }

  const Surface& surface_;
  double shift_;
  Watched_loop<Host_loop> loop_;
  Backend backend_;
  std::unique_ptr<Multigrid<Backend>> multigrid_;
  Eigen::SimplicialLDLT<Matrix> cholesky_;
};

/// One implicit step of the heat equation, of time t: (M + t L)^-1 M x.
template <class Surface>
typename Surface::Vector smoothed(const Watched_loop<Host_loop>& loop, const Surface& surface,
                                  const typename Surface::Vector& x, double t)
{
  return Surface_solver<Surface>(loop, surface, 1 / t)(surface.mass().cwiseProduct(x) / t);
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SIGNATURE_DISCRETE_SURFACE_H
