// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_METHODS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_METHODS_H

#include <cstddef>

namespace CGAL {
namespace Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationMethods
/// @{

/// The fast method, and the default: a harmonic start map, then the balanced critical point of the spring
/// energy by Riemannian conjugate gradients, preconditioned with one multigrid cycle.
///
/// Without fixed vertices and with exponent 2 the six-dimensional freedom of the problem (rotations and Moebius
/// boosts) is removed by balancing: sum of m_i v_i = 0, with m_i the density of the energy in the map itself (to 1e-4).
/// The residual is that of the stationarity P_i((Lv)_i - m_i mu) = 0, P_i the projection to the tangent plane.
/// With three or more fixed vertices, or with an exponent above 2, nothing is balanced, and the residual is that of
/// eq. (2) of the paper, v_i parallel to its weighted neighbour mean.
///
/// Guarantee: none in advance, since positive weights make eq. (2) bijective but not the computation in doubles;
/// the certificate in `Result` decides.
///
/// Named parameters: `accuracy` bounds the residual, `number_of_iterations` the descent steps.
///
/// \cgalModels{SphericalParameterizationMethod}
struct Balanced {
  /// Where the named parameter `accuracy` is not given.
  static constexpr double default_accuracy = 5e-9;
  /// Where the named parameter `number_of_iterations` is not given.
  static constexpr std::size_t default_number_of_iterations = 500;

  /// Exponent p >= 2 of the spring energy E_p = 1/p sum w_ij l_ij^2 (|v_i - v_j| / l_ij)^p, l_ij the length of the edge
  /// in the source mesh, whose area is scaled to 4 pi. 2 is the published energy; larger exponents equalise areas,
  /// trade angles for them, and keep thin limbs wider.
  double spring_exponent = 2;
};

/// The published method, Algorithm 1 of the paper. T. Athanasiadis and I. Fudos, "Parallel computation of spherical
/// parameterizations for mesh analysis", Computers & Graphics 35 (SMI 2011). Each outer iteration minimises the spring
/// energy subject to u_i . v_i = 1 (a saddle-point problem, solved by plain sweeps) and projects u back to the sphere,
/// which cannot raise the energy (Proposition 1).
///
/// Guarantee: the energy falls monotonically. Convergence to a bijective map is not guaranteed: without fixed vertices
/// the boost modes keep it from settling, and the result then says so (`NOT_CONVERGED`).
///
/// Named parameters: `accuracy` bounds the L2 residual of eq. (2), and is the relative reduction of the residual asked
/// of each saddle-point problem; `number_of_iterations` counts outer iterations.
///
/// \cgalModels{SphericalParameterizationMethod}
struct Saddle_point {
  /// Where the named parameter `accuracy` is not given.
  static constexpr double default_accuracy = 1e-7;
  /// Where the named parameter `number_of_iterations` is not given.
  static constexpr std::size_t default_number_of_iterations = 1000;

  /// The splitting of the Laplacian: eq. (12) or (13) of the paper.
  enum class Splitting {
    JACOBI,      ///< parallel; relaxation in (0, 1)
    GAUSS_SEIDEL ///< relaxation in (0, 2)
  };
  /// Where the iteration starts.
  enum class Start {
    CENTROID, ///< vertices projected from their centroid, as the authors do
    HARMONIC, ///< the start map of `Balanced`
    GIVEN     ///< what the sphere map holds on entry; it must be readable
  };
  Splitting splitting = Splitting::JACOBI; ///< which sweep
  Start start = Start::CENTROID;           ///< where to start
  double relaxation = 0.95;                ///< omega, see `Splitting`
  std::size_t check_interval = 1000;       ///< sweeps between two tests for convergence
};

/// The map that always exists: bijective by construction, with little distortion of lengths.
///
/// Coarse to fine: the mesh is decimated to a tetrahedron, whose map is known; the vertices come back one round after
/// the other, each into the kernel of its star, and after every round the distortion is relaxed. Nothing is moved but
/// to where an exact predicate finds all faces positively oriented. The energy is the symmetric Dirichlet energy s^2 +
/// t^2 + 1/s^2 + 1/t^2 of the principal stretches s, t, integrated over the source (with `area_exponent` 1). E. Praun
/// and H. Hoppe, "Spherical parametrization and remeshing", SIGGRAPH 2003; X. Hu, X.-M. Fu, L. Liu, "Advanced
/// hierarchical spherical parameterizations", TVCG 2018. See \ref isometric_method.
///
/// Guarantee: what is handed out is bijective. Should doubles have no position for a vertex, which did not happen with
/// any mesh so far, the result is `NOT_BIJECTIVE` and there is no map. That the energy is at its minimum is not
/// claimed. Faces without area count as small ones of a good shape. Weights are not used; vertices cannot be fixed.
///
/// Named parameters: `number_of_iterations` bounds the Newton steps for the whole mesh, `accuracy` is the relative gain
/// of energy that such a step has to promise for another one to follow.
///
/// \cgalModels{SphericalParameterizationMethod}
struct Isometric {
  /// Where the named parameter `accuracy` is not given.
  static constexpr double default_accuracy = 5e-4;
  /// Where the named parameter `number_of_iterations` is not given.
  static constexpr std::size_t default_number_of_iterations = 20;

  /// What slides from angle to area preservation: the exponent theta >= 0 of the area distortion in
  /// E_c E_a^theta, E_c = (s/t + t/s) / 2, E_a = (st + 1/(st)) / 2 (P. Degener, J. Meseth, R. Klein, "An adaptable
  /// surface parametrization method", IMR 2003). 0 is conformal, as far as the descent comes; 1 isometric, as far as
  /// the surface allows; 30 and more authalic.
  double area_exponent = 1;
};

/// The map that was asked for if it is valid, else one that is:
/// 1. `Balanced{spring_exponent}`;
/// 2. `Balanced` with the exponent `larger_spring_exponent`, if that is larger, which keeps limbs wider;
/// 3. `Isometric{area_exponent}`, unless vertices are fixed.
/// `Result::method` says which one it was, `Result::fallback_reason` why not an earlier one. Weights that are not
/// positive because of a face without area lead to the third one; interrupted there, it hands over what `Isometric`
/// would.
///
/// Named parameters: `accuracy` and `number_of_iterations` as of `Balanced`.
///
/// \cgalModels{SphericalParameterizationMethod}
struct Automatic {
  /// Where the named parameter `accuracy` is not given.
  static constexpr double default_accuracy = Balanced::default_accuracy;
  /// Where the named parameter `number_of_iterations` is not given.
  static constexpr std::size_t default_number_of_iterations = Balanced::default_number_of_iterations;

  double spring_exponent = 2;        ///< of the first map, see `Balanced`
  double larger_spring_exponent = 3; ///< of the second map
  double area_exponent = 1;          ///< of the third map, see `Isometric`
};

/// @}

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_METHODS_H
