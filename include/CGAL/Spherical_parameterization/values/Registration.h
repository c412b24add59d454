// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_VALUES_REGISTRATION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_VALUES_REGISTRATION_H

#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/values/Rotation.h>

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationInverse
/// @{

/// A feature of the caller: numbers of the vertices of both meshes that should be equal at corresponding points, such
/// as sulcal depth, myelin or thickness.
struct Registration_feature {
  std::vector<double> a; ///< of the first mesh, in the order of `vertices(mesh)`
  std::vector<double> b; ///< of the second mesh
  double weight = 20;    ///< as that of the curvature
};

/// The motion and the weights of `register_maps()`.
struct Registration {
  /// How the first map may be moved.
  enum class Motion {
    ROTATION,   ///< rotations: distances do not change
    MOEBIUS,    ///< rotations and boosts: a conformal map stays conformal
    DEFORMATION ///< any deformation that keeps it bijective
  };
  Motion motion = Motion::DEFORMATION; ///< how the first map may be moved

  /// \name Deformation
  /// The weights are those of mean squared differences, relative to the mean symmetric Dirichlet energy of the
  /// deformation of the sphere (4 without deformation). Features, those of the caller, too, are smoothed at the scale
  /// of the level, scaled to mean 0 and variance 1 on either surface, so that their units do not matter, and bounded by
  /// 2 tanh(x / 2). Positions are in units in which the surfaces have the area 4 pi. Stretching is the mean symmetric
  /// Dirichlet energy of the faces of the first surface, mapped to the second one (4 for an isometry).
  /// @{
  double curvature_weight = 20;               ///< of the mean curvature at two scales
  std::vector<Registration_feature> features; ///< of the caller: beside curvature, or (with its weight 0) instead
  double stretch_weight = 0;  ///< of the logarithmic area stretch of the maps; for maps of the same method
  double isometry_weight = 1; ///< of the mean stretching of the first surface onto the second, from the second level on
  double position_weight = 0; ///< of the coordinates, after the best motion in space: for shapes in one pose
  double landmark_weight = 300; ///< of their squared distances on the sphere, until they are in place

  double coarsest_scale = 0.6; ///< of the features that are compared first, as a length on the surface of area 4 pi
  int levels = 4;              ///< each has features half as large as the one before
  int iterations = 50;         ///< on every level, at most
  double accuracy = 1e-3;      ///< a level ends when an iteration gains less than this share of the energy above 4
  /// @}
};

/// The result of `register_maps()`.
struct Registration_result {
  Error_code error = Error_code::OK; ///< `OK` if and only if the registered map is complete and certified
  std::string detail;                ///< what is wrong; empty if `OK`

  std::size_t flipped_faces = 0; ///< of the registered map, exactly, as it is stored
  int degree = 0;                ///< of the registered map, exactly; 1 for a valid one

  std::string start; ///< the start: "spectrum", or a rotation by "landmarks", "coordinates" or "features"
  /// \name Of the Points That the Spectrum Has Found
  /// @{

  /// How much worse the best other candidate is, on a logarithmic scale. Small if the shapes are nearly symmetric or
  /// dissimilar, and down to -0.1 if the other one was passed over since its map brings together less that looks alike;
  /// infinite if there is no other candidate, or the spectrum was not used.
  double margin = std::numeric_limits<double>::infinity();
  /// Mean relative difference of the wave kernel signatures of corresponding points, from 0 to 1: about 0.03 between
  /// poses of one body, 0.1 between different bodies. 0 if the spectrum was not used.
  double signature_difference = 0;
  /// @}
  Rotation rotation = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; ///< of the first map at the start

  /// \name Of the Registered Map, as It Is Stored
  /// @{
  double mismatch_before = 0; ///< root of the sum of the mean squared differences of the features, each times its
                              ///< weight, of the rotated map, on the finest level that was reached; 0 if the call
                              ///< ended before the deformation
  double mismatch = 0;        ///< the same of the registered map
  double distortion = 4; ///< mean symmetric Dirichlet energy of the deformation of the sphere, by determinants; 4: none
  /// Mean symmetric Dirichlet energy of the first surface onto the second: 4: none; 0: not deformed. Determinants below
  /// 0.2 count as that, and faces stretched more than 30 times do not count: those that fold over a limb.
  double stretching = 0;
  double largest_landmark_distance = 0; ///< of two corresponding landmarks, in radians
  /// @}
  std::size_t iterations = 0; ///< of all levels together

  /// Wall-clock time of each phase, in seconds
  struct Seconds {
    double align = 0;  ///< reading and rotating
    double refine = 0; ///< deforming
    double total = 0;  ///< the whole call
  };
  Seconds seconds; ///< wall-clock

  /// How far to trust the correspondence, by margin, signatures and stretching.
  enum class Trust {
    UNKNOWN, ///< the spectrum was not used
    SURE,
    UNSURE, ///< another candidate is nearly as good, or the shapes are not very similar
    UNLIKE  ///< the shapes differ so much that points can hardly be said to correspond
  };
  /// \return the verdict from margin, difference of signatures and stretching
  Trust trust() const
  {
    // chosen on poses 0 to 79 of FAUST and on animals of TOSCA: doc/registration.md
    constexpr double least_margin = 0.25, largest_difference = 0.06, unlike = 0.09, largest_stretching = 15;
    if(start != "spectrum")
      return Trust::UNKNOWN;
    if(signature_difference > unlike || stretching > largest_stretching)
      return Trust::UNLIKE;
    return margin >= least_margin && signature_difference <= largest_difference ? Trust::SURE : Trust::UNSURE;
  }

  /// \return `true` iff the registered map is complete and certified
  explicit operator bool() const { return error == Error_code::OK; }
};

/// \param trust  how far a registration is to be trusted
/// \return "unknown", "sure", "unsure" or "unlike"; never freed
inline const char* get_trust_name(Registration_result::Trust trust)
{
  constexpr const char* names[] = {"unknown", "sure", "unsure", "unlike"};
  return names[static_cast<int>(trust)];
}

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_VALUES_REGISTRATION_H
