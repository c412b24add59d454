// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "preparation/mend.h"
#include "preparation/points.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL::Spherical_parameterization::preparation {
namespace {

/// The part of the surface that has been glued, a sphere with holes; its boundary as lists of sides, and the number of
/// the cycle of each.
class Growing_part {
public:
  explicit Growing_part(const Glued_surface& surface)
    : surface_(surface), is_added_(surface.faces.size(), false), is_open_(surface.twin.size(), false),
      next_(surface.twin.size()), previous_(surface.twin.size()), cycle_(surface.twin.size())
  {
    is_added_[0] = true;
    for(const int side : {0, 1, 2}) {
      connect(side, Glued_surface::next(side));
      open(side, cycles_);
    }
    ++cycles_;
    for(std::size_t i = 0; i < queue_.size(); ++i)
      if(is_open_[place(queue_[i])])
        continue_at(queue_[i]);
  }

  /// One side of each edge whose sides have not been glued.
  std::vector<int> open_edges() const
  {
    std::vector<int> result;
    for(const int side : queue_)
      if(is_open_[place(side)] && surface_.twin_of(side) > side)
        result.push_back(side);
    return result;
  }

private:
  void connect(int side, int next)
  {
    next_[place(side)] = next;
    previous_[place(next)] = side;
  }

  void open(int side, int cycle)
  {
    is_open_[place(side)] = true;
    cycle_[place(side)] = cycle;
    queue_.push_back(side);
  }

  void continue_at(int side)
  {
    const int twin = surface_.twin_of(side);
    if(!is_added_[place(twin / 3)])
      add_face(side, twin);
    else if(cycle_[place(side)] == cycle_[place(twin)])
      glue(side, twin);
  }

  /// Two sides of the face take the place of `side`.
  void add_face(int side, int twin)
  {
    is_added_[place(twin / 3)] = true;
    is_open_[place(side)] = false;
    const int first = Glued_surface::next(twin), second = Glued_surface::next(first);
    connect(previous_[place(side)], first);
    connect(second, next_[place(side)]);
    connect(first, second);
    open(first, cycle_[place(side)]);
    open(second, cycle_[place(side)]);
  }

  /// What was between the two sides is a cycle each; the shorter gets a new number.
  void glue(int side, int twin)
  {
    is_open_[place(side)] = is_open_[place(twin)] = false;
    const int after_side = next_[place(side)], after_twin = next_[place(twin)];
    if(after_side == twin || after_twin == side) {
      connect(previous_[place(after_side == twin ? side : twin)], next_[place(after_side == twin ? twin : side)]);
      return;
    }
    connect(previous_[place(twin)], after_side);
    connect(previous_[place(side)], after_twin);
    int a = after_side, b = after_twin;
    do {
      a = next_[place(a)];
      b = next_[place(b)];
    } while(a != after_side && b != after_twin);
    const int first = a == after_side ? after_side : after_twin;
    int s = first;
    do {
      cycle_[place(s)] = cycles_;
      s = next_[place(s)];
    } while(s != first);
    ++cycles_;
  }

  const Glued_surface& surface_;
  std::vector<bool> is_added_; ///< by face
  std::vector<bool> is_open_;  ///< by side: at the boundary of the part
  std::vector<int> next_, previous_, cycle_;
  std::vector<int> queue_; ///< sides that were opened, in that order
  int cycles_ = 0;
};

} // namespace

void cut_handles_at_once(Glued_surface& surface, const std::function<void()>& go_on)
{
  for(const int side : Growing_part(surface).open_edges())
    surface.unglue(side);
  go_on();
  derive_vertices(surface);
  for(const std::vector<int>& boundary : boundary_cycles(surface)) {
    go_on();
    fill_hole(surface, boundary);
  }
  derive_vertices(surface);
}

} // namespace CGAL::Spherical_parameterization::preparation
