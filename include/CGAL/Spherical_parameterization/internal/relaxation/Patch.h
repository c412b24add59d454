// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_PATCH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_PATCH_H

#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/predicates/orientation.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/Face_hessian.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/Sparse_cholesky.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <variant>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// An energy that is finite for flipped faces, and drives them to become positive: V. Garanzha, I. Kaporin, L.
/// Kudryavtseva, F. Protais, N. Ray, D. Sokolov, "Foldover-free maps in 50 lines of code", ACM Trans. Graph. 40 (2021).
/// Of a face with principal stretches s, t and J = s t, per area,
///   (s^2 + t^2 + 2 a (1 + J^2)) / chi(J),  chi(J) = (J + sqrt(e^2 + J^2)) / 2.
/// Without the share `a` of the areas it would be MIPS for e = 0, and lead faces to shrink to points for e > 0.
class Untangling_energy {
public:
  explicit Untangling_energy(double regularization) : e2_(regularization * regularization) {}

  /// 1 / chi and its derivatives
  Distortion::Psi psi(double ratio) const
  {
    const double root = std::sqrt(e2_ + ratio * ratio);
    const double chi = ratio > 0 ? (ratio + root) / 2 : e2_ / 2 / (root - ratio);
    const double first = chi / root, second = e2_ / (2 * root * root * root); // derivatives of chi
    const double value = 1 / chi;
    return {value, -first * value * value, (2 * first * first * value - second) * value * value};
  }

  /// The share of the areas and its derivatives. \param psi  of the same ratio
  Distortion::Psi phi(double ratio, const Distortion::Psi& psi) const
  {
    constexpr double share_of_areas = 0.05;
    const auto [value, first, second] = psi;
    const double areas = 2 * share_of_areas * (1 + ratio * ratio);
    const double slope = 4 * share_of_areas * ratio, bend = 4 * share_of_areas;
    return {areas * value, slope * value + areas * first, bend * value + 2 * slope * first + areas * second};
  }

private:
  double e2_;
};

/// What a patch minimizes. It is one type, so that Newton's method is compiled once.
struct Patch_energy : std::variant<Distortion, Untangling_energy> {
  using variant::variant;

  /// Whether flipped faces make it infinite
  bool needs_positive_faces() const { return index() == 0; }

  Distortion::Psi psi(double ratio) const
  {
    const auto* const distortion = std::get_if<Distortion>(this);
    return distortion ? distortion->psi(ratio) : std::get_if<Untangling_energy>(this)->psi(ratio);
  }
  Distortion::Psi phi(double ratio, const Distortion::Psi& psi) const
  {
    const auto* const distortion = std::get_if<Distortion>(this);
    return distortion ? distortion->phi(ratio, psi) : std::get_if<Untangling_energy>(this)->phi(ratio, psi);
  }
};

/// A connected set of vertices, and all faces that have one of them as a corner: Newton's method for an energy of the
/// faces, in which these vertices move and no others do. The linear systems are solved by a Cholesky factorization.
class Patch {
public:
  struct Face {
    std::array<int, 3> corner; ///< vertices of the mesh
    std::array<int, 3> moving; ///< their places in the patch, or -1 for those that do not move
    Face_metric metric;        ///< what it is in the source
    double twice_area;         ///< ... and how large it shall be thought of
    double weight = 1;         ///< of its energy
  };

  /// What lasts from one time that the patch is worked on to the next. There may be very many of them.
  struct Part {
    std::vector<int> vertices; ///< of the mesh, by their places in the patch
    std::vector<Face> faces;
    int attempt = 3;        ///< with which the next step begins; the first one is far from a minimum
    std::int64_t moves = 0; ///< of single vertices, in all steps
  };

  /// What a step has done
  struct Step {
    double energy; ///< before
    double gain;   ///< of energy
    bool is_taken; ///< if not, there is none
    /// The longest step of a vertex, in the norm in which its faces' energy is 1: what is left to go after a Newton
    /// step is of the order of its square.
    double length;
    double length_on_sphere; ///< the longest step of a vertex as an angle
  };

