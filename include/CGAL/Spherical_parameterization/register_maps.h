// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_REGISTER_MAPS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_REGISTER_MAPS_H

#include <CGAL/Spherical_parameterization/internal/algebra/pi.h>
#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/align_maps.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/context/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/context/make_monitor.h>
#include <CGAL/Spherical_parameterization/internal/api/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/algebra/rotations.h>
#include <CGAL/Spherical_parameterization/internal/text/text.h>
#include <CGAL/Spherical_parameterization/internal/distortion/Mapped_faces.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_numbering.h>
#include <CGAL/Spherical_parameterization/internal/predicates/certificate.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/Centring.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/refine.h>
#include <CGAL/Spherical_parameterization/locate.h>
#include <CGAL/Spherical_parameterization/spherical_harmonics.h>

#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationInverse
/// @{

/// How far `register_maps()` goes, and what it compares.
struct Registration {
  /// What the first map may be moved by.
  enum class Motion {
    ROTATION,   ///< rotations: the map stays what it was
    MOEBIUS,    ///< rotations and boosts: a conformal map stays conformal
    DEFORMATION ///< anything that keeps it bijective
  };
  Motion motion = Motion::DEFORMATION; ///< the last and strongest one

  /// \name Deformation
  /// The weights are those of mean squared differences, beside the mean symmetric Dirichlet energy of the deformation
  /// of the sphere (4 where there is none). Features have a variance of about 1, but for positions, which are in units
  /// in which the surfaces have the area 4 pi. Stretching is the mean symmetric Dirichlet energy of the
  /// faces of the first surface, carried to the second one (4 where that is isometric).
  /// @{
  double curvature_weight = 5; ///< of the mean curvature at two scales
  double stretch_weight = 5;   ///< of the logarithmic area stretch of the maps; for maps of the same method
  double isometry_weight = 1; ///< of the mean stretching of the first surface onto the second, from the second level on
  double position_weight = 0; ///< of the coordinates, after the best motion in space: for shapes in the same pose
  double landmark_weight = 300; ///< of the squared distances of the landmarks on the sphere

  double coarsest_scale = 0.6; ///< of the features that are compared first, as a length on the surface of area 4 pi
  int levels = 4;              ///< each has features half as large as the one before
  int iterations = 50;         ///< on every level, at most
  double accuracy = 1e-3;      ///< a level ends when ten iterations gain less than this share of the energy above 4
  /// @}
};

/// A vertex of the first mesh and the one of the second mesh to which it corresponds.
template <class MeshA, class MeshB>
using Landmark_pair = std::pair<typename boost::graph_traits<MeshA>::vertex_descriptor,
                                typename boost::graph_traits<MeshB>::vertex_descriptor>;

/// What `register_maps()` has found.
struct Registration_result {
  Error_code error = Error_code::OK; ///< `OK` if and only if the registered map is complete and certified
  std::string detail;                ///< what is wrong; empty if `OK`

  std::size_t flipped_faces = 0; ///< of the registered map, exactly, as it is stored
  int degree = 0;                ///< of the registered map, exactly; 1 for a valid one

  std::string start;          ///< what found the rotation: "landmarks", "coordinates" or "features"
  Rotation rotation = {};     ///< of the first map, to start with
  double mismatch_before = 0; ///< root mean square difference of curvature and stretch on the finest level, rotated;
                              ///< 0 if the call ended before the map was deformed
  double mismatch = 0;        ///< and in the end
  double distortion = 4;      ///< mean symmetric Dirichlet energy of the deformation of the sphere; 4: none
  double stretching = 0;      ///< mean stretching of the first surface onto the second; 4: none. 0: not deformed
  double largest_landmark_distance = 0; ///< of a landmark from its place on the sphere, in radians
  std::size_t iterations = 0;           ///< of all levels together

  /// Wall-clock time of each phase, in seconds
  struct Seconds {
    double align = 0;  ///< reading and rotating
    double refine = 0; ///< deforming
    double total = 0;  ///< the whole call
  };
  Seconds seconds; ///< wall-clock

  /// \return `true` iff the registered map is complete and certified
  explicit operator bool() const { return error == Error_code::OK; }
};

