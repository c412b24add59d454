// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_NEWTON_RELAXATION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_NEWTON_RELAXATION_H

#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/isometric/Map_level.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/Face_hessian.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Spherical_parameterization::internal {

/// Newton's method for all vertices of a level at once. The linear systems are solved by conjugate gradients,
/// preconditioned by symmetric Gauss-Seidel in the order of the colours.
///
/// Half of what makes the Hessians of the faces positive is added to them. With all of it, the sum is far too stiff
/// where a surface is compressed, as in limbs, and they creep to their places; with none, it is often indefinite. Where
/// conjugate gradients find that it is, the same step is tried again with all.
///
/// Every vertex gets tangents in which its diagonal block is the identity. The matrix is then I + L + L^T, and S. C.
/// Eisenstat's trick ("Efficient implementation of a class of preconditioned conjugate gradient methods", 1981) gives
/// the preconditioned product for one pass over the matrix: q = t + (I + L)^-1 (p - t) with t = (I + L^T)^-1 p.
/// Single precision is enough for the blocks, since they only give a direction.
///
/// Anchors pull with their energy; vertices that are pinned have rows and columns of the identity.
template <class...>
class Newton_relaxation {
public:
  Newton_relaxation(const Watched_loop<Host_loop>& loop, const Distortion& distortion, Map_level<>& level)
    : loop_(loop), distortion_(distortion), level_(level), tangents_(level.size()), factor_(level.size()),
      gradient_(level.size()), middle_(level.size()), entry_(level.offset(level.size()))
  {}

  /// One step, taken only if the energy falls and the map stays bijective. Returns the share of the energy it took off.
  double step(int maximum_iterations, double tolerance)
  {
    return search(newton_direction(maximum_iterations, tolerance));
  }

  /// The same where the matrix itself may be positive: it is tried first, if the last step went well. Then the steps
  /// converge quadratically.
  double step_near_minimum(int maximum_iterations, double tolerance)
  {
    constexpr double near = 1e-2;
    const double least_lift = step_length_ >= 1 && promised_gain_ < near ? 0 : half_lift;
    return search(newton_direction(maximum_iterations, tolerance, least_lift));
  }

  /// What `promised_gain()` of the next step would be. It is not taken.
  double gain_ahead(int maximum_iterations, double tolerance)
  {
    newton_direction(maximum_iterations, tolerance);
    return promise(level_.objective(distortion_));
  }

  /// The same by the matrix of the last step, which has changed little near a minimum, at half the cost: unless it
  /// turns out to be indefinite. \pre there was a step, and no vertex has an anchor
  double gain_ahead_by_last_matrix(int maximum_iterations, double tolerance)
  {
    update_gradient();
    solve(maximum_iterations, tolerance);
    if(is_indefinite_)
      return gain_ahead(maximum_iterations, tolerance);
    return promise(level_.objective(distortion_));
  }

  /// The share of the energy that the last step would have taken off, had the energy been its parabola. A step that is
  /// cut short by a few faces that are about to flip gains less than there is to gain.
  double promised_gain() const { return promised_gain_; }

  /// The share of the Newton step that was taken, at most 1 before it was found that more is better; 0: none.
  double step_length() const { return step_length_; }

private:
  static constexpr double half_lift = 0.5; ///< of what makes the Hessians of the faces positive

  /// Positions that are tried: unless they are accepted, and so where the work is interrupted, the old ones come back.
  class Trial {
  public:
    explicit Trial(Host_array<vec3>& position) : position_(position), start_(position) {}
    ~Trial()
    {
      if(!is_accepted_)
        position_.swap(start_);
    }
    Trial(const Trial&) = delete;
    Trial& operator=(const Trial&) = delete;

    const Host_array<vec3>& start() const { return start_; }
    void accept() { is_accepted_ = true; }

  private:
    Host_array<vec3>& position_;
    Host_array<vec3> start_;
    bool is_accepted_ = false;
  };

  struct Entry {
    int column;
    float ss, st, ts, tt;
  };

  /// The blocks of a face, in orthonormal tangents, and what its gradients are made of
  struct Face_blocks {
    Face_gradient gradient;
    std::array<std::array<float, 3>, 3> diagonal; ///< ss, st, tt
    std::array<std::array<float, 4>, 3> side;     ///< of the corners m and m + 1
  };

