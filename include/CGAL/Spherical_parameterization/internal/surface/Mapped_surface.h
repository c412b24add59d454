// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_MAPPED_SURFACE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_MAPPED_SURFACE_H

#include <CGAL/Spherical_parameterization/internal/algebra/point_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/predicates/certificate.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/text/text.h>
#include <CGAL/Spherical_parameterization/values/Error.h>

#include <array>
#include <string>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

/// A surface and its image on the sphere: any, valid or not.
struct Mapped_surface : Surface {
  Host_array<vec3> image; ///< as the sphere map has it

  std::array<vec3, 3> of_image(int f) const { return corners(image, f); }

  /// The same as unit vectors.
  std::array<vec3, 3> of_unit_image(int f) const
  {
    const auto [a, b, c] = of_image(f);
    return {direction_of(a), direction_of(b), direction_of(c)};
  }

  /// Calls f(face, its corners in the source, those of its image) for all faces, in any order.
  template <class Loop, class F>
  void for_each_face(const Loop& loop, F f) const
  {
    for_each_part(loop, number_of_faces(),
                  [&](int begin, int end) { internal::for_each_face(face, begin, end, f, point, image); });
  }

  /// Of the image as it is, whatever its lengths.
  const Certificate& certificate(const Host_loop& loop) const
  {
    return certificate_.get([&] { return certify(loop, face, image); });
  }

private:
  Kept<Certificate> certificate_;
};

/// A map whose certificate is valid: what is asked for by all that needs a bijection.
struct Valid_map : Mapped_surface {
  /// Throws Error if it is not valid.
  Valid_map(Mapped_surface map, const Host_loop& loop) : Mapped_surface(std::move(map))
  {
    const Certificate& its = certificate(loop);
    if(!its.is_valid())
      throw Input_error(Error_code::NOT_BIJECTIVE, counted(its.flipped_faces, "flipped face", "flipped faces") +
                                                     ", the degree is " + std::to_string(its.degree));
  }
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_MAPPED_SURFACE_H
