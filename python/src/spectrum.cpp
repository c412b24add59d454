// SPDX-License-Identifier: LGPL-3.0-or-later
// Eigenfunctions of the Laplacian.

#include "arrays.h"

#include <CGAL/Spherical_parameterization/laplacian_eigenpairs.h>

#include <pybind11/stl.h>

namespace {

std::tuple<std::vector<double>, Doubles, std::vector<double>>
laplacian_eigenpairs(const Doubles& points, const py::array& triangles, std::size_t number, const std::string& policy)
{
  const Mesh mesh = make_mesh(points, triangles);
  const SP::Laplacian_eigenpairs pairs =
    on_watched(policy, [&](const auto& p, const auto& np) { return SP::laplacian_eigenpairs(p, mesh, number, np); });
  return {pairs.value, array_of(pairs.functions, pairs.value.size(), pairs.number_of_vertices), pairs.mass};
}

/// \param functions  a row for each
SP::Laplacian_eigenpairs pairs_of(const std::vector<double>& value, const Doubles& functions)
{
  return {static_cast<std::size_t>(functions.shape(1)),
          value,
          std::vector<double>(functions.data(), functions.data() + functions.size()),
          {}};
}

Doubles heat_kernel_signature(const std::vector<double>& value, const Doubles& functions,
                              const std::vector<double>& times)
{
  const SP::Laplacian_eigenpairs pairs = pairs_of(value, functions);
  const std::vector<double> signature = without_lock([&] { return SP::heat_kernel_signature(pairs, times); });
  return array_of(signature, times.size(), pairs.number_of_vertices);
}

Doubles wave_kernel_signature(const std::vector<double>& value, const Doubles& functions, std::size_t energies)
{
  const SP::Laplacian_eigenpairs pairs = pairs_of(value, functions);
  const std::vector<double> signature = without_lock([&] { return SP::wave_kernel_signature(pairs, energies); });
  return array_of(signature, energies, pairs.number_of_vertices);
}

} // namespace

void add_spectrum(py::module_& module)
{
  module.def("laplacian_eigenpairs", laplacian_eigenpairs);
  module.def("heat_kernel_signature", heat_kernel_signature);
  module.def("wave_kernel_signature", wave_kernel_signature);
}