  /// The blocks of the faces first, then the rows that they add up to.
  void assemble(double lift)
  {
    Host_array<Face_blocks> blocks(level_.number_of_faces());
    level_.for_each_vertex([&](int i) {
      for(int c = level_.offset(i); c < level_.offset(i + 1); ++c)
        if(const Map_level<>::Corner& corner = level_.corner(c); corner.number == 0)
          blocks[corner.face] = blocks_of_face(i, corner, lift);
    });
    level_.for_each_vertex([&](int i) { assemble_row(i, blocks); });
  }

  Face_blocks blocks_of_face(int i, const Map_level<>::Corner& corner, double lift) const
  {
    const vec3 x = level_.position()[i];
    const Star_face face = level_.star_face(corner);
    const Face_hessian hessian(distortion_, x, face, lift);
    const Face_hessian::Frame frame[3] = {hessian.frame(0, tangents_at(x)), hessian.frame(1, tangents_at(face.j)),
                                          hessian.frame(2, tangents_at(face.k))};
    Face_blocks result;
    result.gradient = hessian.gradient();
    for(int m = 0; m < 3; ++m) {
      const int n = m < 2 ? m + 1 : 0;
      const Block d = hessian.block(m, frame[m], m, frame[m]), s = hessian.block(m, frame[m], n, frame[n]);
      result.diagonal[m] = {float(d.ss), float(d.st), float(d.tt)};
      result.side[m] = {float(s.ss), float(s.st), float(s.ts), float(s.tt)};
    }
    return result;
  }

  /// Gradient and blocks of row i, those left of the diagonal first.
  void assemble_row(int i, const Host_array<Face_blocks>& blocks)
  {
    const vec3 x = level_.position()[i];
    const Tangents tangents = tangents_at(x);
    const int begin = level_.offset(i), end = level_.offset(i + 1);
    const bool is_pinned = level_.is_pinned(i);
    boost::container::small_vector<Block, 12> block(end - begin, Block{0, 0, 0, 0});
    Block diagonal = {0, 0, 0, 0};
    vec3 gradient = {0, 0, 0};
    for(int c = begin; c < end; ++c) {
      const Map_level<>::Corner& corner = level_.corner(c);
      const Face_blocks& of_face = blocks[corner.face];
      gradient = add(gradient, of_face.gradient.at(x, level_.star_face(corner)));
      const int m = corner.number;
      const auto& d = of_face.diagonal[m];
      const auto &to_j = of_face.side[m], &from_k = of_face.side[m > 0 ? m - 1 : 2];
      Block &at_j = block[c - begin], &at_k = block[c + 1 == end ? 0 : c + 1 - begin];
      diagonal = sum(diagonal, {d[0], d[1], d[1], d[2]});
      at_j = sum(at_j, {to_j[0], to_j[1], to_j[2], to_j[3]});
      at_k = sum(at_k, {from_k[0], from_k[2], from_k[1], from_k[3]});
    }
    int lower = begin, upper = end;
    for(int c = begin; c < end; ++c) {
      const Block& b = block[c - begin];
      const int j = level_.corner(c).j;
      Entry& entry = entry_[j < i ? lower++ : --upper];
      if(is_pinned || level_.is_pinned(j))
        entry = {j, 0, 0, 0, 0};
      else
        entry = {j, float(b.ss), float(b.st), float(b.ts), float(b.tt)};
    }
    middle_[i] = lower;
    if(is_pinned) {
      factor_[i] = {1, 0, 0, 1};
      tangents_[i] = tangents;
      gradient_[i] = {0, 0};
      return;
    }

    // The sphere bends away from the tangent plane, or towards the other side: not more than leaves the block positive.
    constexpr double least_share = 0.01;
    double radial = -inner(gradient, x);
    if(const Anchor* const anchor = level_.anchor(i)) {
      constexpr double least_cosine = 0.1; // the pull is concave beyond a right angle
      gradient = add_scaled(gradient, -anchor->stiffness, anchor->place);
      radial += anchor->stiffness * (std::max)(least_cosine, inner(x, anchor->place));
    }
    const double mean = (diagonal.ss + diagonal.tt) / 2, half = (diagonal.ss - diagonal.tt) / 2;
    const double smallest = mean - std::hypot(half, diagonal.st); // whose squares may overflow
    const double bend = (std::max)(radial, 2 * least_share * std::abs(mean) - smallest);
    const double a = std::sqrt(diagonal.ss + bend), b = diagonal.ts / a;
    const double c = std::sqrt((std::max)(diagonal.tt + bend - b * b, least_share * least_share * a * a));
    factor_[i] = {1 / a, 0, -b / (a * c), 1 / c};
    tangents_[i] = {tangents.combined({factor_[i].ss, factor_[i].st}),
                    tangents.combined({factor_[i].ts, factor_[i].tt})};
    gradient_[i] = tangents_[i].products(gradient);
  }