/// \cond SKIP_IN_MANUAL
namespace internal {

/// Reads a surface and its map. Throws Error if the map is not valid.
template <class TriangleMesh, class VertexPointMap, class VertexSphereMap>
Registered_surface read_registered_surface(const Host_loop& loop, const TriangleMesh& mesh, VertexPointMap points,
                                           VertexSphereMap sphere_map)
{
  Mapped_faces map = read_mapped_faces(mesh, points, sphere_map, loop);
  const int n = static_cast<int>(map.image.size());
  if(map.face.empty())
    throw Input_error(Error_code::EMPTY_MESH, "there is nothing to register");
  Registered_surface surface;
  static_cast<Corner_table&>(surface) = map.copy_of_corner_table(loop);
  for(int i = 0; i < n; ++i)
    if(!is_finite(map.point[i]))
      throw Input_error(Error_code::NON_FINITE_COORDINATE, "the point of vertex " + std::to_string(i));
  const Certificate certificate = certify(loop, map.face, map.image);
  if(!certificate.is_valid())
    throw Input_error(Error_code::NOT_BIJECTIVE, counted(certificate.flipped_faces, "flipped face", "flipped faces") +
                                                   ", degree " + std::to_string(certificate.degree) +
                                                   "; register certified maps");
  for(vec3& p : map.image)
    p = unit(p);
  if(!certify(loop, map.face, map.image).is_valid())
    throw Input_error(Error_code::NOT_BIJECTIVE, "rounding flips faces; take unit vectors");

  double area = 0;
  vec3 centre = {0, 0, 0};
  for(const std::array<int, 3>& f : map.face) {
    const double of_face = norm(normal(map.point, f)) / 2;
    area += of_face;
    for(int i : f)
      centre = add_scaled(centre, of_face / 3, map.point[i]);
  }
  if(!(area > 0) || !std::isfinite(area))
    throw Input_error(Error_code::DEGENERATE_FACE, "the area of the surface is " + std::to_string(area));
  const double factor = std::sqrt(4 * internal::pi / area);
  for(const vec3& p : map.point)
    surface.point.push_back(scale(factor, add_scaled(p, -1 / area, centre)));
  surface.image = std::move(map.image);
  return surface;
}

/// Registers two surfaces: see `register_maps()`.
class Registrar {
public:
  Registrar(const Host_loop& loop, Registered_surface& a, const Registered_surface& b,
            const std::vector<std::pair<int, int>>& landmarks, const Registration& settings, Monitor& monitor,
            Registration_result& result)
    : loop_(loop), a_(a), b_(b), settings_(settings), monitor_(monitor), result_(result)
  {
    for(const auto& [i, j] : landmarks)
      landmarks_.push_back({i, b.image[j]});
  }

  /// The images of the vertices of A.
  template <class Locator, class LocatorB>
  Host_array<vec3> run(const Locator& locate_a, const LocatorB& locate_b)
  {
    const Stopwatch watch;
    Host_array<vec3> x = align(locate_a, locate_b);
    result_.seconds.align = watch.seconds();
    if(settings_.motion == Registration::Motion::DEFORMATION && !monitor_.is_interrupted())
      deform(x);
    result_.seconds.refine = watch.seconds() - result_.seconds.align;
    for(const Registration_landmark& l : landmarks_)
      result_.largest_landmark_distance = (std::max)(
        result_.largest_landmark_distance, 2 * std::asin((std::min)(1., norm(sub(x[l.vertex], l.place)) / 2)));
    return x;
  }

private:
  static constexpr int degree = 31;             ///< of what is correlated
  static constexpr double share_to_align = 0.3; ///< of the work, for the callback

  Host_array<vec3> turned(const Rotation& rotation) const
  {
    Host_array<vec3> x = a_.image;
    for(vec3& p : x)
      p = unit(rotated(rotation, p));
    return x;
  }

  static const Latitude_longitude_grid& grid()
  {
    static const Latitude_longitude_grid result = Latitude_longitude_grid::gauss_legendre(2 * degree + 1);
    return result;
  }

