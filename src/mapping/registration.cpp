// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "mapping/registration.h"

#include "system/interruption.h"
#include "system/refusal.h"

namespace tool {

namespace SP = CGAL::Spherical_parameterization;

SP::Registration_result register_map(const std::string& file, const Mesh& mesh, Sphere& sphere, const Mesh& to_mesh,
                                     const Sphere& to_sphere)
{
  SP::Registration_result result =
    SP::register_maps(SP::mapped_mesh(mesh, as_map(sphere)), SP::mapped_mesh(to_mesh, as_map(to_sphere)),
                      as_map(sphere), {}, {}, CGAL::parameters::callback([](double) { return !was_interrupted(); }));
  stop_if_interrupted(file);
  if(!result)
    throw Refusal(result.error, file, "could not be registered: " + result.detail, "");
  return result;
}

} // namespace tool
