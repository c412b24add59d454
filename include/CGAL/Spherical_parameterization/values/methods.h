// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_VALUES_METHODS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_VALUES_METHODS_H

#include <cstddef>
#include <limits>
#include <optional>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationMethods
/// @{

/// Moebius-centred harmonic maps; the fast method, and the default. After a harmonic start map on a coarse level, it
/// finds a critical point of the spring energy by Riemannian conjugate gradients, preconditioned with a multigrid
/// cycle. See \ref balanced_method.
///
/// Along Moebius boosts the energy hardly changes. Without fixed vertices and with exponent 2 they are removed by the
/// constraint sum of m_i v_i = 0. Here m_i is the energy density of the map itself, tilted so that the centroid of the
/// source area is at the centre. The map then depends on the mesh alone, not on its numbering (up to a rotation and the
/// accuracy). The residual is that of P_i((Lv)_i - m_i mu) = 0, with P_i the projection to the tangent plane. With
/// three or more fixed vertices, or an exponent above 2, there is no such constraint, and the residual is that of eq.
/// (2) of the paper, v_i parallel to its weighted neighbour mean.
///
/// Guarantee: none in advance. With positive weights a solution of eq. (2) is bijective, but its computation in double
/// precision need not be. The certificate in `Result` says whether the map is valid.
///
/// Named parameters: `accuracy` bounds the residual, `number_of_iterations` the descent steps.
///
/// \cgalModels{SphericalParameterizationMethod}
struct Balanced {
  /// Default of the named parameter `accuracy`.
  static constexpr double default_accuracy = 2e-9;
  /// Default of the named parameter `number_of_iterations`.
  static constexpr std::size_t default_number_of_iterations = 500;

  /// Exponent p >= 2 of the p-Dirichlet energy E_p = 1/p sum w_ij l_ij^2 (|v_i - v_j| / l_ij)^p, l_ij the length of the
  /// edge in the source mesh, whose area is scaled to 4 pi. 2 is the published energy. Larger exponents equalize areas
  /// at the cost of angles, and keep thin limbs wider. On coarse meshes, and with limbs, maps with
  /// exponents near 2 may collapse to a point, with `NOT_BIJECTIVE` or `NOT_CONVERGED`; from 3 on seldom.
  double spring_exponent = 2;
};

/// The published method, Algorithm 1 of the paper. T. Athanasiadis and I. Fudos, "Parallel computation of spherical
/// parameterizations for mesh analysis", Computers & Graphics 35 (SMI 2011). Each outer iteration minimizes the spring
/// energy subject to u_i . v_i = 1 (a saddle-point problem, solved by plain sweeps) and projects u back to the sphere,
/// which cannot raise the energy (Proposition 1).
///
/// Guarantee: the energy falls monotonically. Convergence to a bijective map is not guaranteed: without fixed vertices
/// it usually stalls along Moebius boosts, and the result is `NOT_CONVERGED`.
///
/// Named parameters: `accuracy` bounds the L2 residual of eq. (2), and is the factor by which the residual of each
/// saddle-point problem is reduced; `number_of_iterations` bounds the outer iterations.
///
/// \cgalModels{SphericalParameterizationMethod}
struct Saddle_point {
  /// Default of the named parameter `accuracy`.
  static constexpr double default_accuracy = 1e-7;
  /// Default of the named parameter `number_of_iterations`.
  static constexpr std::size_t default_number_of_iterations = 1000;

  /// The splitting of the Laplacian: eq. (12) or (13) of the paper.
  enum class Splitting {
    JACOBI,      ///< parallel; relaxation in (0, 1)
    GAUSS_SEIDEL ///< relaxation in (0, 2)
  };
  /// The map the iteration starts from.
  enum class Start {
    CENTROID, ///< vertices projected from their centroid, as in the paper
    HARMONIC, ///< the start map of `Balanced`
    GIVEN     ///< the positions in the sphere map on entry, which must be readable
  };
  Splitting splitting = Splitting::JACOBI; ///< the kind of sweep
  Start start = Start::CENTROID;           ///< the start map
  double relaxation = 0.95;                ///< omega, see `Splitting`
  std::size_t check_interval = 1000;       ///< sweeps between two tests for convergence
};