  /// Fields of vertices in harmonics.
  template <class Locate>
  Harmonic_coefficients harmonics(const std::vector<Host_array<double>>& fields, const Locate& locate) const
  {
    const std::size_t size = static_cast<std::size_t>(grid().rows()) * static_cast<std::size_t>(grid().columns());
    std::vector<double> values(fields.size() * size);
    for(int row = 0, at = 0; row < grid().rows(); ++row)
      for(int column = 0; column < grid().columns(); ++column, ++at) {
        const auto [corner, weight] = locate(grid().direction(row, column));
        for(std::size_t k = 0; k < fields.size(); ++k)
          for(int c = 0; c < 3; ++c)
            values[k * size + at] += weight[c] * fields[k][corner[c]];
      }
    return harmonic_analysis(CGAL::Sequential_tag(), grid(), values, degree);
  }

  static std::vector<Host_array<double>> coordinates_of(const Registered_surface& surface)
  {
    std::vector<Host_array<double>> result(3);
    for(const vec3& p : surface.point) {
      result[0].push_back(p.x);
      result[1].push_back(p.y);
      result[2].push_back(p.z);
    }
    return result;
  }

  /// A rotation that may be the best one.
  struct Proposal {
    const char* name;
    Rotation rotation;
  };

  /// By the coordinates in any pose, and by the features, whose correlation has several maxima where a shape is nearly
  /// symmetric, as bodies are in front and behind.
  std::vector<Proposal> proposals(const Rotation& by_coordinates, const Harmonic_coefficients& a,
                                  const Harmonic_coefficients& b) const
  {
    constexpr double least_share = 0.75; // of the largest correlation
    constexpr std::size_t most = 5;
    std::vector<Proposal> result = {{"coordinates", by_coordinates}};
    const std::vector<Correlation> correlations = best_correlations(loop_, b, a);
    double constant = 0; // that no rotation changes
    for(int k = 0; k < a.number_of_fields(); ++k)
      constant += a(0, 0, k) * b(0, 0, k);
    for(const Correlation& c : correlations)
      if(result.size() < most && c.value - constant >= least_share * (correlations.front().value - constant))
        result.push_back({"features", c.rotation});
    return result;
  }

  /// The best rotation, by landmarks if there are enough of them; else the proposal that is the best one after a coarse
  /// deformation.
  template <class Locate, class LocateB>
  Host_array<vec3> align(const Locate& locate_a, const LocateB& locate_b)
  {
    if(settings_.motion == Registration::Motion::MOEBIUS)
      return moebius_aligned(locate_a, locate_b);
    if(landmarks_.size() >= 3) {
      result_.start = "landmarks";
      Host_array<vec3> from, to;
      for(const Registration_landmark& l : landmarks_) {
        from.push_back(a_.image[l.vertex]);
        to.push_back(l.place);
      }
      result_.rotation = best_rotation(from, to);
      if(settings_.position_weight > 0)
        space_ = best_motion(locate_a, locate_b).space;
      return turned(result_.rotation);
    }
    if(!monitor_.advance(0))
      return a_.image;
    const Shape_alignment motion = best_motion(locate_a, locate_b);
    space_ = motion.space;
    if(!monitor_.advance(0))
      return a_.image;
    const auto features_a = features_of(a_, settings_.coarsest_scale),
               features_b = features_of(b_, settings_.coarsest_scale);
    const std::vector<Proposal> proposed =
      proposals(motion.sphere, harmonics(features_a, locate_a), harmonics(features_b, locate_b));
    const Registration_features features = weighted(features_a, features_b);
    const double all = settings_.motion == Registration::Motion::DEFORMATION ? share_to_align : 1;
    double least = std::numeric_limits<double>::infinity();
    Host_array<vec3> best;
    for(std::size_t k = 0; k < proposed.size(); ++k) {
      Host_array<vec3> x = turned(proposed[k].rotation), start = x;
      monitor_.begin_stage(all * k / proposed.size(), all * (k + 1) / proposed.size());
      const double energy =
        refine(loop_, a_, b_, features, landmarks_,
               {settings_.landmark_weight, 0, settings_.iterations, settings_.accuracy}, monitor_, x)
          .energy;
      if(energy < least) {
        least = energy;
        best = std::move(start);
        result_.start = proposed[k].name;
        result_.rotation = proposed[k].rotation;
      }
      if(monitor_.is_interrupted())
        break;
    }
    return best;
  }

