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

/// Moebius-centred harmonic maps; the fast method, and the default. A harmonic start map on a coarse level, then a
/// critical point of the spring energy by Riemannian conjugate gradients, preconditioned with one multigrid cycle. See
/// \ref balanced_method.
///
/// Without fixed vertices and with exponent 2 the Moebius boosts, along which the energy hardly changes, are removed by
/// the constraint sum of m_i v_i = 0, with m_i the density of the energy in the map itself, tilted so that the centroid
/// of the source area is at the centre. Such a map depends on the mesh alone, not on its numbering (up to a rotation,
/// to the accuracy). The residual is that of the stationarity P_i((Lv)_i - m_i mu) = 0, P_i the projection to the
/// tangent plane. With three or more fixed vertices, or with an exponent above 2, nothing is balanced, and the residual
/// is that of eq. (2) of the paper, v_i parallel to its weighted neighbour mean.
///
/// Guarantee: none in advance. Positive weights make a solution of eq. (2) bijective, but not its computation in
/// double precision. The certificate in `Result` says whether the map is valid.
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
  /// at the cost of angles, and keep thin limbs wider.
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
  Splitting splitting = Splitting::JACOBI; ///< which sweep
  Start start = Start::CENTROID;           ///< where to start
  double relaxation = 0.95;                ///< omega, see `Splitting`
  std::size_t check_interval = 1000;       ///< sweeps between two tests for convergence
};

/// Maps of low symmetric Dirichlet energy, coarse to fine, bijective by construction.
///
/// The mesh is decimated to a tetrahedron, which is mapped to a regular one. The vertices are inserted again, round by
/// round, each into the kernel of its star, and the distortion is relaxed after every round, or, above 20,000 vertices,
/// each time the mesh has grown by three. A vertex is moved only to positions where all of its faces are positively
/// oriented by an exact predicate. The energy is the symmetric Dirichlet energy s^2 + t^2 + 1/s^2 + 1/t^2 of the
/// principal stretches s, t, integrated over the source (with `area_exponent` 1). E. Praun and H. Hoppe, "Spherical
/// parametrization and remeshing", SIGGRAPH 2003; X. Hu, X.-M. Fu, L. Liu, "Advanced hierarchical spherical
/// parameterizations", TVCG 2018. See \ref isometric_method.
///
/// Guarantee: the map is bijective in doubles, if there is one. If doubles have no position for a vertex, the result is
/// `NOT_BIJECTIVE` and there is no map. The energy is not claimed to be minimal. Faces without area count as small ones
/// of a good shape. Weights are not used.
///
/// Fixed vertices are landmarks: they can be anywhere, and however far from where the map without them has them. The
/// map has every one exactly where it was put and is bijective as ever, or the result is `BAD_CONSTRAINTS` and names
/// the vertices between which the mesh is too coarse to be bent so far. With a finite `landmark_weight` they are only
/// pulled to their places, and there always is a map. See \ref landmarks.
///
/// With the named parameter `face_density_map` or `vertex_density_map`, of positive numbers, the area of a face on the
/// sphere is wanted to be proportional to its density times its area in the mesh: the map enlarges what matters (G. P.
/// T. Choi, C. H. Rycroft, "Density-equalizing maps for simply connected open surfaces", SIAM J. Imaging Sci. 2018; Z.
/// Lyu, L. M. Lui, G. P. T. Choi, "Spherical density-equalizing map for genus-0 closed surfaces", SIAM J. Imaging Sci.
/// 2024). Stretches are then those against the mesh whose faces have the wanted areas and their own angles, and
/// everything that is said here holds for that. How near areas come is `Result::density_deviation`; see \ref densities.
///
/// Named parameters: `number_of_iterations` bounds the Newton steps for the whole mesh (in proportion fewer above
/// 100,000 vertices, but a quarter at least), `accuracy` is the relative gain of energy that such a step has to promise
/// for another one to follow (above 20,000 vertices, that it has to leave: a quarter of what it promised, if it could
/// be taken in full; below 2,000 vertices, where steps are cheap, in proportion less, down to a twentieth). The
/// residual is what one more step would promise. A map whose steps are used up is `OK` all the same, with
/// `Termination::ITERATIONS`, unless a smaller accuracy or fewer iterations than the defaults were asked for: then it
/// is `NOT_CONVERGED`.
///
/// \cgalModels{SphericalParameterizationMethod}
struct Isometric {
  /// Default of the named parameter `accuracy`.
  static constexpr double default_accuracy = 5e-4;
  /// Default of the named parameter `number_of_iterations`.
  static constexpr std::size_t default_number_of_iterations = 20;
  /// Of `area_exponent`, if there are no densities.
  static constexpr double default_area_exponent = 1;
  /// The default of `area_exponent` where densities are given: areas come within 10 to 20 % of what is wanted.
  static constexpr double area_exponent_of_densities = 10;

  /// Weight of area against angle preservation: the exponent theta >= 0 of the area distortion in
  /// E_c E_a^theta, E_c = (s/t + t/s) / 2, E_a = (st + 1/(st)) / 2 (P. Degener, J. Meseth, R. Klein, "An adaptable
  /// surface parametrization method", IMR 2003). 0 is as conformal as possible, 1 as isometric as possible, 30 and
  /// more as authalic (area preserving) as possible. Not given: `default_area_exponent`, or where densities are given
  /// `area_exponent_of_densities`.
  std::optional<double> area_exponent = std::nullopt;

  /// Infinite: fixed vertices stay exactly where they were put. Finite and positive: they are soft landmarks; to the
  /// mean distortion (4 = isometric, with `area_exponent` 1) is added this weight times the mean of the squared
  /// distances of the fixed vertices from their places.
  double landmark_weight = std::numeric_limits<double>::infinity();
};

/// Tries several methods and returns the first map that is valid and of use:
/// 1. `Balanced{spring_exponent}`;
/// 2. `Isometric{area_exponent}`.
///
/// So it keeps fixed vertices, too, wherever they are: see `Isometric`.
///
/// Harmonic maps shrink limbs exponentially with their length. A valid map that leaves next to nothing of them, by
/// `largest_shrinkage`, is of no use to what samples, paints or measures the sphere; the isometric map is.
///
/// Springs do not follow densities: where these are given only the second map is tried.
///
/// If no map is valid and of use, the best one is returned: a valid one, else one of degree 1, with the fewest flipped
/// faces. `Result::attempts` lists all methods that were tried, each with its verdict and its seconds;
/// `Result::method` is the one whose map was returned, and `Result::fallback_reason` says why not an earlier one. If
/// there are no weights because of a face without area, only the second one is tried.
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

  double spring_exponent = 2;                         ///< of the first map, see `Balanced`
  std::optional<double> area_exponent = std::nullopt; ///< of the second map, see `Isometric`
  /// How many times lengths may shrink, against the mean of the map, on more than a thousandth of the surface; >= 1.
  /// Regions of less than a ten-thousandth of the faces are no limbs, but noise, and do not count.
  /// Infinite: every valid map will do. The default leaves the faces of a limb on the sphere a few units of the last
  /// place of a float.
  double largest_shrinkage = 1e4;
};

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_VALUES_METHODS_H
