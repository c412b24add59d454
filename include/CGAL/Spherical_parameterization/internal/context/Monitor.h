// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CONTEXT_MONITOR_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CONTEXT_MONITOR_H

#include <CGAL/Spherical_parameterization/values/Result.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <limits>
#include <string>
#include <thread>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

/// Seconds since construction.
class Stopwatch {
public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Watches a computation for the user: time limit, callback, and the log on std::cerr. The solvers report after every
/// iteration, and stop where `advance()` or `may_go_on()` says no. The callback is called on the thread that has made
/// the monitor, and on no other.
class Monitor {
public:
  /// Of what nobody waits for
  Monitor() : Monitor(std::numeric_limits<double>::infinity(), {}, false) {}
  Monitor(double maximum_running_time, std::function<bool(double)> callback, bool verbose)
    : limit_(maximum_running_time), callback_(std::move(callback)), verbose_(verbose)
  {}

  /// Whether the callback may not be called for the moment: while the mesh is read, which it may change.
  void set_silent(bool is_silent) { is_silent_ = is_silent; }

  /// From here on `advance()` counts within the stage of the work from `begin` to `end`, in [0,1].
  void begin_stage(double begin, double end)
  {
    begin_ = begin;
    end_ = end;
  }

  /// `fraction` in [0,1] is how far the stage has come; it never goes back. Returns whether to go on.
  bool advance(double fraction)
  {
    if(fraction > 0) // and no NaN
      fraction_ = (std::max)(fraction_, begin_ + (std::min)(1., fraction) * (end_ - begin_));
    return may_go_on();
  }

  /// The same where nobody knows how far the stage has come. Any thread may ask.
  bool may_go_on() { return ask(0); }

  /// The same for loops, which ask every few microseconds: the callback is called every 5 ms only.
  bool may_loop_go_on() { return ask(0.005); }

  /// The same where there is nothing yet that could be handed out. Throws Error if the computation has to end.
  void advance_or_throw(double fraction = 0) { go_on_if(advance(fraction)); }

  /// All is there, whatever the callback says.
  void finish()
  {
    begin_stage(1, 1);
    advance(1);
  }

  /// Throws Error if the answer of one of the functions above was no.
  void go_on_if(bool may_go_on) const
  {
    if(!may_go_on)
      throw Input_error(Error_code::INTERRUPTED, reason());
  }

  /// Share of the way, on a logarithmic scale, that a residual has come from `first` down to `goal`.
  static double share(double residual, double first, double goal)
  {
    return first > goal && residual > 0 ? std::log(first / residual) / std::log(first / goal) : 0;
  }

  void log(const char* phase, std::size_t iteration, double residual, double energy) const
  {
    if(verbose_)
      std::cerr << phase << ' ' << iteration << ": residual " << residual << ", energy " << energy << ", "
                << watch_.seconds() << " s\n";
  }

  bool is_interrupted() const { return state_ != State::RUNNING; }

  /// Of a computation that has been interrupted.
  Termination termination() const { return state_ == State::TIME ? Termination::TIME : Termination::CALLBACK; }
  std::string reason() const
  {
    return state_ == State::TIME ? "the time limit was reached" : "stopped by the callback";
  }
  std::string reason_without_map() const { return reason() + " before there was a map"; }

private:
  enum class State { RUNNING, TIME, CALLBACK };

  /// \param pause  for so many seconds after the callback was called it is not called again
  bool ask(double pause)
  {
    if(!is_interrupted()) {
      const double now = watch_.seconds();
      if(now >= limit_)
        state_ = State::TIME;
      else if(callback_ && !is_silent_ && std::this_thread::get_id() == owner_ && now >= last_call_ + pause) {
        last_call_ = now;
        if(!ask_callback())
          state_ = State::CALLBACK;
      }
    }
    return !is_interrupted();
  }

  /// An error that it throws is no answer of the function that asks, which would catch what this package throws itself.
  bool ask_callback()
  {
    try {
      return callback_(fraction_);
    } catch(const Input_error& error) {
      throw Error(error);
    }
  }

  Stopwatch watch_;
  double limit_;
  std::function<bool(double)> callback_;
  bool verbose_;
  bool is_silent_ = false;
  double fraction_ = 0;
  double begin_ = 0, end_ = 1; ///< of the stage
  double last_call_ = -1;      ///< of the callback: when; the first one is at once
  std::atomic<State> state_ = State::RUNNING;
  std::thread::id owner_ = std::this_thread::get_id();
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CONTEXT_MONITOR_H