  template <class Locate, class LocateB>
  Shape_alignment best_motion(const Locate& locate_a, const LocateB& locate_b) const
  {
    return best_alignment(CGAL::Sequential_tag(), harmonics(coordinates_of(b_), locate_b),
                          harmonics(coordinates_of(a_), locate_a));
  }

  /// Both maps centred by the areas of the surfaces, and the rotation between them for which coordinates and features
  /// are correlated best.
  template <class Locate, class LocateB>
  Host_array<vec3> moebius_aligned(const Locate& locate_a, const LocateB& locate_b)
  {
    const Centring centring_a(vertex_areas(a_), a_.image), centring_b(vertex_areas(b_), b_.image);
    const auto centred = [](const auto& locate, const Centring& centring) {
      return [&](const std::array<double, 3>& d) {
        const vec3 p = centring.inverse({d[0], d[1], d[2]});
        return locate(std::array<double, 3>{p.x, p.y, p.z});
      };
    };
    const auto centred_a = centred(locate_a, centring_a), centred_b = centred(locate_b, centring_b);
    if(landmarks_.size() >= 3) {
      result_.start = "landmarks";
      Host_array<vec3> from, to;
      for(const Registration_landmark& l : landmarks_) {
        from.push_back(centring_a(a_.image[l.vertex]));
        to.push_back(centring_b(l.place));
      }
      result_.rotation = best_rotation(from, to);
    } else {
      result_.start = "features";
      const auto fields = [&](const Registered_surface& s, const Centring& centring) {
        Registered_surface centred_surface = s;
        for(vec3& p : centred_surface.image)
          p = centring(p);
        return features_of(centred_surface, settings_.coarsest_scale);
      };
      result_.rotation = best_correlations(loop_, harmonics(fields(b_, centring_b), centred_b),
                                           harmonics(fields(a_, centring_a), centred_a))
                           .front()
                           .rotation;
    }
    Host_array<vec3> x = a_.image;
    for(vec3& p : x)
      p = centring_b.inverse(unit(rotated(result_.rotation, centring_a(p))));
    return x;
  }

  std::vector<Host_array<double>> features_of(const Registered_surface& surface, double scale) const
  {
    return shape_features(loop_, surface, scale, monitor_);
  }

  /// Stretch and curvatures, times the roots of their weights.
  Registration_features weighted(const std::vector<Host_array<double>>& a,
                                 const std::vector<Host_array<double>>& b) const
  {
    Registration_features result;
    for(std::size_t k = 0; k < a.size(); ++k) {
      const double factor = std::sqrt(k == 0 ? settings_.stretch_weight : settings_.curvature_weight);
      if(factor > 0)
        append(result, a[k], b[k], factor);
    }
    return result;
  }

  static void append(Registration_features& features, const Host_array<double>& a, const Host_array<double>& b,
                     double factor)
  {
    for(double x : a)
      features.a.push_back(factor * x);
    for(double x : b)
      features.b.push_back(factor * x);
    ++features.number;
  }

  void append_positions(Registration_features& features) const
  {
    Registered_surface moved;
    for(const vec3& p : a_.point)
      moved.point.push_back(rotated(space_, p));
    const auto a = coordinates_of(moved), b = coordinates_of(b_);
    for(int k = 0; k < 3; ++k)
      append(features, a[k], b[k], std::sqrt(settings_.position_weight));
  }

