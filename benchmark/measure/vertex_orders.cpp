// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "measure/sweep_graph.h"

#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/cuthill_mckee_ordering.hpp>

#ifdef BENCHMARK_WITH_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

#include <numeric>
#include <random>
#include <utility>

namespace benchmark {
namespace {

std::vector<int> breadth_first(const Sweep_graph& graph)
{
  std::vector<int> order(graph.size());
  std::iota(order.begin(), order.end(), 0);
  return order;
}

std::vector<int> as_in_file(const Sweep_graph& graph)
{
  std::vector<int> order(graph.size());
  for(int i = 0; i < graph.size(); ++i)
    order[graph.position[i]] = i;
  return order;
}

std::vector<int> shuffled(const Sweep_graph& graph)
{
  std::vector<int> order = as_in_file(graph);
  std::mt19937 random(1);
  for(std::size_t i = order.size(); i > 1; --i) // std::shuffle() differs from one standard library to the next
    std::swap(order[i - 1], order[random() % i]);
  return order;
}

std::vector<int> reverse_cuthill_mckee(const Sweep_graph& graph)
{
  typedef boost::adjacency_list<
    boost::vecS, boost::vecS, boost::undirectedS,
    boost::property<boost::vertex_color_t, boost::default_color_type, boost::property<boost::vertex_degree_t, int>>>
    Graph;
  Graph g(graph.size());
  for(int i = 0; i < graph.size(); ++i)
    for(int k = graph.graph.offset[i]; k < graph.graph.offset[i + 1]; ++k)
      if(i < graph.graph.target[k])
        add_edge(i, graph.graph.target[k], g);
  std::vector<int> order(graph.size());
  boost::cuthill_mckee_ordering(g, order.rbegin(), get(boost::vertex_color, g), boost::make_degree_map(g));
  return order;
}

std::vector<int> hilbert_curve(const Sweep_graph& graph)
{
  typedef CGAL::Pointer_property_map<Point_3>::const_type Point_map;
  typedef CGAL::Spatial_sort_traits_adapter_3<CGAL::Simple_cartesian<double>, Point_map> Traits;
  std::vector<std::size_t> order(graph.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  CGAL::hilbert_sort(order.begin(), order.end(), Traits(CGAL::make_property_map(graph.point)));
  return {order.begin(), order.end()};
}

#ifdef BENCHMARK_WITH_MESHOPTIMIZER
/// The triangles in the order that suits a vertex cache, then the vertices in the order in which the triangles meet
/// them: the kind of optimization that the paper applies (Sander et al. 2007). Starts from the order of the file.
std::vector<int> vertex_cache(const Sweep_graph& graph)
{
  const std::vector<int> file = as_in_file(graph);
  std::vector<unsigned> corners;
  for(const std::array<int, 3>& f : graph.face)
    for(int i : f)
      corners.push_back(static_cast<unsigned>(graph.position[i]));
  std::vector<unsigned> number(file.size());
  meshopt_optimizeVertexCache(corners.data(), corners.data(), corners.size(), file.size());
  meshopt_optimizeVertexFetchRemap(number.data(), corners.data(), corners.size(), file.size());
  std::vector<int> order(file.size());
  for(std::size_t i = 0; i < file.size(); ++i)
    order[number[i]] = file[i];
  return order;
}
#endif

} // namespace

const std::map<std::string, Vertex_order> vertex_orders = {
  {"breadth-first", breadth_first}, {"file", as_in_file},
  {"shuffled", shuffled},           {"reverse-cuthill-mckee", reverse_cuthill_mckee},
#ifdef BENCHMARK_WITH_MESHOPTIMIZER
  {"vertex-cache", vertex_cache},
#endif
  {"hilbert", hilbert_curve}};

} // namespace benchmark
