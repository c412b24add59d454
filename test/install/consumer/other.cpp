// SPDX-License-Identifier: GPL-3.0-or-later
// A second translation unit with all headers: nothing may be defined twice.

#include "map.h"

bool can_map_elsewhere(Mesh& mesh)
{
#ifdef CGAL_LINKED_WITH_TBB
  return can_map(CGAL::Parallel_tag(), mesh);
#else
  return can_map(CGAL::Sequential_tag(), mesh);
#endif
}