/// Maps of low symmetric Dirichlet energy, coarse to fine, bijective by construction.
///
/// The mesh is decimated to a tetrahedron, which is mapped to a regular one. The vertices are inserted again, round by
/// round, each into the kernel of its star, and the distortion is relaxed each time the mesh has grown by a third, or,
/// above 500 vertices, has doubled, or, above 20,000, is five times as large. A vertex is moved only to positions where
/// all of its faces are positively oriented by an exact predicate. The energy is the symmetric Dirichlet energy s^2 +
/// t^2 + 1/s^2 + 1/t^2 of the principal stretches s, t, integrated over the source (with `area_exponent` 1). E. Praun
/// and H. Hoppe, "Spherical parametrization and remeshing", SIGGRAPH 2003; X. Hu, X.-M. Fu, L. Liu, "Advanced
/// hierarchical spherical parameterizations", TVCG 2018. See \ref isometric_method.
///
/// Guarantee: the map is bijective in doubles, if there is one. If doubles have no position for a vertex, the result is
/// `NOT_BIJECTIVE` and there is no map. The energy need not be minimal. Faces of area 0 are treated as small faces of
/// good shape. Weights are not used.
///
/// Fixed vertices are landmarks. They can be anywhere, also far from their positions in the map without landmarks.
/// Either the map is bijective and has every landmark exactly at its position, or the result is `BAD_CONSTRAINTS` and
/// names the vertices between which the mesh is too coarse. With a finite `landmark_weight` they are only pulled to
/// their positions, and there always is a map. See \ref landmarks.
///
/// With the named parameter `face_density_map` or `vertex_density_map`, of positive numbers, the area of a face on the
/// sphere is to be proportional to its density times its area in the mesh (G. P. T. Choi, C. H. Rycroft,
/// "Density-equalizing maps for simply connected open surfaces", SIAM J. Imaging Sci. 2018; Z. Lyu, L. M. Lui, G. P. T.
/// Choi, "Spherical density-equalizing map for genus-0 closed surfaces", SIAM J. Imaging Sci. 2024). Stretches are then
/// relative to faces with these target areas and their own angles, and so is everything that is said here.
/// `Result::density_deviation` says how close the areas are; see \ref densities.
///
/// Named parameters: `number_of_iterations` bounds the Newton steps for the whole mesh (above 100,000 vertices in
/// proportion fewer, but at least a quarter); an area exponent above 3 is reached from there by factors of up to 1.5,
/// and each on the way has as many steps, but at most 6. `accuracy` is a relative gain of energy: the steps end when
/// the predicted gain of a step is below it. (Above 20,000 vertices the prediction for the next step is used: a quarter
/// of that of a full step. Below 2,000 vertices, where steps are cheap, the bound is lower in proportion, down to a
/// twentieth.) The residual is the predicted gain of one more step, for the defaults one with at most 20 linear
/// iterations, and above 100,000 vertices with the matrix of the last step (not with landmarks or exponents above 1).
/// If the steps are used up, the map is `OK` with `Termination::ITERATIONS`, unless the accuracy is smaller or the
/// iterations are fewer than the defaults: then it is `NOT_CONVERGED`.
///
/// \cgalModels{SphericalParameterizationMethod}
struct Isometric {
  /// Default of the named parameter `accuracy`.
  static constexpr double default_accuracy = 5e-4;
  /// Default of the named parameter `number_of_iterations`.
  static constexpr std::size_t default_number_of_iterations = 20;
  /// Default of `area_exponent` without densities.
  static constexpr double default_area_exponent = 1;
  /// Default of `area_exponent` with densities: areas are within 10 to 20 % of their targets on most meshes;
  /// less near on coarse tubes, see `Result::density_deviation`.
  static constexpr double area_exponent_of_densities = 10;

  /// Weight of area against angle preservation: the exponent theta >= 0 of the area distortion in E_c E_a^theta, E_c
  /// = (s/t + t/s) / 2, E_a = (st + 1/(st)) / 2 (P. Degener, J. Meseth, R. Klein, "An adaptable surface
  /// parametrization method", IMR 2003). 0 is as conformal as possible, 1 as isometric as possible, 30 and more as
  /// authalic (area preserving) as possible. Not given: `default_area_exponent`, or with densities
  /// `area_exponent_of_densities`.
  std::optional<double> area_exponent = std::nullopt;

  /// Infinite: fixed vertices stay exactly at their positions. Finite and positive: they are soft landmarks. This
  /// weight times the mean squared distance of the fixed vertices from their positions is added to the mean distortion
  /// (4 = isometric, with `area_exponent` 1).
  double landmark_weight = std::numeric_limits<double>::infinity();
};

/// Tries several methods and returns the first map that is valid and usable:
/// 1. `Balanced{spring_exponent}`;
/// 2. `Isometric{area_exponent}`.
///
/// So it accepts fixed vertices at any positions: see `Isometric`.
///
/// Harmonic maps shrink limbs exponentially with their length. If a valid map shrinks them by more than
/// `largest_shrinkage`, it cannot be used for sampling, texture or measurements, and the isometric map is taken.
///
/// Harmonic maps do not follow densities: with densities only the second method is tried.
///
/// If no map is valid and usable, the best one is returned: a valid map, else one of degree 1 with the fewest flipped
/// faces. `Result::attempts` lists all methods that were tried, each with its verdict and its seconds. `Result::method`
/// is the method of the returned map, and `Result::fallback_reason` says why an earlier one was rejected. If weights do
/// not exist because of a face of (almost) no area, only the second method is tried.
///
/// Named parameters: `accuracy` and `number_of_iterations` as for `Balanced`; the second attempt has the defaults of
/// `Isometric`.
///
/// \cgalModels{SphericalParameterizationMethod}
struct Automatic {
  /// Default of the named parameter `accuracy`.
  static constexpr double default_accuracy = Balanced::default_accuracy;
  /// Default of the named parameter `number_of_iterations`.
  static constexpr std::size_t default_number_of_iterations = Balanced::default_number_of_iterations;

  double spring_exponent = 2;                         ///< of the first method, see `Balanced`
  std::optional<double> area_exponent = std::nullopt; ///< of the second method, see `Isometric`
  /// A valid map is not usable if lengths shrink by more than this factor, relative to the mean of the map, on
  /// more than a thousandth of the surface; >= 1. Regions of less than a ten-thousandth of the faces are
  /// noise, and are ignored. Infinite: every valid map is usable. The default corresponds to the resolution of
  /// floats.
  double largest_shrinkage = 1e4;
};

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_VALUES_METHODS_H
