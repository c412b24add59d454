// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_REGISTER_SURFACES_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_REGISTER_SURFACES_IMPL_H

#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/values/Rotation.h>
#include <CGAL/Spherical_parameterization/internal/algebra/rotations.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/Order_on_sphere.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/Spectral_registration.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/landmarks_in_place.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/register_surfaces.h>
#include <CGAL/Spherical_parameterization/internal/locate/Locator.h>
#include <CGAL/Spherical_parameterization/internal/moebius/Centring.h>
#include <CGAL/Spherical_parameterization/internal/predicates/certificate.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/analysis.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/rotation.h>
#include <CGAL/Spherical_parameterization/internal/text/text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

namespace CGAL::Spherical_parameterization::internal {

/// One of the two surfaces, with its fields in harmonics, and the features that were computed last.
template <class...>
class Registered_side {
public:
  static constexpr int degree = 31; ///< of what is correlated

  Registered_side(const Watched_loop<Host_loop>& loop, const Registered_surface& its_surface, const Locator& locator,
                  std::vector<Host_array<double>> own)
    : surface(its_surface), loop_(loop), locator_(locator), own_(std::move(own))
  {}

  const Registered_surface& surface;
  const Locator& locator() const { return locator_; }

  /// Fields of the vertices; the map is seen through a centring if there is one.
  Harmonic_coefficients harmonics(const std::vector<Host_array<double>>& fields,
                                  const Centring* centring = nullptr) const
  {
    const Latitude_rows grid = grid_to_sample(degree);
    const Host_array<vec3> directions = grid.directions();
    const int number = static_cast<int>(fields.size());
    Sampled_fields samples = {number, Host_array<double>(fields.size() * directions.size(), 0.)};
    for(std::size_t i = 0; i < directions.size(); ++i) {
      const auto [face, weight] = locator_.locate(centring ? centring->inverse(directions[i]) : directions[i]);
      for(std::size_t k = 0; k < fields.size(); ++k)
        for(int c = 0; c < 3; ++c)
          samples.value[k * directions.size() + i] += weight[c] * fields[k][surface.face[face][c]];
    }
    return analyze_rows(loop_, grid, samples, degree);
  }

  /// The coordinates, turned in space.
  std::vector<Host_array<double>> coordinates(const Rotation& space = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}) const
  {
    std::vector<Host_array<double>> result(3);
    for(const vec3& p : surface.point) {
      const vec3 q = rotated(space, p);
      result[0].push_back(q.x);
      result[1].push_back(q.y);
      result[2].push_back(q.z);
    }
    return result;
  }

  const std::vector<Host_array<double>>& features(double scale)
  {
    if(scale != scale_)
      features_ = shape_features(loop_.bare(), surface, own_, scale, loop_.monitor());
    scale_ = scale;
    return features_;
  }

  Centring centring() const
  {
    return Centring(loop_.bare(), vertex_areas(loop_.bare(), surface.face, surface.point), surface.image);
  }

  /// Of the centred map.
  std::vector<Host_array<double>> features(double scale, const Centring& centring) const
  {
    Registered_surface centred = surface;
    for(vec3& p : centred.image)
      p = centring(p);
    return shape_features(loop_.bare(), centred, own_, scale, loop_.monitor());
  }

private:
  const Watched_loop<Host_loop>& loop_;
  const Locator& locator_;
  std::vector<Host_array<double>> own_; ///< features of the caller
  double scale_ = 0;
  std::vector<Host_array<double>> features_;
};

template <class...>
class Registrar {
public:
  Registrar(const Watched_loop<Host_loop>& loop, const Registered_side<>& a, const Registered_side<>& b,
            const std::vector<std::pair<int, int>>& landmarks, const Registration& settings,
            Registration_result& result)
    : loop_(loop), a_(a), b_(b), landmark_vertices_(landmarks), settings_(settings), result_(result),
      start_(a.surface.image)
  {
    for(const auto& [i, j] : landmarks)
      landmarks_.push_back({i, b.surface.image[j]});
  }

