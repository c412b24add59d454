// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_NEAREST_SIGNATURES_H
#define SPHERICAL_PARAMETERIZATION_TOOL_NEAREST_SIGNATURES_H

#include "collections/signature_index.h"

#include <cstddef>
#include <vector>

namespace tool {

struct Neighbour {
  double distance;
  std::size_t row; ///< of the index
};

/// The k rows nearest to `query` that have a signature, nearest first, rows of the same distance in their order; fewer
/// if there are not so many. By a k-d tree of CGAL's Spatial_searching, which is GPL: that is why it is not in the
/// library.
std::vector<Neighbour> nearest_signatures(const std::vector<Signature_row>& rows, const Shape_signature& query,
                                          std::size_t k);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_NEAREST_SIGNATURES_H
