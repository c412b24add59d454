// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace tool {

/// The value below which a share of the values lies; they are reordered. Not a number if there are none.
inline double quantile(std::vector<double>& values, double share)
{
  if(values.empty())
    return std::numeric_limits<double>::quiet_NaN();
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

} // namespace tool