  void deform(Host_array<vec3>& x)
  {
    const Host_array<vec3> start = x;
    double size = settings_.coarsest_scale;
    Refinement refinement = {settings_.landmark_weight, 0, settings_.iterations, settings_.accuracy};
    Registration_features features;
    for(int level = 0; level < settings_.levels; ++level, size /= 2) {
      const double share = (1 - share_to_align) / settings_.levels;
      monitor_.begin_stage(share_to_align + level * share, share_to_align + (level + 1) * share);
      const Registration_features shape = weighted(features_of(a_, size), features_of(b_, size));
      features = shape;
      if(settings_.position_weight > 0)
        append_positions(features);
      const Refinement_report report = refined(features, refinement, x);
      refinement.isometry_weight = settings_.isometry_weight; // what is far off must not be in its way
      if(level + 1 == settings_.levels || monitor_.is_interrupted()) {
        const Refinement nothing = {0, 1, 0, 0};
        const auto look_at = [&](const Registration_features& what, Host_array<vec3> y) {
          return refined(what, nothing, y);
        };
        const Refinement_report before = look_at(shape, start);
        result_.distortion = report.distortion;
        if(landmarks_.empty() && !gains(look_at(features, start), look_at(features, x))) {
          x = start;
          result_.distortion = 4;
        }
        const Refinement_report in_the_end = look_at(shape, x);
        result_.mismatch_before = std::sqrt(before.mismatch);
        result_.mismatch = std::sqrt(in_the_end.mismatch);
        result_.stretching = in_the_end.stretching;
        break;
      }
    }
    if(!landmarks_.empty()) { // stiffer springs, until landmarks can be put where they belong
      constexpr int rounds = 4;
      constexpr double stiffer = 10;
      for(int round = 0; round < rounds && !monitor_.is_interrupted() && !place(x); ++round) {
        refinement.landmark_weight *= stiffer;
        result_.distortion = refined(features, refinement, x).distortion;
      }
      place(x);
    }
  }

  /// Whether a deformation has made the shapes more alike. Where they are the same already, the chords of coarse faces
  /// still have a little to gain by it.
  bool gains(const Refinement_report& before, const Refinement_report& after) const
  {
    const auto difference = [this](const Refinement_report& report) {
      return report.mismatch + (settings_.isometry_weight > 0 ? settings_.isometry_weight * report.stretching : 0);
    };
    return !(difference(before) <= difference(after)) || !std::isfinite(difference(before));
  }

  Refinement_report refined(const Registration_features& features, const Refinement& refinement, Host_array<vec3>& x)
  {
    const Refinement_report report = refine(loop_, a_, b_, features, landmarks_, refinement, monitor_, x);
    result_.iterations += static_cast<std::size_t>(report.iterations);
    return report;
  }

  /// Returns whether all landmarks are in place.
  bool place(Host_array<vec3>& x) const
  {
    place_landmarks(loop_, a_, landmarks_, x);
    return std::all_of(landmarks_.begin(), landmarks_.end(),
                       [&](const Registration_landmark& l) { return is_equal(x[l.vertex], l.place); });
  }

  const Host_loop& loop_;
  Registered_surface& a_;
  const Registered_surface& b_;
  const Registration& settings_;
  Monitor& monitor_;
  Registration_result& result_;
  std::vector<Registration_landmark> landmarks_;
  Rotation space_ = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
};

} // namespace internal
/// \endcond

/// Registration of two shapes: moves the map of the first one on the sphere so that equal points of the two maps are
/// corresponding points of the shapes. With the registered map any property is carried over
/// (`transfer_vertex_property()`), shapes are sampled at one icosphere (`resample()`), and meshes are morphed.
///
/// First the best rotation: by three or more landmarks; else that for which the coordinates in any pose
/// (`best_alignment()`), and up to four for which curvature and stretch are correlated best, of which the one is taken
/// that a coarse deformation makes most alike. Then the map is deformed, coarse features first: the mean symmetric
/// Dirichlet energy of the deformation, the mean squared differences of features, and the stretching of the one surface
/// onto the other are minimized (see `Registration`); where differences and stretching have not become less, the map is
/// only turned. The features, area stretch and curvatures, hardly depend on the
/// pose: the maps should be of low isometric distortion (`Isometric`) and of the same method.
///
/// Guarantee: the registered map is without flips and of degree 1, exactly, as stored, or the result says that it is
/// not. That corresponding points are found there is no guarantee of: `Registration_result` has the figures.
///
/// \param policy      `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param mesh_a      a closed triangle mesh, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_a    readable, key vertex_descriptor, value unit vectors: a valid map of `mesh_a`
/// \param mesh_b      as `mesh_a`
/// \param sphere_b    as `sphere_a`: a valid map of `mesh_b`, which is not moved
/// \param registered  readable and writable, key vertex_descriptor of `mesh_a`, value constructible from three numbers:
///                    the registered map; may be that of `sphere_a`. It is written unless the input is refused.
/// \param method      how far to go, and the weights
/// \param landmarks   pairs of vertices that correspond. Springs pull them together, and they are put exactly onto each
///                    other where that flips no face; with fewer than three the rotation is found without them.
/// \param np_a,np_b   optional named parameters: `vertex_point_map`, by default the meshes' own; those of the first
///                    mesh may have `callback`, `maximum_running_time` and `verbose`, too, as in `parameterize()`
/// \return the certificate, and what was reached; `NOT_BIJECTIVE` and the like for maps and meshes that cannot be
///         registered; `INTERRUPTED` if callback or time limit ended it: what is stored then is a certified map, too
/// \pre weights are not negative; there is a level or more; scale and accuracy are positive
///
/// Complexity: about 200 iterations, each linear in the size of the first mesh; two meshes of 10,000 vertices take 3
/// seconds on one core.
template <class ExecutionPolicy, class MeshA, class SphereMapA, class MeshB, class SphereMapB, class RegisteredMap,
          class NamedParametersA = parameters::Default_named_parameters,
          class NamedParametersB = parameters::Default_named_parameters, internal::If_policy<ExecutionPolicy> = 0>
