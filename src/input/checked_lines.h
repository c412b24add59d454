// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_CHECKED_LINES_H
#define SPHERICAL_PARAMETERIZATION_TOOL_CHECKED_LINES_H

#include <exception>
#include <functional>
#include <ios>
#include <streambuf>
#include <string>
#include <utility>

namespace tool {

/// A stream buffer of lines made on demand: CGAL's text readers see only what has been checked, in the plain spelling
/// that all of their versions understand, without a second copy of the file in memory.
class Checked_lines : public std::streambuf {
public:
  /// Appends the next lines to an empty string; `false` at the end.
  using Next_lines = std::function<bool(std::string&)>;

  explicit Checked_lines(Next_lines next) : next_(std::move(next)) {}

  /// Streams swallow what their buffers throw: this hands it on when the reader has given up.
  void rethrow() const
  {
    if(error_)
      std::rethrow_exception(error_);
  }

private:
  int_type underflow() override
  {
    position_ += static_cast<off_type>(lines_.size());
    lines_.clear();
    try {
      if(!error_ && next_(lines_)) {
        setg(lines_.data(), lines_.data(), lines_.data() + lines_.size());
        return traits_type::to_int_type(lines_.front());
      }
    } catch(...) {
      error_ = std::current_exception();
    }
    setg(nullptr, nullptr, nullptr);
    return traits_type::eof();
  }

  /// Only back to the beginning, and only while the first lines are there: the STL reader looks at the first word.
  pos_type seekoff(off_type offset, std::ios_base::seekdir direction, std::ios_base::openmode) override
  {
    if(direction != std::ios_base::beg || offset != 0 || position_ != 0)
      return pos_type(off_type(-1));
    setg(eback(), eback(), egptr());
    return pos_type(off_type(0));
  }
  pos_type seekpos(pos_type position, std::ios_base::openmode mode) override
  {
    return seekoff(off_type(position), std::ios_base::beg, mode);
  }

  Next_lines next_;
  std::string lines_;     // made, but not all read yet
  off_type position_ = 0; // of the first of them
  std::exception_ptr error_;
};

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_CHECKED_LINES_H