  /// \param part  outlives the patch
  /// \param v     all positions of the mesh; those of the patch are changed
  Patch(Part& part, Host_array<vec3>& v)
    : vertex_(part.vertices), face_(part.faces), v_(v), matrix_(neighbours()), tangents_(size()), diagonal_(size()),
      gradient_(size()), around_(size()), attempt_(part.attempt), moves_(part.moves)
  {
    for(const Face& f : face_)
      for(int m = 0; m < 3; ++m)
        for(int n = 0; n <= m; ++n)
          if(f.moving[m] >= 0 && f.moving[n] >= 0)
            place_.push_back(matrix_.place(f.moving[m], f.moving[n]));
    for(const Sparse_cholesky::Place& place : place_)
      at_.push_back(place.at);
    std::sort(at_.begin(), at_.end());
    at_.erase(std::unique(at_.begin(), at_.end()), at_.end());
    for(Sparse_cholesky::Place& place : place_)
      place.at = static_cast<int>(std::lower_bound(at_.begin(), at_.end(), place.at) - at_.begin());
    hessian_.resize(at_.size());
    lift_.resize(at_.size());
  }

  int size() const { return static_cast<int>(vertex_.size()); }
  std::vector<Face>& faces() { return face_; }
  vec3 position(int i) const { return v_[i]; } ///< of any vertex of the mesh

  std::vector<vec3> positions() const
  {
    std::vector<vec3> result;
    for(int i : vertex_)
      result.push_back(v_[i]);
    return result;
  }

  void set_positions(const std::vector<vec3>& positions)
  {
    for(int i = 0; i < size(); ++i)
      v_[vertex_[i]] = positions[i];
  }

  bool is_positive(const Face& f) const
  {
    return is_positively_oriented(v_[f.corner[0]], v_[f.corner[1]], v_[f.corner[2]]);
  }

  /// By the exact predicate
  bool has_positive_faces() const
  {
    return std::all_of(face_.begin(), face_.end(), [&](const Face& f) { return is_positive(f); });
  }
  std::ptrdiff_t number_of_flipped_faces() const
  {
    return std::count_if(face_.begin(), face_.end(), [&](const Face& f) { return !is_positive(f); });
  }

  /// The face as it is seen from its first corner.
  Star_face star_face(const Face& f) const
  {
    Star_face result(v_[f.corner[1]], v_[f.corner[2]], f.metric, 1);
    result.twice_area = f.twice_area;
    return result;
  }

  /// One step of Newton's method, taken only if the energy falls (Armijo) or the rounding of its sum hides whether it
  /// does, and faces that have to be positive stay it.
  /// \param damping  share of the diagonal that is added to Newton's matrix, at least
  Step step(const Patch_energy& energy, double damping)
  {
    constexpr double longest_step = 0.5; // as an angle
    moves_ += size();
    for(int i = 0; i < size(); ++i)
      tangents_[i] = tangents_at(v_[vertex_[i]]);
    Step result = {0, 0, false, 0, 0};
    const int first_attempt = attempt_;
    for(bool has_lift = false; attempt_ < number_of_attempts; ++attempt_) {
      const double lift = lifts[attempt_];
      if(attempt_ == first_attempt || (lift > 0 && !has_lift)) {
        has_lift = lift > 0;
        result.energy = assemble(energy, has_lift);
      }
      set_matrix(lift, (std::max)(damping, dampings[attempt_]));
      if(matrix_.factorize())
        break;
    }
    if(attempt_ == number_of_attempts) {
      attempt_ = first_attempt;
      return result;
    }
    if(attempt_ == first_attempt) // the next step may do with less
      attempt_ = (std::max)(0, attempt_ - 1);
    std::vector<Planar> slopes(size()); // along the tangents, downwards
    for(int i = 0; i < size(); ++i)
      slopes[i] = scaled(-1, tangents_[i].products(gradient_[i]));
    const std::vector<Planar> x = matrix_.solve(slopes);
    double slope = 0;
    double& longest = result.length_on_sphere;
    std::vector<vec3> direction(size());
    for(int i = 0; i < size(); ++i) {
      const Block& d = diagonal_[i];
      slope -= inner(slopes[i], x[i]);
      const double square = d.ss * x[i].s * x[i].s + 2 * d.st * x[i].s * x[i].t + d.tt * x[i].t * x[i].t;
      result.length = (std::max)(result.length, std::sqrt(square / around_[i]));
      direction[i] = tangents_[i].combined(x[i]);
      longest = (std::max)(longest, norm(direction[i]));
    }
    if(!(slope < 0))
      return result;
    double t = longest > longest_step ? longest_step / longest : 1;
    if(energy.needs_positive_faces())
      t = feasible_step(direction, t);
    search(energy, direction, t, slope, result);
    return result;
  }

private:
  // Newton's matrix; where that is indefinite, some of what makes it positive face by face, twice that, or even more
  static constexpr int number_of_attempts = 9;
  static constexpr double lifts[number_of_attempts] = {0, 0.01, 0.1, 0.5, 1, 2, 2, 2, 2};
  static constexpr double dampings[number_of_attempts] = {0, 0, 0, 0, 0, 0, 1e-3, 0.1, 10};