Registration_result register_maps(const ExecutionPolicy& policy, const MeshA& mesh_a, SphereMapA sphere_a,
                                  const MeshB& mesh_b, SphereMapB sphere_b, RegisteredMap registered,
                                  const Registration& method = Registration(),
                                  const std::vector<Landmark_pair<MeshA, MeshB>>& landmarks = {},
                                  const NamedParametersA& np_a = parameters::default_values(),
                                  const NamedParametersB& np_b = parameters::default_values())
{
  using namespace internal;
  CGAL_SP_PRECONDITION(method.curvature_weight >= 0 && method.stretch_weight >= 0 && method.position_weight >= 0 &&
                         method.landmark_weight >= 0 && method.isometry_weight >= 0,
                       "the weights of a registration must not be negative");
  CGAL_SP_PRECONDITION(method.levels >= 1 && method.iterations >= 0, "a registration has a level or more");
  CGAL_SP_PRECONDITION(method.coarsest_scale > 0 && method.accuracy > 0, "scale and accuracy have to be positive");
  const Stopwatch total;
  const Host_loop loop = host_loop(policy);
  Monitor monitor = make_monitor(np_a);
  Registration_result result;
  try {
    Registered_surface a = read_registered_surface(loop, mesh_a, vertex_points(mesh_a, np_a), sphere_a);
    const Registered_surface b = read_registered_surface(loop, mesh_b, vertex_points(mesh_b, np_b), sphere_b);
    const Vertex_numbering<MeshA> number_a(vertices(mesh_a));
    const Vertex_numbering<MeshB> number_b(vertices(mesh_b));
    std::vector<std::pair<int, int>> pairs;
    for(const auto& [v, w] : landmarks)
      pairs.emplace_back(number_a(v), number_b(w));
    const auto locate = [](const auto& locator, const auto& number) {
      return [&](const std::array<double, 3>& direction) {
        const auto place = locator.locate(direction);
        return std::pair(corners_of_face(locator.mesh(), number, place.first), place.second);
      };
    };
    const Spherical_locator<MeshA> locator_a(policy, mesh_a, sphere_a);
    const Spherical_locator<MeshB> locator_b(policy, mesh_b, sphere_b);
    const Host_array<vec3> x = Registrar(loop, a, b, pairs, method, monitor, result)
                                 .run(locate(locator_a, number_a), locate(locator_b, number_b));
    typedef typename boost::property_traits<RegisteredMap>::value_type Point;
    std::size_t i = 0;
    for(auto v : vertices(mesh_a)) {
      put(registered, v, Point{x[i].x, x[i].y, x[i].z});
      ++i;
    }
    const Mapped_faces stored = read_images(mesh_a, registered, loop);
    const Certificate certificate = certify(loop, stored.face, stored.image);
    result.flipped_faces = certificate.flipped_faces;
    result.degree = certificate.degree;
    if(!certificate.is_valid()) {
      result.error = Error_code::NOT_BIJECTIVE;
      result.detail = counted(certificate.flipped_faces, "flipped face", "flipped faces") + ", degree " +
                      std::to_string(certificate.degree) + ", as the registered map is stored";
    } else if(monitor.is_interrupted()) {
      result.error = Error_code::INTERRUPTED;
      result.detail = monitor.reason();
    }
  } catch(const Input_error& error) {
    result.error = error.code();
    result.detail = error.detail();
  }
  result.seconds.total = total.seconds();
  return result;
}

