// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "collections/sign_mesh.h"

#include "input/mesh.h"
#include "mapping/spherical_map.h"
#include "system/error_code_names.h"
#include "system/refusal.h"

#include <algorithm>
#include <exception>
#include <new>

namespace tool {
namespace {

using CGAL::Spherical_parameterization::Result;

/// Whether there is a map to work with, good or bad.
bool has_map(Error_code code)
{
  return code == Error_code::OK || code == Error_code::NOT_CONVERGED || code == Error_code::NOT_BIJECTIVE;
}

/// Fills `row` but for its name. Throws; leaves the signature out where `go_on` says no.
void sign(const std::string& file, const std::function<bool()>& go_on, Signature_row& row)
{
  const Mesh mesh = read_mesh(file).mesh;
  row.vertices = mesh.number_of_vertices();
  const auto compute = [&](Sphere& sphere, const auto& weights) {
    Map_settings settings;
    settings.weights = weights;
    settings.policy = CGAL::Sequential_tag(); // the other cores have meshes of their own
    return map_to_sphere(mesh, sphere, settings, [&go_on](double) { return go_on(); });
  };
  Sphere sphere;
  const Result result = compute(sphere, Conformal_weights());
  if(result.error == Error_code::INTERRUPTED)
    return;
  if(!has_map(result.error))
    throw Refusal(name(result.error), file,
                  get_error_message(result.error) + (result.detail.empty() ? "" : ": " + result.detail), "");
  row.map = result ? "conformal" : "uncertified";
  if(result.error == Error_code::NOT_CONVERGED) {
    Sphere barycentric;
    const Result other = compute(barycentric, Barycentric_weights());
    if(other.error == Error_code::INTERRUPTED)
      return;
    if(other) {
      row.map = "barycentric";
      sphere = barycentric;
    }
  }
  row.signature = CGAL::Spherical_parameterization::shape_signature(mesh, as_map(sphere));
}

void set_error(Signature_row& row, const std::string& status, std::string message)
{
  std::replace_if(
    message.begin(), message.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  row.status = status;
  row.message = message;
  row.map.clear();
  row.signature.reset();
}

} // namespace

std::optional<Signature_row> sign_mesh(const std::string& file, const std::function<bool()>& go_on)
{
  Signature_row row;
  row.name = file;
  try {
    sign(file, go_on, row);
    row.status = "OK";
    if(!row.signature)
      return std::nullopt;
  } catch(const Refusal& refusal) {
    set_error(row, refusal.code(), refusal.what());
  } catch(const std::bad_alloc&) {
    set_error(row, "OUT_OF_MEMORY", file + ": not enough memory; simplify the mesh, or use fewer --jobs");
  } catch(const std::exception& exception) {
    set_error(row, "NO_SIGNATURE", file + ": " + exception.what());
  }
  return row;
}

} // namespace tool