  std::vector<std::vector<int>> neighbours() const
  {
    std::vector<std::vector<int>> result(size());
    for(const Face& f : face_)
      for(int m = 0; m < 3; ++m) // the face on the other side of the edge has it the other way round
        if(const int i = f.moving[m], j = f.moving[(m + 1) % 3]; i >= 0 && j >= 0)
          result[i].push_back(j);
    return result;
  }

  /// The gradient, the second derivatives, and what lifts their negative eigenvalues. Returns the energy.
  double assemble(const Patch_energy& energy, bool has_lift)
  {
    const bool is_stiff = !energy.needs_positive_faces(); // which is fast, but holds limbs that have to turn
    double sum = 0;
    auto place = place_.begin();
    std::fill(hessian_.begin(), hessian_.end(), Block{0, 0, 0, 0});
    if(has_lift)
      std::fill(lift_.begin(), lift_.end(), Block{0, 0, 0, 0});
    std::fill(gradient_.begin(), gradient_.end(), vec3{0, 0, 0});
    std::fill(around_.begin(), around_.end(), 0);
    for(const Face& f : face_) {
      const Star_face star_face = this->star_face(f);
      const vec3 x = v_[f.corner[0]];
      const Face_hessian hessian(energy, x, star_face, has_lift && !is_stiff);
      const double value = f.weight * hessian.value();
      sum += value;
      std::array<Face_hessian::Frame, 3> frame;
      for(int m = 0; m < 3; ++m)
        if(const int i = f.moving[m]; i >= 0) {
          frame[m] = hessian.frame(m, tangents_[i]);
          gradient_[i] = add_scaled(gradient_[i], f.weight, hessian.gradient(m));
          around_[i] += value;
          for(int n = 0; n <= m; ++n)
            if(f.moving[n] >= 0) {
              Sparse_cholesky::add(hessian_, *place, scaled(f.weight, hessian.exact_block(m, frame[m], n, frame[n])));
              if(has_lift)
                Sparse_cholesky::add(lift_, *place,
                                     scaled(f.weight, is_stiff ? hessian.stiff_lift(m, frame[m], n, frame[n])
                                                               : hessian.lift(frame[m], frame[n])));
              ++place;
            }
        }
    }
    return sum;
  }

  /// Newton's matrix. \param lift  multiple of what lifts negative eigenvalues \param damping  share of the diagonal
  void set_matrix(double lift, double damping)
  {
    matrix_.set_sum(at_, hessian_, lift, lift_);
    for(int i = 0; i < size(); ++i) {
      const Block& d = matrix_.diagonal(i);
      const double bend = damping * (std::max)(d.ss, d.tt) - inner(gradient_[i], v_[vertex_[i]]);
      matrix_.add(matrix_.place(i, i), {bend, 0, 0, bend});
      diagonal_[i] = d;
    }
  }