  /// That of the current positions, in the tangents of the matrix.
  void update_gradient()
  {
    level_.for_each_vertex([&](int i) {
      const vec3 x = level_.position()[i];
      vec3 gradient = {0, 0, 0};
      for(int c = level_.offset(i); c < level_.offset(i + 1); ++c)
        gradient = add(gradient, Face_hessian(distortion_, x, level_.star_face(level_.corner(c)), 0).gradient(0));
      // the tangents are those of another position: what points along x is no slope
      gradient_[i] = tangents_[i].products(add_scaled(gradient, -inner(gradient, x), x));
    });
  }

  void normalise_row(int i)
  {
    for(int k = level_.offset(i); k < level_.offset(i + 1); ++k) {
      Entry& e = entry_[k];
      const Block b = product(factor_[i], product(Block{e.ss, e.st, e.ts, e.tt}, transposed(factor_[e.column])));
      e = {e.column, float(b.ss), float(b.st), float(b.ts), float(b.tt)};
    }
  }

  /// x_i -= sum over the entries B_ij y_j
  Planar reduced(Planar x, int begin, int end, const Host_array<Planar>& y) const
  {
    for(int k = begin; k < end; ++k) {
      const Entry& e = entry_[k];
      const Planar z = y[e.column];
      x.s -= e.ss * z.s + e.st * z.t;
      x.t -= e.ts * z.s + e.tt * z.t;
    }
    return x;
  }

  /// y_i = x_i - (L y)_i, where y is known in smaller colours: a row of (I + L) y = x
  Planar lower_row(int i, Planar x, const Host_array<Planar>& y) const
  {
    return reduced(x, level_.offset(i), middle_[i], y);
  }

  /// y = (I + L^T)^-1 x; x(i) is called once for each i.
  template <class X>
  void solve_upper(X x, Host_array<Planar>& y) const
  {
    level_.for_each_vertex_backwards<many_steps>(
      [&](int i) { y[i] = reduced(x(i), middle_[i], level_.offset(i + 1), y); });
  }

  /// The approximate Newton direction, as far as the matrix is positive.
  Host_array<vec3> solve(int maximum_iterations, double tolerance)
  {
    const int n = level_.size();
    Host_array<Planar> x(n, Planar{0, 0}), r(n), p(n, Planar{0, 0}), t(n), w(n);
    double rr = level_.sum_over_vertices<many_steps>([&](int i) {
      r[i] = lower_row(i, {-gradient_[i].s, -gradient_[i].t}, r);
      return inner(r[i], r[i]);
    });
    const double goal = tolerance * tolerance * rr;
    double beta = 0;
    is_indefinite_ = false;
    for(int it = 0; it < maximum_iterations && rr > goal; ++it) {
      solve_upper([&](int i) { return p[i] = add_scaled(r[i], beta, p[i]); }, t);
      const double pq = level_.sum_over_vertices<many_steps>([&](int i) {
        w[i] = lower_row(i, add_scaled(p[i], -1, t[i]), w);
        return inner(p[i], add_scaled(t[i], 1, w[i]));
      });
      if(!(pq > 0)) {
        is_indefinite_ = true;
        if(it == 0)
          x = p;
        break;
      }
      const double alpha = rr / pq;
      const double next = level_.sum_over_vertices<many_steps>([&](int i) {
        x[i] = add_scaled(x[i], alpha, p[i]);
        r[i] = add_scaled(r[i], -alpha, add_scaled(t[i], 1, w[i]));
        return inner(r[i], r[i]);
      });
      beta = next / rr;
      rr = next;
    }
    solve_upper([&](int i) { return x[i]; }, t);
    Host_array<vec3> direction(n);
    level_.for_each_vertex<many_steps>([&](int i) { direction[i] = tangents_[i].combined(t[i]); });
    slope_ = level_.sum_over_vertices<many_steps>([&](int i) { return inner(gradient_[i], t[i]); }) / level_.area();
    return direction;
  }

