// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "benchmark/measure/Counting_policy.h"

#include "helpers/check.h"
#include "helpers/meshes.h"

#include <CGAL/Spherical_parameterization/internal/multigrid/Multigrid.h>

#include <catch2/catch.hpp>

#include <memory>

using namespace test;

namespace {

/// How many entries of sparse matrices the solvers use, over those of the Laplacian; the map has to be valid.
template <class WeightMap>
double counted_sweeps(Mesh mesh, WeightMap weights)
{
  const auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point>("v:sphere").first;
  std::size_t entries = 0;
  const SP::Result result = SP::parameterize(benchmark::Counting_policy{&entries}, mesh, SP::Balanced(), sphere,
                                             CGAL::parameters::edge_weight_map(weights));
  INFO(result);
  CHECK(result.error == SP::Error_code::OK);
  return static_cast<double>(entries) / static_cast<double>(mesh.number_of_halfedges());
}

} // namespace

TEST_CASE("work: it grows like the mesh, and no faster")
{
  constexpr double bound = 160; // products with the Laplacian; the published method takes hundreds of thousands
  constexpr double growth = 1.2;
  const auto make = GENERATE(bumpy_sphere, dumbbell);
  const Mesh small = make_mesh(make(5));
  const Mesh large = make_mesh(make(7));
  const double conformal = counted_sweeps(large, SP::conformal_weights(large));
  const double barycentric = counted_sweeps(large, SP::barycentric_weights(large));
  CHECK(conformal < bound);
  CHECK(barycentric < bound);
  CHECK(conformal < growth * counted_sweeps(small, SP::conformal_weights(small)));
  CHECK(barycentric < growth * counted_sweeps(small, SP::barycentric_weights(small)));
}

TEST_CASE("work: every level of a hierarchy is smaller than the one before, also where hardly anything is coupled")
{
  using namespace SP::internal;
  const double coupling = GENERATE(1., 0.1, 0.03, 0.01, 1e-3, 1e-6, 1e-300);
  CAPTURE(coupling);
  constexpr int size = 1000;
  const auto chain = std::make_shared<Weighted_graph>();
  for(int i = 0; i < size; ++i) {
    for(const int neighbour : {i - 1, i + 1})
      if(neighbour >= 0 && neighbour < size) {
        chain->target.push_back(neighbour);
        chain->weight.push_back(coupling);
      }
    chain->offset.push_back(static_cast<int>(chain->target.size()));
    chain->excess.push_back(1);
  }
  chain->update_diagonal({});
  typedef Backend<CGAL::Sequential_tag> Host;
  const Host host{CGAL::Sequential_tag()};
  Multigrid<Host> multigrid(host, chain);
  for(std::size_t k = 0; k + 1 < multigrid.number_of_levels(); ++k)
    CHECK(multigrid.size(k + 1) <= 0.9 * multigrid.size(k));

  // one cycle solves the system to a third and better
  Host_array<vec3> b(size), x(size), r(size);
  for(int i = 0; i < size; ++i)
    b[i] = make_vec3(std::sin(i), i % 7, 1);
  multigrid.apply(0, b, x);
  host.residual(multigrid.matrix(0), b, x, r);
  CHECK(host.dot(r, r) < host.dot(b, b) / 9);
}