  double face_value(const Patch_energy& energy, const Face& f) const
  {
    const Star_face star_face = this->star_face(f);
    const vec3 x = v_[f.corner[0]];
    const double determinant = star_face.determinant(x);
    if(energy.needs_positive_faces() && !(determinant > 0))
      return std::numeric_limits<double>::infinity();
    const double ratio = determinant / f.twice_area;
    const Distortion::Psi psi = energy.psi(ratio);
    return f.weight * (star_face.dirichlet(x) * psi.value + f.twice_area / 2 * energy.phi(ratio, psi).value);
  }

  double value(const Patch_energy& energy) const
  {
    double sum = 0;
    for(const Face& f : face_)
      sum += face_value(energy, f);
    return sum;
  }

  /// The longest step up to t with which no face shrinks to less than a hundredth at once.
  double feasible_step(const std::vector<vec3>& direction, double t) const
  {
    constexpr double least_share = 0.01, shrink = 0.9, smallest_step = 1e-10;
    for(const Face& f : face_) {
      const auto after = [&](double s) {
        vec3 x[3];
        for(int k = 0; k < 3; ++k) {
          x[k] = v_[f.corner[k]];
          if(f.moving[k] >= 0)
            x[k] = add_scaled(x[k], s, direction[f.moving[k]]);
        }
        return determinant(x[0], x[1], x[2]);
      };
      const double least = least_share * after(0);
      while(t > smallest_step && !(after(t) > least))
        t *= shrink;
    }
    return t;
  }

  void search(const Patch_energy& energy, const std::vector<vec3>& direction, double t, double slope, Step& step)
  {
    constexpr double armijo = 1e-4, rounding = 1e-10; // of the energy; a Newton step that gains less is in no doubt
    constexpr double farthest = 2, worth_a_trial = 1.3;
    constexpr int maximum_halvings = 30;
    const std::vector<vec3> start = positions();
    const auto gain_at = [&](double s) {
      for(int i = 0; i < size(); ++i)
        v_[vertex_[i]] = unit(add_scaled(start[i], s, direction[i]));
      return step.energy - value(energy);
    };
    const auto may_be_taken = [&] { return !energy.needs_positive_faces() || has_positive_faces(); };
    for(int halving = 0; halving < maximum_halvings; ++halving, t /= 2) {
      step.gain = gain_at(t);
      step.is_taken = (step.gain >= -armijo * t * slope || -slope < rounding * step.energy) && may_be_taken();
      if(step.is_taken)
        break;
    }
    if(!step.is_taken) {
      set_positions(start);
      step.gain = 0;
      return;
    }
    // A lifted matrix is stiffer than the energy. The minimum of the parabola that has the same slope and gain:
    const double bend = -slope - step.gain;
    const double longer = bend > -slope / (2 * farthest) ? -slope / (2 * bend) : farthest;
    if(t == 1 && longer > worth_a_trial) {
      const std::vector<vec3> here = positions();
      const double gain = gain_at(longer);
      if(gain > step.gain && may_be_taken())
        step.gain = gain;
      else
        set_positions(here);
    }
  }

  const std::vector<int>& vertex_;
  std::vector<Face>& face_;
  Host_array<vec3>& v_;
  Sparse_cholesky matrix_;
  std::vector<int> at_;                       ///< where the matrix has blocks before the elimination
  std::vector<Sparse_cholesky::Place> place_; ///< in these, of the blocks of the faces, as they are added
  std::vector<Tangents> tangents_;
  std::vector<Block> diagonal_; ///< of the matrix
  Sparse_cholesky::Blocks hessian_, lift_;
  std::vector<vec3> gradient_;
  std::vector<double> around_; ///< the energy of the faces at a vertex
  int& attempt_;
  std::int64_t& moves_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_PATCH_H
