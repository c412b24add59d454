// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "mapping/registered_pair.h"
#include "runner/step.h"

#include <memory>

namespace tool {

/// What a step takes that registers two meshes.
inline Takes pair_of_meshes()
{
  return {Takes::PAIR,      "isometric",  "conformal",
          Takes::NO_SPHERE, Prepare::ALL, "output meshes have the faces of A as 'prepare' writes it"};
}

/// The work of a step on two meshes, which begins with `read_pair()` and `register_pair()`.
inline Work work_on_pair(const std::function<void(const Registration_options&, Run&)>& run_pair)
{
  const auto own = std::make_shared<Registration_options>();
  Work work = {[own, run_pair](Run& run) {
    Registration_options options = *own;
    static_cast<Mapping_options&>(options) = run.options;
    options.other = run.other;
    options.spheres = run.spheres;
    run_pair(options, run);
  }};
  add_registration_options(work.options, *own);
  work.check = [own](const Request&) { feature_weights(*own); };
  work.reads = [own](const Request&) {
    Work::Files files = {{"--landmarks", own->landmarks}};
    for(const std::string& file : own->features)
      files.emplace_back("--features", file);
    return files;
  };
  return work;
}

} // namespace tool
