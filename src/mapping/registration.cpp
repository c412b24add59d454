// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "mapping/registration.h"

#include "mapping/spherical_map.h"
#include "system/error_code_names.h"
#include "system/refusal.h"

#include <CGAL/Spherical_parameterization/align_maps.h>

namespace tool {

namespace SP = CGAL::Spherical_parameterization;

Sphere registered_map(const std::string& file, const Mapped_shape& shape, const Mapped_shape& to)
{
  constexpr int degree = 15;
  const CGAL::Sequential_tag one_core;
  const auto harmonics = [&](const Mapped_shape& of) {
    const SP::Spherical_locator<Mesh> locator(*of.mesh, as_map(*of.sphere));
    return SP::internal::sampled_harmonics(one_core, locator, as_map(*of.points), degree);
  };
  const SP::Shape_alignment alignment = SP::best_alignment(one_core, harmonics(to), harmonics(shape));
  Sphere moved;
  for(const Point& p : *shape.sphere) {
    const SP::internal::vec3 q = SP::internal::rotated(alignment.sphere, {p[0], p[1], p[2]});
    moved.push_back({q.x, q.y, q.z});
  }
  const SP::Result result = certify(*shape.mesh, moved);
  if(!result)
    throw Refusal(name(result.error), file, "the turned map has " + std::to_string(result.flipped_faces) + " flipped faces",
                  "");
  return moved;
}

} // namespace tool