  /// The images of the vertices of A.
  Host_array<vec3> run()
  {
    const Stopwatch watch;
    try {
      if(!is_found_by_spectrum())
        align();
    } catch(const Input_error& error) {
      if(error.code() != Error_code::INTERRUPTED)
        throw;
    }
    result_.seconds.align = watch.seconds();
    Host_array<vec3> x = deformed_.empty() ? start_ : deformed_;
    if(settings_.motion == Registration::Motion::DEFORMATION && !loop_.monitor().is_interrupted())
      deform(x);
    result_.seconds.refine = watch.seconds() - result_.seconds.align;
    return x;
  }

  /// The figures of a map.
  void measure(const Host_array<vec3>& x)
  {
    for(const Registration_landmark& l : landmarks_)
      result_.largest_landmark_distance = (std::max)(
        result_.largest_landmark_distance, 2 * std::asin((std::min)(1., norm(sub(x[l.vertex], l.place)) / 2)));
    if(!is_deformed_)
      return;
    const Refinement_report report = look_at(shape_, x);
    result_.mismatch_before = std::sqrt(look_at(shape_, start_).mismatch);
    result_.mismatch = std::sqrt(report.mismatch);
    result_.stretching = report.stretching;
    const bool is_where_it_was = std::equal(x.begin(), x.end(), start_.begin(), is_equal);
    result_.distortion = is_where_it_was ? 4 : report.distortion;
  }

private:
  static constexpr double share_to_align = 0.3; ///< of the work, for the callback

  /// Finds a start by eigenfunctions: then `deformed_` is one, if there is a valid one. Returns false where that is not
  /// asked for, where the caller's features say what corresponds, or where there are too few vertices.
  bool is_found_by_spectrum()
  {
    if(settings_.motion != Registration::Motion::DEFORMATION || settings_.position_weight > 0 ||
       !settings_.features.empty() ||
       (std::min)(a_.surface.point.size(), b_.surface.point.size()) < Spectral_registration<>::least_vertices)
      return false;
    Spectral_registration<> found(loop_, a_.surface, b_.surface, b_.locator(), weighted(scale_of(settings_.levels - 1)),
                                  landmark_vertices_);
    result_.start = "spectrum";
    result_.margin = found.margin;
    result_.signature_difference = found.difference;
    result_.iterations = found.iterations;
    result_.rotation = found.rotation;
    start_ = turned(found.rotation);
    deformed_ = std::move(found.image);
    return true;
  }

  Host_array<vec3> turned(const Rotation& rotation) const
  {
    Host_array<vec3> x = a_.surface.image;
    for(vec3& p : x)
      p = unit(rotated(rotation, p));
    return x;
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
    for(const Correlation& c : correlations)
      if(result.size() < most && c.value >= least_share * correlations.front().value)
        result.push_back({"features", c.rotation});
    return result;
  }

  /// The best rotation of the landmarks, which `of_a` and `of_b` have moved.
  template <class F, class G>
  Rotation landmark_rotation(F of_a, G of_b)
  {
    result_.start = "landmarks";
    Host_array<vec3> from, to;
    for(const Registration_landmark& l : landmarks_) {
      from.push_back(of_a(a_.surface.image[l.vertex]));
      to.push_back(of_b(l.place));
    }
    return best_rotation(from, to);
  }

  bool has_landmarks() const { return landmarks_.size() >= 3; }

  Shape_alignment best_motion_in_space() const
  {
    return best_motion(loop_, b_.harmonics(b_.coordinates()), a_.harmonics(a_.coordinates()));
  }

