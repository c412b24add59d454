// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "../benchmark/Counting_policy.h"

#include "helpers/check.h"
#include "helpers/meshes.h"

#include <catch2/catch.hpp>

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
  constexpr double bound = 150; // products with the Laplacian; the published method takes hundreds of thousands
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
