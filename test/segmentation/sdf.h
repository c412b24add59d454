// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's segmentation by the shape diameter function, compiled once: it takes as long as that of the package.

#ifndef TEST_SEGMENTATION_SDF_H
#define TEST_SEGMENTATION_SDF_H

#include "helpers/soup.h"

#include <cstddef>
#include <vector>

namespace test {

/// Of each face, with CGAL's defaults.
std::vector<double> sdf_values(const Mesh& mesh);

/// The segment of each face by its value in [0, 1], which need not be an SDF value.
std::vector<std::size_t> sdf_segments(const Mesh& mesh, const std::vector<double>& value, std::size_t clusters = 5,
                                      double smoothing = 0.26);

} // namespace test

#endif // TEST_SEGMENTATION_SDF_H