  /// The best rotation, by landmarks if there are enough of them; else the proposal that is the best one after a coarse
  /// deformation.
  void align()
  {
    if(settings_.motion == Registration::Motion::MOEBIUS)
      return align_centred();
    if(has_landmarks()) {
      const auto as_it_is = [](vec3 p) { return p; };
      result_.rotation = landmark_rotation(as_it_is, as_it_is);
      start_ = turned(result_.rotation);
      if(settings_.position_weight > 0)
        space_ = best_motion_in_space().space;
      return;
    }
    loop_.advance(0);
    const Shape_alignment motion = best_motion_in_space();
    space_ = motion.space;
    loop_.advance(0);
    const double scale = settings_.coarsest_scale;
    const std::vector<Proposal> proposed = proposals(motion.sphere, a_.harmonics(correlated(a_.features(scale))),
                                                     b_.harmonics(correlated(b_.features(scale))));
    const Registration_features features = weighted(scale);
    const double all = settings_.motion == Registration::Motion::DEFORMATION ? share_to_align : 1;
    double least = std::numeric_limits<double>::infinity();
    for(std::size_t k = 0; k < proposed.size() && (k == 0 || !loop_.monitor().is_interrupted()); ++k) {
      const Host_array<vec3> start = turned(proposed[k].rotation);
      Host_array<vec3> x = start;
      loop_.monitor().begin_stage(all * k / proposed.size(), all * (k + 1) / proposed.size());
      const double energy =
        refined(a_.surface, features, {settings_.landmark_weight, 0, settings_.iterations, settings_.accuracy}, x)
          .energy;
      if(energy < least || k == 0) { // the first one also where all of them are infinite
        least = (std::min)(least, energy);
        start_ = start;
        result_.start = proposed[k].name;
        result_.rotation = proposed[k].rotation;
      }
    }
  }

  /// Both maps centred by the areas of the surfaces, and the rotation between them for which coordinates and features
  /// are correlated best.
  void align_centred()
  {
    const Centring centring_a = a_.centring(), centring_b = b_.centring();
    if(has_landmarks())
      result_.rotation = landmark_rotation(centring_a, centring_b);
    else {
      result_.start = "features";
      const double scale = settings_.coarsest_scale;
      result_.rotation = best_correlations(loop_, b_.harmonics(correlated(b_.features(scale, centring_b)), &centring_b),
                                           a_.harmonics(correlated(a_.features(scale, centring_a)), &centring_a))
                           .front()
                           .rotation;
    }
    for(vec3& p : start_)
      p = centring_b.inverse(unit(rotated(result_.rotation, centring_a(p))));
  }

  /// Of the features of a level.
  double scale_of(int level) const { return std::ldexp(settings_.coarsest_scale, -level); }

  /// The root of the weight of feature k.
  double factor(std::size_t k) const
  {
    constexpr std::size_t of_shape = 3; // stretch and curvatures
    return std::sqrt(k == 0         ? settings_.stretch_weight
                     : k < of_shape ? settings_.curvature_weight
                                    : settings_.features[k - of_shape].weight);
  }

  /// What rotations are found by: all features of the shape alike; with features of the caller, all with their weights.
  std::vector<Host_array<double>> correlated(std::vector<Host_array<double>> features) const
  {
    for(std::size_t k = 0; k < features.size() && !settings_.features.empty(); ++k)
      for(double& x : features[k])
        x *= factor(k);
    return features;
  }

