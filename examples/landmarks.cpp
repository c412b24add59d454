// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// Landmarks: the vertices of a lumpy body that are farthest along five directions are put on five axes of the sphere,
// so that bodies can be compared. The second map has two landmarks interchanged, which contradicts the shape. The third
// map has soft landmarks.
//
//   landmarks

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/spherical_parameterization.h>

#include <cmath>
#include <iostream>
#include <utility>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;

int main()
{
  Mesh mesh;
  SP::make_icosphere(4, mesh, mesh.points());
  for(Point_3& p : mesh.points()) {
    const double r = 1 + 0.3 * std::sin(3 * p.x() + 1) * std::cos(2 * p.y()) + 0.2 * std::sin(4 * p.z());
    p = Point_3(1.5 * r * p.x(), r * p.y(), 0.7 * r * p.z());
  }
  std::vector<Vector_3> places = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  std::vector<Mesh::Vertex_index> landmarks(places.size(), Mesh::Vertex_index(0));
  for(std::size_t k = 0; k < places.size(); ++k)
    for(Mesh::Vertex_index v : vertices(mesh))
      if((mesh.point(v) - mesh.point(landmarks[k])) * places[k] > 0)
        landmarks[k] = v;

  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  auto is_landmark = mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_landmark", false).first;
  const auto map = [&](const char* name, const SP::Isometric& method) {
    for(std::size_t k = 0; k < places.size(); ++k) {
      is_landmark[landmarks[k]] = true;
      sphere[landmarks[k]] = CGAL::ORIGIN + places[k];
    }
    const auto result =
      SP::parameterize(mesh, method, sphere, CGAL::parameters::vertex_is_constrained_map(is_landmark));
    double farthest = 0;
    for(std::size_t k = 0; k < places.size(); ++k)
      farthest = (std::max)(farthest, CGAL::squared_distance(sphere[landmarks[k]], CGAL::ORIGIN + places[k]));
    std::cout << name << ": " << (result ? "certified" : result.detail) << ", landmarks "
              << (farthest == 0     ? "exactly"
                  : farthest < 0.01 ? "nearly"
                                    : "not")
              << " in place\n";
    return bool(result);
  };
  bool are_certified = map("on the axes", SP::Isometric());
  are_certified = map("soft", SP::Isometric{1, 100}) && are_certified;
  std::swap(places[0], places[1]);
  return map("two interchanged", SP::Isometric()) && are_certified ? 0 : 1;
}
