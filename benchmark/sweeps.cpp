// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// What a map costs, in sweeps: one sweep is one application of the Laplacian to three vectors of doubles, in the same
// run, on the same graph. Prints Markdown.
//
//   sweeps [--subdivide N] [--published SECONDS] MESH...
//
// --subdivide N       also the meshes subdivided 1 ... N times (every triangle into four, points on the edges)
// --published SECONDS also the published method from the centroid start, both splittings, with this time limit

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;

typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef Mesh::Property_map<Mesh::Vertex_index, Point_3> Point_map;

// Keeps all points, and puts new ones on the middle of the edges.
struct Midpoint_mask {
  const Mesh* mesh;
  Point_map points;

  void edge_node(Mesh::Halfedge_index h, Point_3& p)
  {
    p = CGAL::midpoint(get(points, source(h, *mesh)), get(points, target(h, *mesh)));
  }
  void vertex_node(Mesh::Vertex_index v, Point_3& p) { p = get(points, v); }
  void border_node(Mesh::Halfedge_index, Point_3&, Point_3&) {}
};

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

template <class WeightMap>
double seconds_per_sweep(const Mesh& mesh, WeightMap weights)
{
  typedef SP::internal::Backend<CGAL::Sequential_tag> Backend;
  SP::internal::Source_mesh<Mesh> source(mesh, mesh.points());
  source.set_weights(mesh, weights);
  source.graph->update_diagonal({});
  const SP::internal::Shared_graph graph = source.graph;
  const Backend backend{CGAL::Sequential_tag()};
  Backend::Vectors y = backend.vectors(source.graph->size());
  std::vector<double> times;
  const double begin = seconds();
  while(times.size() < 11 || seconds() < begin + 0.2) {
    const double start = seconds();
    backend.multiply(graph, source.point, y);
    times.push_back(seconds() - start);
  }
  std::nth_element(times.begin(), times.begin() + times.size() / 2, times.end());
  return times[times.size() / 2];
}

template <class WeightMap>
void measure(const std::string& name, const char* weight_name, Mesh& mesh, WeightMap weights, double published)
{
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  const double sweep = seconds_per_sweep(mesh, weights);
  const auto print = [&](const char* method, const SP::Result& r) {
    const double cost = (r.seconds.start_map + r.seconds.solve) / sweep;
    std::printf("| %s | %zu | %s | %s | %zu + %zu | %zu | %.3f | %.3f | %.3g | %.0f | %.1e | %zu | %d | %s |\n",
                name.c_str(), r.number_of_vertices, weight_name, method, r.start_iterations, r.iterations, r.sweeps,
                r.seconds.start_map, r.seconds.solve, 1e3 * sweep, cost, r.residual, r.flipped_faces, r.degree,
                r ? "valid" : SP::get_error_message(r.error));
    std::fflush(stdout);
  };
  const auto np = CGAL::parameters::edge_weight_map(weights);
  print("balanced", SP::parameterize(CGAL::Sequential_tag(), mesh, SP::Balanced(), sphere, np));
  if(published > 0) {
    SP::Saddle_point method;
    print("published, Jacobi",
          SP::parameterize(CGAL::Sequential_tag(), mesh, method, sphere, np.maximum_running_time(published)));
    method.splitting = SP::Saddle_point::Splitting::GAUSS_SEIDEL;
    method.relaxation = 1.9;
    print("published, SOR 1.9",
          SP::parameterize(CGAL::Sequential_tag(), mesh, method, sphere, np.maximum_running_time(published)));
  }
  mesh.remove_property_map(sphere);
}

int main(int argc, char* argv[])
{
  int subdivisions = 0;
  double published = 0;
  std::vector<std::string> files;
  for(int i = 1; i < argc; ++i) {
    const std::string a = argv[i];
    if(a == "--subdivide" && i + 1 < argc)
      subdivisions = std::atoi(argv[++i]);
    else if(a == "--published" && i + 1 < argc)
      published = std::atof(argv[++i]);
    else
      files.push_back(a);
  }
  if(files.empty()) {
    std::cerr << "usage: sweeps [--subdivide N] [--published SECONDS] MESH...\n";
    return 2;
  }
  std::puts(
    "| model | vertices | weights | method | iterations | method's sweeps | start map s | solve s | ms per sweep | "
    "cost in sweeps | residual | flips | degree | verdict |");
  std::puts("|---|---|---|---|---|---|---|---|---|---|---|---|---|---|");
  for(const std::string& file : files) {
    Mesh mesh;
    if(!CGAL::IO::read_polygon_mesh(file, mesh)) {
      std::cerr << file << ": cannot be read as a polygon mesh\n";
      return 1;
    }
    for(int level = 0; level <= subdivisions; ++level) {
      if(level > 0) {
        Midpoint_mask mask = {&mesh, mesh.points()};
        CGAL::Subdivision_method_3::PTQ(mesh, mask);
      }
      const std::string name =
        std::filesystem::path(file).stem().string() + (level > 0 ? "/" + std::to_string(level) : "");
      measure(name, "conformal", mesh, SP::conformal_weights(mesh), published);
      measure(name, "barycentric", mesh, SP::barycentric_weights(mesh), published);
    }
  }
  return 0;
}