  /// All features, times the roots of their weights.
  Registration_features weighted(double scale)
  {
    const std::vector<Host_array<double>>&a = a_.features(scale), &b = b_.features(scale);
    Registration_features result;
    for(std::size_t k = 0; k < a.size(); ++k)
      if(factor(k) > 0)
        append(result, a[k], b[k], factor(k));
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

  void deform(Host_array<vec3>& x)
  {
    const int first_level = deformed_.empty() ? 0 : settings_.levels - 1; // what is far off has been moved already
    const Registered_surface from = {a_.surface, a_.surface.point, x};
    Refinement refinement = {settings_.landmark_weight, 0, settings_.iterations, settings_.accuracy};
    Registration_features features;
    if(first_level > 0)
      refinement.isometry_weight = settings_.isometry_weight;
    for(int level = first_level;
        level < settings_.levels && (level == first_level || !loop_.monitor().is_interrupted()); ++level) {
      const double share = (1 - share_to_align) / settings_.levels;
      loop_.monitor().begin_stage(share_to_align + level * share, share_to_align + (level + 1) * share);
      shape_ = features = weighted(scale_of(level));
      if(settings_.position_weight > 0) {
        const auto a = a_.coordinates(space_), b = b_.coordinates();
        for(int k = 0; k < 3; ++k)
          append(features, a[k], b[k], std::sqrt(settings_.position_weight));
      }
      const Refinement_report report = refined(from, features, refinement, x);
      result_.iterations += static_cast<std::size_t>(report.iterations);
      if(!std::isfinite(report.energy_before))
        throw Input_error(
          Error_code::NOT_BIJECTIVE,
          "after its rotation the smallest faces of the first map are flipped by rounding; use a map with larger "
          "faces, such as one by Isometric");
      refinement.isometry_weight = settings_.isometry_weight; // what is far off must not be in its way
    }
    is_deformed_ = true;
    if(landmarks_.empty()) {
      if(!gains(look_at(features, start_), look_at(features, x)))
        x = start_;
      return;
    }
    if(put_in_place(loop_.bare(), a_.surface.face, landmarks_, loop_.monitor(), x))
      result_.iterations +=
        static_cast<std::size_t>(refined({a_.surface, a_.surface.point, x}, features, refinement, x).iterations);
  }

  /// Whether a deformation has made the shapes more alike. Where they are the same already, the chords of coarse faces
  /// still have a little to gain by it. What eigenfunctions have found stands in all other cases: between bodies of
  /// other proportions it may well stretch more than a rotation that puts limbs nowhere.
  bool gains(const Refinement_report& before, const Refinement_report& after) const
  {
    constexpr double same = 5; // stretching; 4: none
    if(!deformed_.empty() && before.stretching > same)
      return true;
    const auto difference = [this](const Refinement_report& report) {
      return report.mismatch + (settings_.isometry_weight > 0 ? settings_.isometry_weight * report.stretching : 0);
    };
    return !(difference(before) <= difference(after)) || !std::isfinite(difference(before));
  }

  /// \param from  A, with the map whose deformation is held small
  Refinement_report refined(const Registered_surface& from, const Registration_features& features,
                            const Refinement& refinement, Host_array<vec3>& x)
  {
    return refine(loop_.bare(), from, b_.surface, features, landmarks_, refinement, loop_.monitor(), x);
  }

  /// What is there without a step.
  Refinement_report look_at(const Registration_features& features, Host_array<vec3> x)
  {
    return refined(a_.surface, features, {0, 1, 0, 0}, x);
  }

  const Watched_loop<Host_loop>& loop_;
  Registered_side<> a_, b_;
  const std::vector<std::pair<int, int>>& landmark_vertices_;
  const Registration& settings_;
  Registration_result& result_;
  std::vector<Registration_landmark> landmarks_;
  Rotation space_ = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Host_array<vec3> start_;      ///< the images of A before they are deformed
  Host_array<vec3> deformed_;   ///< the images to begin with instead, if there are
  bool is_deformed_ = false;    ///< or at least that was tried
  Registration_features shape_; ///< of the finest level that was reached, without positions
};

CGAL_SP_CORE void check_registration(const Registration& settings)
{
  std::vector<double> weights = {settings.curvature_weight, settings.stretch_weight, settings.position_weight,
                                 settings.landmark_weight, settings.isometry_weight};
  for(const Registration_feature& feature : settings.features)
    weights.push_back(feature.weight);
  CGAL_SP_PRECONDITION(std::all_of(weights.begin(), weights.end(), [](double w) { return w >= 0 && std::isfinite(w); }),
                       "the weights of a registration must not be negative or infinite");
  CGAL_SP_PRECONDITION(settings.levels >= 1, "a registration has a level or more");
  CGAL_SP_PRECONDITION(settings.iterations >= 0, "the number of iterations must not be negative");
  CGAL_SP_PRECONDITION(settings.coarsest_scale > 0 && settings.accuracy > 0, "scale and accuracy have to be positive");
}

CGAL_SP_CORE Registered_surface registered_surface(const Host_loop& loop, const Valid_map& map)
{
  Registered_surface surface;
  static_cast<Corner_table&>(surface) = map.copy_of_corner_table(loop);
  for(const vec3& p : map.image)
    surface.image.push_back(unit(p));
  if(!certify(loop, surface.face, surface.image).is_valid())
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
    throw Input_error(Error_code::DEGENERATE_FACE, "the area of the surface is " + to_string(area));
  const double factor = std::sqrt(4 * pi / area);
  for(const vec3& p : map.point)
    surface.point.push_back(scale(factor, add_scaled(p, -1 / area, centre)));
  return surface;
}

/// The features of one side, in an order. Throws the precondition for those that have not a value for each vertex, and
/// Error for what is no finite number.
inline std::vector<Host_array<double>> features_of(const Registration& settings,
                                                   const std::vector<double> Registration_feature::*side,
                                                   const Order_on_sphere& order)
{
  std::vector<Host_array<double>> result;
  for(const Registration_feature& feature : settings.features) {
    const std::vector<double>& values = feature.*side;
    CGAL_SP_PRECONDITION(values.size() == order.size(), "a feature has a value for every vertex of both meshes");
    for(std::size_t i = 0; i < values.size(); ++i)
      if(!std::isfinite(values[i]))
        throw Input_error(Error_code::NON_FINITE_COORDINATE, "feature " + std::to_string(result.size()) + " of the " +
                                                               (side == &Registration_feature::a ? "first" : "second") +
                                                               " mesh is not finite at vertex " + std::to_string(i));
    result.push_back(order.ordered(values));
  }
  return result;
}

CGAL_SP_CORE Registration_result register_surfaces(const Host_loop& loop, const Valid_map& map_a,
                                                   const Valid_map& map_b,
                                                   const std::vector<std::pair<int, int>>& landmarks,
                                                   const Registration& settings, Monitor& monitor, const Store& store)
{
  const Order_on_sphere order_a(loop, map_a.image), order_b(loop, map_b.image);
  std::vector<std::pair<int, int>> pairs;
  for(const auto& [i, j] : landmarks)
    pairs.emplace_back(order_a(i), order_b(j));
  const Valid_map ordered_a = order_a.ordered(loop, map_a), ordered_b = order_b.ordered(loop, map_b);
  const Registered_surface a = registered_surface(loop, ordered_a), b = registered_surface(loop, ordered_b);
  const Locator locator_a(loop, ordered_a), locator_b(loop, ordered_b);
  const Watched_loop<Host_loop> watched(loop, monitor);
  Registration_result result;
  Registrar<> registrar(watched, {watched, a, locator_a, features_of(settings, &Registration_feature::a, order_a)},
                        {watched, b, locator_b, features_of(settings, &Registration_feature::b, order_b)}, pairs,
                        settings, result);
  const Host_array<vec3> stored = order_a.ordered(store(order_a.by_number(registrar.run())));
  const Certificate certificate = certify(loop, a.face, stored);
  result.flipped_faces = certificate.flipped_faces;
  result.degree = certificate.degree;
  if(!certificate.is_valid()) {
    result.error = Error_code::NOT_BIJECTIVE;
    result.detail = counted(certificate.flipped_faces, "flipped face", "flipped faces") + ", degree " +
                    std::to_string(certificate.degree) +
                    ", since rounding flips the smallest faces of the registered map; use a map with larger faces, "
                    "such as one by Isometric";
    return result;
  }
  registrar.measure(stored);
  if(monitor.is_interrupted()) {
    result.error = Error_code::INTERRUPTED;
    result.detail = monitor.reason();
  } else
    monitor.finish();
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_REGISTER_SURFACES_IMPL_H
