// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "mapping/mapped_mesh.h"
#include "options/mapping_options.h"

#include <CGAL/Spherical_parameterization/register_maps.h>
#include <CGAL/Spherical_parameterization/values/Distortion_summary.h>

#include <string>
#include <vector>

namespace tool {

/// Two meshes, how they are mapped, and how the map of the first one is registered to that of the second one.
struct Registration_options : Mapping_options {
  std::string other;                ///< the second mesh; `input` is the first one
  std::vector<std::string> spheres; ///< of both; or none
  std::string landmarks;
  std::vector<std::string> features; ///< files of A and of B; or none
  std::string feature_weights = "20";
  std::string motion = "deformation";
  SP::Registration registration;
};

/// Both meshes with their maps, and what registration has made of the first one's.
struct Registered_pair {
  Mapped_mesh a, b;
  Sphere registered;              ///< of the vertices of A
  std::vector<Place> places_on_b; ///< where the vertices of A come to lie on the surface of B
  std::vector<Point> points_on_b; ///< the same as points
  SP::Registration_result result;
  SP::Length_changes changes;           ///< from A to B
  std::vector<double> changes_of_faces; ///< of A
};

/// To register the mesh of `options`, which is mapped in another way, to another one: by maps of low distortion.
Registration_options to_register(const Mapping_options& options, const std::string& other);

/// The options that say how they are registered.
void add_registration_options(Options& all, Registration_options& options);

/// The weights of features, one or several. Throws a `CLI::ValidationError` for what is none.
std::vector<double> feature_weights(const Registration_options& options);

/// Reads the meshes that have not been read. Throws a `Refusal`.
void read_pair(const Registration_options& options, Registered_pair& pair);

/// Maps both, unless they have a map, and registers them. Throws a `Refusal` if there is no certified registered map.
void register_pair(const Registration_options& options, Registered_pair& pair);

/// By vertex of the file of A its place on the mesh of the file of B; none if it was left out when A was mended.
std::vector<Place> places_by_files(const Registered_pair& pair);

/// What was done to both meshes before, in lines, each with its end.
std::string preparation_text(const Registration_options& options, const Registered_pair& pair);

/// What has come of it, in lines without the end of the last one: figures, and how good they are in words.
std::string registration_text(const Registration_options& options, const Registered_pair& pair);

/// The figures of the registration, for reports.
Json registration_json(const Registration_options& options, const Registered_pair& pair);

} // namespace tool
