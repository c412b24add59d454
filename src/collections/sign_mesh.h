// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_SIGN_MESH_H
#define SPHERICAL_PARAMETERIZATION_TOOL_SIGN_MESH_H

#include "collections/signature_index.h"

#include <functional>
#include <optional>
#include <string>

namespace tool {

/// The row of a mesh file, on one core: its signature, or what is wrong with it. The same every time, to the last bit.
/// `go_on` is asked again and again; where it says no, there is no row.
///
/// The map is the conformal one, also where its only fault is faces flipped in limbs thinner than doubles resolve: all
/// that the signature needs of a map is where the sphere is large. Where the conformal one does not converge, the
/// barycentric one takes its place if it is valid.
std::optional<Signature_row> sign_mesh(const std::string& file, const std::function<bool()>& go_on);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_SIGN_MESH_H