  /// The longest step up to 1 with which no face shrinks to less than a twentieth at once.
  double feasible_step(const Host_array<vec3>& direction) const
  {
    constexpr double least_share = 0.05, shrink = 0.7;
    const auto feasible = [&](int begin, int end) {
      double t = 1;
      for(int i = begin; i < end; ++i)
        for(int c = level_.offset(i); c < level_.offset(i + 1); ++c) {
          const Map_level<>::Corner& corner = level_.corner(c);
          if(corner.number > 0)
            continue;
          const auto moved = [&](int v, double s) { return add_scaled(level_.position()[v], s, direction[v]); };
          const auto after = [&](double s) { return determinant(moved(i, s), moved(corner.j, s), moved(corner.k, s)); };
          const double least = least_share * after(0);
          while(t > 1e-6 && !(after(t) > least))
            t *= shrink;
        }
      return t;
    };
    double t = 1;
    for(double part : results_of_parts<8 * few_steps>(loop_, level_.size(), feasible))
      t = (std::min)(t, part);
    return t;
  }

  /// The direction of the next step, and the slope along it.
  Host_array<vec3> newton_direction(int maximum_iterations, double tolerance, double least_lift = half_lift)
  {
    Host_array<vec3> direction;
    for(double lift :
        {0., half_lift, 1.}) { // all blocks in orthonormal tangents first, then in those that the diagonal asks for
      if(lift < least_lift)
        continue;
      assemble(lift);
      for_each_of_level(loop_, 0, level_.size(), [&](int i) { normalise_row(i); });
      direction = solve(maximum_iterations, tolerance);
      if(!is_indefinite_)
        break;
    }
    return direction;
  }

  /// The `promised_gain()`, by Newton's model of the energy, which is `before` now.
  double promise(double before)
  {
    // NaN, from numbers out of range, promises anything
    return promised_gain_ = slope_ <= 0 ? -slope_ / 2 / before : 1;
  }

  double search(const Host_array<vec3>& direction)
  {
    constexpr double armijo = 1e-4;
    constexpr int maximum_halvings = 30;
    const double before = level_.objective(distortion_);
    step_length_ = 0;
    promise(before);
    if(!(slope_ < 0))
      return 0;
    Trial trial(level_.position());
    const auto energy_at = [&](double t) {
      level_.for_each_vertex([&](int i) {
        if(!level_.is_pinned(i))
          level_.position()[i] = unit(add_scaled(trial.start()[i], t, direction[i]));
      });
      return level_.objective(distortion_);
    };
    double t = feasible_step(direction);
    for(int halving = 0; halving < maximum_halvings; ++halving, t /= 2) {
      const double after = energy_at(t);
      if(after <= before + armijo * t * slope_ && level_.is_bijective()) {
        step_length_ = t;
        trial.accept();
        return (before - longer_step(t, before, after, energy_at)) / before;
      }
    }
    return 0;
  }

  /// Where the energy still falls nearly as fast after the step t as before, since the matrix is stiffer than the map,
  /// a longer one is tried: to the minimum of the parabola. Returns the energy where that ends.
  template <class Energy>
  double longer_step(double t, double before, double after, const Energy& energy_at)
  {
    constexpr double longest = 4, worthwhile = 1.3; // of the step t
    const double linear = slope_ * t, quadratic = after - before - linear;
    const double factor = longest * 2 * quadratic > -linear ? -linear / (2 * quadratic) : longest;
    if(factor < worthwhile)
      return after;
    Trial trial(level_.position());
    const double further = energy_at(factor * t);
    if(!(further < after && level_.is_bijective()))
      return after;
    trial.accept();
    return further;
  }

  const Watched_loop<Host_loop>& loop_;
  const Distortion& distortion_;
  Map_level<>& level_;
  Host_array<Tangents> tangents_; ///< in which the diagonal blocks are the identity
  Host_array<Block> factor_;      ///< which make them of the orthonormal ones
  Host_array<Planar> gradient_;
  Host_array<int> middle_; ///< where in row i the entries right of the diagonal begin
  Host_array<Entry> entry_;
  double slope_ = 0; ///< of the mean energy along the direction
  double promised_gain_ = 0;
  double step_length_ = 0;
  bool is_indefinite_ = false; ///< the matrix, as far as conjugate gradients saw
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_NEWTON_RELAXATION_H
