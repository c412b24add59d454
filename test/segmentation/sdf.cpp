// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/sdf.h"

#include <CGAL/mesh_segmentation.h>

#include <boost/property_map/property_map.hpp>

namespace test {
namespace {

/// The property map of the faces of a mesh that has no garbage.
template <class Value>
auto of_faces(const Mesh& mesh, std::vector<Value>& values)
{
  return boost::make_iterator_property_map(values.begin(), get(boost::face_index, mesh));
}

} // namespace

std::vector<double> sdf_values(const Mesh& mesh)
{
  std::vector<double> values(mesh.number_of_faces());
  CGAL::sdf_values(mesh, of_faces(mesh, values));
  return values;
}

std::vector<std::size_t> sdf_segments(const Mesh& mesh, const std::vector<double>& value, std::size_t clusters,
                                      double smoothing)
{
  std::vector<double> values = value;
  const std::size_t nowhere = 12345;
  std::vector<std::size_t> segments(mesh.number_of_faces(), nowhere);
  CGAL::segmentation_from_sdf_values(mesh, of_faces(mesh, values), of_faces(mesh, segments), clusters, smoothing);
  return segments;
}

} // namespace test
