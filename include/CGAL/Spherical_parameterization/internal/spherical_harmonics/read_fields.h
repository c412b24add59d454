// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_READ_FIELDS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_READ_FIELDS_H

#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/analysis.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>

namespace CGAL::Spherical_parameterization::internal {

/// The values of a vertex map, numbers or vectors, as one or three fields.
template <class TriangleMesh, class VertexMap>
Sampled_fields read_fields(const TriangleMesh& mesh, VertexMap map)
{
  typedef typename boost::property_traits<VertexMap>::value_type Value;
  Sampled_fields result;
  if constexpr(std::is_arithmetic_v<Value>) {
    result.number_of_fields = 1;
    for(auto v : vertices(mesh))
      result.value.push_back(static_cast<double>(get(map, v)));
  } else {
    result.number_of_fields = 3;
    const Host_array<vec3> rows = vectors_at(vertices(mesh), map);
    result.value.resize(3 * rows.size());
    for(std::size_t i = 0; i < rows.size(); ++i) {
      result.value[i] = rows[i].x;
      result.value[rows.size() + i] = rows[i].y;
      result.value[2 * rows.size() + i] = rows[i].z;
    }
  }
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_READ_FIELDS_H