/// \overload
/// \param mesh_a,sphere_a,mesh_b,sphere_b,registered,method,landmarks,np_a,np_b  as above; on one core
/// \return as above
template <class MeshA, class SphereMapA, class MeshB, class SphereMapB, class RegisteredMap,
          class NamedParametersA = parameters::Default_named_parameters,
          class NamedParametersB = parameters::Default_named_parameters, internal::If_no_policy<MeshA> = 0>
Registration_result register_maps(const MeshA& mesh_a, SphereMapA sphere_a, const MeshB& mesh_b, SphereMapB sphere_b,
                                  RegisteredMap registered, const Registration& method = Registration(),
                                  const std::vector<Landmark_pair<MeshA, MeshB>>& landmarks = {},
                                  const NamedParametersA& np_a = parameters::default_values(),
                                  const NamedParametersB& np_b = parameters::default_values())
{
  return register_maps(CGAL::Sequential_tag(), mesh_a, sphere_a, mesh_b, sphere_b, registered, method, landmarks, np_a,
                       np_b);
}

/// Moebius centring: moves a map by the Moebius transformation for which the centroid of a density on the surface is at
/// the centre of the sphere. Angles stay what they are. Conformal maps of a shape are the same after it up to a
/// rotation, whatever map one began with: A. Baden, K. Crane, M. Kazhdan, "Moebius registration", SGP 2018.
///
/// \param mesh        a closed triangle mesh, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors
/// \param mass_map    readable, key vertex_descriptor, value double: what each vertex counts, not negative: its area
///                    times the density that is chosen
/// \param centred     writable, key vertex_descriptor, value constructible from three numbers; may be that of
///                    `sphere_map`
/// \return the distance of the centroid from the centre in the end: 1e-13 or so; more if half of the mass or more is at
///         one point, for which there is no such transformation
/// \throws Error  `NON_FINITE_COORDINATE` for an image that is no direction, `BAD_WEIGHT` for a mass that is negative
/// or
///         not finite, or if all are 0; nothing is written then
///
/// Rounding may flip the smallest faces of a map that shrinks limbs much: certify what is kept.
///
/// Complexity: O(n) for a few steps of Newton's method.
template <class Mesh, class VertexSphereMap, class MassMap, class CentredMap>
double moebius_centred_map(const Mesh& mesh, VertexSphereMap sphere_map, MassMap mass_map, CentredMap centred)
{
  internal::Host_array<internal::vec3> v = internal::read_vectors(mesh, sphere_map);
  internal::Host_array<double> mass;
  internal::check_harmonics_data(v, {});
  double total = 0;
  for(auto vertex : vertices(mesh)) {
    mass.push_back(static_cast<double>(get(mass_map, vertex)));
    if(!(mass.back() >= 0) || !std::isfinite(mass.back()))
      throw internal::Input_error(Error_code::BAD_WEIGHT, "the mass of vertex " + std::to_string(mass.size() - 1));
    total += mass.back();
  }
  if(!(total > 0) || !std::isfinite(total))
    throw internal::Input_error(Error_code::BAD_WEIGHT, "there is no mass, or too much");
  for(internal::vec3& p : v)
    p = internal::unit(p);
  const internal::Centring centring(mass, v);
  typedef typename boost::property_traits<CentredMap>::value_type Point;
  std::size_t i = 0;
  for(auto vertex : vertices(mesh)) {
    const internal::vec3 p = centring(v[i++]);
    put(centred, vertex, Point{p.x, p.y, p.z});
  }
  return centring.distance();
}

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_REGISTER_MAPS_H
